"""Spindle phase and tool position at each dimple, from a controller's log.

    targets = phase.read_targets('patch.csv')
    report = phase.measure(log, targets, flutes=2, sense=-1)

A dimple is right when the spindle has turned by s·α, modulo one tooth: s the spindle's sense, α the
azimuth of the contact point about the tool axis (Xu & Sasahara 2016, section 3.1). The start phase
is one unknown constant (section 3.3); its best value is taken away.
SPDX-License-Identifier: LGPL-2.1-or-later
"""
import csv
import dataclasses

import numpy

SLACK = 12  # samples looked at beyond a move: the joints follow the planner by a few periods


@dataclasses.dataclass
class Targets:
    """One entry for each dimple, in milling order."""
    line: numpy.ndarray     # program line of the move that ends on the dimple
    tip: numpy.ndarray      # (n, 3) tool tip there, mm
    azimuth: numpy.ndarray  # α, degrees
    patch: numpy.ndarray    # number of its patch


@dataclasses.dataclass
class Report:
    """Angles in degrees, lengths in mm, times in s."""
    time: numpy.ndarray    # when the tool was on each dimple
    error: numpy.ndarray   # phase error of each dimple, constant offset removed
    miss: numpy.ndarray    # how far the tool stayed from each dimple's place at that moment
    offset: float          # the constant offset
    rms: float
    largest: float
    turns_per_dimple: float  # from the first dimple to the last


def read_targets(path):
    """CSV with the columns line, x, y, z, azimuth_deg, patch."""
    with open(path, newline='', encoding='ascii') as file:
        rows = list(csv.DictReader(file))
    columns = {name: numpy.array([float(row[name]) for row in rows])
               for name in ('line', 'x', 'y', 'z', 'azimuth_deg', 'patch')}
    tip = numpy.column_stack([columns['x'], columns['y'], columns['z']])
    return Targets(columns['line'].astype(int), tip, columns['azimuth_deg'],
                   columns['patch'].astype(int))


def nearest(time, tip, point):
    """Moment at which the polyline `tip` is nearest to `point`, and how near. A tool that stands
    there is there in the middle of its stay."""
    start, step = tip[:-1], numpy.diff(tip, axis=0)
    square = numpy.maximum(numpy.einsum('ij,ij->i', step, step), 1e-30)
    along = numpy.clip(numpy.einsum('ij,ij->i', point - start, step) / square, 0.0, 1.0)
    distance = numpy.linalg.norm(start + along[:, None] * step - point, axis=1)
    moments = time[:-1] + along * numpy.diff(time)
    there = moments[distance <= distance.min() + 1e-6]
    return 0.5 * (there[0] + there[-1]), distance.min()


def passing_times(log, targets):
    """When the tool passes each dimple: looked for while its move and the next one are running."""
    begin = {}
    end = {}
    for index, line in enumerate(log.line.astype(int)):
        begin.setdefault(line, index)
        end[line] = index
    lines = sorted(begin)
    times, misses = [], []
    for line, point in zip(targets.line, targets.tip):
        here = line if line in begin else max(at for at in lines if at < line)
        after = next((at for at in lines if at > here), here)
        window = slice(begin[here], min(end[after] + SLACK, len(log.time)))
        moment, miss = nearest(log.time[window], log.tip[window], point)
        times.append(moment)
        misses.append(miss)
    return numpy.array(times), numpy.array(misses)


def wrapped(angle, period):
    return (angle + period / 2) % period - period / 2


def without_offset(angle, period):
    """Angles modulo `period` less their circular mean, and that mean."""
    turn = 2 * numpy.pi / period
    mean = numpy.angle(numpy.mean(numpy.exp(1j * turn * angle))) / turn
    rest = wrapped(angle - mean, period)
    correction = rest.mean()
    return rest - correction, mean + correction


def measure(log, targets, flutes, sense=-1):
    """Phase error at each dimple, modulo one tooth, less one constant offset for all of them."""
    time, miss = passing_times(log, targets)
    turns = numpy.interp(time, log.time, log.turns)
    error, offset = without_offset(360 * turns - sense * targets.azimuth, 360 / flutes)
    return Report(time, error, miss, offset, float(numpy.sqrt(numpy.mean(error ** 2))),
                  float(numpy.abs(error).max()), float((turns[-1] - turns[0]) / (len(turns) - 1)))
