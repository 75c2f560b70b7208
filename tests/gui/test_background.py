"""Work off the GUI thread: the newest job wins, a failure arrives, and no object of Qt's can be freed in a
thread that is not its own.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import gc
import os
import sys
import threading
import unittest

import _patchmill as core
import driver
import Part
from patchmill_gui.work.background import NICER, Background
from PySide import QtCore


class Mourned:
    """A member of a cycle that tells in which thread it was freed."""

    def __init__(self, told):
        self.itself, self.told = self, told

    def __del__(self):
        self.told.append(threading.get_ident())


def litter(progress):
    """Makes containers until Python's collector would have started many times, in all its generations."""
    kept = []
    for number in range(300000):
        kept.append([number])
        if number % 1000 == 0 and not progress(number / 300000):
            return None
    return len(kept)


class RunsInTheBackground(unittest.TestCase):
    def setUp(self):
        self.work = Background()
        self.results, self.errors = [], []
        self.work.finished.connect(self.results.append)
        self.work.failed.connect(self.errors.append)

    def settle(self):
        self.assertTrue(driver.wait(lambda: not self.work.busy and gc.isenabled(), 60))
        driver.rest(0.05)

    def test_cycles_are_freed_in_the_gui_thread(self):
        freed = []
        for _ in range(50):
            Mourned(freed)
        self.work.start(litter)
        self.settle()
        gc.collect()
        self.assertEqual(self.results, [300000])
        self.assertEqual(set(freed), {threading.get_ident()})
        self.assertEqual(len(freed), 50)

    def test_the_collector_stays_as_the_host_has_it(self):
        gc.disable()
        try:
            self.work.start(litter)
            self.assertTrue(driver.wait(lambda: bool(self.results), 60))
            driver.rest(0.05)
            self.assertFalse(gc.isenabled())
        finally:
            gc.enable()

    def test_what_hands_its_progress_to_nobody_is_cancelled_too(self):
        begun, ended, given_up = threading.Event(), threading.Event(), threading.Event()
        block = Part.makeBox(1, 1, 1).exportBrepToString()

        def endless(progress):
            begun.set()
            try:
                while not given_up.is_set():
                    core.tessellate(block, 0.1)
            finally:
                ended.set()

        self.work.start(endless)
        self.assertTrue(begun.wait(30))
        self.work.cancel()
        stopped = driver.wait(ended.is_set, 30)
        given_up.set()
        self.assertTrue(stopped)
        self.assertEqual((self.results, self.errors), ([], []))

    def test_the_newest_wins_and_the_collector_comes_back(self):
        gate = threading.Event()

        def first(progress):
            gate.wait(30)
            return "first"

        self.work.start(first)
        self.work.start(lambda progress: "second")
        self.assertTrue(driver.wait(lambda: bool(self.results), 60))
        self.assertFalse(gc.isenabled())  # the first is still there
        gate.set()
        self.settle()
        self.assertEqual(self.results, ["second"])

    def test_what_is_cancelled_says_nothing(self):
        looks = []

        def work(progress):
            while progress(0.5):
                looks.append(1)
            return "given up"

        self.work.start(work)
        self.assertTrue(driver.wait(lambda: bool(looks), 60))
        self.work.cancel()
        self.settle()
        self.assertEqual((self.results, self.errors), ([], []))

    def test_a_failure_arrives(self):
        def work(progress):
            raise ValueError("as it was raised")

        self.work.start(work)
        self.settle()
        self.assertEqual([str(error) for error in self.errors], ["as it was raised"])

    @unittest.skipUnless(sys.platform == "linux", "threads have a niceness of their own on Linux only")
    def test_it_gives_way_to_the_gui(self):
        def work(progress):
            return os.getpriority(os.PRIO_PROCESS, threading.get_native_id())

        self.work.start(work)
        self.settle()
        own = os.getpriority(os.PRIO_PROCESS, os.getpid())
        self.assertEqual(self.results, [min(own + NICER, 19)])  # 19: the last there is

    def test_it_may_be_forgotten_while_it_runs(self):
        ended = threading.Event()

        def work(progress):
            litter(lambda share: True)
            ended.set()

        self.work.start(work)
        gone = []
        self.work.destroyed.connect(lambda: gone.append(QtCore.QThread.currentThread()))
        self.work = None
        self.assertTrue(driver.wait(ended.is_set, 60))
        self.assertTrue(driver.wait(lambda: bool(gone), 60))
        self.assertEqual(gone, [QtCore.QCoreApplication.instance().thread()])


def main():
    return driver.run_tests(RunsInTheBackground)
