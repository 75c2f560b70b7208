"""One case from plan to cut: make_program -> LinuxCNC -> phase, prediction, places, marks.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
import csv
import dataclasses
import hashlib
import os
import pathlib
import subprocess
import tempfile

import numpy

from . import controller, cutting, load, phase

FLUTES, RADIUS, SPACING, SENSE = 2, 1.0, 0.5, -1
RIDGE = SPACING ** 2 / (4 * RADIUS)  # about the height of the peaks between dimples, mm


@dataclasses.dataclass
class Case:
    strategy: str              # of make_program
    acceleration: float        # mm/s²
    velocity: float = 100.0    # mm/s
    patches: int = 1
    speed_ratio: float = 1.0   # true spindle speed / planned
    options: dict = dataclasses.field(default_factory=dict)

    @property
    def flutes(self):
        return int(self.options.get('flutes', FLUTES))

    @property
    def radius(self):
        return float(self.options.get('radius', RADIUS))

    @property
    def upright(self):
        """(3, 3): turns the axis of a leaned tool upright."""
        axis = numpy.array([float(self.options.get(key, key == 'az')) for key in ('ax', 'ay', 'az')])
        x, y, z = axis / numpy.linalg.norm(axis)
        across = numpy.array([[0, 0, -x], [0, 0, -y], [x, y, 0]])
        return numpy.eye(3) + across + across @ across / (1 + z)

    def machine(self):
        return controller.Machine(acceleration=self.acceleration, velocity=self.velocity,
                                  speed_ratio=self.speed_ratio)


@dataclasses.dataclass
class Result:
    log: controller.Log
    targets: phase.Targets
    report: phase.Report
    points: numpy.ndarray     # of the dimples on the surface, mm
    normals: numpy.ndarray
    predicted: numpy.ndarray  # when the motion model says that the tool passes each dimple, s
    predicted_error: numpy.ndarray  # degrees, constant offset removed
    planned_turns: numpy.ndarray  # spindle turns that the plan gives each dimple
    flutes: int = FLUTES
    radius: float = RADIUS        # mm
    upright: numpy.ndarray = dataclasses.field(default_factory=lambda: numpy.eye(3))  # turns the tool so

    def drift(self):
        """Spindle turns that the machine took above the plan, degrees per dimple."""
        turns = numpy.interp(self.report.time, self.log.time, self.log.turns)
        late = 360 * (turns - self.planned_turns)
        return float(late[-1] - late[0]) / (len(late) - 1)

    def time_difference(self):
        """Logged less predicted passing times, s; the start of the clocks is the mean's affair."""
        difference = self.report.time - self.predicted
        return difference - 0.5 * (difference.max() + difference.min())

    def edge(self, offset=None):
        """In the frame in which the tool stands upright; programs have the point under the ball's centre."""
        offset = self.report.offset if offset is None else offset
        up = numpy.array([0.0, 0.0, self.radius])
        log = dataclasses.replace(self.log, tip=(self.log.tip + up) @ self.upright.T - up)
        return cutting.Edge(log, offset, self.radius, self.flutes, SENSE)

    def places(self):
        return cutting.places(self.edge(), self.report, self.points @ self.upright.T,
                              self.normals @ self.upright.T)

    def unwanted_marks(self, reach=RIDGE):
        return cutting.unwanted_marks(self.edge(), self.report, self.points, self.normals, reach,
                                      SPACING)


def make(case, stem, program=None):
    """Writes stem.ngc and stem.csv."""
    program = program or os.environ['MAKE_PROGRAM']
    words = ['%s=%s' % entry for entry in case.options.items()]
    subprocess.run([program, case.strategy, str(case.acceleration), str(case.velocity),
                    str(case.patches), str(stem), 'ratio=%g' % case.speed_ratio, *words],
                   check=True, stdout=subprocess.DEVNULL)


def run(case, program=None, logs=None, limit=120.0):
    """Plans, runs and measures one case. `logs`: a folder in which logs are kept; a program that has not
    changed is not run again. `limit`: wall seconds for an attempt at the run. Raises
    subprocess.CalledProcessError where there is no plan, and as controller.run."""
    with tempfile.TemporaryDirectory(prefix='patchmill-case-') as folder:
        stem = pathlib.Path(folder) / 'case'
        make(case, stem, program)
        log = logged(stem.with_suffix('.ngc'), case.machine(), logs, limit)
        table = stem.with_suffix('.csv')
        targets = phase.read_targets(table)
        points, normals = cutting.read_surface(table)
        with open(table, newline='', encoding='ascii') as file:
            rows = list(csv.DictReader(file))
    predicted = numpy.array([[float(row[name]) for row in rows]
                             for name in ('predicted_s', 'predicted_turns',
                                          'planned_turns')])
    error, _ = phase.without_offset(360 * predicted[1] - SENSE * targets.azimuth, 360 / case.flutes)
    report = phase.measure(log, targets, case.flutes, SENSE)
    return Result(log, targets, report, points, normals, predicted[0], error,
                  predicted[2], case.flutes, case.radius, case.upright)


def logged(program, machine, logs, limit):
    """The log of a program on a machine, from the folder `logs` if it is there."""
    if logs is None:
        return controller.run(program, machine, limit=limit)
    what = program.read_bytes() + repr(machine).encode()
    slower = load.slower()
    name = hashlib.sha256(what).hexdigest() + ('' if slower == 1 else '-%g' % slower)
    kept = pathlib.Path(logs) / (name + '.npz')
    if kept.exists():
        with numpy.load(kept) as found:
            return controller.Log(found['time'], found['tip'], found['turns'], found['line'], 0, found['tip'])
    log = controller.run(program, machine, limit=limit)
    if machine.kinematics == 'xyz':
        kept.parent.mkdir(parents=True, exist_ok=True)
        numpy.savez_compressed(kept, time=log.time, tip=log.tip, turns=log.turns, line=log.line)
    return log
