"""A spindle-locked texture that was stopped and goes on from a patch, through LinuxCNC: the phase at each
dimple of the rest beside that of the whole program, from two logs, counted from the spindle's own index.

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
PERIOD = 180.0  # degrees: two flutes, any of them
FIRST = 3  # of four patches
# a lock begins at the first servo period after the index: 1 ms at 1000 rpm is 6 degrees
RMS, LARGEST = 6.0, 9.0
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
data["linear_axes"] = dict(data["linear_axes"], acceleration_mm_s2=2000.0, velocity_mm_s=100.0)
json.dump(data, open(os.path.join(%(folder)r, "simulated.json"), "w"))
document, part = run.make_document(STEP)
job, op = run.make_job(part, 4)
job.PostProcessor, job.PostProcessorArgs = "patchmill_linuxcnc", "--precision=4"
op.PatchSide, op.PatchesX, op.PatchesY = 8, 2, 2
op.Strategy, op.Machine, op.SameFlute, op.ExtraTurns = "Spindle-locked", "simulated", False, 0.0
op.PatchComments = True
def targets(name, first):
    op.FirstPatch = first
    plan = patchmill.recompute(op)
    patchmill.post(job, %(folder)r + "/" + name + ".ngc")
    section = core.read_gcode(open(%(folder)r + "/" + name + ".ngc").read(), plan.input.tool)[-1]
    core.match_plan(section.path, plan.path, 1e-6)
    ends = np.flatnonzero(section.path.dimples >= 0)
    number = section.path.dimples[ends]
    n = plan.dimples.normals[number]
    return {"line": np.array(section.lines)[ends].tolist(), "tip": section.path.tips[ends].tolist(),
            "azimuth": np.degrees(np.arctan2(-n[:, 1], -n[:, 0])).tolist(),
            "patch": plan.dimples.patches[number].tolist()}
found = {"whole": targets("whole", 1), "rest": targets("rest", %(first)d)}
op.FirstPatch = 1
patchmill.recompute(op)
patchmill.resume(job, %(first)d, %(folder)r + "/resumed.ngc")
same = [open(%(folder)r + "/" + name + ".ngc").read() for name in ("rest", "resumed")]
assert same[0] == same[1]
json.dump(found, open(%(folder)r + "/targets.json", "w"))
"""


class Resumed(unittest.TestCase):
    @load.told_from_load
    def test_the_phase_is_as_before(self):
        with tempfile.TemporaryDirectory(prefix="patchmill-resumed-") as folder:
            script = Path(folder) / "post.py"
            values = {"tests": str(ROOT / "tests" / "host"), "folder": folder, "first": FIRST}
            script.write_text(SCRIPT % values)
            done = subprocess.run(
                [str(ROOT / "tools" / "freecad"), str(script)], capture_output=True, text=True
            )
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            found = json.loads(Path(folder, "targets.json").read_text())
            machine = controller.Machine(acceleration=2000.0, velocity=100.0)
            raw, places = {}, {}
            for name, columns in found.items():
                log = controller.run(Path(folder) / (name + ".ngc"), machine, stops=STOPS)
                targets = phase.Targets(
                    *(numpy.array(columns[k]) for k in ("line", "tip", "azimuth", "patch"))
                )
                time, miss = phase.passing_times(log, targets)
                self.assertLessEqual(miss.max(), 2e-3)
                raw[name] = 360.0 * numpy.interp(time, log.time, log.turns) + targets.azimuth
                places[name] = targets.tip
        count = len(raw["rest"])
        self.assertEqual(2 * count, len(raw["whole"]))
        self.assertLess(numpy.abs(places["whole"][-count:] - places["rest"]).max(), 1e-9)
        off = phase.wrapped(raw["rest"] - raw["whole"][-count:], PERIOD)
        rms = float(numpy.sqrt(numpy.mean(off**2)))
        print(
            "%d dimples of the rest beside the whole: %.2f degrees rms, %.2f at most, %.2f on the average"
            % (count, rms, numpy.abs(off).max(), off.mean())
        )
        self.assertLessEqual(rms, RMS)
        self.assertLessEqual(numpy.abs(off).max(), LARGEST)


if __name__ == "__main__":
    load.main(verbosity=2)
