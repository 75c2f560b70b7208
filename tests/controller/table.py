#!/usr/bin/python3
"""Every strategy through LinuxCNC: the table and the picture of docs/synchronisation.md.

    MAKE_PROGRAM=build/tests/controller/make_program tests/controller/table.py docs/images > rows.md
SPDX-License-Identifier: LGPL-2.1-or-later
"""
import pathlib
import sys

import matplotlib
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from harness.case import Case, SPACING, run  # noqa: E402

matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402

# name in the table, strategy of make_program, its options
STRATEGIES = [
    ("constant feed (the paper's zigzag), same flute, exact stop", 'constant', {'same': 1}),
    ('constant feed, any flute, exact stop', 'constant', {}),
    ('constant feed, any flute, G64 P0.001', 'constant', {'tolerance': 0.001}),
    ('constant feed, any flute, legs fitted to the stops', 'constant', {'fit': 1}),
    ('feed per move (F), straight on', 'feed', {'turnarounds': 0}),
    ('feed per move (G93), straight on', 'inverse', {'turnarounds': 0}),
    ('feed per move (F), turn-arounds', 'feed', {}),
    ('spindle-locked, straight on', 'locked', {'turnarounds': 0}),
    ('**spindle-locked, turn-arounds**', 'locked', {}),
]
ACCELERATIONS = (500, 2000, 10000)
LOST = 20.0  # degrees rms: of 180, nothing is recognisable


def row(name, case, result):
    report = result.report
    predicted = numpy.sqrt(numpy.mean(result.predicted_error ** 2))
    if report.rms > LOST:
        drift = result.drift()
        if 'fit' in case.options:  # its plan is not length / feed: count from dimple to dimple
            error = numpy.unwrap(report.error, period=180)
            drift = (error[-1] - error[0]) / (len(error) - 1)
        held = 'lost, %+.1f° a dimple' % drift
        place = '–'
    else:
        places = result.places()
        held = '%.1f° / %.1f°' % (report.rms, report.largest)
        place = '%.1f µm (%.1f %%)' % (1e3 * places.rms, 100 * places.rms / SPACING)
    forecast = 'lost' if predicted > LOST else '%.1f° / %.1f°' % (
        predicted, abs(result.predicted_error).max())
    return '| %s | %d | %d | %.2f | %s | %s | %.1f | %s | %.1f |' % (
        name, case.acceleration, case.velocity, report.turns_per_dimple, held, forecast,
        1e3 * abs(result.time_difference()).max(), place, report.time[-1] - report.time[0])


def picture(results, path):
    """Phase error along the patch at 2000 mm/s²: lost above, held below on its own scale."""
    figure, axes = pyplot.subplots(2, 1, figsize=(9, 6.4), sharex=True)
    shown = [(0, 'constant feed, zigzag (paper)', '#b3261e'), (4, 'feed per move, straight on',
             '#8a6d00'), (7, 'spindle-locked, straight on', '#5f6b7a')]
    for index, label, colour in shown:
        error = results[index].report.error
        axes[0].plot(error, '.', ms=4, color=colour, label=label)
    axes[0].set_ylabel('phase error, degrees\n(modulo one tooth, 180)')
    axes[0].set_ylim(-95, 95)
    axes[0].legend(loc='upper left', ncol=3, fontsize=8, framealpha=0.95)
    fitted, last = results[3], results[8]
    axes[1].axhspan(-6, 6, color='#e7eef7', label='bound on the largest, 6°')
    axes[1].plot(fitted.report.error, '.', ms=3, color='#d98880',
                 label='constant feed, legs fitted to the stops')
    axes[1].plot(last.predicted_error, '-', color='#7a9cc6', lw=1.2,
                 label='spindle-locked, predicted')
    axes[1].plot(last.report.error, '.', ms=4, color='#0b4f9e', label='spindle-locked, logged')
    axes[1].set_ylim(-11, 14)
    axes[1].set_ylabel('phase error, degrees')
    axes[1].set_xlabel('dimple, in milling order')
    axes[1].set_title('made with the motion model', fontsize=10)
    axes[1].legend(loc='upper right', ncol=2, fontsize=8)
    axes[0].set_title('LinuxCNC, 2000 mm/s², S1000, N 2: 14 × 14 dimples of the Bezier surface',
                      fontsize=10)
    for axis in axes:
        axis.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def path_picture(result, path):
    """The tool tip's way at one corner, from the log: in plan, and its height over the surface."""
    tips, targets = result.log.tip, result.targets.tip
    first, last = result.report.time[[8, 18]]
    inside = (result.log.time >= first) & (result.log.time <= last)
    way = tips[inside]
    centre, lifted = way + [0, 0, 1], result.points + result.normals
    near = numpy.argmin(((centre[:, None] - lifted[None]) ** 2).sum(axis=2), axis=1)
    height = numpy.einsum('ij,ij->i', centre - lifted[near], result.normals[near])
    figure, (plan, side) = pyplot.subplots(1, 2, figsize=(9.5, 4.2))
    plan.plot(targets[:, 0], targets[:, 1], 'o', ms=3, color='#c9ced6')
    colours = plan.scatter(way[:, 0], way[:, 1], c=1e3 * height, s=5, cmap='viridis')
    plan.plot(targets[8:19, 0], targets[8:19, 1], 'o', ms=6, mfc='none', color='#b3261e')
    plan.set_aspect('equal')
    plan.set_xlim(way[:, 0].min() - 0.3, way[:, 0].max() + 0.3)
    plan.set_ylim(way[:, 1].min() - 0.3, way[:, 1].max() + 0.3)
    plan.set_xlabel('x, mm')
    plan.set_ylabel('y, mm')
    plan.set_title('tool tip, logged every ms; dimples red', fontsize=10)
    figure.colorbar(colours, ax=plan, label='height over the surface, µm')
    time = 1e3 * (result.log.time[inside] - first)
    side.plot(time, 1e3 * height, color='#0b4f9e')
    for moment in result.report.time[8:19]:
        side.axvline(1e3 * (moment - first), color='#b3261e', lw=0.7)
    side.set_xlabel('time, ms (red: a dimple)')
    side.set_ylabel('height over the surface, µm')
    side.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    images = pathlib.Path(sys.argv[1])
    shown = []
    print('| strategy | mm/s² | mm/s | turns per dimple | phase error, rms / largest | predicted |'
          ' times differ by, ms | place error, rms (of f) | s |')
    print('| --- ' * 9 + '|')
    for name, strategy, options in STRATEGIES:
        for acceleration in ACCELERATIONS:
            case = Case(strategy, acceleration, options=options)
            result = run(case)
            print(row(name, case, result), flush=True)
            if acceleration == 2000:
                shown.append(result)
    name = STRATEGIES[-1][0]
    for patches, velocity, ratio, what in ((1, 300, 1, ''), (4, 100, 1, ', four patches'),
                                           (4, 300, 1, ', four patches'),
                                           (1, 100, 1.01, ', spindle +1 %'),
                                           (1, 100, 0.99, ', spindle −1 %')):
        for acceleration in ACCELERATIONS if ratio == 1 else (2000,):
            case = Case('locked', acceleration, velocity, patches, ratio)
            print(row(name + what, case, run(case)), flush=True)
    fitted = STRATEGIES[3][0]
    for patches, ratio, what in ((4, 1, ', four patches'), (1, 1.001, ', spindle +0.1 %')):
        case = Case('constant', 2000, 100, patches, ratio, {'fit': 1})
        print(row(fitted + what, case, run(case)), flush=True)
    picture(shown, images / 'phase-error-strategies.png')
    path_picture(shown[-1], images / 'turnaround.png')


if __name__ == '__main__':
    main()
