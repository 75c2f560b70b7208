"""A stored start phase knows its controller, is counted from the spindle's index, and holds for each texture.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import _patchmill as core  # noqa: E402
import patchmill  # noqa: E402
from patchmill.machine import machines  # noqa: E402
from test_strategies import WithMachines, locked_job  # noqa: E402

KEY = "linuxcnc-mill"


class Conditions(WithMachines):
    def calibrate(self):
        """(job, operation) on a machine whose start phase was found at the operation's own speed."""
        _, job, operation = locked_job()
        patch = patchmill.CalibrationPatch.Create("Calibration", parentJob=job)
        for name in ("Base", "Strategy", "Machine", "SameFlute", "ExtraTurns", "Decimals", "Spacing"):
            setattr(patch, name, getattr(operation, name))
        patchmill.recompute(patch)
        patchmill.CalibrationPatch.store(patch, 57)
        patch.Active = False
        return job, operation

    def say(self, **words):
        machines.save(KEY, dict(machines.load(KEY).data, **words))

    def test_they_are_stored_with_the_start_phase(self):
        _, operation = self.calibrate()
        found = machines.load(KEY).data["calibration"]
        self.assertEqual(found["controller"], "LinuxCNC 2.9")
        self.assertAlmostEqual(found["spindle_rpm"], operation.ToolController.SpindleSpeed)
        self.assertAlmostEqual(found["pitch_mm"], operation.Spacing.Value * 2)

    def test_another_controller_is_refused(self):
        job, operation = self.calibrate()
        patchmill.recompute(operation)
        patchmill.post(job, self.path("a.ngc"))
        self.say(controller_version="LinuxCNC 2.10")
        patchmill.recompute(operation)
        error = self.assert_refused("Machine", patchmill.post, job, self.path("b.ngc"))
        self.assertIn("LinuxCNC 2.9", error.remedy)
        self.assertFalse(os.path.exists(self.path("b.ngc")))
        # a start phase of 0 has nothing to lose, and one that nobody calibrated says nothing
        self.say(start_phase_degrees=0.0)
        patchmill.recompute(operation)
        patchmill.post(job, self.path("c.ngc"))

    def test_one_that_was_counted_from_elsewhere_is_refused(self):
        job, operation = self.calibrate()
        found = dict(machines.load(KEY).data["calibration"])
        self.assertEqual(found.pop("counted_from"), "index")
        self.say(calibration=found)
        patchmill.recompute(operation)
        error = self.assert_refused("Machine", patchmill.post, job, self.path("a.ngc"))
        self.assertIn("anew", error.remedy)

    def test_it_holds_at_another_speed_and_on_another_texture(self):
        """Counted from the index, every program's own start phase is taken off by the motion model."""
        job, operation = self.calibrate()
        start = machines.load(KEY).start_phase
        for rpm, spacing, origin in ((1000, 0.5, "at speed"), (800, 0.45, "at speed"), (800, 0.5, "index")):
            self.say(lock_origin=origin)
            operation.ToolController.SpindleSpeed, operation.Spacing = rpm, spacing
            plan = patchmill.recompute(operation)
            left = core.own_start_phase(
                plan.path, plan.dimples, plan.rule, plan.machine.model, origin == "index"
            )
            period = core.phase_period(plan.input.tool.flutes, plan.rule)
            off = (left + start + 0.5 * period) % period - 0.5 * period
            self.assertLess(abs(math.degrees(off)), 1.0, (rpm, spacing, origin))
            patchmill.post(job, self.path("a.ngc"))


class MachineFile(unittest.TestCase):
    def test_what_a_file_may_say(self):
        good = machines.load(KEY).data
        wrong = {"lock_origin": "soon", "calibration": {"controller": "x"}, "controller_version": 2.9}
        for words in [{word: value} for word, value in wrong.items()]:
            with self.assertRaises(patchmill.InputError):
                machines.checked(json.dumps(dict(good, **words)), "x")


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
