"""A program that was stopped goes on from a patch: numbered comments, the rest locked anew, and the document
as it was.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError  # noqa: E402
from recipe import small_job  # noqa: E402
from roof_job import custom, roof_job  # noqa: E402

LOCKED, POST = "Spindle-locked", "patchmill_linuxcnc"


class Resume(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = os.path.join(folder.name, "program.ngc")

    def text(self):
        return pathlib.Path(self.program).read_text(encoding="ascii")

    def job(self, strategy=LOCKED, **properties):
        """(job, texture) of 2 x 2 patches of 6 x 6 dimples."""
        _, job, op = small_job(4)
        op.Strategy, op.PostUnheld = strategy, True
        if strategy != "Constant feed":
            op.Machine, op.SameFlute, op.ExtraTurns = "linuxcnc-mill", False, 0.0
        for name, value in properties.items():
            setattr(op, name, value)
        job.PostProcessor, job.PostProcessorArgs = "patchmill_linuxcnc", "--precision=4"
        return job, op

    def test_each_patch_has_its_number(self):
        for properties in (
            {"strategy": "Constant feed"},
            {},
            {"strategy": "Feed per move"},
            {"Order": "Rows"},
            {"Machine": "table-table-ac", "FixedAxis": FreeCAD.Vector(0.25, 0.1, 1.0)},
        ):
            job, op = self.job(**properties)
            if "Machine" in properties:
                op.Machine = properties["Machine"]
            patchmill.post(job, self.program)
            without = self.text()
            op.PatchComments = True
            (posted,) = patchmill.post(job, self.program)
            text = self.text()
            plan = op.Proxy.planned
            count = len(np.unique(plan.dimples.patches[plan.dimples.states == 0]))
            said = [int(n) for n in re.findall(r"\(PATCH (\d+) OF %d\)" % count, text, re.I)]
            self.assertEqual(said, list(range(1, count + 1)), properties)
            self.assertEqual(re.sub(r"\(PATCH .*\)\n", "", text, flags=re.I), without)
            # between two comments are the dimples of one patch alone
            lines = text.split("\n")
            at = [k for k, line in enumerate(lines, 1) if line.upper().startswith("(PATCH")]
            if plan.posture is None:
                dimples = posted.path.dimples
                lines_of = self.lines_of(posted, text, plan)
                number = np.searchsorted(at, lines_of[dimples >= 0])
                patch = plan.dimples.patches[dimples[dimples >= 0]]
                self.assertEqual(len(set(zip(number.tolist(), patch.tolist()))), count)
            self.doCleanups()
            self.tearDown()
            self.setUp()

    def lines_of(self, posted, text, plan):
        import _patchmill as core

        section = core.read_gcode(text, plan.input.tool)[-1]
        return np.array(section.lines)[-len(posted.path) :]

    def test_the_rest_is_the_end_of_the_whole(self):
        for strategy in (LOCKED, "Feed per move", "Constant feed"):
            job, op = self.job(strategy)
            whole = patchmill.recompute(op)
            tips, dimples = whole.path.tips, whole.path.dimples
            (posted,) = patchmill.resume(job, 3, self.program)
            self.assertIn("Begins with patch 3 of 4", self.text())
            found = posted.path
            again = found.dimples >= 0
            self.assertEqual(posted.match.found, again.sum())
            self.assertLess(again.sum(), (dimples >= 0).sum())
            first = len(dimples[dimples >= 0]) - again.sum()
            np.testing.assert_allclose(found.tips[again], tips[dimples >= 0][first:], atol=1e-9)
            self.assertEqual(op.FirstPatch, 1)
            self.assertEqual(len(op.Proxy.planned.path), len(whole.path))

    def test_the_phase_is_that_of_the_whole(self):
        """Of each dimple modulo a tooth, as planned, from where the lock begins."""
        job, op = self.job()
        phase = []
        for first in (1, 2):
            op.FirstPatch = first
            path = patchmill.recompute(op).path
            turns = np.cumsum(np.where(path.kinds > 0, path.turns, 0.0))
            phase.append(turns[path.dimples >= 0])
        difference = phase[0][-len(phase[1]) :] - phase[1]
        teeth = 2.0 * difference
        off = np.abs(teeth - np.round(teeth)) / 2.0 * 360.0
        print("phase of the rest beside the whole: %.3f degrees at most" % off.max())
        self.assertLess(off.max(), 1e-3)

    def test_what_comes_before_is_left_out(self):
        job, textures = roof_job("Constant feed", LOCKED)
        after = custom(job, ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X46", "G0 Z30"])
        with self.assertRaises(InputError) as caught:
            patchmill.resume(job, 1, self.program)
        self.assertEqual(caught.exception.property, "Operation")
        job.Fixtures = ["G54", "G55"]
        with self.assertRaises(InputError) as caught:
            patchmill.resume(job, 1, self.program, textures[1])
        self.assertEqual(caught.exception.property, "Fixtures")
        posted = patchmill.resume(job, 1, self.program, textures[1], "G55", POST)
        self.assertEqual([one.operation for one in posted], [textures[1], after])
        self.assertEqual([one.offset for one in posted], ["G55", "G55"])
        self.assertTrue(textures[0].Active)
        self.assertEqual(list(job.Fixtures), ["G54", "G55"])
        for patch in (0, -1, 1000, 1.5, "2"):
            with self.assertRaises(InputError) as caught:
                patchmill.resume(job, patch, self.program, textures[1], "G55", POST)
            self.assertEqual(caught.exception.property, "FirstPatch")
        self.assertEqual(len(patchmill.post(job, self.program, POST)), 6)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
