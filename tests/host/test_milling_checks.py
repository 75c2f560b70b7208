"""Shank and holder of copy milling and DCM dressups against a wall that nothing else touches: clear,
colliding, posted and refused.

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
from patchmill import CopyMilling, DressupDCM
from patchmill.freecad import host

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from milling_jobs import add_pocket, dress, make_job, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402


def floor_with_wall():
    """A floor at z = 10 and a wall up to z = 60 at x = 50."""
    return Part.makeBox(50, 20, 10).fuse(Part.makeBox(10, 20, 60, FreeCAD.Vector(50, 0, 0)))


def copied(**properties):
    """(job, CopyMilling) of the last pass over it, with a ball of 6 mm on a shank of 4 mm."""
    _, job = make_job(floor_with_wall(), "wall", ball=True)
    bit = host.tool_controllers(job)[0].Tool
    bit.ShankDiameter, bit.CuttingEdgeHeight = 4.0, 15.0
    operation = CopyMilling.Create("Copy", parentJob=job)
    operation.Passes, operation.RadialDepth, operation.AxialDepth = "Finishing", 10.0, 10.0
    for name, value in properties.items():
        setattr(operation, name, value)
    CopyMilling.recompute(operation)
    return job, operation


def pocketed(holder, feed="Feed"):
    """(job, DressupDCM) on FreeCAD's own pocket, its floor at z = 12, with a wall up to z = 40 at x = 10."""
    part = pocket_part().fuse(Part.makeBox(10, 20, 20, FreeCAD.Vector(0, 10, 20)))
    _, job = make_job(part, "pocket")
    dressup = dress(add_pocket(job), Controls=feed, VoxelSize=2.0, Holder=holder)
    DressupDCM.recompute(dressup)
    return job, dressup


class MillingChecks(WithDocuments):
    def post(self, job):
        """What posting raised, or None; the file must be there only if nothing was raised."""
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "x.ngc")
            try:
                self.posted = patchmill.post(job, name)
            except patchmill.InputError as error:
                self.assertFalse(os.path.exists(name))
                return error
            self.assertTrue(os.path.exists(name))
            return None

    def test_copy_milling_with_a_long_tool_is_clear(self):
        job, operation = copied(StickOut=70.0)
        result = patchmill.check(operation)
        self.assertEqual(result.outcome, "clear", result.sentence)
        self.assertEqual([section[0] for section in result.sections], ["flute", "shank", "holder"])
        self.assertEqual(result.sections[2][1:3], (70.0, 130.0))
        self.assertIsNone(self.post(job))
        self.assertEqual(self.posted[0].check.outcome, "clear")

    def test_copy_milling_whose_holder_meets_the_wall_is_not_posted(self):
        job, operation = copied(StickOut=30.0)  # over the floor from z = 40 on, where the wall is
        result = patchmill.check(operation)
        self.assertEqual(result.outcome, "violated")
        self.assertEqual({f.part for f in result.findings}, {"holder"})
        # ball centres come to x = 47, so that the holder, 20 mm wide, would be 17 mm in the wall, which is
        # 10 mm thick: the nearest way out is upwards past the wall's top, or less
        self.assertTrue(45.0 <= result.worst.place[0] <= 60.001, result.worst)
        self.assertGreater(result.worst.depth, 5.0)
        error = self.post(job)
        self.assertEqual(error.property, "PostGouging")
        self.assertIn("holder", str(error))
        operation.PostGouging = True
        self.assertIsNone(self.post(job))
        self.assertEqual(self.posted[0].check.outcome, "violated")

    def test_copy_milling_without_a_holder_has_none(self):
        _, operation = copied(StickOut=30.0, HolderDiameter=0.0)
        self.assertEqual(patchmill.check(operation).outcome, "clear")

    def test_a_thick_shank_is_seen_over_the_edges(self):
        job, operation = copied(StickOut=70.0)
        bit = operation.ToolController.Tool
        bit.ShankDiameter = 10.0  # 2 mm wider than the ball, from 15 mm above the tip on
        job.Document.recompute()
        CopyMilling.recompute(operation)
        result = patchmill.check(operation)
        self.assertEqual({f.part for f in result.findings}, {"shank"})
        self.assertAlmostEqual(result.worst.depth, 2.0 + 0.1, delta=0.25)

    def test_too_short_a_tool_is_named(self):
        _, operation = copied(StickOut=70.0)
        operation.StickOut = 2.0
        with self.assertRaises(patchmill.InputError) as caught:
            CopyMilling.recompute(operation)
        self.assertEqual(caught.exception.property, "StickOut")

    def test_dcm_beside_the_wall_is_clear(self):
        # the tool's axis comes to 20.5 mm: 1.5 mm stay between this holder and the wall
        job, dressup = pocketed(["10 40 18 18"])
        result = patchmill.check(dressup)
        self.assertEqual(result.outcome, "clear", result.sentence)
        self.assertFalse(result.cutting)  # a pocket of FreeCAD's: what it cuts is its own affair
        self.assertIn("shank and holder stay 1 mm away", result.sentence)
        self.assertIsNone(self.post(job))

    def test_dcm_whose_holder_meets_the_wall_is_not_posted(self):
        job, dressup = pocketed(["10 40 30 30"])
        result = patchmill.check(dressup)
        self.assertEqual(result.outcome, "violated")
        self.assertEqual({f.part for f in result.findings}, {"holder"})
        self.assertAlmostEqual(result.worst.depth, 4.5 + 1.0, delta=0.6)  # to within a tenth
        error = self.post(job)
        self.assertEqual(error.property, "PostGouging")
        self.assertIn("holder", str(error))
        dressup.PostGouging = True
        self.assertIsNone(self.post(job))

    def test_dcm_on_copy_milling_takes_its_holder_and_looks_at_what_it_cuts(self):
        job, operation = copied(StickOut=30.0)
        dressup = dress(operation, Controls="Feed", VoxelSize=2.0, HolderClearance=0.5)
        DressupDCM.recompute(dressup)
        result = patchmill.check(dressup)
        self.assertTrue(result.cutting)
        self.assertEqual({f.part for f in result.findings}, {"holder"})
        self.assertEqual(self.post(job).property, "PostGouging")

    def test_what_is_none_of_ours_is_refused_by_name(self):
        _, job = make_job(pocket_part())
        with self.assertRaises(patchmill.InputError) as caught:
            patchmill.check(add_pocket(job))
        self.assertEqual(caught.exception.property, "Operation")


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
