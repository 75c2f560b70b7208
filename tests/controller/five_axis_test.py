"""Five-axis programs through LinuxCNC with xyzac-trt and xyzbc-trt kinematics: is the tool tip where the
plan has it, in the frame of the work, by the logged joints? Do programs with and without TCP lead the
joints the same way? Is the phase held while C turns?

S1000, N 2, f 0.5, R 1, 14 x 14 dimples on the Bezier surface of Xu & Sasahara 2016, Table 1, with its
steepest corner; the tool leads by 15 degrees towards X. Run with MAKE_FIVE_AXIS set to the program of that
name. Offsets of the tables: harness/table.py.
SPDX-License-Identifier: LGPL-2.1-or-later
"""
import csv
import dataclasses
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from harness import controller, load, phase, table  # noqa: E402

FLUTES, SENSE = 2, -1
MICROMETRE = 1e-3
# acceleration -> phase error, rms and largest [degrees]; turns per dimple with TCP, without
BOUNDS = {500: (3.0, 9.0, 1.3, 1.5), 2000: (2.0, 6.0, 0.9, 0.9), 10000: (1.5, 4.0, 0.7, 0.7)}


@dataclasses.dataclass
class Result:
    log: controller.Log
    time: numpy.ndarray      # when the tool is at each dimple, s
    miss: numpy.ndarray      # how far the programmed point is from its place then, mm
    error: numpy.ndarray     # phase, degrees, constant offset removed
    turns: float             # per dimple
    azimuth_off: float       # greatest difference of planned and logged contact azimuth, degrees
    rotary: numpy.ndarray    # (n, 2) at each dimple, degrees
    joints: numpy.ndarray    # (n, 3) at each dimple, mm
    points: numpy.ndarray    # (n, 3) of the dimples in the frame of the work, mm
    normals: numpy.ndarray   # (n, 3)
    offset: float            # the constant offset of the phase, degrees

    @property
    def rms(self):
        return float(numpy.sqrt(numpy.mean(self.error ** 2)))

    @property
    def largest(self):
        return float(abs(self.error).max())


def columns(path, names):
    with open(path, newline='', encoding='ascii') as file:
        rows = list(csv.DictReader(file))
    return numpy.array([[float(row[name]) for name in names] for row in rows])


def run(kind, form, acceleration=2000, velocity=100, spindle=1.0, limit=120.0, **options):
    """One program of make_five_axis, made, run and measured. `spindle`: true speed / commanded speed;
    `limit`: wall seconds for an attempt."""
    words = ['%s=%s' % entry for entry in options.items()]
    with tempfile.TemporaryDirectory(prefix='patchmill-five-') as folder:
        stem = pathlib.Path(folder) / 'case'
        subprocess.run([os.environ['MAKE_FIVE_AXIS'], kind, form, str(acceleration), str(velocity),
                        str(stem), *words], check=True, stdout=subprocess.DEVNULL)
        machine = controller.Machine(acceleration=acceleration, velocity=velocity,
                                     kinematics='xyz' + kind, speed_ratio=spindle)
        log = controller.run(stem.with_suffix('.ngc'), machine, limit=limit, stops=2)
        path = stem.with_suffix('.csv')
        targets = phase.read_targets(path)
        normals = columns(path, ('nx', 'ny', 'nz'))
        points = columns(path, ('px', 'py', 'pz'))
        if options.get('ball'):  # the log has the programmed point, which with TCP is in the work frame
            targets.tip = columns(path, ('kx', 'ky', 'kz'))
    time, miss = phase.passing_times(log, targets)

    def at_dimples(values):
        return numpy.column_stack([numpy.interp(time, log.time, v) for v in values.T])

    rotary = at_dimples(log.rotary)
    seen = numpy.einsum('nij,nj->ni', table.work_to_housing(machine.kinematics, rotary), normals)
    azimuth = numpy.degrees(numpy.arctan2(-seen[:, 1], -seen[:, 0]))
    turns = numpy.interp(time, log.time, log.turns)
    error, offset = phase.without_offset(360 * turns - SENSE * azimuth, 360 / FLUTES)
    off = abs(phase.wrapped(azimuth - targets.azimuth, 360)).max()
    return Result(log, time, miss, error, (turns[-1] - turns[0]) / (len(turns) - 1), off, rotary,
                  at_dimples(log.joints), points, normals, offset)


class TipInWork(unittest.TestCase):
    """Whatever the strategy, the kinematics and the form: within 2 micrometres of the plan."""

    def check(self, *case, **options):
        with self.subTest(case=case, **options):
            self.check_tip(case, options)

    @load.told_from_load
    def check_tip(self, case, options):
        result = run(*case, **options)
        print('%s %s: tip within %.3f um, C from %.1f to %.1f degrees'
              % (case, options, result.miss.max() / MICROMETRE, result.log.rotary[:, 1].min(),
                 result.log.rotary[:, 1].max()))
        self.assertLessEqual(result.miss.max(), 2 * MICROMETRE)
        self.assertGreater(numpy.ptp(result.rotary[:, 1]), 20.0)

    def test_axes_turning_on_every_move(self):
        for kind in ('ac', 'bc'):
            for form in ('tcp', 'pivot'):
                self.check(kind, form, strategy='feed')
        self.check('ac', 'tcp', strategy='constant')

    def test_spindle_locked(self):
        for kind in ('ac', 'bc'):
            for form in ('tcp', 'pivot'):
                self.check(kind, form)
        self.check('ac', 'tcp', ball=1)


class FormsAgree(unittest.TestCase):
    """The same path with TCP and without leads the joints the same way."""

    def test_joints(self):
        for kind in ('ac', 'bc'):
            with self.subTest(kind=kind):
                self.check(kind)

    @load.told_from_load
    def check(self, kind):
        # constant feed stops at every vertex: the ends of moves can be compared
        tcp = run(kind, 'tcp', strategy='constant', side=8)
        pivot = run(kind, 'pivot', strategy='constant', side=8, chord=0.0005, clear=0.0005)
        linear = numpy.linalg.norm(tcp.joints - pivot.joints, axis=1).max()
        rotary = abs(tcp.rotary - pivot.rotary).max()
        along = self.farthest(tcp, pivot)
        print('%s: at the dimples %.3f um, %.5f degrees; on the way %.3f um'
              % (kind, linear / MICROMETRE, rotary, along / MICROMETRE))
        self.assertLessEqual(linear, 2 * MICROMETRE)
        self.assertLessEqual(rotary, 1e-3)
        self.assertLessEqual(along, 2 * MICROMETRE)

    @staticmethod
    def farthest(one, other, every=7):
        """Greatest distance of a moment's joints in `one` from the way of the joints in `other`. A degree
        counts as a tenth of a millimetre, so that 2 micrometres bound 0.02 degrees on the way."""
        a = numpy.column_stack([one.log.joints, 0.1 * one.log.rotary])
        b = numpy.column_stack([other.log.joints, 0.1 * other.log.rotary])
        # from the first dimple to the last: the way of a rapid is the machine's
        cutting = (one.log.time > one.time[0]) & (one.log.time < one.time[-1])
        start, step = b[:-1], numpy.diff(b, axis=0)
        square = numpy.maximum(numpy.einsum('ij,ij->i', step, step), 1e-30)
        worst = 0.0
        for point in a[cutting][::every]:
            along = numpy.clip(numpy.einsum('ij,ij->i', point - start, step) / square, 0, 1)
            worst = max(worst, numpy.linalg.norm(start + along[:, None] * step - point, axis=1).min())
        return worst


class PhaseWithCTurning(unittest.TestCase):
    def check(self, kind, form, acceleration, velocity, **options):
        with self.subTest(kind=kind, form=form, acceleration=acceleration, velocity=velocity, **options):
            self.check_phase(kind, form, acceleration, velocity, options)

    @load.told_from_load
    def check_phase(self, kind, form, acceleration, velocity, options):
        result = run(kind, form, acceleration, velocity, **options)
        print('%s %s %d mm/s², %d mm/s %s: rms %.2f°, largest %.2f°, %.3f turns per dimple'
              % (kind, form, acceleration, velocity, options or '', result.rms, result.largest,
                 result.turns))
        rms, largest, with_tcp, without = BOUNDS[acceleration]
        self.assertLessEqual(result.rms, rms)
        self.assertLessEqual(result.largest, largest)
        self.assertLessEqual(result.turns, with_tcp if form == 'tcp' else without)
        self.assertLessEqual(result.azimuth_off, 1e-3)
        self.assertGreater(numpy.ptp(result.rotary[:, 1]), 20.0)

    def test_one_patch(self):
        for acceleration in BOUNDS:
            for velocity in (100, 300):
                self.check('ac', 'tcp', acceleration, velocity)
        self.check('bc', 'tcp', 2000, 100)

    def test_without_tcp(self):
        for kind, acceleration in (('ac', 2000), ('bc', 2000), ('bc', 10000)):
            for velocity in (100, 300):
                self.check(kind, 'pivot', acceleration, velocity)

    def test_spindle_one_percent_off(self):
        for ratio in (0.99, 1.01):
            for velocity in (100, 300):
                self.check('ac', 'tcp', 2000, velocity, spindle=ratio)

    def test_four_patches_with_links(self):
        for acceleration in (2000, 10000):
            for velocity in (100, 300):
                self.check('ac', 'tcp', acceleration, velocity, patches=4)


if __name__ == '__main__':
    load.main()
