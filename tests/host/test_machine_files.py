"""Machine files: every shipped one is sound and can point its tool, and what is wrong in a bad one is named
by its place.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import copy
import json
import math
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from patchmill.machine import machines  # noqa: E402

KINDS = {
    "table-table-ac": ("CA", ["table", "table"]),
    "table-table-bc": ("CB", ["table", "table"]),
    "head-head-ca": ("CA", ["head", "head"]),
    "head-table-bc": ("CB", ["table", "head"]),
    "nutating-table-bc-45": ("CB", ["table", "table"]),
    "nutating-head-bc-45": ("CB", ["table", "head"]),
    "linuxcnc-mill": ("", []),
    "open-loop-mill": ("", []),
    "haas-mill": ("", []),
}


class ShippedFiles(unittest.TestCase):
    def test_every_kind_is_there(self):
        self.assertLessEqual(set(KINDS), set(machines.names()))
        for key, (letters, sides) in KINDS.items():
            machine = machines.load(key)
            self.assertEqual(machine.rotary_letters, letters)
            self.assertEqual([a["side"] for a in machine.data.get("rotary_axes", [])], sides)

    def test_each_points_its_tool(self):
        generator = random.Random(5)
        for key, (letters, _) in KINDS.items():
            kinematics = machines.load(key).kinematics
            reached = 0
            for _ in range(200 if letters else 0):
                tilt, turn = generator.uniform(0, math.radians(29)), generator.uniform(-math.pi, math.pi)
                axis = (math.sin(tilt) * math.cos(turn), math.sin(tilt) * math.sin(turn), math.cos(tilt))
                for joints in kinematics.solve_axis(axis):
                    self.assertLess(np.linalg.norm(kinematics.tool_axis(joints) - axis), 1e-12)
                    reached += 1
                plan = patchmill_core().plan_joints(kinematics, np.array([axis]), np.array([True]))
                self.assertTrue(plan["complete"], (key, plan["reason"]))
            self.assertTrue(reached == 400 or not letters, key)


def patchmill_core():
    import _patchmill

    return _patchmill


class BadFiles(unittest.TestCase):
    def setUp(self):
        self.good = machines.load("table-table-ac").data

    def refused(self, place, change, remedy=""):
        data = copy.deepcopy(self.good)
        change(data)
        with self.assertRaises(patchmill.InputError) as caught:
            machines.checked(json.dumps(data), "mine")
        print(caught.exception)
        self.assertEqual(caught.exception.property, "Machine file mine: " + place)
        self.assertIn(remedy, caught.exception.remedy)

    def test_the_good_one_is_good(self):
        self.assertEqual(machines.checked(json.dumps(self.good), "mine"), self.good)

    def test_missing_axis(self):
        self.refused("/rotary_axes", lambda d: d["rotary_axes"].pop(0), "axis C of XYZAC is missing")
        self.refused("/rotary_axes", lambda d: d.pop("rotary_axes"), "axis A of XYZAC is missing")
        self.refused("/rotary_axes/0", lambda d: d.update(axes="XYZA"), "XYZA")

    def test_missing_word(self):
        self.refused("/rotary_axes/1/direction", lambda d: d["rotary_axes"][1].pop("direction"), "give it")
        self.refused("/controller/dialect", lambda d: d["controller"].pop("dialect"))
        self.refused("/linear_axes", lambda d: d.pop("linear_axes"))

    def test_parallel_axes(self):
        def parallel(d):
            d["rotary_axes"][0]["direction"] = [-2, 0, 0]

        def wrong_way_round(d):
            d["rotary_axes"].reverse()

        self.refused("/rotary_axes/1/direction", parallel, "parallel")
        self.refused("/rotary_axes/1/direction", wrong_way_round, "chain order")
        self.refused("/rotary_axes/0/direction", lambda d: d["rotary_axes"][0].update(direction=[0, 0, 0]))

    def test_wrong_unit(self):
        def per_minute(d):
            d["linear_axes"]["velocity_mm_min"] = d["linear_axes"].pop("velocity_mm_s")

        def in_radians(d):
            d["rotary_axes"][1]["limits_radians"] = d["rotary_axes"][1].pop("limits_degrees")

        self.refused("/linear_axes/velocity_mm_min", per_minute, "the word is velocity_mm_s")
        self.refused("/rotary_axes/1/limits_radians", in_radians, "the word is limits_degrees")
        text = {"velocity_deg_s": "90"}
        self.refused("/rotary_axes/0/velocity_deg_s", lambda d: d["rotary_axes"][0].update(text))

    def test_unknown_word(self):
        self.refused("/colour", lambda d: d.update(colour="red"), "unknown word")
        self.refused("/rotary_axes/0/colour", lambda d: d["rotary_axes"][0].update(colour=1), "unknown word")
        self.refused("/controller/dialect", lambda d: d["controller"].update(dialect="fanuk"), "fanuc")
        self.refused("/rotary_axes/0/side", lambda d: d["rotary_axes"][0].update(side="left"), "table, head")

    def test_wrong_values(self):
        self.refused("/rotary_axes/1/letter", lambda d: d["rotary_axes"][1].update(letter="C"))
        falling = {"limits_degrees": [30, -30]}
        self.refused("/rotary_axes/1/limits_degrees", lambda d: d["rotary_axes"][1].update(falling))
        self.refused("/rotary_axes/1/point_mm", lambda d: d["rotary_axes"][1].update(point_mm=[0, 0]))
        self.refused("/linear_axes/limits_mm/X", lambda d: d["linear_axes"]["limits_mm"].update(X=[1, "2"]))
        self.refused("/rotary_axes", lambda d: d.update(rotary_axes=3))
        self.refused("/decimals", lambda d: d.update(decimals=True))


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2, argv=["test"] + sys.argv[1:]).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
