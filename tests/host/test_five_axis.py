"""Textures on machines with rotary axes, from the document to the posted program and back: every shipped
five-axis machine with its own post, with TCP and without, tool-axis modes, and what is refused.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import os
import re
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import FreeCAD  # noqa: E402
import _patchmill as core  # noqa: E402
import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from patchmill.machine import machines  # noqa: E402
from patchmill.posting import post_dialect  # noqa: E402
from patchmill.textures import tool_posture  # noqa: E402
from recipe import small_job  # noqa: E402

POSTS = {
    "table-table-ac": "patchmill_linuxcnc",
    "table-table-bc": "patchmill_linuxcnc",
    "head-head-ca": "patchmill_fanuc",
    "head-table-bc": "patchmill_siemens",
    "nutating-table-bc-45": "patchmill_heidenhain",
    "nutating-head-bc-45": "patchmill_siemens",
}


def five_axis_job(machine, decimals=4):
    document, job, op = small_job(decimals, name="five")
    op.PatchesX, op.PatchesY = 2, 1
    op.Machine = machine
    op.ToolAxisMode, op.Lead, op.LeadTowards = "Normal", 12.0, FreeCAD.Vector(1, 0, 0)
    op.PostUnheld = True
    op.PostGouging = True
    post = POSTS.get(machine, "patchmill_linuxcnc")
    job.PostProcessor = post
    job.PostProcessorArgs = "--precision=%d" % decimals
    return document, job, op


class FiveAxis(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="patchmill-five-")
        self.addCleanup(self.folder.cleanup)
        self.addCleanup(lambda: [FreeCAD.closeDocument(n) for n in list(FreeCAD.listDocuments())])

    def post(self, job, op):
        plan = patchmill.recompute(op)
        name = os.path.join(self.folder.name, "x.nc")
        posted = patchmill.post(job, name)[0]
        with open(name, encoding="ascii") as file:
            return plan, posted, file.read()

    def check_read_back(self, plan, posted):
        """Tips in the work frame, from the text alone, are where the ball cuts each dimple."""
        ends = np.flatnonzero(posted.path.dimples >= 0)
        self.assertEqual(len(ends), plan.counts["cut"])
        number = posted.path.dimples[ends]
        centre = posted.path.tips[ends] + plan.input.tool.radius * posted.path.axes[ends]
        wanted = plan.dimples.positions[number] + plan.input.tool.radius * plan.dimples.normals[number]
        self.assertLess(np.abs(centre - wanted).max(), 4.0 * 10.0**-plan.input.decimals)
        self.assertLess(math.degrees(posted.errors["largest"]), 1.0)
        cosine = np.einsum("ij,ij->i", posted.path.axes[ends], plan.dimples.normals[number])
        return np.degrees(np.arccos(cosine))

    def test_each_machine_with_its_post(self):
        for machine in POSTS:
            with self.subTest(machine=machine):
                document, job, op = five_axis_job(machine)
                plan, posted, text = self.post(job, op)
                tilt = self.check_read_back(plan, posted)
                self.assertLess(np.abs(tilt - 12.0).max(), 1e-2)
                print(machine, len(text.splitlines()), "blocks;", "C from %.1f to %.1f" % tuple(
                    np.degrees(plan.posture.work.joints[:, 0][[0, -1]])))
                FreeCAD.closeDocument(document.Name)

    def test_tilt_is_beside_the_feed_as_lead_is_along_it(self):
        _, job, op = five_axis_job("table-table-ac")
        op.Lead, op.Tilt = 0.0, 7.0
        plan, posted, _ = self.post(job, op)
        self.assertLess(np.abs(self.check_read_back(plan, posted) - 7.0).max(), 1e-2)

    def machine_with(self, **words):
        """Saves table-table-ac with other words as 'other'."""
        machines.save("other", dict(machines.load("table-table-ac").data, **words))

    def test_axes_that_are_too_slow_or_too_short_are_refused(self):
        with mock.patch.dict(os.environ, PATCHMILL_MACHINES=self.folder.name):
            _, _, op = five_axis_job("table-table-ac")
            work = patchmill.recompute(op).posture.work
            seconds = (work.path.turns / work.path.spindle.speed)[:, None]
            with np.errstate(divide="ignore", invalid="ignore"):
                rates = np.degrees(np.abs(np.diff(work.joints, axis=0)) / seconds)
            fastest = np.nanmax(np.where(seconds > 0.0, rates, np.nan), axis=0)  # C, A [degrees/s]
            axes = machines.load("table-table-ac").data["rotary_axes"]
            for share, good in ((1.001, True), (0.999, False)):
                velocities = fastest * (share, 10.0)
                self.machine_with(rotary_axes=[
                    dict(a, velocity_deg_s=v) for a, v in zip(axes, velocities)])  # fmt: skip
                op.Machine = "other"
                if good:
                    self.assertAlmostEqual(patchmill.recompute(op).posture.load["rate"], 1 / share, places=6)
                else:
                    said = self.refused("ToolAxis", op)
                    speed = int(re.search(r"at (\d+) rpm or less", said.remedy).group(1))
                    op.ToolController.SpindleSpeed, before = speed, op.ToolController.SpindleSpeed
                    self.assertLessEqual(patchmill.recompute(op).posture.load["rate"], 1.0)
                    op.ToolController.SpindleSpeed = before
            limits = machines.load("table-table-ac").data["linear_axes"]
            self.machine_with(linear_axes=dict(limits, limits_mm={"X": [-0.5, 0.5]}))
            self.refused("Machine", op)

    def test_without_tcp(self):
        for machine in ("table-table-ac", "head-table-bc"):
            with self.subTest(machine=machine):
                document, job, op = five_axis_job(machine)
                op.ProgramForm, op.GaugeLength = "Without TCP", 120.0
                plan, posted, text = self.post(job, op)
                self.check_read_back(plan, posted)
                blocks = [line for line in text.splitlines() if line[0] != "(" and ";" not in line]
                words = [word for line in blocks for word in line.split()]
                self.assertFalse({"M428", "TRAORI"} & set(words))
                self.assertIn("G93", words)
                FreeCAD.closeDocument(document.Name)

    def test_spindle_locked_with_rotary_axes(self):
        _, job, op = five_axis_job("table-table-ac")
        op.Strategy, op.SameFlute, op.ExtraTurns = "Spindle-locked", False, 0.0
        plan, posted, text = self.post(job, op)
        self.check_read_back(plan, posted)
        self.assertIn("M428", text)
        locked = [line for line in text.splitlines() if line.startswith("G33")]
        self.assertEqual(len(locked), int((posted.path.kinds > 0).sum()))
        self.assertTrue(all("K" in line for line in locked))

    def test_three_plus_two(self):
        _, job, op = five_axis_job("table-table-bc")
        op.ToolAxisMode, op.FixedAxis = "Fixed", FreeCAD.Vector(math.sin(0.4), 0.1, math.cos(0.4))
        plan, posted, _ = self.post(job, op)
        self.check_read_back(plan, posted)
        self.assertLess(np.ptp(plan.posture.work.joints, axis=0).max(), 1e-12)

    def test_minimum_lead_and_field(self):
        _, job, op = five_axis_job("table-table-ac")
        op.ToolAxisMode, op.MinimumLead = "Minimum lead", 10.0
        plan, posted, _ = self.post(job, op)
        self.assertGreater(self.check_read_back(plan, posted).min(), 10.0 - 1e-2)
        op.ToolAxisMode = "Field"
        op.Proxy.posture_field = lambda places, normals: normals + (0.2, 0.1, 0.0)
        op.MinimumLead = 14.0
        plan, posted, _ = self.post(job, op)
        self.assertGreater(self.check_read_back(plan, posted).min(), 14.0 - 1e-2)
        op.MinimumLead = 0.0
        plan, posted, _ = self.post(job, op)
        self.assertLess(self.check_read_back(plan, posted).max(), 13.0)

    def test_any_path_with_tool_axes(self):
        """What copy milling with a posture field needs: a path with axes, and a machine."""
        _, _, op = five_axis_job("table-table-bc")
        op.ToolAxisMode = "Fixed"
        op.FixedAxis = FreeCAD.Vector(0.2, 0.1, 1.0)
        path = patchmill.recompute(op).path
        machine = machines.load("nutating-table-bc-45")
        posture, text = tool_posture.of_path(path, machine, 4)
        self.assertIn("M128", str(text))
        post = post_dialect.Dialect("x", "heidenhain", "x", 4)
        program = core.write_program(["M6 T1\nM3 S1000\n" + str(text)], post.dialect, precision=4)
        section = core.read_gcode(program, path.tool, "heidenhain", rotary=True)[-1]
        complete, _, work = tool_posture.read_back(section, posture, machine, 0.5e-4)
        self.assertTrue(complete)
        timed, planned = work.kinds > 0, path.kinds > 0
        self.assertLess(np.abs(work.tips[timed] - path.tips[planned]).max(), 3e-4)
        self.assertLess(np.abs(work.axes[timed] - path.axes[planned]).max(), 3e-6)

    def refused(self, named, op):
        with self.assertRaises(patchmill.InputError) as caught:
            patchmill.recompute(op)
        self.assertEqual(caught.exception.property, named, caught.exception)
        return caught.exception

    def test_what_cannot_be_is_refused(self):
        _, _, op = five_axis_job("linuxcnc-mill")
        self.refused("Machine", op)
        op.Machine = ""
        self.refused("Machine", op)
        op.Machine, op.ProgramForm = "head-table-bc", "Without TCP"
        self.refused("GaugeLength", op)
        op.Machine, op.ProgramForm, op.Lead = "table-table-ac", "As the machine", 89.0
        self.refused("Lead", op)
        op.Lead = 10.0
        op.ToolAxisMode, op.FixedAxis = "Fixed", FreeCAD.Vector(0, 0, -1)
        self.refused("Dimples", op)

    def refused_by(self, job, op, post, words):
        job.PostProcessor = post
        with self.assertRaises(patchmill.InputError) as caught:
            self.post(job, op)
        print(caught.exception)
        self.assertEqual(caught.exception.property, "PostProcessor")
        self.assertIn(words, caught.exception.remedy)
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_stock_posts_that_lose_words_are_refused_with_the_reason(self):
        _, job, op = five_axis_job("table-table-ac")
        self.refused_by(job, op, "centroid", "does not keep C")
        op.Strategy, op.SameFlute, op.ExtraTurns = "Spindle-locked", False, 0.0
        self.refused_by(job, op, "linuxcnc", "does not keep K")

    def test_a_stock_post_that_keeps_them_comes_out_right(self):
        _, job, op = five_axis_job("table-table-ac", 3)
        job.PostProcessor = "linuxcnc"
        job.PostProcessorArgs = "--no-show-editor"
        plan, posted, text = self.post(job, op)
        self.check_read_back(plan, posted)
        self.assertIn("M428", text)
        self.assertIn("M429", text)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2, argv=["test"] + sys.argv[1:]).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
