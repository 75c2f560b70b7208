# Draws the pictures of patch-division.md, matsuda-condition.md and on-surface.md from what
# tests/figures/patch_figures.cpp wrote: draw_patch.py <folder of CSV files>.
# SPDX-License-Identifier: LGPL-2.1-or-later
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import EllipseCollection, LineCollection  # noqa: E402

SOURCE = sys.argv[1]
TARGET = os.path.dirname(os.path.abspath(__file__))


def read(name):
    return np.genfromtxt(os.path.join(SOURCE, name + ".csv"), delimiter=",", names=True,
                         dtype=None, encoding="utf-8")


def save(figure, name, dpi=110):
    figure.savefig(os.path.join(TARGET, name + ".png"), dpi=dpi)
    plt.close(figure)


def look(x, y, z, azimuth, elevation):
    """Orthographic view: coordinates on the picture and towards the eye."""
    a, e = np.radians(azimuth), np.radians(elevation)
    right = -np.sin(a) * x + np.cos(a) * y
    back = np.cos(a) * x + np.sin(a) * y
    return right, np.cos(e) * z - np.sin(e) * back, np.sin(e) * z + np.cos(e) * back


def shade(d, light):
    return np.clip(d["nx"] * light[0] + d["ny"] * light[1] + d["nz"] * light[2], 0, 1)


def bare(axes, title=None):
    axes.set_aspect("equal")
    axes.axis("off")
    if title:
        axes.set_title(title, fontsize=10)


def relief(axes, d, azimuth=-60, elevation=48, size=3.0, light=(0.2, -0.55, 0.81), dark=-0.1):
    x, y, depth = look(d["x"], d["y"], d["z"], azimuth, elevation)
    order = np.argsort(depth)
    value = shade(d, light)
    axes.scatter(x[order], y[order], c=value[order], s=size, cmap="copper", vmin=dark, vmax=1, lw=0)


def tilings():
    points, borders = read("tilings"), read("outlines")
    figure, all_axes = plt.subplots(1, 3, figsize=(13, 4.6), layout="constrained")
    titles = {"square": "square, m = 7", "hexagon": "hexagon, r = 5",
              "triangle": "triangle, m = 10"}
    for axes, shape in zip(all_axes, titles):
        p, b = points[points["shape"] == shape], borders[borders["shape"] == shape]
        for k in np.unique(b["patch"]):
            one, border = p[p["patch"] == k], b[b["patch"] == k]
            colour = plt.cm.tab20(k % 20)
            axes.fill(border["x"], border["y"], facecolor=colour, alpha=0.12, edgecolor="0.4",
                      lw=0.8)
            axes.plot(one["x"], one["y"], color=colour, lw=1.1, marker="o", ms=2.2)
            axes.plot(one["x"][0], one["y"][0], "o", color="k", ms=4)
        axes.set_xlim(-12, 12)
        axes.set_ylim(-10.5, 10.5)
        bare(axes, titles[shape])
    save(figure, "patch-shapes")


def matsuda():
    d = read("marks")
    with open(os.path.join(SOURCE, "marks_titles.csv"), encoding="utf-8") as lines:
        states = lines.read().splitlines()[1:]
    figure, all_axes = plt.subplots(2, 3, figsize=(12, 8.4), layout="constrained")
    names = ("a = 14, c = 0.5, f_z = 0.5", "a = 14.0625, c = 0.5, f_z = 0.5",
             "a = 14, c = 0.505, f_z = 0.5", "the same, as the advisor changes it",
             "hexagon a = 8, c = 0.4330, f_z = 0.5", "triangle a = 20, c = 0.44, f_z = 0.5")
    for k, axes in enumerate(all_axes.flat):
        one = d[d["panel"] == k]
        axes.plot(one["x"], one["y"], ".", color="k", ms=2.6)
        bare(axes, names[k] + "\n" + states[k])
    save(figure, "matsuda-marks")


def workpieces():
    d = read("workpieces")
    figure, all_axes = plt.subplots(1, 2, figsize=(11, 5), layout="constrained")
    for k, (axes, title) in enumerate(zip(all_axes, ("inclined plane", "cylinder"))):
        one = d[d["panel"] == k]
        x, y, _ = look(one["x"], one["y"], one["z"], -50, 55)
        axes.scatter(x, y, c=one["patch"] % 2, s=5.0, cmap="copper", vmin=-0.3, vmax=1.3, lw=0)
        bare(axes, title)
    save(figure, "matsuda-workpieces")


def fillet():
    d = read("fillet")
    figure, axes = plt.subplots(figsize=(9, 7), layout="constrained")
    relief(axes, d[d["state"] == "cut"], azimuth=-62, elevation=55, size=7.0)
    for state, colour in (("near an edge", "tab:blue"), ("sliver", "tab:red")):
        one = d[d["state"] == state]
        x, y, _ = look(one["x"], one["y"], one["z"], -62, 55)
        axes.scatter(x, y, s=7, color=colour, lw=0, label=f"{state}: {len(one)}")
    axes.legend(frameon=False, loc="upper left")
    counts = ", ".join(f"{np.sum(d['state'] == s)} {s}" for s in np.unique(d["state"]))
    bare(axes, counts)
    save(figure, "patch-borders")


def hemisphere():
    d, spread = read("hemisphere"), read("hemisphere_spread")
    steps = {0: ((1, 0), (0, 1)), 1: ((1, 0), (0, 1)),
             2: ((1, 0), (0, 1), (-1, 1)), 3: ((1, 0), (0, 1), (-1, 1))}
    names = ("square lattice, projected", "square lattice, Chebyshev net",
             "triangular lattice, projected", "triangular lattice, low distortion")
    figure, all_axes = plt.subplots(2, 2, figsize=(11, 9), layout="constrained")
    for k, axes in enumerate(all_axes.flat):
        one = d[(d["panel"] == k) & (d["state"] == "cut")]
        at = {(p["i"], p["j"]): np.array((p["x"], p["y"], p["z"])) for p in one}
        lines, ratio = [], []
        for (i, j), p in at.items():
            for s in steps[k]:
                q = at.get((i + s[0], j + s[1]))
                if q is None:
                    continue
                ends = [look(*r, -90, 50) for r in (p, q)]
                if min(e[2] for e in ends) < 0:
                    continue
                lines.append([e[:2] for e in ends])
                ratio.append(np.linalg.norm(q - p) / 1.25)
        drawn = axes.add_collection(LineCollection(lines, array=np.array(ratio), cmap="turbo",
                                                   lw=1.4, clim=(0.8, 1.8)))
        axes.autoscale()
        s = spread[k]
        bare(axes, f"{names[k]}\nspacing / f {s['least']:.3f} … {s['greatest']:.3f}, angles "
                   f"{s['least_angle']:.1f}° … {s['greatest_angle']:.1f}°")
    figure.colorbar(drawn, ax=all_axes, shrink=0.6, label="distance of neighbours / f")
    save(figure, "on-surface")


def masks():
    d = read("masks")
    figure, all_axes = plt.subplots(3, 1, figsize=(9, 14), layout="constrained")
    titles = ("inside curves", "density by an image",
              "depth by an image (size: the dimple's diameter)")
    for k, axes in enumerate(all_axes):
        one = d[(d["panel"] == k) & (d["state"] == "cut")]
        if k < 2:
            relief(axes, one, azimuth=-90, elevation=62, size=24)
        else:
            x, y, _ = look(one["x"], one["y"], one["z"], -90, 62)
            diameter = 2 * np.sqrt(2 * one["depth"] - one["depth"] ** 2)
            axes.add_collection(EllipseCollection(
                diameter, diameter, np.zeros(len(one)), units="x", color="saddlebrown",
                offsets=np.column_stack((x, y)), transOffset=axes.transData))
            axes.autoscale()
        bare(axes, titles[k])
    save(figure, "patch-masks")


for draw in (tilings, matsuda, workpieces, fillet, hemisphere, masks):
    draw()
