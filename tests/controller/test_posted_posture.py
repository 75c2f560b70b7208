"""A five-axis program of the dressup, posted by FreeCAD, through LinuxCNC with xyzac kinematics: the ball
centre runs where copy milling planned it, in the frame of the work, by the logged joints.

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
from harness import controller, load, table  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
RADIUS, CONTACT = 3.0, 0.001
SCRIPT = """
import json, os, sys
sys.path.insert(0, %(tests)r)
sys.path.insert(0, %(recipe)r)
import numpy as np
import patchmill
import make_parts
from patchmill import CopyMilling, DressupDCM
from patchmill.freecad import host
from test_copy_milling import job_with_stock
document, job = job_with_stock(make_parts.convex_part(), 1.0)
job.PostProcessor = "patchmill_linuxcnc"
op = CopyMilling.Create("Copy", parentJob=job)
op.Passes, op.RadialDepth = "Finishing", 20.0
CopyMilling.recompute(op)
dressup = DressupDCM.Create("DressupDCM", op)
dressup.Controls, dressup.Machine, dressup.TiltLimit = "Feed and posture", "table-table-ac", 40.0
result = DressupDCM.recompute(dressup)
text = host.post_parts(job, "patchmill_linuxcnc", "--no-header --no-compare --precision=5")[0]
open(%(folder)r + "/x.ngc", "w").write(text)
base, path = result.base, result.path
json.dump({"planned": (np.vstack([np.array(base.start)[None], base.tips]) + (0, 0, 3.0)).tolist(),
           "kinds": base.kinds.tolist(), "seconds": result.seconds,
           "tilt": float(np.degrees(np.arccos(path.axes[:, 2].min())))}, open(%(folder)r + "/x.json", "w"))
"""


def distance_to_lines(points, starts, ends):
    d = ends - starts
    square = numpy.maximum((d**2).sum(1), 1e-30)
    worst = []
    for chunk in numpy.array_split(points, max(1, len(points) * len(d) // 2_000_000)):
        v = chunk[:, None] - starts[None]
        t = numpy.clip((v * d[None]).sum(2) / square, 0, 1)
        worst.append(numpy.linalg.norm(v - t[..., None] * d[None], axis=2).min(1))
    return numpy.concatenate(worst)


class PostedPosture(unittest.TestCase):
    @load.told_from_load
    def test_ball_centre_in_the_frame_of_the_work(self):
        with tempfile.TemporaryDirectory(prefix="patchmill-posture-") as folder:
            values = {
                "tests": str(ROOT / "tests" / "host"),
                "recipe": str(ROOT / "Resources" / "recipes" / "kobayashi2014"),
                "folder": folder,
            }
            script = Path(folder) / "post.py"
            script.write_text(SCRIPT % values)
            done = subprocess.run(
                [str(ROOT / "tools" / "freecad"), str(script)], capture_output=True, text=True
            )
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            found = json.loads(Path(folder, "x.json").read_text())
            machine = controller.Machine(kinematics="xyzac", rotary_velocity=60.0, rotary_acceleration=600.0)
            text = (Path(folder) / "x.ngc").read_text().splitlines()
            log = controller.run(Path(folder) / "x.ngc", machine, stops=1000, limit=300.0)
        planned = numpy.array(found["planned"])
        cuts = numpy.array(found["kinds"]) > 0
        turn = table.work_to_housing("xyzac", log.rotary)
        axis = turn[:, 2, :]  # the spindle's axis in the frame of the work
        centre = log.tip + RADIUS * axis
        lines = planned[:-1], planned[1:]
        # the post turns the axes once above the stock before TCP is on: a G1 without X
        feed = numpy.array([False] + ["G1 X" in line for line in text] + [False])
        down = feed[numpy.clip(log.line.astype(int), 0, len(text))]
        off = distance_to_lines(centre[down], *lines)
        tilt = numpy.degrees(numpy.arccos(numpy.clip(axis[down, 2], -1, 1))).max()
        print(
            "%d cuts, tilt up to %.1f degrees (planned %.1f): ball centre off by %.2f um, %.2f um rms; "
            "%.1f s, planned %.1f s"
            % (cuts.sum(), tilt, found["tilt"], 1000 * off.max(), 1000 * (off**2).mean() ** 0.5,
               log.time[-1], found["seconds"])
        )  # fmt: skip
        self.assertGreater(down.sum(), 1000)
        self.assertGreater(tilt, 20.0)
        # half of it for the rounding of corners (G64 P0.0005), half for the way between ends of moves
        self.assertLess(off.max(), CONTACT)
        self.assertLess((off**2).mean() ** 0.5, 0.2 * CONTACT)


if __name__ == "__main__":
    load.main(verbosity=2)
