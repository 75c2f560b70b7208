"""Spindle-locked programs as FreeCAD posts them with PatchMill's own post, through LinuxCNC's planner:
from the STEP file to the phase at each dimple. The machine file's limits are the simulated machine's.

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
from harness import controller, load, phase  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
# acceleration -> bounds of the phase error, rms and largest [degrees], and of turns per dimple
BOUNDS = {2000: (2.0, 6.0, 0.9), 10000: (1.5, 4.0, 0.7)}
# moments at which the program itself lets the motion queue run empty: tool change, its end
STOPS = 3
SCRIPT = """
import json, os, sys
sys.path.insert(0, %(tests)r)
os.environ["PATCHMILL_MACHINES"] = %(folder)r
import numpy as np
import _patchmill as core
import patchmill
from patchmill.machine import machines
from recipe import STEP, run
data = dict(machines.load("linuxcnc-mill").data)
data["linear_axes"] = dict(data["linear_axes"])
data["linear_axes"].update(acceleration_mm_s2=%(acceleration)f, velocity_mm_s=%(velocity)f)
json.dump(data, open(os.path.join(%(folder)r, "simulated.json"), "w"))
document, part = run.make_document(STEP)
job, op = run.make_job(part, 4)
job.PostProcessor = "patchmill_linuxcnc"
job.PostProcessorArgs = "--precision=4"
op.PatchesX, op.PatchesY = %(patches)r
op.AutoOrigin = False
corner = -27.5
op.Origin = tuple(corner + (7.0 * n - 0.5) / 2.0 for n in %(patches)r) + (0,)
op.Strategy, op.Machine, op.SameFlute, op.ExtraTurns = "Spindle-locked", "simulated", False, 0.0
plan = patchmill.recompute(op)
posted = patchmill.post(job, %(folder)r + "/x.ngc")[0]
section = core.read_gcode(open(%(folder)r + "/x.ngc").read(), plan.input.tool)[-1]
core.match_plan(section.path, plan.path, 1e-6)
ends = np.flatnonzero(section.path.dimples >= 0)
number = section.path.dimples[ends]
n = plan.dimples.normals[number]
json.dump({"line": np.array(section.lines)[ends].tolist(), "tip": section.path.tips[ends].tolist(),
           "azimuth": np.degrees(np.arctan2(-n[:, 1], -n[:, 0])).tolist(),
           "patch": plan.dimples.patches[number].tolist(), "verdict": plan.pacing.verdict.holding,
           "counts": plan.counts}, open(%(folder)r + "/targets.json", "w"))
"""


class PostedSpindleLocked(unittest.TestCase):
    def run_case(self, acceleration, velocity, patches):
        with tempfile.TemporaryDirectory(prefix="patchmill-posted-") as folder:
            values = {
                "tests": str(ROOT / "tests" / "host"),
                "folder": folder,
                "acceleration": acceleration,
                "velocity": velocity,
                "patches": patches,
            }
            script = Path(folder) / "post.py"
            script.write_text(SCRIPT % values)
            done = subprocess.run(
                [str(ROOT / "tools" / "freecad"), str(script)], capture_output=True, text=True
            )
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            found = json.loads(Path(folder, "targets.json").read_text())
            machine = controller.Machine(acceleration=acceleration, velocity=velocity)
            log = controller.run(Path(folder) / "x.ngc", machine, stops=STOPS)
        targets = phase.Targets(*(numpy.array(found[k]) for k in ("line", "tip", "azimuth", "patch")))
        return found, phase.measure(log, targets, 2)

    @load.told_from_load
    def check(self, acceleration, velocity, patches):
        found, report = self.run_case(acceleration, velocity, patches)
        self.assertEqual(found["verdict"], "holds")
        self.assertEqual(found["counts"]["cut"], 196 * patches[0] * patches[1])
        rms, largest, turns = BOUNDS[acceleration]
        print(
            "%d mm/s², %d mm/s, %d x %d patches: rms %.2f°, largest %.2f°, %.2f turns a dimple"
            % (acceleration, velocity, *patches, report.rms, report.largest, report.turns_per_dimple)
        )
        self.assertLessEqual(report.rms, rms)
        self.assertLessEqual(report.largest, largest)
        self.assertLessEqual(report.turns_per_dimple, turns)
        self.assertLessEqual(report.miss.max(), 1e-3)

    def test_one_patch(self):
        for acceleration in BOUNDS:
            for velocity in (100, 300):
                with self.subTest(acceleration=acceleration, velocity=velocity):
                    self.check(acceleration, velocity, (1, 1))

    def test_four_patches_with_links(self):
        self.check(2000, 100, (2, 2))


if __name__ == "__main__":
    load.main(verbosity=2)
