"""A stored start phase knows its controller, speed and pitch, and is not posted where it is another one.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import patchmill  # noqa: E402
from patchmill.machine import calibrated, machines  # noqa: E402
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

    def test_another_speed_is_refused_where_the_lag_differs(self):
        job, operation = self.calibrate()
        operation.ToolController.SpindleSpeed = 800
        patchmill.recompute(operation)
        self.assert_refused("SpindleSpeed", patchmill.post, job, self.path("a.ngc"))
        self.say(lock_origin="index")
        patchmill.recompute(operation)
        patchmill.post(job, self.path("a.ngc"))


class Lag(unittest.TestCase):
    def test_is_half_of_the_way_that_getting_to_speed_takes(self):
        """From rest to v = S K under a: t = v / a, and v t / 2 of way where v t had been asked for."""
        data = {"linear_axes": {"acceleration_mm_s2": 2000.0}}
        speed, pitch = 1000.0 / 60.0, 1.1
        velocity = speed * pitch
        asked, gone = speed * velocity / 2000.0, 0.5 * velocity**2 / 2000.0 / pitch
        self.assertAlmostEqual(calibrated.lag(data, 1000.0, pitch), 360.0 * (asked - gone), 9)
        self.assertEqual(calibrated.lag(dict(data, lock_origin="index"), 1000.0, pitch), 0.0)

    def test_what_a_file_may_say(self):
        good = machines.load(KEY).data
        wrong = {"lock_origin": "soon", "calibration": {"controller": "x"}, "controller_version": 2.9}
        for words in [{word: value} for word, value in wrong.items()]:
            with self.assertRaises(patchmill.InputError):
                machines.checked(json.dumps(dict(good, **words)), "x")


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
