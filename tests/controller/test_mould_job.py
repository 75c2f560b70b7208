"""The mould maker's job of several operations, tools and work offsets through LinuxCNC: its interpreter takes
every block, and its planner, with a tilting and a turning table, runs the program to its end and meets each
dimple of each work offset.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
from harness import controller, load  # noqa: E402
from rs274 import interpret  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
OURS, THEIRS = "ours.ngc", "freecad.ngc"
OFFSETS = {"G55": (60.0, -20.0, 5.0)}  # mm; G54 is zero
MISS = 0.02  # mm that the tool may stay from a dimple, by the log's samples
SCRIPT = """
import json, sys
sys.path.insert(0, %(tests)r)
import patchmill
from mould_job import mould_job
job, _ = mould_job("table-table-ac", "Feed per move", 4, ("G54",))
patchmill.post(job, %(folder)r + "/freecad.ngc", "linuxcnc")
job, textures = mould_job("table-table-ac", "Spindle-locked", 4, ("G54", "G55"))
posted = patchmill.post(job, %(folder)r + "/ours.ngc", "patchmill_linuxcnc")
posted = [one for one in posted if one.operation in textures]
found = [[one.offset, one.path.tips[one.path.dimples >= 0].tolist()] for one in posted]
json.dump(found, open(%(folder)r + "/dimples.json", "w"))
"""


def _distance(way, point):
    """From `point` to the nearest of `way`, which rises in X; inf if none is as near as MISS."""
    first, last = numpy.searchsorted(way[:, 0], (point[0] - MISS, point[0] + MISS))
    return numpy.linalg.norm(way[first:last] - point, axis=1).min(initial=numpy.inf)


class MouldJob(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="patchmill-mould-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        script = cls.folder / "post.py"
        script.write_text(SCRIPT % {"tests": str(ROOT / "tests" / "host"), "folder": folder.name})
        command = [str(ROOT / "tools" / "freecad"), str(script)]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout + done.stderr

    def test_the_interpreter_takes_every_block(self):
        for name, offsets in ((OURS, 2), (THEIRS, 1)):
            text = (self.folder / name).read_text()
            words = self.folder / "words.ngc"  # without those of a configuration, which rs274 alone has not
            words.write_text(text.replace("M428", "").replace("M429", ""))
            calls = interpret(words, tools=(1, 2, 3))
            names = [called for called, _ in calls]
            self.assertIn("PROGRAM_END", names)
            changes = [v[0] for called, v in calls if called == "CHANGE_TOOL"]
            self.assertEqual(len(changes), 4 * offsets)
            self.assertGreater(names.count("STRAIGHT_FEED"), 500 * offsets)
            self.assertGreater(names.count("ARC_FEED"), 5 * offsets)

    @load.told_from_load
    def test_the_planner_runs_it_to_its_end(self):
        program = self.folder / OURS
        lines = program.read_text().splitlines()
        machine = controller.Machine(
            kinematics="xyzac", rotary_velocity=60.0, rotary_acceleration=600.0, offsets=OFFSETS
        )
        log = controller.run(program, machine, rate=80.0, stops=10**6, limit=300.0)
        last = max(k for k, line in enumerate(lines, 1) if line.startswith("G1 "))
        self.assertGreaterEqual(log.line.max(), last)
        tilted = numpy.abs(log.rotary).max(axis=0)
        self.assertGreater(tilted[0], 5.0)
        self.assertLess(numpy.abs(log.rotary[-1]).max(), 1e-6)
        self.assert_each_dimple_is_met(log, lines.index("G55") + 1)
        print("%d lines in %.0f s, axes up to %s degrees" % (len(lines), log.time[-1], tilted.round(2)))

    def assert_each_dimple_is_met(self, log, second):
        """`second`: number of the line where the second work offset begins."""
        for offset, dimples in json.loads((self.folder / "dimples.json").read_text()):
            way = log.tip[(log.line > second) == (offset == "G55")] - OFFSETS.get(offset, (0.0, 0.0, 0.0))
            way = way[numpy.argsort(way[:, 0])]
            miss = max(_distance(way, dimple) for dimple in numpy.array(dimples))
            print("%s: %d dimples, missed by %.4f mm at most" % (offset, len(dimples), miss))
            self.assertGreater(len(dimples), 200)
            self.assertLess(miss, MISS)


if __name__ == "__main__":
    load.main(verbosity=2)
