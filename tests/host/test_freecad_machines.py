"""Machine files from FreeCAD's own machines: what they say is taken over, what they do not say is told, and
what is wrong is named.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import copy
import json
import os
import sys
import tempfile
import unittest

import numpy as np
from patchmill import InputError
from patchmill.machine import freecad_file, machines


def axis(role, direction, low, high, velocity, parent=None):
    joint = {"origin": [0, 0, 5.0], "axis": direction}
    limits = {"min": low, "max": high}
    return {"role": role, "parent": parent, "joint": joint, "limits": limits, "max_velocity": velocity}


LINEAR = {
    "X": axis("table_linear", [1, 0, 0], 0, 510, 18000),
    "Y": axis("table_linear", [0, 1, 0], 0, 360, 18000),
    "Z": axis("head_linear", [0, 0, 1], -410, 0, 12000),
}
MILL = {
    "freecad_version": "1.2.0",
    "machine": {"name": "Shop mill", "units": "metric", "axes": LINEAR},
    "output": {"precision": {"axis": 4}},
    "postprocessor": {"file_name": "fanuc"},
    "version": 1,
}
TABLE = {
    "A": axis("table_rotary", [1, 0, 0], -110, 30, 3600),
    "C": axis("table_rotary", [0, 0, 1], -720, 720, 5400, parent="A"),
}
HEAD = {
    "B": axis("head_rotary", [0, 1, 0], -90, 90, 3600, parent="C"),
    "C": axis("head_rotary", [0, 0, 1], -720, 720, 5400),
}


class FreeCADMachines(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = os.path.join(folder.name, "mill.fcm")

    def read(self, content):
        with open(self.file, "w", encoding="utf-8") as file:
            file.write(content if isinstance(content, str) else json.dumps(content))
        return freecad_file.read(self.file)

    def with_axes(self, more):
        content = copy.deepcopy(MILL)
        content["machine"]["axes"].update(more)
        return content

    def test_a_mill_of_three_axes(self):
        found = self.read(MILL)
        machine = machines.Machine("mill", machines.checked(json.dumps(found.data), "mill"))
        self.assertEqual((machine.data["name"], machine.data["decimals"]), ("Shop mill", 4))
        self.assertEqual(machine.data["linear_axes"]["velocity_mm_s"], 200.0)
        self.assertEqual(machine.data["linear_axes"]["limits_mm"]["Z"], [-410, 0])
        self.assertEqual((machine.controller["dialect"], machine.rotary_letters), ("fanuc", ""))
        said = " ".join(found.remarks)
        for part in ("X 300, Y 300, Z 200", "500 mm/s²", "follow the spindle", "start phase"):
            self.assertIn(part, said)
        self.assertNotIn("°/s²", said)

    def test_a_table_turns_the_carried_axis_first(self):
        """At A = 90° what C turns about looks along Y, and the tool axis in the work frame with it."""
        found = self.read(self.with_axes(TABLE))
        machine = machines.Machine("mill", machines.checked(json.dumps(found.data), "mill"))
        self.assertEqual((machine.rotary_letters, machine.data["axes"]), ("CA", "XYZAC"))
        self.assertEqual(machine.data["rotary_axes"][0]["velocity_deg_s"], 90.0)
        self.assertEqual(machine.data["rotary_axes"][1]["limits_degrees"], [-110, 30])
        shipped = machines.load("table-table-ac").data["rotary_axes"]
        for ours, theirs in zip(machine.data["rotary_axes"], shipped):
            self.assertEqual((ours["letter"], ours["side"]), (theirs["letter"], theirs["side"]))
            np.testing.assert_array_equal(ours["direction"], theirs["direction"])
        self.assertIn("500°/s²", " ".join(found.remarks))
        self.assertNotIn("carries the other", " ".join(found.remarks))

    def test_a_head_turns_the_carrying_axis_first(self):
        found = self.read(self.with_axes(HEAD))
        self.assertEqual([a["letter"] for a in found.data["rotary_axes"]], ["C", "B"])
        self.assertEqual({a["side"] for a in found.data["rotary_axes"]}, {"head"})

    def test_an_order_that_is_not_said_is_told(self):
        free = {letter: dict(each, parent=None) for letter, each in TABLE.items()}
        self.assertIn("Which of A and C carries the other", " ".join(self.read(self.with_axes(free)).remarks))
        round_about = {"A": dict(TABLE["A"], parent="C"), "C": TABLE["C"]}
        self.assertEqual(len(self.read(self.with_axes(round_about)).data["rotary_axes"]), 2)

    def test_an_unknown_post_is_of_no_control_of_ours(self):
        found = self.read(dict(MILL, postprocessor={"file_name": "smoothie"}))
        self.assertEqual(found.data["controller"]["dialect"], "freecad")

    def test_what_is_wrong_is_named(self):
        bad = axis("table_linear", [1, 0, 0], 0, "far", 18000)
        three = self.with_axes({**TABLE, "B": axis("table_rotary", [0, 1, 0], -90, 90, 3600)})
        inches = copy.deepcopy(MILL)
        inches["machine"]["units"] = "imperial"
        for content, property, value in (
            ("{ not json", "filename", "mill.fcm"),
            ("[" * 100000, "filename", "mill.fcm"),
            ([], "filename", "mill.fcm"),
            ({"machine": {"axes": {}}}, "filename", "mill.fcm"),
            (inches, "units", "imperial"),
            (self.with_axes({"X": bad}), "filename", "X/limits/max"),
            (self.with_axes({"X": dict(LINEAR["X"], max_velocity=-5)}), "velocity_mm_s", "-0.08"),
            (self.with_axes({"A": dict(TABLE["A"], joint={})}), "direction", "null"),
            (three, "/", ""),
        ):
            with self.assertRaises(InputError) as caught:
                self.read(content)
            self.assertIn(property, caught.exception.property)
            self.assertIn(value, str(caught.exception.value))


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
