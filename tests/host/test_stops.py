"""Long calls come back: told to stop at any of their progress calls they ask no more and give None, and
Ctrl-C ends them as KeyboardInterrupt; afterwards all is as it was.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import random
import signal
import sys
import tempfile
import threading
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import add_pocket, dress, make_job, pocket_part  # noqa: E402
from parts import WithDocuments, job_on  # noqa: E402
from patchmill.modifiers import dcm_input, dressup_dcm  # noqa: E402
from patchmill.operations import copy_input, copy_milling, texture_operation  # noqa: E402
from patchmill.verify import checks  # noqa: E402
from recipe import small_job  # noqa: E402

MOMENTS = 8  # tried of each call
V = FreeCAD.Vector


class Counted:
    """A progress that says no at its call number `last`, and counts how often it is asked."""

    def __init__(self, last=None):
        self.last, self.count, self.shares = last, 0, []

    def __call__(self, share):
        self.count += 1
        self.shares.append(share)
        return self.last is None or self.count < self.last


class Stops(WithDocuments):
    def check(self, name, call, stopped=lambda result: result is None):
        """`call` of a progress, whole and stopped at random calls of it."""
        whole = Counted()
        self.assertFalse(stopped(call(whole)), name)
        self.assertGreater(whole.count, 2, name)
        self.assertTrue(all(0.0 <= share <= 1.0 for share in whole.shares), name)
        numbers = random.Random(name)
        for last in [1, 2] + [numbers.randint(1, whole.count) for _ in range(MOMENTS)]:
            some = Counted(last)
            result = call(some)
            if some.count < last:  # by time it asked less often than before
                continue
            self.assertTrue(stopped(result), "%s, stopped at call %d of %d" % (name, last, whole.count))
            self.assertLessEqual(some.count, last + 1, name)

    def test_a_texture(self):
        _, _, op = small_job(name="texture")
        given = op.Proxy.texture_input(op)
        self.check("texture", lambda progress: texture_operation.prepare(given, progress))

    def test_a_texture_on_a_surface(self):
        _, op = job_on(Part.makeSphere(20).common(Part.makeBox(30, 30, 30)), "Face1")
        op.Mapping, op.PatchSide = "On surface", 4
        given = op.Proxy.texture_input(op)
        self.check("on surface", lambda progress: texture_operation.prepare(given, progress))

    def test_simulation_check_and_post(self):
        _, job, op = small_job(name="verify")
        patchmill.recompute(op)
        self.check("simulate", lambda progress: patchmill.simulate(op, progress=progress))
        given = checks.check_input(op)
        self.check(
            "check",
            lambda progress: checks.run_check(given, progress=progress),
            lambda result: result.outcome == "unknown" and "stopped" in result.reason,
        )
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "program.ngc")

            def post(progress):
                if os.path.exists(name):
                    os.remove(name)
                return patchmill.post(job, name, "patchmill_linuxcnc", "--precision=3", progress)

            def stopped(result):
                self.assertEqual(result is None, not os.path.exists(name))
                return result is None

            self.check("post", post, stopped)
            self.assertLessEqual(set(os.listdir(folder)), {"program.ngc"})

    def test_copy_milling(self):
        _, job = make_job(pocket_part(), ball=True)
        op = patchmill.CopyMilling.Create("Copy", parentJob=job)
        patchmill.recompute(op)
        given = copy_input.input_of(op)
        self.check("copy milling", lambda progress: copy_milling.mill(given, progress))

    def test_dcm_and_its_voxels(self):
        _, job = make_job(pocket_part())
        dressup = dress(add_pocket(job))
        given = dcm_input.input_of(dressup)
        self.check("dcm", lambda progress: dressup_dcm.compute(given, "", progress))


class CtrlC(WithDocuments):
    def test_ends_a_call_that_has_no_progress(self):
        _, _, op = small_job(name="interrupted")
        patchmill.recompute(op)
        brep = op.Base[0][0].Shape.exportBrepToString()
        before = signal.getsignal(signal.SIGINT)
        timer = threading.Timer(0.05, lambda: os.kill(os.getpid(), signal.SIGINT))
        with self.assertRaises(KeyboardInterrupt):
            timer.start()
            while True:
                core.tessellate(brep, 0.001)
        timer.join()
        self.assertIs(signal.getsignal(signal.SIGINT), before)
        patchmill.recompute(op)  # nothing is left behind

    def test_what_a_progress_raises_comes_out(self):
        _, _, op = small_job(name="raises")
        given = op.Proxy.texture_input(op)

        def progress(share):
            raise ZeroDivisionError("of the one who asks")

        with self.assertRaises(ZeroDivisionError):
            texture_operation.prepare(given, progress)

    def test_a_watch_ends_its_block_and_no_more(self):
        brep = Part.makeBox(1, 1, 1).exportBrepToString()
        reached = []
        with core.Watch(lambda share: False):
            core.tessellate(brep, 0.1)
            reached.append("after a stop")
        with core.Watch(None) as progress:
            self.assertTrue(progress(0.5))
            core.tessellate(brep, 0.1)
            reached.append("within")
        core.tessellate(brep, 0.1)
        self.assertEqual(reached, ["within"])


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
