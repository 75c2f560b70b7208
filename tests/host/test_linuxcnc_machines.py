"""Machine files from LinuxCNC configurations: those that the controller tests run, where the tool's tip is by
LinuxCNC's own formulas; and what a configuration may say otherwise.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import random
import shutil
import sys
import tempfile
import unittest

import numpy as np
from _patchmill import InputError
from patchmill.machine import machines
from patchmill.machine.linuxcnc import machine_of

HERE = os.path.dirname(os.path.abspath(__file__))
HARNESS = os.path.join(os.path.dirname(HERE), "controller")
sys.path.insert(0, HARNESS)

from harness import controller, table  # noqa: E402

MILL = """
# a mill in inches
[EMC]
MACHINE = Old mill
[EMCMOT]
SERVO_PERIOD = 500000
[TRAJ]
COORDINATES = X Y Y Z
LINEAR_UNITS = inch
MAX_LINEAR_VELOCITY = 4
[KINS]
KINEMATICS = trivkins coordinates=XYYZ kinstype=both
#INCLUDE axes.inc
[HAL]
HALFILE = mill.hal
HALCMD = net turns => spindle.0.revs
"""
AXES = """
[AXIS_X]
MIN_LIMIT = -1
MAX_LIMIT = 10
MAX_VELOCITY = 5
MAX_ACCELERATION = 20
[AXIS_Y]
MAX_VELOCITY = 5
MAX_ACCELERATION = 30
MAX_LIMIT = 6
[AXIS_Z]
MIN_LIMIT = -4
MAX_LIMIT = 0
MAX_VELOCITY = 6
MAX_ACCELERATION = 40
[JOINT_2]
MAX_ACCELERATION = 10
[JOINT_3]
MIN_LIMIT = -3.5
"""
HAL = """
# net commented spindle.0.index-enable encoder.0.index-enable
net turns encoder.0.position
net index spindle.0.index-enable <=> encoder.0.index-enable
"""


class OfTheHarness(unittest.TestCase):
    """The configurations that the controller tests really run."""

    def read(self, kinematics, **limits):
        with tempfile.TemporaryDirectory() as folder:
            text = controller.ini(controller.Machine(kinematics=kinematics, **limits))
            for name in ("machine.hal", "rotary.hal"):
                shutil.copy(os.path.join(HARNESS, "harness", name), folder)
            name = os.path.join(folder, "machine.ini")
            with open(name, "w", encoding="utf-8") as file:
                file.write(text)
            return machine_of.read(name)

    def test_three_axes_with_an_encoder(self):
        found = self.read("xyz", acceleration=1234.0, velocity=77.0, travel=400.0, period=5e-4)
        machine = machines.Machine("mine", machines.checked(json.dumps(found.data), "mine"))
        self.assertEqual(machine.data["linear_axes"]["velocity_mm_s"], 77.0)
        self.assertEqual(machine.model.acceleration, 1234.0)
        self.assertTrue(machine.model.spindle_lock)
        self.assertAlmostEqual(machine.data["servo_period_s"], 5e-4)
        self.assertEqual(machine.data["linear_axes"]["limits_mm"], {c: [-400.0, 400.0] for c in "XYZ"})
        self.assertEqual(machine.rotary_letters, "")

    def test_tables_put_the_tip_where_linuxcnc_does(self):
        generator = np.random.default_rng(3)
        for kinematics in ("xyzac", "xyzbc"):
            found = self.read(kinematics, rotary_velocity=120.0)
            data = machines.checked(json.dumps(found.data), "mine")
            machine = machines.Machine("mine", data)
            self.assertEqual(machine.rotary_letters, "C" + kinematics[3].upper())
            self.assertEqual([a["velocity_deg_s"] for a in data["rotary_axes"]], [120.0, 120.0])
            self.assertEqual((machine.controller["tcp_on"], machine.controller["tcp_off"]), ("M428", "M429"))
            self.assertTrue(machine.controller["tcp"])
            for _ in range(20):
                linear = generator.uniform(-100.0, 100.0, 3)
                tilt, turn = generator.uniform(-90.0, 90.0), generator.uniform(-180.0, 180.0)
                theirs = table.tip_in_work(kinematics, linear[None], np.array([[tilt, turn]]))[0]
                joints = np.radians([turn, tilt]).reshape(2, 1)
                ours = machine.kinematics.in_work_frame(linear, joints)
                np.testing.assert_allclose(ours, theirs, atol=1e-9)


class Said(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def read(self, ini=MILL, axes=AXES, hal=HAL):
        for name, text in (("mill.ini", ini), ("axes.inc", axes), ("mill.hal", hal)):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        found = machine_of.read(os.path.join(self.folder, "mill.ini"))
        machines.checked(json.dumps(found.data), "mill")
        return found

    def test_inches_includes_and_two_joints_of_an_axis(self):
        found = self.read()
        axes = found.data["linear_axes"]
        self.assertEqual(found.data["name"], "Old mill")
        self.assertAlmostEqual(axes["velocity_mm_s"], 4 * 25.4)  # the path's
        self.assertAlmostEqual(axes["acceleration_mm_s2"], 10 * 25.4)  # of Y's second joint
        self.assertEqual(sorted(axes["limits_mm"]), ["X", "Z"])
        np.testing.assert_allclose(axes["limits_mm"]["Z"], [-3.5 * 25.4, 0.0])
        self.assertIsNone(axes["jerk_mm_s3"])
        self.assertTrue(found.data["spindle_lock"])
        self.assertIn("MAX_ACCELERATION differs (X 508, Y 254, Z 1016 mm/s²)", "\n".join(found.remarks))

    def test_an_encoder_is_what_both_pins_are_joined_to(self):
        for hal in (HAL.replace("net index", "# net index"), HAL.replace("<=> encoder.0.index-enable", "")):
            found = self.read(hal=hal)
            self.assertFalse(found.data["spindle_lock"])
            self.assertIn("spindle.0.index-enable", "\n".join(found.remarks))
        found = self.read(ini=MILL.replace("mill.hal", "LIB:basic_sim.tcl"))
        self.assertFalse(found.data["spindle_lock"])
        self.assertIn("Not read: LIB:basic_sim.tcl", "\n".join(found.remarks))

    def test_jerk_counts_where_the_planner_heeds_it(self):
        for kind, jerk, expected in ((1, 100, 2540.0), (0, 100, None), (1, 0.5, None)):
            lines = "[TRAJ]\nPLANNER_TYPE = %d\nMAX_LINEAR_JERK = %g\n" % (kind, jerk)
            axes = self.read(ini=MILL + lines).data["linear_axes"]
            self.assertEqual(axes["jerk_mm_s3"], expected)

    def test_what_is_missing_or_strange_is_named(self):
        turning = MILL.replace("trivkins", "genhexkins")
        for ini, axes, named in (
            (turning, AXES, "[KINS]KINEMATICS"),
            (MILL.replace("= inch", "= furlong"), AXES, "[TRAJ]LINEAR_UNITS"),
            (MILL, AXES.replace("MAX_VELOCITY = 6", "MAX_VELOCITY = fast"), "[AXIS_Z]MAX_VELOCITY"),
            (MILL, AXES.replace("MAX_VELOCITY = 6", ""), "[AXIS_Z]MAX_VELOCITY"),
            (MILL.replace("axes.inc", "mill.ini"), AXES, "filename"),
            ("[EMC]\nMACHINE = x\n", AXES, "filename"),
        ):
            with self.assertRaises(InputError) as raised:
                self.read(ini, axes)
            self.assertIn(named, raised.exception.property)

    def test_a_rotary_axis_of_trivkins_is_left_out_and_said(self):
        found = self.read(ini=MILL.replace("=XYYZ", "=XYYZA"))
        self.assertEqual(found.data["axes"], "XYZ")
        self.assertTrue(any("rotary axis A" in remark for remark in found.remarks))

    def test_a_key_is_free_and_can_be_a_files_name(self):
        for text, key in (("shop mill", "shop-mill"), ("../x", "x"), ("", "machine"), ("é", "machine")):
            self.assertEqual(machines.free_key(text), key)
        self.assertEqual(machines.free_key("linuxcnc-mill"), "linuxcnc-mill-2")

    def test_no_text_leads_to_anything_but_a_machine_or_a_sentence(self):
        generator = random.Random(15)
        lines = (MILL + AXES).splitlines()
        for _ in range(400):
            spoilt = list(lines)
            for _ in range(generator.randrange(1, 4)):
                number = generator.randrange(len(spoilt))
                strange = ["", "[", "= =", "MAX_LIMIT = 1e400", "[TRAJ]", "HALFILE =", "[HAL]"]
                spoilt[number] = generator.choice([*strange, spoilt[number][: generator.randrange(9)]])
            try:
                self.read("\n".join(spoilt), "")
            except InputError as error:
                self.assertTrue(error.remedy)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2, argv=["test"] + sys.argv[1:]).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
