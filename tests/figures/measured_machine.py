"""The picture of docs/measured-machine.md: marks of a machine with a start phase, play and runout, beside
the plan.

    tools/freecad tests/figures/measured_machine.py docs/images

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys

import numpy as np
import patchmill
from matplotlib.figure import Figure

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "host"))
from test_measured_machine import STEP, locked_texture  # noqa: E402

from patchmill.areal.machine_deviations import samples_with  # noqa: E402
from patchmill.areal.measured_texture import marks_of  # noqa: E402

LATE, PLAY, RUNOUT, MICRONS = 0.6, (0.004, 0.002), 0.004, 1e3


def main(out):
    _, plan = locked_texture("figure")
    reference = marks_of(plan, STEP)
    marks = reference.marks
    samples = samples_with(plan, marks, LATE, 0.0, PLAY)
    relief = patchmill.simulate(plan, samples=samples, step=STEP, runout=(0.0, RUNOUT)).height_map()
    told = patchmill.measured_texture(plan, relief, angle=0.0, reference=reference)
    figure = Figure(figsize=(11, 5.2))
    left, right = figure.subplots(1, 2)
    low, size = relief.origin, relief.size
    shown = left.imshow(MICRONS * relief.heights, origin="lower", cmap="gray", vmin=-5, vmax=60,
                        extent=(low[0], low[0] + size[0], low[1], low[1] + size[1]))  # fmt: skip
    figure.colorbar(shown, ax=left, label="height over the face, µm", shrink=0.8)
    left.plot(*marks.places.T, "+", color="tab:red", markersize=5, label="planned")
    placed = told.registration.placed(told.found.places)
    left.plot(*placed.T, ".", color="tab:cyan", markersize=4, label="found")
    left.set(xlabel="x, mm", ylabel="y, mm", title="measured relief: marks lie along the travel of the helix")
    left.legend(loc="upper right", fontsize=8)
    pairs = told.registration.pairs
    cut = np.searchsorted(np.sort(marks.numbers), np.arange(len(marks.numbers)))
    order = np.argsort(marks.numbers)[cut[pairs[:, 1]]]
    depth = MICRONS * (reference.bottoms[order] - told.found.heights[pairs[:, 0]])
    for flute, colour in ((0, "tab:blue"), (1, "tab:orange")):
        its = marks.flutes[order] == flute
        name = "flute %d" % (flute + 1)
        right.plot(order[its], depth[its], "o", color=colour, markersize=4, label=name)
    right.set(xlabel="dimple in milling order", ylabel="deeper than planned, µm")
    right.set_title("runout: %s" % told.finding("runout of flute 2 over flute 1").text())
    right.legend(fontsize=8)
    names = ("flutes late", "play of X", "play of Y")
    said = ["%s: %s" % (name, told.finding(name).text()) for name in names]
    figure.suptitle("; ".join(said), fontsize=10)
    figure.tight_layout()
    figure.savefig(os.path.join(out, "measured-machine.png"), dpi=90)


if __name__ == "__main__":
    main(sys.argv[1])
