#!/usr/bin/python3
"""The pictures of docs/rows.md: the time of 784 dimples over the spindle's speed, and the marks of helices
and rows side by side, cut with LinuxCNC's logs.

    MAKE_PROGRAM=build/tests/controller/make_program tests/controller/row_pictures.py docs/images [LOGS]

Prints the curve as a table, and how far the marks are from their places.
SPDX-License-Identifier: LGPL-2.1-or-later
"""
import csv
import pathlib
import subprocess
import sys
import tempfile

import matplotlib
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from harness import phase  # noqa: E402
from harness.case import Case, SENSE, SPACING, make, run  # noqa: E402
from prediction import LARGEST, RMS, TOOTH  # noqa: E402

matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402

ACCELERATIONS = 2000, 100  # mm/s²: of a good machine and of a slow one
SPEEDS = (200, 250, 300, 350, 400, 499, 600, 700, 800, 900, 1000, 1100, 1200, 1400, 1600, 1800, 2000, 2200,
          2400, 2700)
ORDERS = {'helix': ({}, '#b3261e'), 'rows': ({'rows': 1}, '#0b4f9e')}
CELL = 0.01    # mm: of the simulated surface
ZOOM = 3.2     # mm: side of the piece that is shown


def point(acceleration, options, rpm):
    """(rpm, seconds, rms, largest, said to hold) of four patches of 14 x 14 as planned; None without plan."""
    case = Case('locked', acceleration, 100, 4, options=dict(options, rpm=rpm))
    with tempfile.TemporaryDirectory() as folder:
        stem = pathlib.Path(folder) / 'point'
        try:
            make(case, stem)
        except subprocess.CalledProcessError:
            return None
        table = stem.with_suffix('.csv')
        targets = phase.read_targets(table)
        with open(table, newline='', encoding='ascii') as file:
            rows = list(csv.DictReader(file))
    turns = numpy.array([float(row['predicted_turns']) for row in rows])
    error, _ = phase.without_offset(360 * turns - SENSE * targets.azimuth, 360 / case.flutes)
    rms, largest = float(numpy.sqrt(numpy.mean(error ** 2))), float(abs(error).max())
    tooth = 60.0 / rpm / case.flutes
    holds = rms <= RMS and largest <= LARGEST and tooth >= TOOTH * case.machine().period
    return rpm, float(turns[-1] - turns[0]) * 60.0 / rpm, rms, largest, holds


def table_of(acceleration, found):
    print('\n%d mm/s²:\n' % acceleration)
    print('| S | helix: s | rms / largest | rows: s | rms / largest |\n| --- | --- | --- | --- | --- |')
    for number, rpm in enumerate(SPEEDS):
        words = ['%d' % rpm]
        for at in (found[name][number] for name in ORDERS):
            held = '' if at is None or at[4] else ', not held'
            words += ['no plan', ''] if at is None else ['%.0f%s' % (at[1], held), '%.1f / %.1f' % at[2:4]]
        print('| %s |' % ' | '.join(words))


def curve(path):
    figure, panels = pyplot.subplots(1, 2, figsize=(11, 4.4), sharey=True)
    for axes, acceleration in zip(panels, ACCELERATIONS):
        found = {name: [point(acceleration, options, rpm) for rpm in SPEEDS]
                 for name, (options, _) in ORDERS.items()}
        table_of(acceleration, found)
        for name, (_, colour) in ORDERS.items():
            there = [at for at in found[name] if at is not None]
            axes.plot([at[0] for at in there], [at[1] for at in there], '-', color=colour, lw=1, alpha=0.5)
            for held, fill in ((True, colour), (False, 'none')):
                part = [at for at in there if at[4] == held]
                label = '%s, %s' % (name, 'holds' if held else 'does not hold')
                axes.plot([at[0] for at in part], [at[1] for at in part], 'o', ms=4, color=colour, mfc=fill,
                          label=label)
            best = min((at for at in there if at[4]), key=lambda at: at[1], default=None)
            if best:
                axes.annotate('S%d: %.0f s' % best[:2], best[:2], textcoords='offset points', xytext=(4, -16),
                              color=colour)
        speeds = numpy.linspace(SPEEDS[0], SPEEDS[-1], 200)
        limit = 784 * 0.5 * 60 / speeds
        axes.plot(speeds, limit, '--', color='#5f6b7a', lw=1, label='a tooth a dimple: the limit')
        axes.set_xlabel('spindle speed, rpm')
        axes.set_yscale('log')
        axes.set_title('%d mm/s², 100 mm/s' % acceleration, fontsize=10)
        axes.grid(alpha=0.3, which='both')
    panels[0].set_ylabel('time of 784 dimples, s')
    panels[0].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def surface_cells(result, corner, normal):
    """Heights [mm] of the milled surface over its tangent plane in a square at `corner`, by brute force: the
    lowest point of any flute's edge over each cell, at steps in which the edge moves less than a cell."""
    u = numpy.cross(normal, [0.0, 1.0, 0.0])
    u /= numpy.linalg.norm(u)
    v = numpy.cross(normal, u)
    edge = result.edge()
    cells = int(ZOOM / CELL)
    height = numpy.full((cells, cells), numpy.inf)
    centre = edge.centre(result.log.time) - corner
    near = (abs(centre @ u) < ZOOM / 2 + 1.2) & (abs(centre @ v) < ZOOM / 2 + 1.2)
    step = CELL / (2 * numpy.pi * numpy.ptp(result.log.turns) / numpy.ptp(result.log.time) * result.radius)
    meridian = numpy.linspace(0.0, 0.5 * numpy.pi, 240)
    for begin in result.log.time[:-1][near[:-1]]:
        time = numpy.arange(begin, begin + 1e-3, step)
        ball = edge.centre(time) - corner
        for azimuth in edge.azimuths(time):
            outward = numpy.column_stack([numpy.cos(azimuth), numpy.sin(azimuth), 0 * azimuth])
            there = (ball[:, None] + result.radius * (numpy.sin(meridian)[None, :, None] * outward[:, None]
                     - numpy.cos(meridian)[None, :, None] * numpy.array([0.0, 0.0, 1.0])))
            there = there.reshape(-1, 3)
            low = there @ normal
            keep = low < 0.1
            i = ((there[keep] @ u + ZOOM / 2) / CELL).astype(int)
            j = ((there[keep] @ v + ZOOM / 2) / CELL).astype(int)
            inside = (i >= 0) & (i < cells) & (j >= 0) & (j < cells)
            numpy.minimum.at(height, (j[inside], i[inside]), low[keep][inside])
    return height


def marks(path, logs):
    figure, axes = pyplot.subplots(1, 3, figsize=(14, 5))
    orders = {'helix': {}, 'rows to and fro': {'rows': 1}, 'rows one way': {'rows': 1, 'oneway': 1}}
    for axis, (name, options) in zip(axes, orders.items()):
        result = run(Case('locked', ACCELERATIONS[0], 100, 4, options=options), logs=logs)
        middle = result.points.mean(axis=0)  # where the four patches meet
        at = int(numpy.argmin(numpy.linalg.norm(result.points - middle, axis=1)))
        height = surface_cells(result, result.points[at], result.normals[at])
        places = result.places()
        print('%s: %d dimples in %.1f s, phase %.2f / %.1f degrees, places %.2f %% of f rms' % (
            name, len(result.points), result.report.time[-1] - result.report.time[0], result.report.rms,
            result.report.largest, 100 * places.rms / SPACING))
        from_bend = height - smooth(height)
        shown = axis.imshow(1e3 * from_bend, origin='lower', cmap='gray', vmin=-25, vmax=35,
                            extent=[0, ZOOM, 0, ZOOM])
        axis.set_title('%s, LinuxCNC at 2000 mm/s²' % name, fontsize=10)
        axis.set_xlabel('mm')
    figure.colorbar(shown, ax=axes, label='height over the mean surface, µm', shrink=0.8)
    figure.savefig(path, dpi=110, bbox_inches='tight')


def smooth(height):
    """The square polynomial that fits a surface best: its bend, without the marks."""
    j, i = numpy.mgrid[0:1:1j * height.shape[0], 0:1:1j * height.shape[1]]
    terms = numpy.stack([i ** a * j ** b for a in range(4) for b in range(4 - a)], axis=-1)
    known = numpy.isfinite(height)
    factors, *_ = numpy.linalg.lstsq(terms[known], height[known], rcond=None)
    return terms @ factors


def main():
    images = pathlib.Path(sys.argv[1])
    logs = sys.argv[2] if len(sys.argv) > 2 else None
    curve(images / 'rows-speed.png')
    marks(images / 'rows-marks.png', logs)


if __name__ == '__main__':
    main()
