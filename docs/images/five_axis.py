"""Draws docs/images/five-axis.png from runs through LinuxCNC: rotary joints, phase error at each dimple
and the miss of the tool tip in the work's frame, with TCP and without.

    MAKE_FIVE_AXIS=build/tests/controller/make_five_axis python3 docs/images/five_axis.py

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "controller"))
from five_axis_test import run  # noqa: E402

results = [("with TCP", run("ac", "tcp")), ("without TCP", run("ac", "pivot"))]
figure, rows = plt.subplots(3, 1, figsize=(8, 7.5), constrained_layout=True)
log, first = results[0][1].log, results[0][1]
rows[0].plot(log.time, log.rotary[:, 0], label="A")
rows[0].plot(log.time, log.rotary[:, 1], label="C")
rows[0].set(ylabel="logged joints, degrees", xlabel="time, s (with TCP)")
rows[0].set_xlim(first.time[0], first.time[-1])
rows[0].legend(loc="center right")
for name, result in results:
    label = "%s: rms %.2f°, largest %.2f°, %.2f turns a dimple"
    rows[1].plot(result.error, ".", ms=4, label=label % (name, result.rms, result.largest, result.turns))
    rows[2].plot(1e3 * result.miss, ".", ms=4, label=name)
rows[1].set(ylabel="phase error, degrees", ylim=(-6, 6))
rows[2].set(ylabel="tip off its place, µm", xlabel="dimple", ylim=(0, None))
for axes in rows[1:]:
    axes.legend(loc="upper right", fontsize=8)
for axes in rows:
    axes.grid(alpha=0.3)
figure.savefig(ROOT / "docs" / "images" / "five-axis.png", dpi=110)
