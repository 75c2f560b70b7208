"""The macros that users copy, each run as they run it, on parts of which the result is known.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import re
import shutil
import struct
import subprocess
import sys
import unittest
import zlib

from batch_calls import MODULE, RECIPE, STEP, WithFolder, call  # first: it finds the module

MAKE_FAMILY = """
import FreeCAD, sys
document = FreeCAD.newDocument("family")
sizes = document.addObject("Spreadsheet::Sheet", "Sizes")
sizes.set("A1", "20"); sizes.setAlias("A1", "Length")
sizes.set("A2", "12"); sizes.setAlias("A2", "Width")
document.recompute()
box = document.addObject("Part::Box", "Box")
box.setExpression("Length", "Sizes.Length * 1 mm"); box.setExpression("Width", "Sizes.Width * 1 mm")
box.Placement.Rotation = FreeCAD.Rotation(FreeCAD.Vector(0, 1, 0), 30)  # a slope: on flats the tip rubs
family = document.addObject("Spreadsheet::Sheet", "Family")
for row, cells in enumerate((("Name", "Length", "Width"), ("small", "10", "10"), ("large", "20", "10"))):
    for column, text in zip("ABC", cells):
        family.set("%s%d" % (column, row + 1), text)
document.recompute()
document.saveAs(sys.argv[1])
"""


def grey_png(filename, rows):
    """Writes rows of grey values, 0 to 255, as a PNG."""

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    raw = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    with open(filename, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", raw) + chunk(b"IEND", b""))


class Macros(WithFolder):
    def setUp(self):
        super().setUp()
        self.assertEqual(call("examples", "macros", self.path("macros"))[0], 0)

    def macro(self, name, *arguments, status=0):
        """What a macro of the copied folder printed."""
        environment = dict(os.environ, PYTHONPATH=MODULE, FREECAD_USER_HOME=self.path("home"))
        os.makedirs(self.path("home"), exist_ok=True)
        words = [sys.executable, "-m", "patchmill", "macro", self.path("macros", name), *arguments]
        done = subprocess.run(words, env=environment, capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout

    def test_all_are_run_here(self):
        with open(__file__, encoding="utf-8") as file:
            run = set(re.findall(r'self\.macro\(\s*"(\w+\.py)"', file.read()))
        self.assertEqual(set(os.listdir(self.path("macros"))) - run, set())

    def test_a_folder_of_step_files(self):
        os.mkdir(self.path("parts"))
        shutil.copy(STEP, self.path("parts", "a.step"))
        with open(self.path("parts", "broken.stp"), "w") as file:
            file.write("no part")
        said = self.macro("folder_of_step_files.py", self.path("parts"), self.path("out"), status=1)
        self.assertRegex(said, r"(?m)^a\.step: \d+ dimples$")
        self.assertRegex(said, r"(?m)^broken\.stp: part = ")
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["a-report", "a.ngc"])

    def test_sweep(self):
        said = self.macro("sweep.py", STEP, self.path("out"))
        rows = re.findall(r"(?m)^ +(0\.\d+) +(0\.\d+) +(\d+) +([\d.]+) mm", said)
        tried = [(float(r[0]), float(r[1])) for r in rows]
        self.assertEqual(tried, [(0.6, 0.01), (0.6, 0.02), (0.8, 0.01), (0.8, 0.02)])
        self.assertEqual([int(r[2]) for r in rows], [36] * 4)
        self.assertEqual(len(os.listdir(self.path("out"))), 4)

    def test_logo(self):
        """A picture and its negative leave out all of the face between them, and at most one row twice."""
        masked = []
        for name, row in (("left", [0] * 8 + [255] * 8), ("right", [255] * 8 + [0] * 8)):
            grey_png(self.path(name + ".png"), [row] * 16)
            said = self.macro("logo.py", STEP, self.path(name + ".png"), self.path(name))
            counts = {word: int(n) for word, n in re.findall(r"(?m)^([a-z ]+?) +(\d+)$", said)}
            side = round(sum(counts.values()) ** 0.5)
            self.assertEqual(side**2, sum(counts.values()))
            self.assertGreater(counts["cut"], 0.3 * side**2)
            masked.append(counts["masked"])
        twice = sum(masked) - (side**2 - counts["off the face"])
        self.assertGreaterEqual(twice, 0)
        self.assertLessEqual(twice, side)

    def test_calibration(self):
        recipe = json.loads(json.dumps(RECIPE))
        self.macro("calibration.py", self.write(recipe), STEP, self.path("out"), status=2)
        recipe.update(machine="linuxcnc-mill", post="patchmill_linuxcnc")
        recipe["operations"][0]["properties"] = {
            "Spacing": 0.5,
            "Strategy": "Spindle-locked",
            "ExtraTurns": 0,
            "SameFlute": False,
        }
        name = self.write(recipe)
        said = self.macro("calibration.py", name, STEP, self.path("out"))
        self.assertIn("dimples, each 1 degrees later", said)
        self.assertTrue(os.path.isfile(self.path("out", "calibration.ngc")))
        said = self.macro("calibration.py", name, STEP, self.path("out"), "57")
        self.assertIn("start phase 123.0 degrees, stored with linuxcnc-mill", said)  # 180 - 57

    def test_strategies(self):
        said = self.macro("strategies.py", STEP, "linuxcnc-mill")
        for name in ("Constant feed", "Feed per move", "Spindle-locked"):
            self.assertRegex(said, r"(?m)^%s " % name)

    def test_family(self):
        with open(self.path("make.py"), "w") as file:
            file.write(MAKE_FAMILY)
        shutil.copy(self.path("make.py"), self.path("macros", "make.py"))
        self.macro("make.py", self.path("family.FCStd"))
        said = self.macro("family.py", self.path("family.FCStd"), self.path("out"))
        small, large = (int(n) for n in re.findall(r": (\d+) dimples", said))
        self.assertGreater(large, 1.5 * small)
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["large.ngc", "small.ngc"])


if __name__ == "__main__":
    unittest.main()
