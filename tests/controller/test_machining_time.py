"""The time that PatchMill says, which is FreeCAD's CycleTime and that of the program's header too, beside the
time that LinuxCNC takes: a texture locked to the spindle, one on five axes, and copy milling.

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

ROOT = Path(__file__).resolve().parents[2]
OFF = 0.03  # of the log's time
LIMITS = {"acceleration": 2000.0, "velocity": 100.0}
ROTARY = {"kinematics": "xyzac", "rotary_velocity": 60.0, "rotary_acceleration": 600.0}
SCRIPT = """
import json, os, sys
sys.path.insert(0, %(tests)r)
os.environ["PATCHMILL_MACHINES"] = %(folder)r
import FreeCAD
import Part
import _patchmill as core
import patchmill
from milling_jobs import make_job
from patchmill.machine import machines
from recipe import STEP, run
from test_axis_field import textured_job

def simulated(key, **rotary):
    data = dict(machines.load(key).data)
    limits = dict(acceleration_mm_s2=%(acceleration)r, velocity_mm_s=%(velocity)r)
    data["linear_axes"] = dict(data["linear_axes"], **limits)
    if rotary:
        data["rotary_axes"] = [dict(axis, **rotary) for axis in data["rotary_axes"]]
    json.dump(data, open(os.path.join(%(folder)r, "simulated.json"), "w"))

def texture():
    document, part = run.make_document(STEP)
    job, op = run.make_job(part, 4)
    op.PatchSide, op.PatchesX, op.PatchesY = 12, 2, 2
    op.Machine, op.SameFlute, op.ExtraTurns = "simulated", False, 0.0
    op.PostUnheld = op.PostGouging = True
    return job, op

def locked():
    simulated("linuxcnc-mill")
    job, op = texture()
    op.Strategy = "Spindle-locked"
    return job, op

def five_axes():
    simulated("table-table-ac", velocity_deg_s=60.0, acceleration_deg_s2=600.0)
    job, op = textured_job()
    op.Strategy, op.SameFlute, op.ExtraTurns, op.RowTolerance = "Spindle-locked", False, 0.0, 6.0
    op.Machine = "simulated"
    return job, op

def copy():
    box = Part.makeBox(40, 30, 20, FreeCAD.Vector(-5, -5, 0))
    box.rotate(FreeCAD.Vector(), FreeCAD.Vector(0, 1, 0), -10)
    box.translate(FreeCAD.Vector(0, 0, 6))
    _, job = make_job(Part.makeBox(30, 20, 10).cut(box), ball=True)
    op = patchmill.CopyMilling.Create("Copy", parentJob=job)
    op.RadialDepth = op.AxialDepth = 4.0
    return job, op

def on_machine():
    simulated("linuxcnc-mill")
    job, op = copy()
    op.Machine, op.Mode = "simulated", "Contour"
    op.ToolController.HorizFeed = op.ToolController.VertFeed = "1500 mm/min"
    return job, op

makers = {"locked": locked, "five axes": five_axes, "copy": copy, "copy on its machine": on_machine}
job, op = makers[%(case)r]()
patchmill.recompute(op)
patchmill.post(job, %(folder)r + "/x.ngc", "patchmill_linuxcnc", "--precision=4")
text = open(%(folder)r + "/x.ngc").read()
sections = core.read_gcode(text, core.BallEndMill(1.0, 2), "linuxcnc", rotary=True)
section = max(sections, key=lambda s: len(s.lines))
path = op.Proxy.path if %(case)r.startswith("copy") else op.Proxy.planned.path
lines = list(section.lines)[-len(path):]
if tuple(path.tips[0]) == tuple(path.start):  # the way there is no move of the path
    lines = lines[1:]
turn = [k for k, line in enumerate(text.splitlines(), 1) if line.startswith("G0 A") and k < lines[0]]
found = {"seconds": op.MachiningTime, "clock": op.CycleTime, "lines": turn + lines, "moves": len(path) - 1}
json.dump(found, open(%(folder)r + "/x.json", "w"))
"""


class MachiningTime(unittest.TestCase):
    @load.told_from_load
    def check(self, case, acceleration=LIMITS["acceleration"], **machine):
        limits = dict(LIMITS, acceleration=acceleration)
        with tempfile.TemporaryDirectory(prefix="patchmill-time-") as folder:
            script = Path(folder) / "post.py"
            values = {"tests": str(ROOT / "tests" / "host"), "folder": folder, "case": case} | limits
            script.write_text(SCRIPT % values)
            done = subprocess.run(
                [str(ROOT / "tools" / "freecad"), str(script)], capture_output=True, text=True
            )
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            found = json.loads(Path(folder, "x.json").read_text())
            log = controller.run(
                Path(folder) / "x.ngc", controller.Machine(**limits, **machine), stops=1000, limit=300.0
            )
        on_path = numpy.isin(log.line, found["lines"])
        still = numpy.all(numpy.diff(log.joints, axis=0) == 0.0, axis=1)
        if log.rotary is not None:
            still &= numpy.all(numpy.diff(log.rotary, axis=0) == 0.0, axis=1)
        took = 1e-3 * numpy.count_nonzero(on_path[1:] & ~still)
        off = found["seconds"] / took - 1.0
        self.assertGreaterEqual(len(found["lines"]), found["moves"])
        hours, minutes, seconds = map(int, found["clock"].split(":"))
        self.assertAlmostEqual(3600 * hours + 60 * minutes + seconds, found["seconds"], delta=0.5)
        said = case, found["seconds"], took, 100.0 * off
        print("%s: %.2f s said, %.2f s in LinuxCNC's log: %+.2f %%" % said)
        self.assertLessEqual(abs(off), OFF)

    def test_a_locked_texture(self):
        self.check("locked")

    def test_a_texture_on_five_axes(self):
        self.check("five axes", **ROTARY)

    def test_copy_milling(self):
        self.check("copy")

    def test_copy_milling_on_a_slow_machine(self):
        """Whose accelerations take a fifth of the time."""
        for acceleration in (300.0, 2000.0):
            self.check("copy on its machine", acceleration)


if __name__ == "__main__":
    load.main(verbosity=2)
