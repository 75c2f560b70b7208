"""Jobs and textures in one call each, and faces chosen by what they are.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import sys
import tempfile
import unittest

import FreeCAD
import Part
import patchmill

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from parts import WithDocuments  # noqa: E402

V = FreeCAD.Vector
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
STEP = os.path.join(ROOT, "Resources", "recipes", "xu2016", "block.step")


class Faces(unittest.TestCase):
    """On a box of 10 x 20 x 30 mm, whose faces are known, and on a cylinder."""

    def setUp(self):
        self.box = Part.makeBox(10, 20, 30)

    def only(self, choice):
        names = patchmill.faces(self.box, choice)
        self.assertEqual(len(names), 1)
        return self.box.getElement(names[0])

    def test_by_words(self):
        self.assertEqual(len(patchmill.faces(self.box, "all")), 6)
        self.assertAlmostEqual(self.only("top").CenterOfMass.z, 30.0)
        self.assertAlmostEqual(self.only("largest").Area, 600.0)

    def test_of_equals_the_first(self):
        self.assertEqual(patchmill.faces(self.box, "largest"), ["Face1"])

    def test_by_normal_outward(self):
        self.assertAlmostEqual(self.only({"normal": [0, 0, -1]}).CenterOfMass.z, 0.0)
        self.assertEqual(len(patchmill.faces(self.box, {"normal": [1, 1, 0], "within": 50})), 2)
        moved = self.box.copy()
        moved.rotate(V(1, 2, 3), V(1, 0, 0), 90)
        self.assertEqual(
            patchmill.faces(moved, {"normal": [0, -1, 0]}),
            patchmill.faces(self.box, {"normal": [0, 0, 1]}),
        )

    def test_nearest(self):
        self.assertAlmostEqual(self.only({"nearest": [5, -3, 15]}).CenterOfMass.y, 0.0)

    def test_free_form(self):
        block = Part.read(STEP)
        (name,) = patchmill.faces(block, "largest free-form")
        self.assertIn(type(block.getElement(name).Surface).__name__, ("BSplineSurface", "BezierSurface"))

    def test_refused_by_name(self):
        for choice in (
            "Face7", "biggest", "largest free-form", [], ["Face0"], [1], None, 3, {}, {"normal": [0, 0, 0]},
            {"normal": [1, 2]}, {"normal": [0, 0, float("nan")]}, {"nearest": "abc"}, {"names": []},
            {"normal": [0, 0, 1], "within": 0}, {"normal": [0, 0, 1], "nearest": [0, 0, 0]},
        ):  # fmt: skip
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.faces(self.box, choice)
            self.assertEqual(caught.exception.property, "Faces", choice)


class Jobs(WithDocuments):
    def test_from_a_file_to_a_program(self):
        job = patchmill.job(STEP, tool={"diameter": 2, "flutes": 2, "speed": 1000, "feed": 434.413})
        op = patchmill.texture(
            job, "largest free-form", PatchSide=4, PatchesX=2, PatchesY=2, Rotation=10
        )
        plan = patchmill.recompute(op)
        self.assertEqual(plan.counts["cut"], 64)
        with tempfile.TemporaryDirectory() as folder:
            posted = patchmill.post(job, os.path.join(folder, "x.ngc"))
        self.assertEqual(posted[0].path.statistics()["dimples"], 64)

    def test_the_machine_goes_into_its_textures(self):
        job = patchmill.job(STEP, machine="linuxcnc-mill", offset="G55")
        op = patchmill.texture(job, "top")
        self.assertEqual((op.Machine, list(job.Fixtures)), ("linuxcnc-mill", ["G55"]))

    def test_refused_by_name(self):
        for name, value in (
            ("tool", {"diameter": -1}), ("tool", {"flutes": 2.5}), ("tool", {"teeth": 2}),
            ("tool", {"speed": True}),
            ("machine", "no-such"), ("offset", "G53"), ("post", "no_such"),
        ):  # fmt: skip
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.job(STEP, **{name: value})
            self.assertEqual(caught.exception.property.lower(), name, value)
        for part in ("none.step", __file__):
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.job(part)
            self.assertEqual(caught.exception.property, "part")
        job = patchmill.job(STEP)
        for kind, properties, name in (
            ("Round", {}, "kind"), ("Curved", {"Spacinng": 1}, "Spacinng"),
            ("Curved", {"Spacing": "wide"}, "Spacing"),
            ("Curved", {"Strategy": "Magic"}, "Strategy"), ("Curved", {"Direction": 5}, "Direction"),
        ):  # fmt: skip
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.texture(job, "top", kind, **properties)
            self.assertEqual(caught.exception.property, name)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
