"""A job as several programs: together they are the whole job, each stands for itself, and nothing is written
until all of them hold.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import csv
import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import _patchmill as core  # noqa: E402
import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError  # noqa: E402
from patchmill.verify.posted_program import offset_number  # noqa: E402
from recipe import small_job  # noqa: E402
from roof_job import custom, roof_job  # noqa: E402

LOCKED, POST = "Spindle-locked", "patchmill_linuxcnc"
UPRIGHT = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X45 F10", "G0 Z30"]


class SeveralFiles(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.program = os.path.join(folder.name, "mould.ngc")

    def roof(self):
        """(job, textures, another operation) under two work offsets."""
        job, textures = roof_job(LOCKED, "Constant feed")
        other = custom(job, UPRIGHT)
        job.Operations.Group = [textures[0], other, textures[1]]
        job.Fixtures = ["G54", "G55"]
        return job, textures, other

    def texture(self, strategy=LOCKED):
        """(job, texture) of 2 x 2 patches of 6 x 6 dimples."""
        _, job, op = small_job(4)
        op.Strategy, op.PostUnheld = strategy, True
        if strategy != "Constant feed":
            op.Machine, op.SameFlute, op.ExtraTurns = "linuxcnc-mill", False, 0.0
        job.PostProcessor, job.PostProcessorArgs = POST, "--precision=4"
        return job, op

    def contents(self, made):
        return [[(p.offset, p.operation.Label) for p in one.posted] for one in made]

    def assert_stands_for_itself(self, one):
        """Spindle, work offset and tool are said in the file before its first cut."""
        text = pathlib.Path(one.filename).read_text(encoding="ascii")
        self.assertEqual(text, one.text)
        sections = core.read_gcode(text, core.BallEndMill(1.0, 2), "linuxcnc")
        for section in sections:
            if (section.path.kinds != core.MoveKind.RAPID).any():
                self.assertGreater(section.path.spindle.speed, 0.0)
                self.assertIn(offset_number(section.offset), (1, 2))
                self.assertEqual(section.tool_number, 1)

    def test_as_the_job_divides_itself(self):
        job, (first, second), other = self.roof()
        names = [first.Label, other.Label, second.Label]
        both = [("G54", name) for name in names], [("G55", name) for name in names]
        for order, wanted in (
            ("Fixture", list(both)),
            ("Tool", [both[0] + both[1]]),
            ("Operation", [[("G54", name), ("G55", name)] for name in names]),
        ):
            job.SplitOutput, job.OrderOutputBy = True, order
            made = patchmill.post_files(job, self.program, post_name=POST)
            found = [sorted(one) for one in self.contents(made)]
            self.assertEqual(found, [sorted(one) for one in wanted], order)
            for one in made:
                self.assert_stands_for_itself(one)
                os.remove(one.filename)
            self.assertTrue(job.SplitOutput)
            self.assertEqual(list(job.Fixtures), ["G54", "G55"])

    def test_patches_one_after_the_other_are_the_whole(self):
        for strategy, ranges in ((LOCKED, ((1, 3), (4, 4))), ("Constant feed", ((1, 2), (3, 4)))):
            job, op = self.texture(strategy)
            whole = patchmill.recompute(op)
            tips = whole.path.tips[whole.path.dimples >= 0]
            made = patchmill.post_files(job, self.program, patches=ranges[0][1])
            wanted = ["%s %d-%d" % (op.Label, *ends) for ends in ranges]
            self.assertEqual([one.row["patches"] for one in made], wanted)
            found = [one.posted[0].path for one in made]
            again = np.vstack([path.tips[path.dimples >= 0] for path in found])
            np.testing.assert_allclose(again, tips, atol=1e-9)
            self.assertEqual((op.FirstPatch, op.LastPatch), (1, 0))
            self.assertEqual(len(op.Proxy.planned.path), len(whole.path))
            self.assertIn("Ends with patch %d of 4" % ranges[0][1], made[0].text)
            self.assertNotIn("Ends with", made[1].text)
            for one in made:
                os.remove(one.filename)
            self.tearDown()

    def test_the_phase_goes_on_from_file_to_file(self):
        """Of each dimple modulo a tooth, as planned, counted in each file from where its lock begins."""
        job, op = self.texture()
        phases = []
        for first, last in ((1, 0), (1, 2), (3, 3), (4, 4)):
            op.FirstPatch, op.LastPatch = first, last
            path = patchmill.recompute(op).path
            turns = np.cumsum(np.where(path.kinds > 0, path.turns, 0.0))
            phases.append(turns[path.dimples >= 0])
        off = 2.0 * (np.concatenate(phases[1:]) - phases[0])
        off = np.abs(off - np.round(off)) / 2.0 * 360.0
        self.assertLess(off.max(), 1e-3)

    def test_with_other_operations_and_offsets(self):
        job, (first, second), other = self.roof()
        made = patchmill.post_files(job, self.program, patches=100, post_name=POST)
        self.assertEqual([len(one.posted) for one in made], [3, 3])  # one for each work offset
        self.assertEqual({p.offset for p in made[1].posted}, {"G55"})

    def test_by_size(self):
        job, op = self.texture()
        (whole,) = patchmill.post_files(job, self.program)
        size = len(whole.text) / 1000.0
        made = patchmill.post_files(job, self.program, kilobytes=0.6 * size)
        self.assertEqual(len(made), 2)
        for one in made:
            self.assertLessEqual(os.path.getsize(one.filename), 600.0 * size)
            self.assertEqual(float(one.row["kB"]), round(os.path.getsize(one.filename) / 1000.0, 1))
        before = sorted(os.listdir(self.folder))
        for kilobytes, name in ((0.3, "Kilobytes"), (-1.0, "Kilobytes"), (float("nan"), "Kilobytes")):
            with self.assertRaises(InputError) as caught:
                patchmill.post_files(job, self.program, kilobytes=kilobytes)
            self.assertEqual(caught.exception.property, name)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_a_name_in_another_encoding(self):
        job, op = self.texture()
        made = patchmill.post_files(job, os.fsencode(self.folder) + b"/\xe4.ngc", patches=100)
        self.assertEqual(os.path.basename(made[0].filename), "\udce4-01.ngc")
        table = pathlib.Path(self.folder, "\udce4-files.csv").read_bytes()
        self.assertIn(b"\n\xe4-01.ngc,G54", table)

    def test_the_table(self):
        job, op = self.texture()
        made = patchmill.post_files(job, self.program, patches=2)
        with open(os.path.join(self.folder, "mould-files.csv"), encoding="ascii", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["file"] for row in rows], ["mould-01.ngc", "mould-02.ngc"])
        self.assertEqual([row["tools"] for row in rows], ["T1", "T1"])
        self.assertEqual(sum(int(row["dimples"]) for row in rows), patchmill.recompute(op).counts["cut"])
        for row, one in zip(rows, made):
            self.assertEqual(int(row["blocks"]), one.text.count("\n"))
            self.assertRegex(row["time"], r"^00:0\d:\d\d$")

    def test_what_cannot_be(self):
        job, op = self.texture()
        for last in (-1, 5, 100):
            op.LastPatch = last
            self.assert_refused(op, "LastPatch")
        op.FirstPatch, op.LastPatch = 3, 2
        self.assert_refused(op, "LastPatch")
        op.FirstPatch, op.LastPatch = 1, 0
        with self.assertRaises(InputError) as caught:
            patchmill.post_files(job, self.program, patches=-1)
        self.assertEqual(caught.exception.property, "Patches")
        pathlib.Path(self.folder, "mould-03.ngc").write_text("M2\n")
        with self.assertRaises(InputError) as caught:
            patchmill.post_files(job, self.program, patches=2)
        self.assertIn("mould-03.ngc", str(caught.exception))
        self.assertEqual(os.listdir(self.folder), ["mould-03.ngc"])
        op.ToolController.Tool.Flutes = 0
        with self.assertRaises(InputError):
            patchmill.post_files(job, self.program, patches=4)
        self.assertEqual(os.listdir(self.folder), ["mould-03.ngc"])

    def test_stops_before_patches(self):
        job, op = self.texture("Constant feed")
        patchmill.post(job, self.program)
        without = pathlib.Path(self.program).read_text(encoding="ascii")
        op.PatchStops = True
        patchmill.post(job, self.program)
        text = pathlib.Path(self.program).read_text(encoding="ascii")
        self.assertEqual(text.count("\nM1\n"), 3)
        self.assertEqual(text.replace("\nM1\n", "\n"), without)
        spoilt = text.replace("\nM1\n", "\n", 1)
        pathlib.Path(self.program).write_text(spoilt, encoding="ascii")
        with self.assertRaises(InputError) as caught:
            patchmill.read_back(job, self.program)
        self.assertEqual(caught.exception.property, op.Label)
        op.Strategy, op.Machine, op.SameFlute, op.ExtraTurns = LOCKED, "linuxcnc-mill", False, 0.0
        self.assert_refused(op, "PatchStops")


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
