"""LinuxCNC's own interpreter accepts the posted program of the paper's experiment, and its positions agree
with the plan to the last decimal.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from rs274 import interpret

ROOT = Path(__file__).resolve().parents[2]


def post_in_freecad(folder, decimals):
    """Posts the experiment; returns the program's name and the planned timed moves [mm]."""
    script = Path(folder) / "post.py"
    script.write_text(
        "import sys, json\n"
        "sys.path.insert(0, %r)\n"
        "import patchmill\n"
        "from recipe import STEP, run\n"
        "document, part = run.make_document(STEP)\n"
        "job, operation = run.make_job(part, %d)\n"
        "plan = patchmill.recompute(operation)\n"
        "patchmill.post(job, %r)\n"
        "timed = plan.path.kinds > 0\n"
        "json.dump(plan.path.tips[timed].tolist(), open(%r, 'w'))\n"
        % (str(ROOT / "tests" / "host"), decimals, folder + "/x.ngc", folder + "/plan.json")
    )
    subprocess.run([str(ROOT / "tools" / "freecad"), str(script)], check=True, capture_output=True)
    return folder + "/x.ngc", json.loads(Path(folder, "plan.json").read_text())


class Interpreter(unittest.TestCase):
    def check(self, decimals):
        with tempfile.TemporaryDirectory() as folder:
            program, plan = post_in_freecad(folder, decimals)
            calls = interpret(program)
            text = Path(program).read_text()
        feeds = [values[:3] for name, values in calls if name == "STRAIGHT_FEED"]
        self.assertGreater(len(feeds), 20000)
        self.assertEqual(len(feeds), len(plan))
        worst = max(abs(a - b) for f, p in zip(feeds, plan) for a, b in zip(f, p))
        self.assertLess(worst, 1e-9 + 0.1 * 10.0**-decimals)
        rates = {values[0] for name, values in calls if name == "SET_FEED_RATE"}
        self.assertEqual(rates - {0.0}, {434.413})
        names = [name for name, _ in calls]
        self.assertIn("START_SPINDLE_CLOCKWISE", names)
        self.assertLess(names.index("START_SPINDLE_CLOCKWISE"), names.index("STRAIGHT_FEED"))
        self.assertEqual(calls[[n for n, _ in calls].index("SET_SPINDLE_SPEED")][1][1], 1000.0)
        self.assertIn("M3 S1000", text)

    def test_three_decimals(self):
        self.check(3)

    def test_four_decimals(self):
        self.check(4)

    def test_the_interpreter_refuses_nonsense(self):
        with tempfile.TemporaryDirectory() as folder:
            bad = Path(folder) / "bad.ngc"
            bad.write_text("G1 X1 F\n")
            with self.assertRaises(RuntimeError):
                interpret(bad)


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
