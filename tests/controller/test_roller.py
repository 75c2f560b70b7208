"""A roller milled all round along one thread, posted by FreeCAD, through LinuxCNC with a rotary axis A: where
each tooth passes by the logged joints and spindle, and so how far each dimple is from all its neighbours,
across every turn of the thread.

ROLLER_LENGTH [mm] and ROLLER_RPM make it a longer or faster run.
SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
from harness import controller, load  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
RADIUS, FLUTES = 20.0, 2
SETTLING = 20.0  # turns of the spindle: the lock is taken up beside the end of the cylinder
SCRIPT = """
import json, sys
sys.path.insert(0, %(tests)r)
import patchmill
from test_thread import roller
document, op = roller(length=%(length)r)
op.ToolController.SpindleSpeed = %(rpm)d
plan = patchmill.recompute(op)
job = document.getObject("Job")
job.PostProcessor, job.PostProcessorArgs = "patchmill_linuxcnc", "--precision=4"
patchmill.post(job, %(folder)r + "/roller.ngc")
found = plan.thread.lattice
json.dump({"spacing": plan.input.spacing, "neighbours": found.neighbours, "dimples": plan.counts["cut"],
           "turns": plan.thread.turns, "start": plan.thread.start.tolist(), "end": plan.thread.end.tolist(),
           "lead": plan.thread.lead, "angle": plan.thread.angle}, open(%(folder)r + "/roller.json", "w"))
"""


def posted(folder, length, rpm):
    """(program, its plan as a dict)"""
    values = {"tests": str(ROOT / "tests" / "host"), "folder": folder, "length": length, "rpm": rpm}
    script = Path(folder) / "post.py"
    script.write_text(SCRIPT % values)
    done = subprocess.run([str(ROOT / "tools" / "freecad"), str(script)], capture_output=True, text=True)
    if done.returncode:
        raise AssertionError(done.stdout + done.stderr)
    return Path(folder) / "roller.ngc", json.loads((Path(folder) / "roller.json").read_text())


def tooth_passes(log, plan):
    """(n, 3) X [mm], A [rad] and phase error [turns] of all tooth passes while the thread is milled and the
    lock holds: the constant that a lock begins with is the mean's affair."""
    x, a = log.joints[:, 0], numpy.radians(log.rotary[:, 0])
    share = a / plan["angle"]
    there = numpy.arange(len(a)) <= numpy.argmax(a)  # the program winds the table back at its end
    settled = there & (share * plan["turns"] > SETTLING) & ((1.0 - share) * plan["turns"] > SETTLING)
    error = log.turns - share * plan["turns"]
    offset = numpy.mean(error[settled])
    turned = log.turns[settled] - offset
    passes = numpy.arange(numpy.ceil(turned[0] * FLUTES), numpy.floor(turned[-1] * FLUTES)) / FLUTES
    at = [numpy.interp(passes, turned, values[settled]) for values in (x, a, error - offset)]
    return numpy.column_stack(at)


def distances(passes, neighbours):
    """Of each dimple to those that are `neighbours` behind it, in space [mm], one array for each of them."""
    x, a = passes[:, 0], passes[:, 1]
    places = numpy.column_stack([x, RADIUS * numpy.cos(a), RADIUS * numpy.sin(a)])
    return [numpy.linalg.norm(places[k:] - places[:-k], axis=1) for k in neighbours]


class Roller(unittest.TestCase):
    @load.told_from_load
    def test_no_seam(self):
        length = float(os.environ.get("ROLLER_LENGTH", 2.0))
        rpm = int(os.environ.get("ROLLER_RPM", 2000))
        with tempfile.TemporaryDirectory(prefix="patchmill-roller-") as folder:
            program, plan = posted(folder, length, rpm)
            machine = controller.Machine(
                kinematics="xyza", rotary_velocity=180.0, rotary_acceleration=1000.0, rotary_travel=1e6
            )
            log = controller.run(program, machine, limit=1500.0, stops=20)
        passes = tooth_passes(log, plan)
        each = numpy.concatenate(distances(passes, plan["neighbours"]))
        off = each - plan["spacing"]
        phase = 360.0 * passes[:, 2]
        print(
            "Ø%g x %g mm, S%d: %d dimples planned, %d logged; neighbours %.5f to %.5f mm for %.5f "
            "(%.3f um at most, %.3f um rms); phase %.3f degrees rms, %.3f largest; %.0f s"
            % (2 * RADIUS, length, rpm, plan["dimples"], len(passes), each.min(), each.max(), plan["spacing"],
               1e3 * abs(off).max(), 1e3 * (off**2).mean() ** 0.5, (phase**2).mean() ** 0.5, abs(phase).max(),
               log.time[-1])
        )  # fmt: skip
        if os.environ.get("ROLLER_LOG"):
            numpy.savez_compressed(os.environ["ROLLER_LOG"], passes=passes, time=log.time, turns=log.turns,
                                   joints=log.joints, rotary=log.rotary)  # fmt: skip
        self.assertGreater(len(passes), plan["dimples"])  # the run-in and run-out beside the ends as well
        self.assertLess(abs(off).max(), 1e-3)
        self.assertLess(abs(phase).max(), 0.3)


if __name__ == "__main__":
    load.main(verbosity=2)
