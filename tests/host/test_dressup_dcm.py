"""DressupDCM on FreeCAD's own Profile and Pocket: the contact is kept, the feed is the field's, everything
else is as it was.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import re
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import CONTACT, HIGH, LOW, contact_off, trace  # noqa: E402
from milling_jobs import add_pocket, add_profile, dress, make_job, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import DressupDCM, InputError  # noqa: E402


def accelerations(path):
    """Of timed moves that follow each other, along the longer of the two [mm/s^2]."""
    length = np.linalg.norm(np.diff(np.vstack([np.array(path.start)[None], path.tips]), axis=0), axis=1)
    speed = length * path.spindle.speed / path.turns
    timed = path.kinds[1:] * path.kinds[:-1] > 0
    change = np.abs(speed[1:] ** 2 - speed[:-1] ** 2)
    return (change / (2.0 * np.fmax(length[1:], length[:-1])))[timed]


class OnFreeCADsOwn(WithDocuments):
    def check_contact(self, operation, dressup):
        off = contact_off(operation, dressup)
        print("%s: %d commands -> %d, off by %.2g um" % (
            operation.Name, len(operation.Path.Commands), len(dressup.Path.Commands), 1000 * off))
        self.assertLess(off, CONTACT)

    def check_feed(self, operation, dressup):
        points, tangents, feeds = trace(dressup.Path.Commands)
        plunge = tangents[:, 2] < -0.5
        self.assertGreaterEqual(feeds[~plunge].min(), LOW * (1 - 1e-9))
        self.assertLessEqual(feeds[~plunge].max(), HIGH * (1 + 1e-9))
        base = trace(operation.Path.Commands)
        slow = base[2][base[1][:, 2] < -0.5]
        if plunge.any():
            self.assertLessEqual(feeds[plunge].max(), slow.max() * (1 + 1e-9))
        self.assertLess(dressup.LargestFeedStep, 60.0)

    def check_others(self, operation, dressup):
        def others(obj):
            return [c.toGCode() for c in obj.Path.Commands if c.Name not in ("G1", "G2", "G3")]

        self.assertEqual(others(operation), others(dressup))

    def check(self, operation):
        job = patchmill.host.PathUtils.findParentJob(operation)
        dressup = dress(operation)
        result = DressupDCM.recompute(dressup)
        self.assertIn(dressup, job.Operations.Group)
        self.assertNotIn(operation, job.Operations.Group)
        self.check_contact(operation, dressup)
        self.check_feed(operation, dressup)
        self.check_others(operation, dressup)
        self.assertGreater(result.steps["moves"], 100)
        return dressup

    def test_profile(self):
        document, job = make_job(pocket_part())
        job.Stock.ExtXneg = job.Stock.ExtYpos = 15
        document.recompute()
        dressup = self.check(add_profile(job))
        points, tangents, feeds = trace(dressup.Path.Commands)
        flat = np.abs(tangents[:, 2]) < 0.01
        self.assertGreater(np.ptp(feeds[flat]), 2.0)
        # V_x runs from V_Lo at the product to V_Hi at the skin, so along X the feed falls towards the product
        along = flat & (np.abs(tangents[:, 0]) > 0.999)
        self.assertTrue(along.any())

    def test_pocket(self):
        document, job = make_job(pocket_part())
        dressup = self.check(add_pocket(job))
        self.assertTrue(any(c.Name in ("G2", "G3") for c in dressup.Path.Commands))
        # every line along x or y in a closed pocket ends at the product: V_Lo all along
        points, tangents, feeds = trace(dressup.Path.Commands)
        flat = np.abs(tangents[:, 2]) < 0.001
        np.testing.assert_allclose(feeds[flat & (points[:, 2] < 19)], LOW, rtol=1e-9)

    def test_air_cuts_make_it_faster_and_nothing_else(self):
        document, job = make_job(pocket_part())
        job.Stock.ExtXneg = 0  # the passes along that side touch nothing
        document.recompute()
        operation = add_profile(job)
        dressup = dress(operation)
        slow = DressupDCM.recompute(dressup).seconds
        dressup.FeedInAir = 3000.0 / 60.0
        fast = DressupDCM.recompute(dressup).seconds
        self.assertLess(fast, slow)
        self.check_contact(operation, dressup)

    def test_transient_with_the_papers_numbers(self):
        document, job = make_job(pocket_part())
        job.Stock.ExtXneg = job.Stock.ExtYpos = 15
        document.recompute()
        dressup = dress(add_profile(job), VoxelSize=2.0)
        steady = DressupDCM.recompute(dressup).seconds
        dressup.Diffusion = "Transient"
        with self.assertRaises(InputError) as caught:  # r = D dt / dx^2 = 1
            DressupDCM.recompute(dressup)
        self.assertEqual(caught.exception.property, "TimeStep")
        self.assertIn("0.05", caught.exception.remedy)  # r = 1/2
        dressup.SubSteps = True
        self.assertAlmostEqual(DressupDCM.recompute(dressup).seconds, steady, delta=0.002 * steady)
        dressup.DiffusionTime = 0.5
        self.assertLess(DressupDCM.recompute(dressup).seconds, 0.999 * steady)  # V_Hi has not sunk yet

    def test_machine_limits(self):
        document, job = make_job(pocket_part())
        dressup = dress(add_profile(job), Machine="linuxcnc-mill")
        result = DressupDCM.recompute(dressup)
        path = result.path
        a = patchmill.machines.load("linuxcnc-mill").model.acceleration
        self.assertLessEqual(accelerations(path).max(), a * (1 + 1e-9))
        self.assertEqual(path.spindle.speed, 100.0)  # 6000 rpm
        dressup.FeedAtSkin = 100.0  # mm/s, as fast as the machine is
        DressupDCM.recompute(dressup)
        dressup.FeedAtSkin = 100.1
        with self.assertRaises(InputError) as caught:
            DressupDCM.recompute(dressup)
        self.assertEqual(caught.exception.property, "FeedAtSkin")

    def test_a_slow_machines_acceleration_holds_the_feed_back(self):
        slow = 5.0  # mm/s^2
        document, job = make_job(pocket_part())
        dressup = dress(add_profile(job), KeepPlunges=False)  # a plunge is slowed beyond the machine's limits
        self.assertGreater(accelerations(DressupDCM.recompute(dressup).path).max(), 2 * slow)
        with tempfile.TemporaryDirectory() as folder, mock.patch.dict(os.environ, PATCHMILL_MACHINES=folder):
            data = patchmill.machines.load("linuxcnc-mill").data
            axes = dict(data["linear_axes"], acceleration_mm_s2=slow)
            patchmill.machines.save("slow", dict(data, linear_axes=axes))
            dressup.Machine = "slow"
            held = accelerations(DressupDCM.recompute(dressup).path).max()
        self.assertLessEqual(held, slow * (1 + 1e-9))
        self.assertGreater(held, 0.99 * slow)

    def test_posts(self):
        document, job = make_job(pocket_part())
        dressup = dress(add_profile(job), FeedTolerance=0.03)
        DressupDCM.recompute(dressup)
        text = patchmill.host.post_parts(job, "linuxcnc", job.PostProcessorArgs)[0]
        words = re.sub(r"\(.*?\)", "", text).split()  # comments have words of their own
        feeds = [float(w[1:]) for w in words if w.startswith("F")]
        own = [c.Parameters["F"] for c in dressup.Path.Commands if c.Name in ("G1", "G2", "G3")]
        np.testing.assert_allclose(feeds, 60.0 * np.array(own), atol=0.0051)
        self.assertGreater(len(set(feeds)), 20)
        self.assertLessEqual(max(feeds), 800.01)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
