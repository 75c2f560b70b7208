"""Draws docs/images/balls.png: a golf ball milled in two set-ups, as both posted programs leave it, and the
spacing of four lattices of 392 dimples.

    tools/freecad docs/images/balls.py

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "host"))
import patchmill  # noqa: E402
from patchmill.textures.ball import lattice, neighbours  # noqa: E402
from test_ball import DIMPLES, RADIUS, ball  # noqa: E402

PIXELS = 900
LAMP = np.array([-0.45, 0.55, 0.70]) / np.linalg.norm([-0.45, 0.55, 0.70])
OVER = np.array([1.0, -1.0, -1.0])  # the ball turned over, about X
PROJECTED = 0.1382  # spacing over the radius: 398 dimples from both sides


def milled():
    """(SimulatedBall of each set-up, marks of each dimple)."""
    made, marks = [], np.zeros(DIMPLES, int)
    with tempfile.TemporaryDirectory() as folder:
        for turned in (False, True):
            document, op = ball(turned)
            plan = patchmill.recompute(op)
            job = document.getObject("Job")
            job.PostProcessor, job.PostProcessorArgs = "patchmill_linuxcnc", "--precision=4"
            program = os.path.join(folder, "set-up-%d.ngc" % turned)
            posted = patchmill.post(job, program)[0]
            made.append(patchmill.simulate_ball(op, program=program))
            marks += made[-1].marks_of_dimples()
            print("%d dimples in %.0f s, %s %d marks that nobody planned"
                  % (plan.counts["cut"], plan.seconds, posted.check.sentence, made[-1].extra))  # fmt: skip
    print("marks of each dimple: %d to %d" % (marks.min(), marks.max()))
    return made


def picture(made, eye, up):
    """Grey of the ball as it is seen from `eye`, (PIXELS, PIXELS), NaN beside it."""
    right = np.cross(up, eye)
    right /= np.linalg.norm(right)
    above = np.cross(eye, right)
    c = (np.arange(PIXELS) + 0.5) / PIXELS * 2.04 - 1.02
    x, y = np.meshgrid(c, -c)
    inside = x**2 + y**2 < 0.999
    x, y = x[inside], y[inside]
    normals = x[:, None] * right + y[:, None] * above + np.sqrt(1.0 - x**2 - y**2)[:, None] * eye

    def deep(n):
        first, second = made
        return np.fmin(first.heights(n), second.heights(n * OVER))

    step, grey = 0.15 / RADIUS, np.full(inside.shape, np.nan)
    slope = []
    for way in (right, above):
        aside = way - (normals @ way)[:, None] * normals
        ends = [normals + side * step * aside for side in (0.5, -0.5)]
        ends = [n / np.linalg.norm(n, axis=1, keepdims=True) for n in ends]
        slope.append((deep(ends[0]) - deep(ends[1])) / (step * RADIUS))
    tilted = normals - slope[0][:, None] * right - slope[1][:, None] * above
    tilted /= np.linalg.norm(tilted, axis=1, keepdims=True)
    lamp = LAMP @ np.array([right, above, eye])
    half = (lamp + eye) / np.linalg.norm(lamp + eye)
    lit = np.clip(tilted @ lamp, 0.0, None)
    grey[inside] = 0.12 + 0.72 * lit + 0.35 * np.clip(tilted @ half, 0.0, None) ** 40
    return grey


made = milled()
figure = plt.figure(figsize=(13, 8.2), constrained_layout=True)
grid = figure.add_gridspec(2, 4, height_ratios=(2.1, 1.0))
views = (((0.25, -0.2, 0.95), "the first set-up's half"), ((1.0, 0.1, 0.12), "across the equator"))
for number, (eye, title) in enumerate(views):
    axes = figure.add_subplot(grid[0, 2 * number : 2 * number + 2])
    eye = np.array(eye) / np.linalg.norm(eye)
    axes.imshow(picture(made, eye, np.array([0.0, 0.3, 1.0])), cmap="gray", vmin=0, vmax=1)
    axes.set_title("Ø42.7 mm, %d dimples of Ø3.5 mm, %s" % (DIMPLES, title), fontsize=10)
    axes.set_axis_off()
lattices = [(name, lattice.points(name, DIMPLES)) for name in lattice.LATTICES]
lattices.append(("Projected", lattice.projected(PROJECTED)))
for number, (name, points) in enumerate(lattices):
    pairs = neighbours.pairs(points)
    apart = RADIUS * np.linalg.norm(points[pairs[:, 1]] - points[pairs[:, 0]], axis=1)
    spread = neighbours.spread(points, pairs)
    axes = figure.add_subplot(grid[1, number])
    axes.hist(apart, bins=np.arange(1.5, 9.0, 0.1), color="tab:blue")
    axes.axvline(3.5, color="tab:red", lw=1.0, ls="--")
    said = "%s, %d: %.3f to %.3f, rms %.1f %%"
    said %= (name, len(points), spread["least"], spread["greatest"], 100.0 * spread["rms"])
    print(said, "mean %.3f mm, least %.3f, greatest %.3f" % (apart.mean(), apart.min(), apart.max()))
    axes.set_title(said, fontsize=8)
    axes.set_xlabel("distance of neighbours, mm", fontsize=8)
figure.savefig(ROOT / "docs" / "images" / "balls.png", dpi=100)
