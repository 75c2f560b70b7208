"""What the texture operations offer beyond the paper's experiment: lattices on the surface, sizes,
fitted direction, the advisor; old documents and setup sheets.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import unittest

import _patchmill as core
import numpy as np
import Part
import patchmill
from patchmill.properties.texture_properties import PROPERTIES
from patchmill.properties.texture_results import RESULTS

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from parts import V, WithDocuments, job_on, tilted_box  # noqa: E402
from recipe import small_job  # noqa: E402


class OnTheSurface(WithDocuments):
    def test_spacing_is_kept_along_an_inclined_plane(self):
        for shape in ("Square", "Hexagon", "Triangle"):
            box, face = tilted_box(40.0)
            document, operation = job_on(box, face)
            operation.PatchShape, operation.PatchSide = shape, 5 if shape != "Hexagon" else 3
            patchmill.recompute(operation)
            stretched = 0.5 / math.cos(math.radians(40.0))
            self.assertAlmostEqual(operation.SpacingGreatest.Value, stretched, 6)
            operation.Mapping = "On surface"
            plan = patchmill.recompute(operation)
            self.assertGreater(plan.counts["cut"], 800)
            self.assertAlmostEqual(operation.SpacingLeast.Value, 0.5, 6)
            self.assertAlmostEqual(operation.SpacingGreatest.Value, 0.5, 6)
            right = 90.0 if shape == "Square" else 60.0
            self.assertAlmostEqual(operation.LatticeAngleLeast.Value, right, 3)
            self.tearDown()

    def test_a_block_of_patches_is_centred(self):
        box, face = tilted_box(40.0)
        document, operation = job_on(box, face)
        operation.Mapping, operation.PatchesX, operation.PatchesY = "On surface", 2, 2
        plan = patchmill.recompute(operation)
        self.assertEqual(plan.counts["cut"], 4 * 36)
        middle = plan.dimples.positions.mean(axis=0) - plan.plane.origin
        self.assertLess(np.linalg.norm(middle), 0.5)
        outline = np.concatenate(plan.outlines())
        places = plan.places()
        self.assertTrue((outline.min(axis=0) < places.min(axis=0)).all())
        self.assertTrue((outline.max(axis=0) > places.max(axis=0)).all())

    def test_it_begins_on_the_faces(self):
        ring = Part.makeCylinder(10, 4).cut(Part.makeCylinder(5, 4))
        ring.rotate(V(0, 0, 0), V(0, 1, 0), 10.0)
        top = max(range(4), key=lambda k: ring.Faces[k].CenterOfMass.z)
        document, operation = job_on(ring, "Face%d" % (top + 1), "PlanarTexture")
        operation.Mapping = "On surface"
        plan = patchmill.recompute(operation)
        self.assertGreater(plan.counts["cut"], 500)
        operation.AutoOrigin, operation.Origin = False, V(0, 0, 4)
        self.assert_refused(operation, "Origin")


class Sizes(WithDocuments):
    def setUp(self):
        self.document, self.job, self.operation = small_job()

    def test_isolated_dimples_are_sunk(self):
        op = self.operation
        top = patchmill.recompute(op).path
        op.TextureKind, op.Depth = "Isolated", 0.02
        plan = patchmill.recompute(op)
        self.assertAlmostEqual(op.FoundDiameter.Value, 0.397995, 5)
        self.assertAlmostEqual(op.RubbingTilt.Value, 11.478, 3)
        deeper = [p.tips[p.dimples >= 0] for p in (top, plan.path)]
        drop = deeper[0] - deeper[1]  # along the normals, within the decimals
        number = plan.path.dimples[plan.path.dimples >= 0]
        normals = plan.dimples.normals[number]
        self.assertLess(np.abs(drop - 0.02 * normals).max(), 1.01e-3)

    def test_paced_paths_are_sunk_too(self):
        op = self.operation
        op.Strategy, op.Machine, op.SameFlute, op.ExtraTurns = "Spindle-locked", "linuxcnc-mill", 0, 0
        op.TextureKind, op.Depth, op.Decimals = "Isolated", 0.02, 4
        op.PostUnheld = True
        plan = patchmill.recompute(op)
        number = plan.path.dimples[plan.path.dimples >= 0]
        tips = plan.path.tips[plan.path.dimples >= 0]
        touch = tips + [0, 0, 1.0] - 0.98 * plan.dimples.normals[number]
        self.assertLess(np.abs(touch - plan.dimples.positions[number]).max(), 0.51e-4)

    def test_spacing_from_ridge_height(self):
        self.operation.Spacing, self.operation.RidgeHeight = 0.0, 0.03175416344814578
        patchmill.recompute(self.operation)
        self.assertAlmostEqual(self.operation.FoundSpacing.Value, 0.5, 9)

    def test_contradictions_are_named(self):
        op = self.operation
        op.RidgeHeight = 0.05
        self.assert_refused(op, "RidgeHeight")
        op.RidgeHeight, op.TextureKind, op.Depth = 0.0, "Isolated", 0.1
        self.assert_refused(op, "Spacing")  # they touch
        op.Depth = 0.0
        self.assert_refused(op, "Depth")

    def test_rubbing_is_counted_and_avoided(self):
        op = self.operation
        op.TextureKind, op.Depth = "Isolated", 0.02
        plan = patchmill.recompute(op)
        tilts = np.degrees(core.tilts(plan.dimples, (0, 0, 1)))
        self.assertEqual(op.RubbingDimples, (tilts < op.RubbingTilt.Value).sum())
        self.assertGreater(op.RubbingDimples, 0)
        op.AvoidRubbing = True
        if (tilts > op.RubbingTilt.Value).any():
            patchmill.recompute(op)
            self.assertEqual(op.RubbingDimples, 0)
        else:
            self.assert_refused(op, "AvoidRubbing")

    def test_a_plane_that_is_not_inclined_rubs_everywhere(self):
        box, face = tilted_box(5.0)
        document, op = job_on(box, face)
        op.TextureKind, op.Depth, op.AvoidRubbing = "Isolated", 0.02, True
        self.assert_refused(op, "AvoidRubbing")
        op.Depth = 0.002  # asin(D / 2R) = 3.62°
        patchmill.recompute(op)
        self.assertEqual(op.RubbingDimples, 0)


class TheDirection(WithDocuments):
    def test_if_nothing_can_be_cut_the_reason_is_named(self):
        document, operation = job_on(*tilted_box(0.0))
        with self.assertRaises(patchmill.InputError) as caught:
            patchmill.recompute(operation)
        self.assertEqual(caught.exception.property, "Dimples")
        self.assertIn("tool tip", caught.exception.remedy)
        self.assertIn("incline the part", caught.exception.remedy)  # lowering MinimumTilt would not help

    def test_is_fitted_to_the_faces(self):
        box, face = tilted_box(25.0)
        document, operation = job_on(box, face)
        operation.AutoDirection = True
        patchmill.recompute(operation)
        wanted = V(-math.sin(math.radians(25)), 0, -math.cos(math.radians(25)))
        self.assertLess((operation.FoundDirection - wanted).Length, 1e-9)
        self.assertAlmostEqual(operation.SpacingGreatest.Value, 0.5, 9)

    def test_of_a_whole_cylinder_is_chosen_and_said(self):
        lying = Part.makeCylinder(10, 20, V(), V(1, 0, 0))
        document, operation = job_on(lying, "Face1")
        operation.AutoDirection = True
        plan = patchmill.recompute(operation)
        self.assertGreater(plan.counts["cut"], 500)
        self.assertEqual(operation.FoundDirection, V(0, 0, -1))  # as it is given
        self.assertIn("look to all sides alike", operation.Remarks)
        standing = Part.makeCylinder(10, 20).Faces[0].exportBrepToString()
        found = core.seen_best([standing], (0.0, 0.0, -1.0))  # from where nothing of it is seen
        self.assertLess(abs(found["direction"][2]), 1e-9)


class Faces(WithDocuments):
    def test_an_edge_between_two_of_them_is_no_border(self):
        box, _ = tilted_box(0.0)
        edges = [e for e in box.Edges if abs(e.CenterOfMass.y + 8) + abs(e.CenterOfMass.z) < 1e-6]
        part = box.makeFillet(3.0, edges)
        part.rotate(V(0, 0, 0), V(0, 1, 0), 15.0)
        names = []
        for number, face in enumerate(part.Faces, 1):
            if isinstance(face.Surface, Part.Cylinder) or face.normalAt(0, 0).z > 0.9:
                names.append("Face%d" % number)
        document, operation = job_on(part, names[0])
        model = operation.Base[0][0]
        operation.Base = [(model, [name]) for name in names]
        operation.Margin = 1.0
        plan = patchmill.recompute(operation)
        y = plan.dimples.positions[plan.dimples.states == 0][:, 1]
        self.assertGreater(plan.counts["near an edge"], 50)
        # the edge that top and fillet share is at y = -5
        self.assertGreater((abs(y + 5.0) < 1.0).sum(), 100)


class TheAdvisor(unittest.TestCase):
    def test_proposals_are_aligned(self):
        wish = dict(diameter=2.0, flutes=2, speed=1000.0, side=14.0, spacing=0.5, cross_feed=0.505)
        self.assertIn("drifting", patchmill.mark_state(**wish))
        proposals = patchmill.advise(**wish)
        self.assertEqual(proposals[0].kept, "nothing")
        for p in proposals:
            self.assertIn("square", p.state)
            again = dict(wish, side=p.side, spacing=p.feed_per_tooth, cross_feed=p.cross_feed)
            self.assertIn("square", patchmill.mark_state(**again))
            self.assertAlmostEqual(p.feed, p.feed_per_tooth * 2 * 1000.0, 9)


class Documents(WithDocuments):
    def test_old_ones_get_the_new_properties(self):
        document, job, operation = small_job()
        names = [row[1] for row in PROPERTIES + RESULTS]
        new = [n for n in names if n not in ("Spacing", "PatchSide", "PatchesX", "PatchesY")]
        for name in new:
            operation.removeProperty(name)
        operation.Proxy.opOnDocumentRestored(operation)
        for name in new:
            self.assertTrue(hasattr(operation, name), name)
        operation.AutoOrigin, operation.Origin = False, V(-15, -10, 0)
        self.assertEqual(patchmill.recompute(operation).counts["cut"], 144)

    def test_setup_sheets_know_the_properties(self):
        small_job()
        known = patchmill.host.SetupSheet._RegisteredOps["CurvedTexture"]
        prototype = known.prototype("CurvedTexture")
        for name in known.properties():
            self.assertEqual(prototype.getProperty(name).name, name)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
