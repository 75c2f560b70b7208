#!/usr/bin/python3
"""The whole face of Table 1 on five axes, normal with lead 15 degrees, in rows, through LinuxCNC.

    MAKE_FIVE_AXIS=build/tests/controller/make_five_axis tests/controller/five_axis_face.py [direction=1]

SPDX-License-Identifier: LGPL-2.1-or-later
"""
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import five_axis_test  # noqa: E402
from harness import controller, cutting, table  # noqa: E402
from harness.case import RADIUS, SPACING  # noqa: E402

KIND, UP = 'ac', numpy.array([0.0, 0.0, RADIUS])


def places(result):
    """How far each mark's deepest point is from its dimple, mm: in the frame of the spindle's housing, in
    which the work stands as it does at the dimple."""
    turn = table.work_to_housing('xyz' + KIND, result.rotary)
    off = []
    for moment, point, normal, to_housing in zip(result.time, result.points, result.normals, turn):
        first, last = numpy.searchsorted(result.log.time, [moment - 0.01, moment + 0.01])
        tip = (result.log.tip[first:last] - point) @ to_housing.T
        log = controller.Log(result.log.time[first:last], tip, result.log.turns[first:last], None, 0)
        edge = cutting.Edge(log, result.offset, RADIUS, five_axis_test.FLUTES, five_axis_test.SENSE)
        time = numpy.arange(moment - cutting.WINDOW, moment + cutting.WINDOW, cutting.STEP)
        seen = to_housing @ normal
        found, _ = edge.deepest(time, numpy.zeros(3), seen)
        off.append(numpy.linalg.norm(found - (found @ seen) * seen))
    return numpy.array(off)


def main():
    options = dict(word.split('=') for word in sys.argv[1:])
    result = five_axis_test.run(KIND, 'tcp', patches=64, tip=0.001, rows=1, limit=400.0, **options)
    off = places(result)
    place = 100 * numpy.sqrt(numpy.mean(off ** 2)) / SPACING
    print('%d dimples, %.3f turns per dimple, %.1f s' % (
        len(off), result.turns, result.time[-1] - result.time[0]))
    print('phase %.2f / %.1f degrees, beside the path %.2f um, place %.2f %% of f rms, %d there' % (
        result.rms, result.largest, 1e3 * result.miss.max(), place, (off < 0.25 * SPACING).sum()))


if __name__ == '__main__':
    main()
