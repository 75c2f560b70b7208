"""patchmill.check and the posting that it stops: gouges and holder collisions with place and depth, clean
paths, and parts of which nothing is known.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile
import unittest

import FreeCAD
import Part
import patchmill
from patchmill.freecad import host

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from parts import WithDocuments  # noqa: E402
from recipe import small_job  # noqa: E402


def job_on(shape, face, direction=None, **properties):
    """(document, job, CurvedTexture) of 2 x 2 patches of 6 x 6 dimples on a face of a shape."""
    document = FreeCAD.newDocument("checks")
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape
    document.recompute()
    job = host.create_job("Job", [part])
    host.add_ball_end_controller(job, 2.0, 2, 434.413, 1000.0)
    job.PostProcessor = "linuxcnc"
    job.PostProcessorArgs = "--no-header --no-show-editor --precision=3"
    op = patchmill.CurvedTexture.Create("Texture", parentJob=job)
    op.Base = [(job.Model.Group[0], [face])]
    op.PatchSide, op.PatchesX, op.PatchesY = 6, 2, 2
    for name, value in properties.items():
        setattr(op, name, value)
    return document, job, op


def slope_with_wall(height):
    """A block whose top slopes by 30 degrees about y, 30 x 40 mm, and a wall of `height` over its upper
    edge at its side y = 20; the sloping face's name."""
    wedge = Part.Face(
        Part.makePolygon([(0, 0, 0), (30, 0, 0), (30, 0, 10 + 30 * 0.57735), (0, 0, 10), (0, 0, 0)])
    ).extrude(FreeCAD.Vector(0, 40, 0))
    wall = Part.makeBox(30, 5, 30 + height, FreeCAD.Vector(0, 40, 0))
    solid = wedge.fuse(wall).removeSplitter() if height else wedge
    for number, face in enumerate(solid.Faces, 1):
        n = face.normalAt(0, 0)
        if abs(n.x + 0.5) < 1e-3 and n.z > 0.5:
            return solid, "Face%d" % number
    raise AssertionError("no sloping face")


class Checks(WithDocuments):
    def post(self, job):
        """What posting raised, or None; the file must be there only if nothing was raised."""
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "x.ngc")
            try:
                posted = patchmill.post(job, name)
            except patchmill.InputError as error:
                self.assertFalse(os.path.exists(name))
                return error
            self.assertTrue(os.path.exists(name))
            self.assertEqual(len(posted), 1)
            return None

    def test_clean_path_is_clear_and_posted(self):
        _, job, op = job_on(*slope_with_wall(0))
        patchmill.recompute(op)
        result = patchmill.check(op)
        self.assertEqual(result.outcome, "clear", result.sentence)
        self.assertLess(result.sink, 1e-3)
        self.assertIsNone(self.post(job))

    def test_holder_collides_with_a_wall(self):
        # the wall stands 31 mm over the lowest dimples' slope; the holder begins 25 mm above the tip
        _, job, op = job_on(*slope_with_wall(20), StickOut=25.0)
        op.AutoOrigin, op.Origin = False, FreeCAD.Vector(12, 32, 0)
        patchmill.recompute(op)
        result = patchmill.check(op)
        self.assertEqual(result.outcome, "violated")
        self.assertEqual({f.part for f in result.findings}, {"holder"})
        worst = result.worst
        # dimples reach y = 34.75; the holder's radius is 20, so it stands 14.75 - 0 in the wall from y = 40
        # and is deepest in it there, or as high as the wall is over it
        self.assertAlmostEqual(worst.place[1], 40.0, delta=5.0)
        self.assertTrue(45.0 - 15.0 < worst.place[2] <= 50.001, worst)
        self.assertGreater(worst.depth, 1.0)
        error = self.post(job)
        self.assertEqual(error.property, "PostGouging")
        self.assertIn("holder", str(error))
        self.assertIn("(%.3f, %.3f, %.3f)" % worst.place, str(error))
        op.PostGouging = True
        self.assertIsNone(self.post(job))
        op.PostGouging, op.StickOut = False, 60.0
        patchmill.recompute(op)
        self.assertEqual(patchmill.check(op).outcome, "clear")
        op.StickOut, op.HolderDiameter = 25.0, 0.0  # no holder
        patchmill.recompute(op)
        self.assertEqual(patchmill.check(op).outcome, "clear")

    def test_deliberate_gouge_has_place_and_depth(self):
        """A groove of radius 0.8 cannot take a ball of 1: it cuts into the groove's flanks."""
        groove = Part.makeCylinder(0.8, 40, FreeCAD.Vector(15, 0, 20), FreeCAD.Vector(0, 1, 0))
        solid = Part.makeBox(30, 40, 20).cut(groove)
        number = next(
            i for i, f in enumerate(solid.Faces, 1) if f.Surface.TypeId == "Part::GeomCylinder"
        )
        _, job, op = job_on(
            solid, "Face%d" % number, PatchSide=2, PatchesX=1, PatchesY=1, MinimumTilt=1.0
        )
        op.Spacing = 0.5
        patchmill.recompute(op)
        result = patchmill.check(op)
        self.assertEqual(result.outcome, "violated", result.sentence)
        worst = result.worst
        self.assertEqual(worst.part, "ball")
        # two dimples at x = 15 -+ 0.25: the ball's centre is 0.2 beyond the axis on the other side, and
        # cuts 1 - (0.8 - 0.2) = 0.4 deep opposite, or where the groove opens
        self.assertTrue(0.05 < worst.depth < 0.41, worst)
        self.assertLess(abs(worst.place[0] - 15.0), 1.3)
        self.assertIn("ball", str(self.post(job)))

    def test_links_are_checked(self):
        """A pin between patches that a link runs through, though every dimple is clear."""
        solid, name = slope_with_wall(0)
        plain = job_on(solid, name)[2]
        plan = patchmill.recompute(plain)
        tips, kinds = plan.path.tips, plan.path.kinds
        links = [i for i in range(1, len(kinds)) if kinds[i] == 1 and kinds[i - 1] == 1]
        at = max(links, key=lambda i: tips[i][2] + tips[i - 1][2] - 0.5 * abs(tips[i][0] - tips[i - 1][0]))
        middle = 0.5 * (tips[at] + tips[at - 1])
        pin = Part.makeCylinder(0.05, middle[2] + 0.3, FreeCAD.Vector(*middle[:2], 0))
        with_pin = solid.fuse(pin)
        number = next(
            i
            for i, f in enumerate(with_pin.Faces, 1)
            if abs(f.normalAt(0, 0).x + 0.5) < 1e-3 and f.normalAt(0, 0).z > 0.5
        )
        op = job_on(with_pin, "Face%d" % number)[2]
        patchmill.recompute(op)
        result = patchmill.check(op)
        self.assertEqual(result.outcome, "violated")
        near = [
            f
            for f in result.findings
            if abs(f.place[0] - middle[0]) < 0.2 and abs(f.place[1] - middle[1]) < 0.2
        ]
        self.assertTrue(near)

    def test_a_part_that_cannot_be_meshed_is_unknown(self):
        solid, name = slope_with_wall(0)
        number = int(name[4:])
        shell = Part.makeCompound([solid.Faces[number - 1]])  # one face: not a solid
        _, job, op = job_on(shell, "Face1")
        patchmill.recompute(op)
        result = patchmill.check(op)
        self.assertEqual(result.outcome, "unknown")
        self.assertIn("not a closed solid", result.reason)
        error = self.post(job)
        self.assertEqual(error.property, "PostGouging")
        self.assertIn("closed solid", str(error))
        op.PostGouging = True
        self.assertIsNone(self.post(job))

    def test_planar_patches_may_lie_as_deep_as_planned(self):
        document, job, curved = small_job(name="sink")
        op = patchmill.PlanarTexture.Create("Planar", parentJob=job)
        for name in ("Base", "PatchSide", "PatchesX", "PatchesY", "Decimals"):
            setattr(op, name, getattr(curved, name))
        op.AutoOrigin, op.Origin = False, curved.Origin
        patchmill.recompute(op)
        result = patchmill.check(op)
        self.assertEqual(result.outcome, "clear", result.sentence)
        self.assertGreater(result.sink, 0.001)

    def test_cancelled_is_unknown(self):
        _, _, op = job_on(*slope_with_wall(0))
        patchmill.recompute(op)
        self.assertEqual(patchmill.check(op, progress=lambda share: False).outcome, "unknown")

    def test_bad_input_is_named(self):
        _, _, op = job_on(*slope_with_wall(0))
        for name, value in (("StickOut", 0.5), ("GougeTolerance", 0.0)):
            setattr(op, name, value)
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.recompute(op)
                patchmill.check(op)
            self.assertEqual(caught.exception.property, name)
            setattr(op, name, 0.01 if name == "GougeTolerance" else 0.0)


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
