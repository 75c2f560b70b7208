"""The phase that each strategy holds, through LinuxCNC's planner at a 1 ms servo period.

S1000, N 2, f 0.5, R 1, patches of 14 x 14 dimples on the Bezier surface of Xu & Sasahara 2016,
Table 1, with its steepest corner. Run with MAKE_PROGRAM set to the program of that name.
SPDX-License-Identifier: LGPL-2.1-or-later
"""
import dataclasses
import os
import pathlib
import random
import sys
import tempfile
import unittest

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import prediction  # noqa: E402
from harness import controller, load, phase  # noqa: E402
from harness.case import Case, FLUTES, SENSE, SPACING, run  # noqa: E402

PERIOD = 1e-3
# acceleration -> bounds of phase error, rms and largest [degrees]; turns per dimple; place [of f]
BOUNDS = {500: (3.0, 9.0, 1.3, 0.03), 2000: (2.0, 6.0, 0.9, 0.03), 10000: (1.5, 4.0, 0.7, 0.02)}


class SpindleLocked(unittest.TestCase):
    @load.told_from_load
    def check(self, case, *further):
        """Runs a case and holds it against the bounds and `further` checks of (result, bound of the
        place)."""
        result = run(case)
        rms, largest, turns, place = BOUNDS[case.acceleration]
        report = result.report
        self.assertLessEqual(report.rms, rms)
        self.assertLessEqual(report.largest, largest)
        self.assertLessEqual(report.turns_per_dimple, turns)
        self.assertLessEqual(report.miss.max(), 1e-3)
        for check in further:
            check(result, place)

    def in_place(self, result, place):
        self.assertLessEqual(result.places().rms, place * SPACING)

    def in_time(self, result, _):
        """The model's times beside the log."""
        self.assertLessEqual(abs(result.time_difference()).max(), PERIOD)

    def four_patches(self, result, _):
        self.assertEqual(len(set(result.targets.patch)), 4)

    def no_other_mark(self, result, _):
        self.assertEqual(result.unwanted_marks(), [])

    def test_one_patch(self):
        for acceleration in BOUNDS:
            for velocity in (100, 300):
                with self.subTest(acceleration=acceleration, velocity=velocity):
                    self.check(Case('locked', acceleration, velocity), self.in_place, self.in_time)

    def test_four_patches_with_links(self):
        for acceleration in BOUNDS:
            for velocity in (100, 300):
                with self.subTest(acceleration=acceleration, velocity=velocity):
                    case = Case('locked', acceleration, velocity, 4)
                    self.check(case, self.four_patches, self.in_place)

    def test_spindle_one_percent_off(self):
        for ratio in (0.99, 1.01):
            for velocity in (100, 300):
                with self.subTest(ratio=ratio, velocity=velocity):
                    self.check(Case('locked', 2000, velocity, 1, ratio))

    def test_no_tooth_marks_between_rows(self):
        for acceleration in (2000, 10000):
            with self.subTest(acceleration=acceleration):
                self.check(Case('locked', acceleration), self.no_other_mark)


class Prediction(unittest.TestCase):
    """A small sample of what prediction.py does with many more."""

    @load.told_from_load
    def check(self, case):
        found = prediction.finding(case)
        self.assertTrue(found.within(), found)
        self.assertFalse(found.wrongly(), found)
        self.assertLessEqual(found.miss, prediction.MISS)
        self.assertLessEqual(found.apart, 0.1)  # at each dimple, not only on the whole

    def test_a_patch_and_two_of_another_tool(self):
        for case in (Case('locked', 2000), Case('locked', 1000, 150, 2, options=prediction.WIDE),
                     Case('locked', 1000, 150, 2, options=dict(prediction.WIDE, rows=1))):
            with self.subTest(acceleration=case.acceleration, options=case.options):
                self.check(case)

    def test_a_finding_that_is_off_is_told(self):
        near = prediction.Finding((0.2, 1.0), (0.25, 1.4), 0.05, 1e-4, True, 0.5, 1.0)
        self.assertTrue(near.within())
        self.assertFalse(near.wrongly())
        self.assertFalse(dataclasses.replace(near, predicted=(0.12, 1.0)).within())
        self.assertFalse(dataclasses.replace(near, predicted=(0.2, 1.6)).within())
        self.assertTrue(dataclasses.replace(near, log=(0.2, 9.1)).wrongly())
        self.assertTrue(dataclasses.replace(near, log=(3.1, 9.0)).wrongly())
        self.assertFalse(dataclasses.replace(near, log=(3.1, 9.1), said_to_hold=False).wrongly())


class ConstantFeed(unittest.TestCase):
    @load.told_from_load
    def check_zigzag(self, acceleration):
        result = run(Case('constant', acceleration))
        self.assertGreater(result.report.rms, 30.0)
        # every move stops: the model knows each time to one interpolation period
        self.assertLessEqual(abs(result.time_difference()).max(), PERIOD)

    @load.told_from_load
    def check_fitted(self, acceleration):
        result = run(Case('constant', acceleration, options={'fit': 1}))
        self.assertLessEqual(result.report.rms, 4.0)
        self.assertLessEqual(abs(result.time_difference()).max(), PERIOD)

    def test_zigzag_is_lost_as_predicted(self):
        for acceleration in BOUNDS:
            with self.subTest(acceleration=acceleration):
                self.check_zigzag(acceleration)

    def test_legs_fitted_to_the_stops_hold(self):
        """Open loop: a servo period is 6 degrees of spindle, half of it is the best there is."""
        for acceleration in BOUNDS:
            with self.subTest(acceleration=acceleration):
                self.check_fitted(acceleration)


class Calibration(unittest.TestCase):
    @load.told_from_load
    def test_best_mark_gives_the_start_phase(self):
        """Each dimple is asked for 1 degree more; the mark that is at its place tells the phase."""
        result = run(Case('locked', 2000, options={'step': 1}))
        period = 360 / FLUTES
        turns = numpy.interp(result.report.time, result.log.time, result.log.turns)
        steps = numpy.arange(len(turns))
        _, known = phase.without_offset(
            360 * turns - SENSE * result.targets.azimuth - steps, period)
        generator = random.Random(2016)
        for _ in range(8):
            unknown = generator.uniform(0, period)
            miss = self.misses(result, result.edge(known - unknown))
            best = self.middle_of_the_good(miss)
            self.assertLessEqual(abs(phase.wrapped(-best - unknown, period)), 1.0)

    @load.told_from_load
    def check_from_index(self, case):
        result = run(case)
        rpm = case.options.get('rpm', 1000)
        off = phase.wrapped(result.report.offset, 360 / FLUTES)
        self.assertLessEqual(abs(off), 0.5 * 6 * rpm * PERIOD + 0.5)

    def test_every_program_is_counted_from_the_index(self):
        """What one calibration finds holds for another texture, speed and acceleration: within the half
        period in which nobody knows where the index passes."""
        for acceleration, options in ((2000, {'x': 0, 'y': 0}), (500, {'x': 10, 'y': -20, 'rows': 1}),
                                      (2000, {'radius': 1.5, 'spacing': 0.6, 'rpm': 1300})):
            with self.subTest(acceleration=acceleration, options=options):
                self.check_from_index(Case('locked', acceleration, options=dict(options, anchored=1)))

    @staticmethod
    def middle_of_the_good(miss, reach=8):
        """Number of the mark about which the misses grow alike on both sides: the V that fits them
        best in absolute deviation. A single mark may be good by luck."""
        steps = numpy.arange(len(miss))
        best = (numpy.inf, 0)
        for middle in steps[reach:-reach]:
            near = slice(middle - reach, middle + reach + 1)
            distance = abs(steps[near] - middle)
            for slope in numpy.linspace(1e-3, 5e-3, 17):
                misfit = abs(miss[near] - slope * distance).sum()
                best = min(best, (misfit, int(middle)))
        return best[1]

    @staticmethod
    def misses(result, edge):
        """How far each mark's deepest point is from its dimple, mm."""
        found = []
        for moment, point, normal in zip(result.report.time, result.points, result.normals):
            window = numpy.arange(moment - 0.016, moment + 0.016, 2e-5)
            found.append(numpy.linalg.norm(edge.deepest(window, point, normal)[0] - point))
        return numpy.array(found)


def log_of(speed):
    """A log of a tool that goes along X at the given speeds, mm/s, one for each period."""
    x = numpy.concatenate([[0.0], numpy.cumsum(numpy.asarray(speed) * PERIOD)])
    tip = numpy.column_stack([x, 0 * x, 0 * x])
    time = PERIOD * numpy.arange(len(x))
    return controller.Log(time, tip, 0 * x, 0 * x, 0)


class LoadOrFault(unittest.TestCase):
    """load.told_from_load, with logs as from runs."""

    STEADY = numpy.full(2000, 50.0)
    BRAKED = numpy.where(numpy.arange(2000) % 100 < 20, 10.0, 50.0)

    def outcome(self, *attempts):
        """What becomes of a check whose attempts run with these speeds and have these findings."""
        given = list(attempts)

        @load.told_from_load
        def check():
            speed, finding = given.pop(0)
            if speed is not None:
                load.note(log_of(speed))
            if isinstance(finding, Exception):
                raise finding
            return finding

        try:
            return check(), len(attempts) - len(given)
        except (AssertionError, unittest.SkipTest) as end:
            return type(end), len(attempts) - len(given)

    def test_a_fault_fails_however_slow(self):
        wrong = AssertionError('phase')
        self.assertEqual(self.outcome((self.STEADY, wrong), (self.STEADY, wrong)), (AssertionError, 2))
        self.assertEqual(self.outcome((None, wrong)), (AssertionError, 1))  # no run that load could change

    def test_a_wait_for_the_spindle_is_no_difference(self):
        wrong = AssertionError('phase')
        waited = numpy.concatenate([numpy.zeros(300), self.STEADY])
        self.assertEqual(self.outcome((self.STEADY, wrong), (waited, wrong)), (AssertionError, 2))

    def test_braking_that_is_gone_when_slower_was_load(self):
        wrong = AssertionError('phase')
        self.assertEqual(self.outcome((self.BRAKED, wrong), (self.STEADY, 'held')), ('held', 2))
        shifted = numpy.roll(self.BRAKED, 50)
        found = self.outcome((self.BRAKED, wrong), (shifted, wrong), (self.STEADY, 'held'))
        self.assertEqual(found, ('held', 3))

    def test_what_never_agrees_is_unknown(self):
        wrong, never = AssertionError('phase'), controller.TooFast('never began')
        found = self.outcome((self.BRAKED, wrong), (numpy.roll(self.BRAKED, 50), wrong), (self.STEADY, wrong))
        self.assertEqual(found, (unittest.SkipTest, 3))
        self.assertEqual(self.outcome((None, never), (None, never), (None, never)), (unittest.SkipTest, 3))
        self.assertEqual(self.outcome((None, never), (self.STEADY, 'held')), ('held', 2))


class Harness(unittest.TestCase):
    def test_half_a_program_is_unknown(self):
        """Seen on a busy machine: the queue was empty, the tool at rest, after 3779 of 13741 lines."""
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / 'long.ngc'
            moves = ''.join('G1 X%d F100\n' % n for n in range(100))
            program.write_text('G21\n' + moves + 'M2\n', encoding='ascii')
            log = log_of(numpy.full(5, 1.0))
            self.assertEqual(controller.last_move(program), 101)
            log.line = numpy.array([0, 50, 101, 101, 0])
            controller.require_whole(log, program)
            log.line = numpy.array([0, 50, 50, 50, 0])
            with self.assertRaisesRegex(controller.TooFast, 'line 50 of 101'):
                controller.require_whole(log, program)

    def test_ends_in_time_and_leaves_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / 'wait.ngc'
            program.write_text('G4 P100000\nM2\n', encoding='ascii')
            before = self.processes()
            with self.assertRaisesRegex(controller.TooFast, 'not done'):
                controller.run_once(program, controller.Machine(), 20.0, 5.0)
            self.assertEqual(self.processes() - before, set())

    def test_reports_the_controllers_words(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / 'bad.ngc'
            program.write_text('G21\nG33 X1 K1\nM2\n', encoding='ascii')
            with self.assertRaisesRegex(controller.ControllerError, 'Spindle'):
                controller.run(program)

    @staticmethod
    def processes():
        """Processes that live in the work folder of one of this process' runs."""
        found, mine = set(), f'patchmill-controller-{os.getpid()}-'
        for entry in pathlib.Path('/proc').iterdir():
            try:
                if entry.name.isdigit() and mine in os.readlink(entry / 'cwd'):
                    found.add(entry.name)
            except OSError:
                continue  # gone meanwhile, or another user's
        return found


if __name__ == '__main__':
    load.main()
