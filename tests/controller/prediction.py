#!/usr/bin/python3
"""What the motion model says of a lock beside what LinuxCNC's planner does, over many machines and textures.

    MAKE_PROGRAM=build/tests/controller/make_program tests/controller/prediction.py [random|faces] [LOGS]

Prints a table of docs/rows.md: without a word the cases that it names, with `random` twenty random ones, with
`faces` the whole face of Table 1, which takes minutes. Logs are kept in the folder LOGS, so that a program
that has not changed is not run again.
SPDX-License-Identifier: LGPL-2.1-or-later
"""
import dataclasses
import pathlib
import random
import subprocess
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from harness import load  # noqa: E402
from harness.case import Case, SPACING, run  # noqa: E402

FACTOR = 1.5             # that prediction and log may differ by, either way
RMS, LARGEST = 3.0, 9.0  # degrees: PhaseLimits of the core
TOOTH = 11               # servo periods: a lock of fewer for a tooth is not said to hold
AS_FORESEEN = 0.05       # degrees rms, at the dimples
MISS = 2e-3              # mm: how near the path passes to every dimple
LEANED = {'ax': 0.55, 'ay': 0.3, 'az': 0.8}
WIDE = {'radius': 1.5, 'flutes': 3, 'rpm': 1200, 'spacing': 0.6, 'side': 9}
STEEP = {'radius': 2, 'rpm': 3000, 'spacing': 0.8, 'side': 12, 'triangle': 1}


def named():
    """(name, Case) of single patches and of the small cases in docs/rows.md."""
    for acceleration in (500, 2000, 10000):
        yield 'a patch of 14 x 14', Case('locked', acceleration)
    yield 'R 1.5, N 3, two patches of 9', Case('locked', 1000, 150, 2, options=WIDE)
    yield 'R 1.5, N 3, two patches of 9', Case('locked', 1000, 150, 2, options=dict(WIDE, rows=1))
    yield 'R 2, a triangle of 12', Case('locked', 8000, 300, 1, options=STEEP)
    yield 'R 2, a triangle of 12', Case('locked', 8000, 300, 1, options=dict(STEEP, rows=1))


ROWS = (500, 1000), (500, 1300), (2000, 1000), (2000, 2000), (2000, 2400), (10000, 1000), (10000, 2700)
UPRIGHT = (500, 1000), (2000, 500), (2000, 1000), (2000, 2000), (10000, 1000)
ONE_PATCH = (500, 1000), (2000, 1000), (10000, 1000), (2000, 3000)


def faces():
    """(name, Case) of the whole face of Table 1: leaned and upright, in rows, as helices and as one patch."""
    for acceleration, rpm in ROWS + ((2000, 3000),):
        yield 'leaned', Case('locked', acceleration, 100, 64, options=dict(LEANED, rows=1, rpm=rpm))
    for acceleration, rpm in UPRIGHT + ((2000, 3000),):
        yield 'upright', Case('locked', acceleration, 100, 64, options={'rows': 1, 'rpm': rpm})
    for acceleration in (500, 2000, 10000):
        yield 'leaned', Case('locked', acceleration, 100, 64, options=LEANED)
    for acceleration, rpm in ONE_PATCH:
        options = dict(LEANED, side=112, rpm=rpm)
        yield 'leaned, one patch', Case('locked', acceleration, 100, 64, options=options)


def drawn(count=20, seed=2016):
    """(name, Case) of random machines, tools, textures and corners of the face; the same every time."""
    draw = random.Random(seed)
    for number in range(count):
        options = {
            'radius': draw.choice([0.75, 1, 1.5, 2, 3]), 'flutes': draw.choice([2, 2, 3, 4]),
            'rpm': draw.randrange(300, 2001, 50), 'spacing': round(draw.uniform(0.3, 0.9), 2),
            'side': draw.randrange(8, 15), 'triangle': draw.randrange(2),
            'x': round(draw.uniform(-27.5, 15), 1), 'y': round(draw.uniform(-27.5, 15), 1),
            'rows': draw.randrange(2)}
        acceleration = int(round(300 * (10000 / 300) ** draw.random(), -2))
        velocity = draw.choice([50, 100, 150, 200, 300])
        patches = draw.choice([1, 2])
        yield 'random %d' % number, Case('locked', acceleration, velocity, patches, options=options)


@dataclasses.dataclass
class Finding:
    """Phase errors [degrees], rms and largest, of the log and as predicted, and how far the two are apart at
    the dimples, rms; how far the path is from a dimple [mm]."""
    log: tuple
    predicted: tuple
    apart: float
    miss: float
    said_to_hold: bool
    turns: float
    seconds: float
    place: float = float('nan')  # of the spacing: how far the marks' deepest points are off, rms
    there: str = ''  # how many of the dimples have theirs within a fourth of the spacing

    def within(self, factor=FACTOR):
        return all(a <= factor * b and b <= factor * a for a, b in zip(self.log, self.predicted))

    def logged_as(self, other):
        """Whether the log of another run says the same, to a twentieth."""
        return other is not None and all(
            abs(a - b) <= 0.05 * b for a, b in zip(self.log, other.log))

    def held(self):
        return self.log[0] <= RMS and self.log[1] <= LARGEST

    def wrongly(self):
        """Whether a lock is said to hold that does not."""
        return self.said_to_hold and not self.held()


def finding(case, logs=None, marks=False):
    """What run_once says of a case. On a busy machine the queue of moves is filled too slowly: a log that is
    not as foreseen is made again, slower, until one is, or two are alike. Raises load.Unknown if none are."""
    before = None
    for slower in load.SLOWER:
        with load.attempting(load.Attempt(slower)):
            found = run_once(case, logs, marks)
        if found is None or found.apart <= AS_FORESEEN or found.logged_as(before):
            return found
        before = found
    raise load.Unknown('no two logs of it are alike')


def run_once(case, logs=None, marks=False):
    """Runs a case; None where there is no plan for it. `marks`: they are cut with the log, and looked for."""
    try:
        result = run(case, logs=logs, limit=300.0)
    except subprocess.CalledProcessError:
        return None
    report, error = result.report, result.predicted_error
    predicted = float(numpy.sqrt(numpy.mean(error ** 2))), float(abs(error).max())
    tooth = 60.0 / float(case.options.get('rpm', 1000)) / case.flutes
    holds = (predicted[0] <= RMS and predicted[1] <= LARGEST
             and tooth >= TOOTH * case.machine().period * (1 - 1e-9))
    apart = float(numpy.sqrt(numpy.mean((report.error - error) ** 2)))
    found = Finding((report.rms, report.largest), predicted, apart, float(report.miss.max()), holds,
                    report.turns_per_dimple, float(report.time[-1] - report.time[0]))
    if marks:
        spacing = float(case.options.get('spacing', SPACING))
        places = result.places()
        there = numpy.linalg.norm(places.error, axis=1) < 0.25 * spacing
        found = dataclasses.replace(found, place=places.rms / spacing,
                                    there='%d of %d' % (there.sum(), len(there)))
    return found


def row(name, case, found):
    option = case.options.get
    what = '| %s, R %g, N %d, f %g, %s | %d | %d | %d | ' % (
        name, case.radius, case.flutes, option('spacing', 0.5), 'rows' if option('rows') else 'helix',
        case.acceleration, case.velocity, option('rpm', 1000))
    if found is None:
        return what + 'no plan | | | | | |'
    marks = ' %.2f %% | %s |' % (100 * found.place, found.there) if found.there else ''
    return what + '%.3f | %.2f / %.1f | %.2f / %.1f | %.2f | %.2f | %s | %.1f |%s' % (
        found.turns, *found.log, *found.predicted, found.apart, 1e3 * found.miss,
        ('yes' if found.said_to_hold else 'no') + (', wrongly' if found.wrongly() else ''), found.seconds,
        marks)


def main():
    words = sys.argv[1:]
    cases = {'random': drawn, 'faces': faces}.get(words[0] if words else '', named)
    logs = next((word for word in words if word not in ('random', 'faces')), None)
    marks = cases is faces
    print('| case | mm/s² | mm/s | S | turns per dimple | log | predicted | apart |'
          ' beside, µm | said to hold | s |' + (' place, of f | there |' if marks else ''))
    print('| --- ' * (13 if marks else 11) + '|')
    outside, wrong = [], []
    for name, case in cases():
        try:
            found = finding(case, logs, marks)
        except load.Unknown as unknown:
            print('%s: unknown: %s' % (name, unknown), file=sys.stderr)
            continue
        print(row(name, case, found), flush=True)
        if found and not found.within():
            outside.append(name)
        if found and found.wrongly():
            wrong.append(name)
    print('\nOutside a factor of %g: %d (%s). Said to hold and do not: %d.' % (
        FACTOR, len(outside), ', '.join(outside) or 'none', len(wrong)))


if __name__ == '__main__':
    main()
