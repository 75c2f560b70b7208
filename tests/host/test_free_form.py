"""Matsuda's free form in FreeCADCmd: the recipe's experiments, posted and read back, with the phase
difference measured on the text that the machine gets.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import runpy
import sys
import tempfile
import unittest

import numpy as np
import patchmill
from patchmill.textures import advisor, free_form

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from parts import WithDocuments  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
RECIPE = runpy.run_path(str(ROOT / "Resources" / "recipes" / "matsuda2008" / "run.py"))


class FreeForm(WithDocuments):
    def test_experiments_make_the_predicted_arrays(self):
        for part in RECIPE["PARTS"]:
            for array in RECIPE["ARRAYS"]:
                with self.subTest(part=part, array=array):
                    self.check(part, array)
                    self.tearDown()

    def check(self, part, array):
        document, job, operation = RECIPE["make"](part, array)
        plan = patchmill.recompute(operation)
        self.assertTrue(operation.MarkArray.startswith(array))
        self.assertEqual(sum(plan.counts.values()), len(plan.dimples))
        with tempfile.TemporaryDirectory() as folder:
            posted = patchmill.post(job, str(pathlib.Path(folder) / "x.ngc"))[0]
        self.assertTrue(posted.match.complete)
        phases = free_form.phase_differences(plan, posted.path)
        self.assertGreater(len(phases["lap"]), 20)
        self.assertLess(phases["largest_miss"], 0.01)  # three decimals, sides of 7 mm
        self.assertAlmostEqual(phases["measured_drift"], phases["drift"], delta=0.002)
        if array != "drifting":
            offset = phases["measured"] - (0.5 if array == "staggered" else 0.0)
            self.assertLess(np.abs(offset - np.round(offset)).max(), 0.02)

    def test_marks_lie_on_planes_a_feed_apart(self):
        document, job, operation = RECIPE["make"]("cylinder", "square")
        plan = patchmill.recompute(operation)
        per_patch = plan.free.marks_per_patch
        for patch in range(len(plan.free)):
            own = slice(patch * per_patch, (patch + 1) * per_patch)
            cut = plan.dimples.states[own] == 0
            if cut.sum() < 10:
                continue
            places, normals = plan.dimples.positions[own][cut], plan.dimples.normals[own][cut]
            self.assertLess(np.abs((places - places[0]) @ normals[0]).max(), 1e-9)
            steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
            self.assertLess(steps.min(), 0.5 + 1e-9)
            # the sagitta of a 7 mm patch on the cylinder
            axis = np.hypot(places[:, 1], places[:, 2] + RECIPE["RADIUS"])
            self.assertLess(np.abs(axis - RECIPE["RADIUS"]).max(), 7.1**2 / 8 / 30 + 0.02)

    def test_feed_per_tooth_sets_the_feed(self):
        document, job, operation = RECIPE["make"]("inclined plane", "square")
        operation.FeedPerTooth = 0.4
        plan = patchmill.recompute(operation)
        self.assertAlmostEqual(60.0 * plan.feed, 0.4 * 2 * 1000.0, 6)
        self.assertAlmostEqual(operation.FoundSpacing.Value, 0.4, 9)

    def test_advice_aligns_what_drifts(self):
        document, job, operation = RECIPE["make"]("inclined plane", "drifting")
        patchmill.recompute(operation)
        self.assertGreater(abs(operation.MeasuredDrift), 0.1)
        best = advisor.advise_operation(operation)[0]
        same = patchmill.advise(2.0, 2, 1000.0, side=7.0, spacing=0.5, cross_feed=0.51)[0]
        self.assertAlmostEqual(best.side, same.side, 9)
        advisor.take(operation, best)
        patchmill.recompute(operation)
        self.assertTrue(operation.MarkArray.startswith("square"))
        self.assertLess(abs(operation.MeasuredDrift), 0.002)

    def test_bad_input_is_named(self):
        document, job, operation = RECIPE["make"]("inclined plane", "square")
        for name, value in (
            ("TextureKind", "Isolated"),
            ("MaskUse", "Density"),
            ("Strategy", "Feed per move"),
            ("FreeSide", 0.0),
            ("CrossFeed", 0.0),
        ):
            before = getattr(operation, name)
            if name == "Strategy":
                operation.Machine = "linuxcnc-mill"
            setattr(operation, name, value)
            self.assert_refused(operation, name)
            setattr(operation, name, before)
            operation.Machine = ""

    def test_the_machine_is_judged(self):
        document, job, operation = RECIPE["make"]("inclined plane", "square")
        operation.Machine = "linuxcnc-mill"
        patchmill.recompute(operation)
        self.assertTrue(math.isfinite(operation.MachiningTime))
        self.assertNotEqual(operation.Verdict, "Unknown: no machine is named.")


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
