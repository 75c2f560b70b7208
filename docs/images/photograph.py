"""Draws docs/images/photograph.png: a photograph, and the plate whose dimples are as deep as it is dark, as
milled by the posted program and seen from above.

    tools/freecad docs/images/photograph.py [DIMPLES ALONG A SIDE]

The photograph is a scene of our own: balls on a table under a lamp, with soft shadows.

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
from photographs import SPACING, cells, correlation, photograph, plate, seen_from_above  # noqa: E402

SIDE = int(sys.argv[1]) if len(sys.argv) > 1 else 320
picture = photograph(480)
with tempfile.TemporaryDirectory() as folder:
    document, op = plate(picture, SIDE, os.path.join(folder, "photograph.png"))
    plan = patchmill.recompute(op)
    job = document.getObject("Job")
    program = os.path.join(folder, "photograph.ngc")
    posted = patchmill.post(job, program)[0]
    print("%d dimples, %s" % (plan.counts["cut"], posted.check.sentence))
    result = patchmill.simulate(op, program=program, step=plan.input.spacing / 8.0)
data = result.data()
print("found %d, missing %d, extra %d, quality %.4f"
      % (data["found"], data["missing"], data["extra"], data["quality"]))  # fmt: skip
grey = seen_from_above(result)
from_afar = cells(grey, result, SIDE * SPACING, SIDE)
print("correlation with the photograph: %.4f" % correlation(picture, from_afar))
figure, axes = plt.subplots(1, 2, figsize=(12, 6.2), constrained_layout=True)
axes[0].imshow(picture, cmap="gray", vmin=0, vmax=1)
axes[0].set_title("photograph")
across = cells(grey, result, SIDE * SPACING, 2 * SIDE)
low, high = np.nanpercentile(across, (1.0, 99.0))
axes[1].imshow(across, cmap="gray", vmin=low, vmax=high)
axes[1].set_title("{:,} dimples, milled, seen from above".format(plan.counts["cut"]))
for one in axes:
    one.set_axis_off()
at = 0.50, 0.36  # a piece of the milled surface itself, from the left and the top
shape = grey.shape
rows = slice(int(shape[0] * (1 - at[1])) - 60, int(shape[0] * (1 - at[1])) + 60)
columns = slice(int(shape[1] * at[0]) - 60, int(shape[1] * at[0]) + 60)
inset = axes[1].inset_axes([0.70, 0.02, 0.28, 0.28])
inset.imshow(grey[rows, columns], cmap="gray", origin="lower")
inset.set(xticks=[], yticks=[])
inset.set_title("%.1f mm of it" % (120 * result.step), fontsize=8, color="w", pad=2)
figure.savefig(ROOT / "docs" / "images" / "photograph.png", dpi=100)
