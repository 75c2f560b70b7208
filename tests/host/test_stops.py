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
from patchmill.advice import room  # noqa: E402
from patchmill.modifiers import dcm_input, dressup_dcm  # noqa: E402
from patchmill.operations import copy_input, copy_milling, texture_operation  # noqa: E402
from patchmill.path import base_path  # noqa: E402
from patchmill.system.stops import stoppable  # noqa: E402
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

    def test_ends_functions_of_python(self):
        with self.assertRaises(KeyboardInterrupt):
            threading.Timer(0.05, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
            while True:
                base_path.arc_points((1, 0, 0), (0, 1, 0), (0, 0), False)

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


def one_call(progress=None):
    """A call of the core that looks for a stop."""
    core.tessellate(Part.makeBox(1, 1, 1).exportBrepToString(), 0.1)
    return "whole"


stoppable_call = stoppable(one_call)


class WithinEachOther(WithDocuments):
    """Functions that stop, and are called by others that do."""

    def test_one_without_a_progress_asks_the_one_around_it(self):
        reached = []

        @stoppable
        def outer(progress=None):
            reached.append(stoppable_call())
            return reached[-1]

        self.assertIsNone(outer(lambda share: False))
        self.assertEqual(reached, [])
        self.assertEqual(outer(), "whole")

    def test_one_that_hands_its_progress_on_ends_with_it(self):
        """What it calls gives None; so does it, not something made of that."""
        reached = []

        @stoppable
        def middle(progress=None):
            reached.append(stoppable_call(progress))
            return "made of %s" % reached[-1]

        @stoppable
        def outer(progress=None):
            return middle()

        self.assertIsNone(outer(lambda share: False))
        self.assertEqual(reached, [])
        self.assertEqual(middle(lambda share: False), "made of None")

    def test_a_check_of_walls_for_a_remedy(self):
        _, _, op = small_job(name="walls")
        given = op.Proxy.texture_input(op)
        self.assertFalse(room.touches(given, [Part.makeBox(1, 1, 1).exportBrepToString()]))
        some = Counted(last=3)
        with core.Watch(some):
            room.touches(given, given.breps)
            self.fail("not stopped")
        self.assertEqual(some.count, 3)

    def test_recomputes_are_not_ended(self):
        """FreeCAD would take a stop in the middle for a fault of the operation."""
        _, _, op = small_job(name="recomputed")
        patchmill.recompute(op)
        op.touch()
        with core.Watch(lambda share: False):
            op.Document.recompute()
            self.assertIsNone(op.Proxy.error)
            self.assertIsNotNone(op.Proxy.planned)
            one_call()
            self.fail("not stopped")


class OfPython(WithDocuments):
    """Functions of the package that call none of the core's."""

    CALLS = 10**6  # more than a progress waits for

    def arcs(self, progress, watched):
        with core.Watch(progress):
            for made in range(self.CALLS):
                base_path.arc_points((1, 0, 0), (0, 1, 0), (0, 0), False)
                watched.append(made)

    def test_ask_and_end(self):
        made, some = [], Counted(last=2)
        self.arcs(some, made)
        self.assertEqual(some.count, 2)
        self.assertLess(len(made), self.CALLS)
        self.assertIsNone(sys.getprofile())

    def test_what_is_cleaned_up_after_a_stop_is_let_alone(self):
        done, some = [], Counted(last=2)
        with core.Watch(some):
            try:
                for _ in range(self.CALLS):
                    base_path.arc_points((1, 0, 0), (0, 1, 0), (0, 0), False)
            finally:
                for _ in range(20000):  # longer than it takes until it would be asked again
                    base_path.arc_points((1, 0, 0), (0, 1, 0), (0, 0), False)
                done.append(True)
        self.assertEqual((done, some.count), ([True], 2))

    def test_a_profiler_stays(self):
        def profiler(*_):
            return None

        sys.setprofile(profiler)
        try:
            with core.Watch(Counted(last=2)):
                self.assertIs(sys.getprofile(), profiler)
            self.assertIs(sys.getprofile(), profiler)
        finally:
            sys.setprofile(None)


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
