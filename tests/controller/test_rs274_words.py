"""LinuxCNC's own interpreter accepts what the writer makes of other operations' words: arcs in all planes,
drilling cycles, machine coordinates, relative moves, outputs, and comments out of any label; and goes where
they say.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from rs274 import interpret

ROOT = Path(__file__).resolve().parents[2]
BEGIN = "M6 T1\nM3 S1000\nG0 X0 Y0 Z20\nG0 X1 Y0 Z5\n"
LABELS = ("abort, now", "py, x", "msg, hello", "debug, #1", "log", "LOGOPEN, x", "x" * 400, "a) (b", "50 % ;")


def written(texts):
    """What the core's writer makes of each text for LinuxCNC."""
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "write.py"
        script.write_text(
            "import json, _patchmill\n"
            "texts = json.loads(%r)\n"
            "made = [_patchmill.write_program([t], 'linuxcnc', precision=4) for t in texts]\n"
            "json.dump(made, open(%r, 'w'))\n" % (json.dumps(texts), folder + "/made.json")
        )
        subprocess.run([str(ROOT / "tools" / "freecad"), str(script)], check=True, capture_output=True)
        return json.loads(Path(folder, "made.json").read_text())


def run(program):
    with tempfile.TemporaryDirectory() as folder:
        name = Path(folder) / "x.ngc"
        name.write_text(program)
        return interpret(name)


class Words(unittest.TestCase):
    def test_arcs(self):
        arcs = ("G3 X0 Y1 Z5 I-1 J0 K0 F2", "G2 X0 Y1 Z4 I-1 J0 F2", "G18\nG2 X0 Y0 Z6 I-1 K0 F2\nG17",
                "G19\nG0 X1 Y1 Z5\nG3 X1 Y0 Z6 J-1 K0 F2\nG17", "G2 X1 Y0 I-1 J0 F2", "G3 X0 Y1 R1 F2")
        for arc, program in zip(arcs, written([BEGIN + arc + "\n" for arc in arcs])):
            calls = [values for name, values in run(program) if name == "ARC_FEED"]
            self.assertEqual(len(calls), 1, arc)
            rates = {values[0] for name, values in run(program) if name == "SET_FEED_RATE"}
            self.assertEqual(rates - {0.0}, {120.0}, arc)
        x, y, centre_x, centre_y = calls[0][:4]  # of the last: a quarter about the zero
        self.assertLess(math.hypot(x, y - 1.0) + math.hypot(centre_x, centre_y), 1e-3)

    def test_cycles(self):
        cycles = ("G98\nG81 X5 Y5 Z-3 R2 F1\nG81 X7 Y5 Z-3 R2 F1\nG80", "G99\nG82 X5 Y5 Z-3 R2 P0.5 F1\nG80",
                  "G98\nG83 X5 Y5 Z-3 R2 Q2 F1\nG80", "G98\nG73 X5 Y5 Z-3 R2 Q2 F1\nG80",
                  "G98\nG85 X5 Y5 Z-3 R2 F1\nG80", "G98\nG89 X5 Y5 Z-3 R2 P0.5 F1\nG80")
        for cycle, program in zip(cycles, written([BEGIN + cycle + "\n" for cycle in cycles])):
            calls = run(program)
            lowest = min(values[2] for name, values in calls if name == "STRAIGHT_FEED")
            self.assertAlmostEqual(lowest, -3.0, msg=cycle)
            waits = [values[0] for name, values in calls if name == "DWELL"]
            self.assertEqual(waits, [0.5] if "P0.5" in cycle else [], cycle)

    def test_other_words(self):
        words = ("G53 G0 Z0", "G91 G0 Z5\nG90", "M19 R45", "M62 P3", "M66 P0 L0", "M68 E0 Q2.5", "G43 H1")
        words += ("M8\nM9", "G4 P0.25", "G64 P0.02", "G61", "G55\nG0 X1 Y1 Z5", "G59.3\nG0 X1 Y1 Z5")
        words += ("M48", "M1", "S800")
        for word, program in zip(words, written([BEGIN + word + "\nG1 X3 F2\n" for word in words])):
            calls = run(program)
            self.assertIn("PROGRAM_END", [name for name, _ in calls], word)
        waits = [v[0] for n, v in run(written([BEGIN + "G4 P0.25\n"])[0]) if n == "DWELL"]
        self.assertEqual(waits, [0.25])

    def test_labels(self):
        plain = self.without_comments(run(written([BEGIN + "G1 X3 F2\n"])[0]), "no label")
        texts = ["%s(%s)\nG1 X3 F2\n" % (BEGIN, label) for label in LABELS]
        for label, program in zip(LABELS, written(texts)):
            self.assertEqual(self.without_comments(run(program), label), plain, label)

    def without_comments(self, calls, label):
        names = [name for name, _ in calls]
        self.assertFalse({"MESSAGE", "LOG"} & set(names), label)
        return [name for name in names if name != "COMMENT"]


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
