"""Draws docs/images/thread.png: the marks of a thread on a roller of 40 mm, as posted and read back, all
round, and where the unrolled cylinder begins and ends.

    tools/freecad docs/images/thread.py

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
from test_thread import roller  # noqa: E402

RADIUS, LENGTH, INSIDE = 20.0, 5.0, (0.6, 4.4)  # at the ends there are halves of marks that no dimple is
document, op = roller(RADIUS, LENGTH)
patchmill.recompute(op)
job = document.getObject("Job")
job.PostProcessor, job.PostProcessorArgs = "patchmill_linuxcnc", "--precision=4"
with tempfile.TemporaryDirectory() as folder:
    program = os.path.join(folder, "roller.ngc")
    patchmill.post(job, program)
    result = patchmill.simulate_round(op, program=program, along=INSIDE)
relief = result.unrolled()
heights, step = 1000.0 * relief.heights, relief.step[0]
looked, found = result.dimples
print("%d dimples, %d missing, %d marks that nobody planned, quality %.4f"
      % (len(looked), result.missing, result.extra, result.quality))  # fmt: skip
low, high = np.nanpercentile(heights, (1.0, 99.0))
figure = plt.figure(figsize=(11, 5.2), constrained_layout=True)
left = figure.add_subplot(1, 2, 1, projection="3d")
every = 3
block = heights[::every, ::every]
y = np.arange(len(heights))[::every] * step / RADIUS
x = np.arange(heights.shape[1])[::every] * step
angle, along = np.meshgrid(y, x, indexing="ij")
share = np.clip((block - low) / (high - low), 0.0, 1.0)
left.plot_surface(along, RADIUS * np.sin(angle), RADIUS * np.cos(angle), facecolors=plt.cm.viridis(share),
                  rstride=1, cstride=1, shade=False, antialiased=False)  # fmt: skip
left.set_box_aspect((LENGTH, 2 * RADIUS, 2 * RADIUS))
left.view_init(25, -35)
left.set_axis_off()
left.set_title("Ø40 mm, all round: %d dimples" % len(looked))
right = figure.add_subplot(1, 2, 2)
rows = round(2.5 / step)
seam = np.vstack([heights[-rows:], heights[:rows]])
extent = (0.0, LENGTH, -rows * step, rows * step)
shown = right.imshow(seam, origin="lower", extent=extent, vmin=low, vmax=high)
right.axhline(0.0, color="white", lw=0.6, ls=":")
right.set(xlim=INSIDE, xlabel="along the axis, mm", ylabel="round the cylinder, mm")
right.set_title("where round begins and ends")
figure.colorbar(shown, ax=right, label="height over the cylinder, µm", shrink=0.8)
figure.savefig(ROOT / "docs" / "images" / "thread.png", dpi=100, bbox_inches="tight")
