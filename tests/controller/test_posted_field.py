"""A spindle-locked texture whose tool axes come from the voxel model, posted by FreeCAD, through LinuxCNC
with xyzac kinematics: the phase at each dimple, and the axis there against the field.

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
from harness import controller, load, phase, table  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
ROW_TOLERANCE = 6.0  # degrees: rows keep one axis
SCRIPT = """
import json, sys
sys.path.insert(0, %(tests)r)
import numpy as np
import _patchmill as core
import patchmill
from test_axis_field import textured_job
job, op = textured_job()
op.Strategy, op.SameFlute, op.ExtraTurns, op.RowTolerance = "Spindle-locked", False, 0.0, %(row)f
op.PostUnheld = False
plan = patchmill.recompute(op)
patchmill.post(job, %(folder)r + "/x.ngc")
text = open(%(folder)r + "/x.ngc").read()
section = core.read_gcode(text, plan.input.tool, "linuxcnc", rotary=True)[0]  # then the table turns back
core.match_plan(section.path, plan.posture.told.path, 1e-6)
work = plan.posture.work.path
ends = np.flatnonzero(section.path.dimples >= 0)
number = section.path.dimples[ends]
tips = work.tips[np.flatnonzero(work.dimples >= 0)]
field = plan.input.posture_field(plan.dimples.positions, plan.dimples.normals)[number]
json.dump({"line": np.array(section.lines)[ends].tolist(), "tip": tips.tolist(),
           "azimuth": np.degrees(plan.posture.postures.azimuths[number]).tolist(),
           "patch": plan.dimples.patches[number].tolist(), "verdict": plan.pacing.verdict.holding,
           "field": field.tolist()}, open(%(folder)r + "/targets.json", "w"))
"""


class PostedField(unittest.TestCase):
    @load.told_from_load
    def test_phase_and_axis_at_each_dimple(self):
        with tempfile.TemporaryDirectory(prefix="patchmill-field-") as folder:
            script = Path(folder) / "post.py"
            values = {"tests": str(ROOT / "tests" / "host"), "folder": folder, "row": ROW_TOLERANCE}
            script.write_text(SCRIPT % values)
            done = subprocess.run(
                [str(ROOT / "tools" / "freecad"), str(script)], capture_output=True, text=True
            )
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            found = json.loads(Path(folder, "targets.json").read_text())
            machine = controller.Machine(
                kinematics="xyzac", rotary_velocity=90.0, rotary_acceleration=1000.0
            )
            log = controller.run(Path(folder) / "x.ngc", machine, stops=1000, limit=300.0)
        targets = phase.Targets(*(numpy.array(found[k]) for k in ("line", "tip", "azimuth", "patch")))
        report = phase.measure(log, targets, 2)
        axis = table.work_to_housing("xyzac", log.rotary)[:, 2, :]  # the spindle's, in the work's frame
        there = numpy.array([numpy.interp(report.time, log.time, axis[:, k]) for k in range(3)]).T
        cosine = (there * numpy.array(found["field"])).sum(axis=1) / numpy.linalg.norm(there, axis=1)
        off = numpy.degrees(numpy.arccos(numpy.clip(cosine, -1, 1)))
        tilt = numpy.degrees(numpy.arccos(there[:, 2]))
        print(
            "%d dimples, axes %.1f to %.1f degrees off Z, off the field by %.2f at most; phase rms %.2f, "
            "largest %.2f degrees, %.2f turns a dimple; tips off by %.2f um"
            % (len(off), tilt.min(), tilt.max(), off.max(), report.rms, report.largest,
               report.turns_per_dimple, 1000 * report.miss.max())
        )  # fmt: skip
        self.assertEqual(found["verdict"], "holds")
        self.assertGreater(len(off), 60)
        self.assertGreater(tilt.min(), 15.0)
        self.assertLessEqual(off.max(), ROW_TOLERANCE + 0.01)
        self.assertLessEqual(report.rms, 2.0)
        self.assertLessEqual(report.largest, 6.0)
        self.assertLessEqual(report.miss.max(), 1e-3)


if __name__ == "__main__":
    load.main(verbosity=2)
