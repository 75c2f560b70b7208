"""Makes the picture of docs/cutting-load.md: a pocket cleared in rings from the middle out, the force on the
tool along it at a constant feed and with a limit of the force.

    PYTHONPATH=build/Mod/PatchMill /usr/bin/python3 docs/images/cutting_load.py docs/images

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import sys

import _patchmill as core
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

RADIUS, DEPTH, STEP, FEED, LIMIT = 3.0, 4.0, 2.5, 20.0, 600.0  # mm, mm/s, N
STOCK = dict(specific=2000.0, exponent=0.25, normal=0.3)


def rings():
    """Corners of a pocket's rings, each one STEP further out."""
    middle, places = 20.0, [(20.0, 20.0)]
    for k in range(1, 6):
        low, high = middle - k * STEP, middle + k * STEP
        places += [(low, low), (high, low), (high, high), (low, high), (low, low)]
    return np.array([(x, y, 16.0 - DEPTH) for x, y in places])


def path_of(tips):
    """At the constant feed, from above the first corner; straight down into the stock at a tenth of it."""
    start = tips[0] + (0.0, 0.0, DEPTH + 1.0)
    length = np.linalg.norm(np.diff(np.vstack([start, tips]), axis=0), axis=1)
    feeds = np.where(np.arange(len(tips)) == 0, 0.1 * FEED, FEED)
    spindle = core.Spindle(100.0, "M3")
    kinds = [core.MoveKind.CUT] * len(tips)
    turns = list(spindle.speed * length / feeds)
    return core.make_path(core.Tool(RADIUS, 2, 0.0), spindle, tuple(start), tips, None, kinds, turns)


def places_of(path, load):
    """Where on the path each step of the load is (n, 3) [mm]."""
    start = np.vstack([np.array(path.start)[None], path.tips])[:-1]
    move = load["move"]
    return start[move] + load["at"][:, None] * (path.tips[move] - start[move])


def main(folder):
    stock, part = core.Solid.box((0, 0, 0), (40, 40, 16)), core.Solid.box((0, 0, 0), (40, 40, 10))
    grid = core.voxelise(stock, part, 0.5)
    free = path_of(rings())
    kept = core.limit_load(free, grid, **STOCK, force=LIMIT)[0]
    figure = plt.figure(figsize=(10, 6.4), constrained_layout=True)
    layout = figure.add_gridspec(2, 2, height_ratios=(3, 2))
    along = figure.add_subplot(layout[1, :])
    for column, (path, title) in enumerate(((free, "constant feed"), (kept, "force limited to 600 N"))):
        load = core.load_along(path, grid, **STOCK)
        seconds = np.cumsum(load["length"] / load["feed"])
        plan = figure.add_subplot(layout[0, column])
        x, y, _ = places_of(path, load).T
        dots = plan.scatter(x, y, c=load["force"], s=5, vmin=0.0, vmax=1000.0, cmap="viridis")
        plan.set_aspect("equal")
        plan.set_title("%s: %.1f s" % (title, seconds[-1]))
        plan.set_xlabel("x [mm]")
        plan.set_ylabel("y [mm]")
        along.plot(seconds, load["force"], linewidth=0.9, label=title)
        print("%s: %.1f s, largest %.0f N" % (title, seconds[-1], load["force"].max()))
    figure.colorbar(dots, ax=figure.axes[1:], label="force [N]", shrink=0.8)
    along.set_xlabel("time [s]")
    along.set_ylabel("force [N]")
    along.legend(loc="lower right")
    figure.savefig(os.path.join(folder, "cutting_load.png"), dpi=90)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
