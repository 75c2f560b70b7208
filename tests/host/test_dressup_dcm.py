"""DressupDCM on FreeCAD's own Profile and Pocket: the contact is kept, the feed is the field's, everything
else is as it was; the saved model; bad input.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import re
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parents[1] / "Resources" / "recipes" / "kobayashi2014"))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import make_parts  # noqa: E402
import numpy as np  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import (  # noqa: E402
    add_pocket,
    add_profile,
    distance_off,
    distance_to_lines,
    make_job,
    pocket_part,
    trace,
)
from patchmill import DressupDCM, InputError  # noqa: E402
from recipe import small_job  # noqa: E402
from test_copy_milling import job_with_stock  # noqa: E402

CONTACT = 0.001  # mm
LOW, HIGH = 400.0 / 60.0, 800.0 / 60.0


def dress(operation, **properties):
    dressup = DressupDCM.Create("DressupDCM", operation)
    dressup.VoxelSize = 1.0
    for name, value in properties.items():
        setattr(dressup, name, value)
    return dressup


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


class OnFreeCADsOwn(unittest.TestCase):
    def tearDown(self):
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

    def check_contact(self, operation, dressup):
        base = trace(operation.Path.Commands)
        out = trace(dressup.Path.Commands)
        there = distance_off(out[0], base[0], base[1])
        back = distance_off(base[0], out[0], out[1])
        print("%s: %d commands -> %d, off by %.2g and %.2g um" % (
            operation.Name, len(operation.Path.Commands), len(dressup.Path.Commands),
            1000 * there, 1000 * back))
        self.assertLess(max(there, back), CONTACT)

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
        length = np.linalg.norm(np.diff(np.vstack([np.array(path.start)[None], path.tips]), axis=0), axis=1)
        speed = length * path.spindle.speed / path.turns
        a = patchmill.machines.load("linuxcnc-mill").model.acceleration
        timed = path.kinds[1:] * path.kinds[:-1] > 0
        change = np.abs(speed[1:] ** 2 - speed[:-1] ** 2)[timed]
        self.assertLessEqual((change - 2 * a * np.fmax(length[1:], length[:-1])[timed]).max(), 1e-6)
        dressup.FeedAtSkin = 1e6
        with self.assertRaises(InputError) as caught:
            DressupDCM.recompute(dressup)
        self.assertEqual(caught.exception.property, "FeedAtSkin")

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


class Posture(unittest.TestCase):
    """On copy milling over the paper's convex part, for LinuxCNC's xyzac machine."""

    def tearDown(self):
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

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
        now = core.holder_clearance(part, holder, after.path, 1.0, 1.0)
        print("holder %.2f mm before, %.2f mm after; %d places not clear" % (
            before["least"], now["least"], dressup.NotClear))
        self.assertLess(before["least"], 0.9)
        self.assertEqual(dressup.NotClear, 0)
        self.assertGreaterEqual(now["least"], 1.0)  # as stated


class Saved(unittest.TestCase):
    def test_made_anew_when_the_part_changes(self):
        document, job = make_job(pocket_part(), "changes")
        dressup = dress(add_profile(job), VoxelSize=0.5)
        DressupDCM.recompute(dressup)
        before = dressup.Proxy.model.grid.counts
        document.getObject("Part").Shape = Part.makeBox(50, 40, 15)
        document.recompute()
        DressupDCM.recompute(dressup)
        self.assertNotEqual(before, dressup.Proxy.model.grid.counts)
        FreeCAD.closeDocument(document.Name)

    def test_beside_the_document_and_made_anew(self):
        with tempfile.TemporaryDirectory() as folder:
            document, job = make_job(pocket_part(), "saved")
            dressup = dress(add_profile(job))
            DressupDCM.recompute(dressup)
            name = os.path.join(folder, "part.FCStd")
            document.saveAs(name)
            dressup.VoxelSize = 1.5
            DressupDCM.recompute(dressup)
            file = os.path.join(folder, "part-DressupDCM.voxels")
            self.assertTrue(os.path.exists(file))
            words = [c.toGCode() for c in dressup.Path.Commands if not c.Name.startswith("(")]
            document.save()
            FreeCAD.closeDocument(document.Name)
            del document, job, dressup

            document = FreeCAD.openDocument(name)
            dressup = document.getObject("DressupDCM")
            DressupDCM.recompute(dressup)
            self.assertTrue(dressup.Proxy.model.loaded)
            # the document keeps six decimals of the base's path
            names = [c.Name for c in dressup.Path.Commands if not c.Name.startswith("(")]
            self.assertEqual(names, [w.split()[0] for w in words])
            dressup.VoxelSize = 2.0
            DressupDCM.recompute(dressup)
            self.assertFalse(dressup.Proxy.model.loaded)
            FreeCAD.closeDocument(document.Name)


class BadInput(unittest.TestCase):
    def setUp(self):
        self.document, self.job = make_job(pocket_part(), "bad")
        self.operation = add_profile(self.job)
        self.words = [c.toGCode() for c in self.operation.Path.Commands]

    def tearDown(self):
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

    def refused(self, name, dressup):
        with self.assertRaises(InputError) as caught:
            DressupDCM.recompute(dressup)
        self.assertEqual(caught.exception.property, name, caught.exception)
        self.assertTrue(caught.exception.remedy)
        self.assertEqual(len(dressup.Path.Commands), 0)  # nothing old is left to be posted
        self.assertEqual([c.toGCode() for c in self.operation.Path.Commands], self.words)
        print("refused:", caught.exception)

    def test_values(self):
        dressup = dress(self.operation)
        for name, bad in [
            ("VoxelSize", 0.0), ("FeedAtProduct", 0.0), ("MemoryLimit", 0.0), ("FeedInAir", 1.0),
            ("FeedTolerance", 0.0), ("Machine", "none such"), ("Deflection", 0.0),
        ]:  # fmt: skip
            good = getattr(dressup, name)
            setattr(dressup, name, bad)
            self.refused(name, dressup)
            setattr(dressup, name, good)
        dressup.Holder = ["10 20 30"]
        self.refused("Holder", dressup)
        dressup.Holder = []
        DressupDCM.recompute(dressup)

    def test_memory(self):
        dressup = dress(self.operation, VoxelSize=0.02)
        self.refused("VoxelSize", dressup)
        given = patchmill.dcm.input_of(dressup)
        self.assertGreater(patchmill.removal_model.estimate(given.model)["total"], 4 * 2**30)

    def test_part_outside_stock(self):
        self.job.Stock = self.document.addObject("Part::Box", "Small")
        self.document.recompute()
        dressup = dress(self.operation)
        self.words = [c.toGCode() for c in self.operation.Path.Commands]
        self.refused("Model", dressup)

    def test_nothing_to_remove(self):
        stock = self.document.addObject("Part::Feature", "Same")
        stock.Shape = self.job.Model.Group[0].Shape.copy()
        self.job.Stock = stock
        self.document.recompute()
        self.words = [c.toGCode() for c in self.operation.Path.Commands]
        self.refused("Stock", dress(self.operation))

    def test_open_shell(self):
        dressup = dress(self.operation)
        self.document.getObject("Part").Shape = Part.makeShell(pocket_part().Faces[1:])
        self.document.recompute()
        self.words = [c.toGCode() for c in self.operation.Path.Commands]
        self.refused("Model", dressup)

    def test_posture_needs_a_ball_and_rotary_axes(self):
        dressup = dress(self.operation, Controls="Posture")
        self.refused("ToolController", dressup)
        controller = patchmill.host.add_ball_end_controller(self.job, 6.0, 2, 400.0, 6000.0)
        self.operation.ToolController = controller
        self.document.recompute()
        self.words = [c.toGCode() for c in self.operation.Path.Commands]
        self.refused("Machine", dressup)
        dressup.Machine = "linuxcnc-mill"
        self.refused("Machine", dressup)

    def test_a_textures_feed_is_its_timing(self):
        document, job, texture = small_job()
        patchmill.recompute(texture)
        self.words = [c.toGCode() for c in self.operation.Path.Commands]
        dressup = dress(texture)
        self.refused("Base", dressup)
        dressup.Controls, dressup.Machine = "Posture", "table-table-ac"
        self.refused("Base", dressup)  # its axis sets the phase, too


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
