"""Spindle-locked operations in FreeCADCmd: posted by PatchMill's own post, refused where they would not hold,
calibrated, and corrected by the machine's stored start phase.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import math
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

import _patchmill as core
import FreeCAD
import numpy as np
import patchmill
from patchmill.machine import machines

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from parts import saved_and_reopened  # noqa: E402
from recipe import small_job  # noqa: E402


def locked_job(machine="linuxcnc-mill", strategy="Spindle-locked"):
    """A small job on the surface's steep corner, spindle-locked, with PatchMill's own post."""
    document, job, operation = small_job(4)
    job.PostProcessor = "patchmill_linuxcnc"
    job.PostProcessorArgs = "--no-header --precision=4"
    operation.Origin = (-24, -24, 0)
    operation.Strategy = strategy
    operation.Machine = machine
    operation.SameFlute = False
    operation.ExtraTurns = 0.0
    return document, job, operation


class WithMachines(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        os.environ["PATCHMILL_MACHINES"] = os.path.join(self.folder, "machines")
        self.addCleanup(os.environ.pop, "PATCHMILL_MACHINES")
        self.addCleanup(lambda: [FreeCAD.closeDocument(n) for n in list(FreeCAD.listDocuments())])

    def path(self, name):
        return os.path.join(self.folder, name)

    def machine(self, key, **axes):
        """A user's machine file like linuxcnc-mill, with other axes."""
        data = json.loads(json.dumps(machines.load("linuxcnc-mill").data))
        data["linear_axes"].update(axes)
        os.makedirs(machines.user_folder(), exist_ok=True)
        with open(os.path.join(machines.user_folder(), key + ".json"), "w") as file:
            json.dump(data, file)
        return key

    def assert_refused(self, name, call, *arguments):
        with self.assertRaises(patchmill.InputError) as caught:
            call(*arguments)
        self.assertIn(name, caught.exception.property)
        return caught.exception


class SpindleLocked(WithMachines):
    def test_is_posted_with_every_k_and_holds_by_the_model(self):
        document, job, operation = locked_job()
        plan = patchmill.recompute(operation)
        posted = patchmill.post(job, self.path("x.ngc"))[0]
        text = pathlib.Path(self.path("x.ngc")).read_text()
        self.assertTrue(posted.match.complete)
        self.assertEqual(posted.match.extra_moves, 0)
        locked = [line for line in text.splitlines() if line.startswith("G33")]
        self.assertGreater(len(locked), plan.counts["cut"])
        self.assertTrue(all(re.search(r" K\d+\.\d{6}$", line) for line in locked))
        self.assertRegex(text, r"G64 P0\.0\d+")
        self.assert_starts_from_clearance(text, operation.ClearanceHeight.Value)
        self.assertEqual(plan.pacing.verdict.holding, "holds")
        self.assertIn("olds", operation.Verdict)
        self.assertLess(math.degrees(posted.errors["largest"]), 9.0)
        self.assertLess(operation.TurnsPerDimple, 1.5)

    def assert_starts_from_clearance(self, text, clearance):
        """After the spindle starts, the first move goes over the start at the clearance height."""
        after = text[text.index("M3 S1000") :]
        first = re.search(r"^G0 X\S+ Y\S+ Z(\S+)$", after, re.M)
        self.assertAlmostEqual(float(first.group(1)), clearance, 6)

    def test_freecads_own_post_is_refused_because_it_drops_k(self):
        document, job, operation = locked_job()
        patchmill.recompute(operation)
        for name in ("linuxcnc", "grbl"):
            with self.subTest(name):
                arguments = "--no-header --no-show-editor --precision=4"
                with self.assertRaises(patchmill.InputError):
                    patchmill.post(job, self.path("y.ngc"), name, arguments)
                self.assertFalse(os.path.exists(self.path("y.ngc")))

    def test_a_controller_that_cannot_lock_is_refused(self):
        document, job, operation = locked_job("open-loop-mill")
        error = self.assert_refused("Strategy", patchmill.recompute, operation)
        self.assertIn("open-loop-mill", error.remedy)

    def test_a_strategy_without_a_machine_is_refused(self):
        document, job, operation = locked_job("")
        self.assert_refused("Machine", patchmill.recompute, operation)

    def test_an_unknown_machine_is_named(self):
        document, job, operation = locked_job("no-such-mill")
        self.assert_refused("Machine", patchmill.recompute, operation)

    def test_reopened_documents_post_the_same_bytes(self):
        document, job, operation = locked_job()
        patchmill.recompute(operation)
        patchmill.post(job, self.path("a.ngc"))
        _, job = saved_and_reopened(document, self.path("d.FCStd"))
        patchmill.post(job, self.path("b.ngc"), "patchmill_linuxcnc")
        a, b = (pathlib.Path(self.path(n)).read_bytes() for n in ("a.ngc", "b.ngc"))
        self.assertEqual(a, b)


class Verdicts(WithMachines):
    def test_open_loop_that_cannot_hold_is_told_so_before_posting(self):
        document, job, operation = locked_job(strategy="Feed per move")
        plan = patchmill.recompute(operation)
        self.assertNotEqual(plan.pacing.verdict.holding, "holds")
        error = self.assert_refused("SpindleSpeed", patchmill.post, job, self.path("x.ngc"))
        if plan.pacing.verdict.holding == "holds up to":
            self.assertIn("%.0f" % math.floor(60 * plan.pacing.verdict.speed), error.remedy)
        self.assertFalse(os.path.exists(self.path("x.ngc")))
        operation.PostUnheld = True
        patchmill.recompute(operation)
        patchmill.post(job, self.path("x.ngc"))
        self.assertTrue(os.path.exists(self.path("x.ngc")))

    def test_the_speed_named_is_one_at_which_it_holds(self):
        key = self.machine("slow", acceleration_mm_s2=150.0)
        document, job, operation = locked_job(key, "Feed per move")
        verdict = patchmill.recompute(operation).pacing.verdict
        if verdict.holding == "holds up to":
            operation.ToolController.SpindleSpeed = math.floor(60 * verdict.speed)
            self.assertEqual(patchmill.recompute(operation).pacing.verdict.holding, "holds")
        else:
            self.assertEqual(verdict.holding, "cannot")
            self.assertIn("annot", verdict.sentence)

    def test_the_path_that_is_judged_is_the_one_that_is_posted(self):
        """With its start phase a lock takes other steps to its first dimples."""
        _, _, operation = locked_job()
        for speed in (1000, 1730):
            operation.ToolController.SpindleSpeed = speed
            plan = patchmill.recompute(operation)
            given, model = plan.input, plan.machine.model
            judged = plan.dimples, given.tool, given.spindle, plan.rule, model
            posted = core.judge_plan(lambda _, path=plan.path: path, *judged)
            self.assertEqual(plan.pacing.verdict.largest, posted.largest)
            self.assertEqual(plan.pacing.verdict.rms, posted.rms)

    def test_the_papers_zigzag_is_lost_and_fitted_stops_hold(self):
        held = {}
        for strategy in ("Constant feed", "Constant feed, fitted stops"):
            document, job, operation = locked_job(strategy=strategy)
            operation.ExtraTurns = 5.0
            held[strategy] = patchmill.recompute(operation).pacing.verdict.holding
        self.assertNotEqual(held["Constant feed"], "holds")
        self.assertEqual(held["Constant feed, fitted stops"], "holds")


class Calibration(WithMachines):
    def test_patch_store_and_correction(self):
        document, job, operation = locked_job()
        before = patchmill.recompute(operation)
        operation.Active = False
        patch = patchmill.CalibrationPatch.Create("Calibration", parentJob=job)
        for name in ("Base", "Strategy", "Machine", "SameFlute", "ExtraTurns", "Decimals", "Spacing"):
            setattr(patch, name, getattr(operation, name))
        plan = patchmill.recompute(patch)
        self.assertGreaterEqual(plan.counts["cut"], 180)
        patchmill.post(job, self.path("calibration.ngc"))
        self.assertAlmostEqual(patchmill.CalibrationPatch.store(patch, 57), 180.0 - 57.0, 9)
        stored = machines.load("linuxcnc-mill").data["start_phase_degrees"]
        self.assertAlmostEqual(stored, 123.0, 9)
        # all operations turn the spindle on by what is missing, before their first dimple
        operation.Active = True
        after = patchmill.recompute(operation)
        first = [int(np.flatnonzero(p.path.dimples >= 0)[0]) for p in (before, after)]
        turns = [np.nansum(p.path.turns[: f + 1]) for p, f in zip((before, after), first)]
        # that much further back, on the decimals of the program
        self.assertAlmostEqual((turns[1] - turns[0]) % 0.5, 57.0 / 360.0, delta=1e-4)
        # and the calibration patch itself does not
        again = patchmill.recompute(patch)
        np.testing.assert_array_equal(again.path.tips, plan.path.tips)
        np.testing.assert_array_equal(again.path.turns, plan.path.turns)

    def test_bad_numbers_are_named(self):
        document, job, operation = locked_job()
        patch = patchmill.CalibrationPatch.Create("Calibration", parentJob=job)
        patch.Base, patch.SameFlute, patch.ExtraTurns = operation.Base, False, 0.0
        self.assert_refused("Machine", patchmill.CalibrationPatch.store, patch, 3)
        patch.Machine = "linuxcnc-mill"
        self.assert_refused("BestDimple", patchmill.CalibrationPatch.store, patch, -1)
        self.assert_refused("BestDimple", patchmill.CalibrationPatch.store, patch, 9999)


class MachineFiles(WithMachines):
    def test_shipped_ones_fit_the_schema(self):
        self.assertIn("linuxcnc-mill", machines.names())
        for key in machines.names():
            self.assertGreater(machines.load(key).model.acceleration, 0.0)

    def test_mistakes_are_named_by_their_place(self):
        good = machines.load("linuxcnc-mill").data
        for place, value in (
            (("spindle_lock",), 1),
            (("decimals",), True),
            (("linear_axes", "velocity_mm_s"), "fast"),
            (("linear_axes", "acceleration_mm_s2"), -1.0),
            (("linear_axes", "jerk_mm_s3"), 0.0),
            (("format",), "other"),
            (("start_phase_degrees",), 400.0),
        ):
            data = json.loads(json.dumps(good))
            inner = data
            for word in place[:-1]:
                inner = inner[word]
            inner[place[-1]] = value
            error = self.assert_refused("/" + "/".join(place), machines.checked, json.dumps(data), "x")
            self.assertTrue(error.remedy)
            del inner[place[-1]]
            self.assert_refused("/" + "/".join(place), machines.checked, json.dumps(data), "x")
        self.assert_refused("Machine file x", machines.checked, "{", "x")
        self.assert_refused("/colour", machines.checked, json.dumps(dict(good, colour="red")), "x")


class ExactStop(unittest.TestCase):
    def test_constant_feed_says_so_where_the_model_counts_on_stops(self):
        """A controller that rounds corners would cut the zigzag's vertices off."""
        for strategy, machine, stops in (
            ("Constant feed", "", False),
            ("Constant feed", "linuxcnc-mill", True),
            ("Constant feed, fitted stops", "linuxcnc-mill", True),
        ):
            with self.subTest(strategy=strategy, machine=machine):
                document, job, operation = locked_job(machine, strategy)
                operation.SameFlute, operation.ExtraTurns = True, 5.0
                operation.PostUnheld = True
                patchmill.recompute(operation)
                with tempfile.TemporaryDirectory() as folder:
                    name = os.path.join(folder, "x.ngc")
                    patchmill.post(job, name)
                    lines = pathlib.Path(name).read_text().split()
                first_cut = lines.index("G1")
                self.assertEqual("G61" in lines[:first_cut], stops)
                FreeCAD.closeDocument(document.Name)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
