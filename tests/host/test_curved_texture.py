"""CurvedTexture in FreeCADCmd: the paper's experiment from the STEP file to posted text and back.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import tempfile
import unittest

import _patchmill as core
import FreeCAD
import numpy as np
import Part
import patchmill

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from parts import saved_and_reopened  # noqa: E402
from recipe import STEP, make_part, run, small_job  # noqa: E402


class WithFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.addCleanup(self.close_documents)

    def path(self, name):
        return str(pathlib.Path(self.folder.name) / name)

    def assert_same_bytes(self, one, other):
        one, other = (pathlib.Path(self.path(name)).read_bytes() for name in (one, other))
        self.assertEqual(one, other)

    def close_documents(self):
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)


class ThePart(WithFolder):
    def test_step_file_is_what_the_script_makes(self):
        made, read = make_part.block(), Part.read(STEP)
        self.assertTrue(read.isValid())
        self.assertEqual(read.ShapeType, "Solid")
        self.assertAlmostEqual(made.Volume / read.Volume, 1.0, 9)
        self.assertAlmostEqual(made.cut(read).Volume / made.Volume, 0.0, 6)

    def test_bezier_points_through_the_brep_path(self):
        shape = Part.read(STEP)
        face = shape.getElement(run.top_face(shape))
        plane = core.texture_plane((0, 0, 0), (0, 0, -1), (1, 0, 0))
        sampler = core.FaceSampler([face.exportBrepToString()], plane, math.radians(80))
        # De Casteljau at (1/2, 1/2), (1/4, 1/4) and (3/4, 1/4)
        known = np.array(
            [
                [0, 0.546875, 24.875],
                [-16.5029296875, 16.698486328125, 23.759765625],
                [-16.8017578125, -14.947509765625, 22.880859375],
            ]
        )
        hits = sampler.sample(known[:, :2])
        self.assertLess(np.abs(hits["positions"] - known).max(), 1e-6)


class TheExperiment(WithFolder):
    """Tables 1 and 2 of Xu & Sasahara 2016, 8 x 8 patches."""

    def test_three_decimals(self):
        self.check(3, 1.0)

    def test_four_decimals(self):
        self.check(4, 0.15)

    def check(self, decimals, bound):
        document, part = run.make_document(STEP)
        job, operation = run.make_job(part, decimals)
        plan = patchmill.recompute(operation)
        self.assert_plan(plan)
        posted = patchmill.post(job, self.path("x.ngc"))[0]
        errors = np.degrees(posted.errors["error"])
        self.assertEqual(len(errors), plan.counts["cut"])
        self.assertGreater(len(errors), 10000)
        self.assertLess(np.abs(errors).max(), bound)
        half = len(errors) // 2
        self.assertLess(np.abs(errors[half:]).mean(), 2.0 * np.abs(errors[:half]).mean() + 1e-6)
        self.assertTrue(posted.match.complete)
        self.assertEqual(posted.match.extra_moves, 0)
        self.assertLess(posted.match.largest_miss, 1e-9)
        self.assert_contacts(plan, posted.path, 0.5 * 10.0**-decimals)

    def assert_plan(self, plan):
        self.assertEqual(sum(plan.counts.values()), len(plan.dimples))
        self.assertEqual(len(plan.dimples), 112 * 112)
        lattice, places = plan.dimples.lattice[:, :2].astype(int), plan.dimples.positions
        on_grid = np.full((112, 112, 2), np.nan)
        on_grid[lattice[:, 0], lattice[:, 1]] = places[:, :2]
        self.assertFalse(np.isnan(on_grid).any(), "every lattice point once")
        # over the whole plan, so across patch borders too
        for axis in (0, 1):
            steps = np.diff(on_grid, axis=axis)
            self.assertLess(np.abs(steps[..., axis] - 0.5).max(), 1e-6)
            self.assertLess(np.abs(steps[..., 1 - axis]).max(), 1e-6)

    def assert_contacts(self, plan, path, unit):
        """The posted ball touches the face at the dimple: |tip + R t - R n - p| within rounding."""
        number = path.dimples[path.dimples >= 0]
        tips = path.tips[path.dimples >= 0]
        radius = plan.input.tool.radius
        touch = tips + [0, 0, radius] - radius * plan.dimples.normals[number]
        self.assertLess(np.abs(touch - plan.dimples.positions[number]).max(), unit * 1.001)


class SenseOfTheSpindle(WithFolder):
    def test_a_direction_is_posted_or_refused(self):
        # FreeCAD 1.1 posts the tool bit's, whatever the controller says
        document, job, operation = small_job(4)
        operation.ToolController.SpindleDir = "Reverse"
        if patchmill.host.posted_direction(operation.ToolController) == "Reverse":
            patchmill.post(job, self.path("reverse"))
            self.assertIn("M4 S1000", pathlib.Path(self.path("reverse")).read_text())
            return
        with self.assertRaises(patchmill.InputError) as caught:
            patchmill.recompute(operation)
        self.assertEqual(caught.exception.property, "SpindleDirection")
        operation.ToolController.Tool.SpindleDirection = "Reverse"
        patchmill.recompute(operation)
        patchmill.post(job, self.path("reverse"))
        self.assertIn("M4 S1000", pathlib.Path(self.path("reverse")).read_text())

    def test_m3_and_m4_are_not_confused(self):
        texts, plans = [], []
        for direction in ("Forward", "Reverse"):
            document, job, operation = small_job(4, direction, "s" + direction)
            plans.append(patchmill.recompute(operation))
            patchmill.post(job, self.path(direction))
            texts.append(pathlib.Path(self.path(direction)).read_text())
        self.assertIn("M3 S1000", texts[0])
        self.assertIn("M4 S1000", texts[1])
        tool = plans[0].input.tool
        # the M4 text with M3 in it is read back out of phase
        wrong = core.read_gcode(texts[1].replace("M4 ", "M3 "), tool)[-1]
        self.assertTrue(core.match_plan(wrong.path, plans[1].path, 1e-3).complete)
        normals = plans[1].dimples.normals
        azimuth = np.arctan2(-normals[:, 1], -normals[:, 0])
        twice = -2.0 * (azimuth - azimuth[0])  # the spindle goes the other way by as much
        error = plans[1].phase_errors(wrong.path)["error"]
        difference = (error - twice + math.pi) % (2 * math.pi) - math.pi
        self.assertLess(np.degrees(np.abs(difference)).max(), 0.15)
        self.assertGreater(np.degrees(np.abs(error)).max(), 30.0)
        # from dimple to dimple the two turn opposite ways: their turns add up to whole ones
        per_dimple = []
        for plan in plans:
            e = plan.phase_errors()
            per_dimple.append(np.diff(e["turns"])[:20])
        whole = per_dimple[0] + per_dimple[1]
        self.assertLess(np.abs(whole - np.round(whole)).max(), 2e-3)


class TheDocument(WithFolder):
    def test_saved_reopened_and_recomputed_posts_the_same_bytes(self):
        document, job, operation = small_job()
        patchmill.recompute(operation)
        patchmill.post(job, self.path("before.ngc"))
        reopened, job = saved_and_reopened(document, self.path("d.FCStd"))
        operation = reopened.getObject(operation_name(reopened))
        self.assertEqual(operation.PatchSide, 6)
        operation.touch()
        reopened.recompute()
        patchmill.post(job, self.path("after.ngc"))
        self.assert_same_bytes("before.ngc", "after.ngc")

    def test_reopened_without_recompute_posts_the_same_bytes(self):
        document, job, operation = small_job()
        patchmill.recompute(operation)
        patchmill.post(job, self.path("before.ngc"))
        _, job = saved_and_reopened(document, self.path("d.FCStd"))
        patchmill.post(job, self.path("after.ngc"))
        self.assert_same_bytes("before.ngc", "after.ngc")

    def test_left_out_dimples_are_reported_by_reason(self):
        document, job, operation = small_job()
        operation.MinimumTilt = 12.0
        operation.SteepestSlope = 20.0
        operation.Origin = (-14, -14, 0)
        operation.PatchSide = 14
        operation.PatchesX = operation.PatchesY = 5
        plan = patchmill.recompute(operation)
        tilt = np.degrees(core.tilts(plan.dimples, (0, 0, 1)))
        state = plan.dimples.states
        on = state != core.state_names().index("off the face")
        self.assertEqual(plan.counts["too steep"], int((tilt[on] > 20).sum()))
        self.assertEqual(plan.counts["tool tip"], int((tilt[on] < 12).sum()))
        self.assertGreater(plan.counts["off the face"], 0)
        self.assertGreater(plan.counts["too steep"], 0)
        self.assertGreater(plan.counts["tool tip"], 0)
        for name in ("off the face", "too steep", "tool tip"):
            self.assertIn("%s: %d" % (name, plan.counts[name]), operation.LeftOut)


def operation_name(document):
    return [o.Name for o in document.Objects if o.Name.startswith("CurvedTexture")][0]


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
