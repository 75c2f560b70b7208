"""The posture that DressupDCM gives copy milling over the paper's convex part: the ball centre stays, the
rotary axes have time, the holder keeps clear.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parents[1] / "Resources" / "recipes" / "kobayashi2014"))

import _patchmill as core  # noqa: E402
import make_parts  # noqa: E402
import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import CONTACT, distance_to_lines, dress  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import DressupDCM  # noqa: E402
from test_copy_milling import job_with_stock  # noqa: E402


def convex_posture(**depths):
    """(job, dressup, result): the paper's posture over its convex part, copied in scanning lines."""
    document, job = job_with_stock(make_parts.convex_part(), 1.0)
    operation = patchmill.CopyMilling.Create("Copy", parentJob=job)
    operation.RadialDepth, operation.AxialDepth = 10.0, 8.0
    for name, value in depths.items():
        setattr(operation, name, value)
    patchmill.CopyMilling.recompute(operation)
    dressup = dress(operation, Controls="Feed and posture", Machine="table-table-ac", TiltLimit=40.0)
    return job, dressup, DressupDCM.recompute(dressup)


class Posture(WithDocuments):
    """On copy milling over the paper's convex part, for LinuxCNC's xyzac machine."""

    def test_ball_centre_is_kept_and_the_axes_have_time(self):
        job, dressup, result = convex_posture()
        path, base = result.path, result.base
        axes = np.vstack([path.axes[:1], path.axes])
        centres = np.vstack([np.array(path.start)[None], path.tips]) + 3.0 * axes
        cut = path.kinds > 0
        planned = np.vstack([np.array(base.start)[None], base.tips]) + (0, 0, 3.0)
        on_the_way = []
        for s in (0.25, 0.5, 0.75, 1.0):  # tip and axis go evenly
            axis = axes[:-1] + s * np.diff(axes, axis=0)
            axis /= np.linalg.norm(axis, axis=1)[:, None]
            tips = centres[:-1] - 3.0 * axes[:-1]
            tips = tips + s * (centres[1:] - 3.0 * axes[1:] - tips)
            on_the_way.append((tips + 3.0 * axis)[cut])
        off = distance_to_lines(np.vstack(on_the_way), planned)
        print("ball centre off by %.3f um, tilts up to %.1f degrees, %d moves" % (
            1000 * off, np.degrees(np.arccos(path.axes[:, 2].min())), len(path)))
        self.assertLess(off, CONTACT)
        self.assertGreater(np.degrees(np.arccos(path.axes[:, 2].min())), 20.0)
        machine = patchmill.machines.load("table-table-ac")
        source = np.arange(len(path))
        path, source, joints = patchmill.tilted_path.with_angles(path, source, machine)
        self.assertEqual(len(source), len(result.path))  # nothing is left to be halved
        dressup.AxisTolerance = 0.01  # degrees; 0.25 before: more, shorter moves
        self.assertGreater(len(DressupDCM.recompute(dressup).path), 1.2 * len(result.path))
        rates = np.radians([a["velocity_deg_s"] for a in machine.data["rotary_axes"]])
        turned = np.abs(np.diff(joints, axis=0))
        seconds = path.turns / path.spindle.speed
        self.assertLessEqual((turned[cut] / rates / seconds[cut][:, None]).max(), 1 + 1e-9)
        for axis, joint in zip(path.axes, joints[1:]):
            # angles are on four decimals of a degree
            np.testing.assert_allclose(machine.kinematics.tool_axis(joint), axis, atol=2e-6)

    def test_holder_is_kept_clear(self):
        job, dressup, result = convex_posture(RadialDepth=60.0, Passes="Finishing")
        holder = [(3.0, 20.0, 2.5, 2.5), (20.0, 60.0, 16.0, 16.0)]  # over the ball centre, radii
        part = dressup.Proxy.model.part
        before = core.holder_clearance(part, holder, result.path, 1.0, 1.0)
        dressup.Holder = ["6 23 5 5", "23 63 32 32"]  # over the tip, diameters
        after = DressupDCM.recompute(dressup)
        held = [section[1:] for section in after.path.tool.sections if section[0] == "holder"]
        self.assertEqual(held, [(6.0, 23.0, 2.5, 2.5), (23.0, 63.0, 16.0, 16.0)])
        now = core.holder_clearance(part, holder, after.path, 1.0, 1.0)
        print("holder %.2f mm before, %.2f mm after; %d places not clear" % (
            before["least"], now["least"], dressup.NotClear))
        self.assertLess(before["least"], 0.9)
        self.assertEqual(dressup.NotClear, 0)
        self.assertGreaterEqual(now["least"], 1.0)  # as stated


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
