"""Plots of digital copy milling: fields in a section of the removal volume, feed and B angle
along a pass, as in Figs. 8, 9, 12 and 13 of Kobayashi & Shirase 2014.

The plotting functions take arrays and a matplotlib Axes and know nothing of files or FreeCAD. Run
as a program it makes the pictures of docs/ from the tables that the experiments' test writes:

    PATCHMILL_DCM_DIR=tables build/tests/core/test_copy --gtest_filter='Kobayashi*'
    PYTHONPATH=build/Mod/PatchMill /usr/bin/python3 src/patchmill/reports/dcm_plots.py tables docs/images

SPDX-License-Identifier: LGPL-2.1-or-later
"""
import os
import sys

import numpy as np
from _patchmill import VoxelKind

STAIRS_COLOUR = "#c44e52"
SMOOTH_COLOUR = "#1f4e79"
HEIGHT_COLOUR = "#8a8a8a"


def section_image(x, z, kind, value):
    """Scattered voxels of one section as an image.

    x, z: centres [mm]; kind: VoxelKinds; value: what to show. Returns (edges of columns,
    edges of rows, values with NaN where there is no removal volume, True where there is surface).
    """
    xs, zs = np.unique(x), np.unique(z)
    pitch = np.min(np.diff(xs)) if len(xs) > 1 else 1.0
    shape = (int(round((zs[-1] - zs[0]) / pitch)) + 1, int(round((xs[-1] - xs[0]) / pitch)) + 1)
    image, surface = np.full(shape, np.nan), np.zeros(shape, bool)
    column = np.rint((x - xs[0]) / pitch).astype(int)
    row = np.rint((z - zs[0]) / pitch).astype(int)
    filled = ~np.isin(kind, (VoxelKind.AIR, VoxelKind.PART))
    image[row[filled], column[filled]] = value[filled]
    surface[row, column] = kind == VoxelKind.SURFACE
    edges_x = xs[0] + pitch * (np.arange(shape[1] + 1) - 0.5)
    edges_z = zs[0] + pitch * (np.arange(shape[0] + 1) - 0.5)
    return edges_x, edges_z, image, surface


def plot_section(axes, x, z, kind, value, low, high, colours="viridis"):
    """Voxels of one section coloured by `value` from `low` to `high`; surface voxels are dotted."""
    edges_x, edges_z, image, surface = section_image(x, z, kind, value)
    mesh = axes.pcolormesh(edges_x, edges_z, np.ma.masked_invalid(image), vmin=low, vmax=high,
                           cmap=colours, edgecolors="white", linewidth=0.25)
    row, column = np.nonzero(surface)
    axes.plot(0.5 * (edges_x[column] + edges_x[column + 1]),
              0.5 * (edges_z[row] + edges_z[row + 1]), ".", color="black", markersize=2.2)
    axes.set_aspect("equal")
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("z [mm]")
    return mesh


def plot_pass(axes, stairs, smooth, column, label, start=None, end=None, height=True):
    """One quantity along a pass, both ways, with the height of the ball centre behind it.

    stairs, smooth: structured arrays with columns run, s (travelled [mm], at the end of each move),
    z and `column`. start, end: the part of the pass to show [mm].
    """
    if height:
        behind = axes.twinx()
        behind.plot(*with_gaps(smooth, "z"), color=HEIGHT_COLOUR, linewidth=0.8, linestyle=":")
        behind.set_ylabel("ball centre z [mm]", color=HEIGHT_COLOUR)
        behind.tick_params(axis="y", colors=HEIGHT_COLOUR)
        axes.set_zorder(behind.get_zorder() + 1)
        axes.patch.set_visible(False)
    # a move's feed holds over all of it, up to s; its axis is reached at s, or held in a staircase
    axes.step(*with_gaps(stairs, column), where="pre", color=STAIRS_COLOUR, linewidth=0.9,
              label="voxel by voxel (paper)")
    draw = axes.step if column == "feed" else axes.plot
    draw(*with_gaps(smooth, column), color=SMOOTH_COLOUR, linewidth=1.3, label="interpolated",
         **({"where": "pre"} if column == "feed" else {}))
    axes.set_xlabel("travelled [mm]")
    axes.set_ylabel(label)
    axes.set_xlim(start, end)


def with_gaps(table, column):
    """s and a column with NaN between runs, so that no line is drawn over a lift of the tool."""
    breaks = np.nonzero(np.diff(table["run"]))[0] + 1
    return np.insert(table["s"], breaks, np.nan), np.insert(table[column], breaks, np.nan)


def last_run(table):
    """(start, end) of the longest run among the last ones: the finishing pass [mm]."""
    runs = np.unique(table["run"])
    ends = [table["s"][table["run"] == run][[0, -1]] for run in runs]
    start, end = max(ends, key=lambda both: both[1] - both[0] if both[1] > ends[-1][0] - 1 else 0)
    return start, end


def read_table(path):
    return np.genfromtxt(path, delimiter=",", names=True)


def feed_figures(plt, tables, images):
    section = read_table(os.path.join(tables, "feed_y24.csv"))
    stairs = read_table(os.path.join(tables, "feed_pass_stairs.csv"))
    smooth = read_table(os.path.join(tables, "feed_pass_smooth.csv"))

    figure, axes = plt.subplots(figsize=(7.2, 4.6), constrained_layout=True)
    mesh = plot_section(axes, section["x"], section["z"], section["kind"], section["value"],
                        400, 800)
    figure.colorbar(mesh, ax=axes, label="feed along x [mm/min]", shrink=0.8)
    axes.set_title("Feed field $V_x$ at Y = 24 mm; dots: voxels with product surface")
    save(plt, figure, images, "dcm_feed_section.png")

    figure, (whole, part) = plt.subplots(2, 1, figsize=(8.4, 6.4), constrained_layout=True)
    plot_pass(whole, stairs, smooth, "feed", "feed [mm/min]")
    head(whole, "Feed along all layers at Y = 24 mm", legend=True)
    start = 0.62 * smooth["s"][-1]
    plot_pass(part, stairs, smooth, "feed", "feed [mm/min]", start, start + 0.12 * smooth["s"][-1])
    head(part, "A part of it")
    for axes in (whole, part):
        axes.set_ylim(380, 820)
    save(plt, figure, images, "dcm_feed_pass.png")


def posture_figures(plt, tables, images):
    places = (10, 20, 30, 40)
    figure, grid = plt.subplots(2, 2, figsize=(9.6, 5.8), constrained_layout=True)
    for axes, y in zip(grid.flat, places):
        section = read_table(os.path.join(tables, "posture_y%d.csv" % y))
        mesh = plot_section(axes, section["x"], section["z"], section["kind"], section["value"],
                            -70, 70, "RdBu_r")
        axes.set_title("Y = %d mm" % y)
    figure.colorbar(mesh, ax=grid, label="posture about y [degrees]", shrink=0.8)
    save(plt, figure, images, "dcm_posture_section.png")

    figure, grid = plt.subplots(2, 2, figsize=(10.4, 6.6), constrained_layout=True)
    for axes, y in zip(grid.flat, places):
        stairs = read_table(os.path.join(tables, "posture_pass_y%d_stairs.csv" % y))
        smooth = read_table(os.path.join(tables, "posture_pass_y%d_smooth.csv" % y))
        plot_pass(axes, stairs, smooth, "b", "B [degrees]", *last_run(smooth))
        head(axes, "Finishing, Y = %d mm" % y, legend=axes is grid[0, 0])
    save(plt, figure, images, "dcm_posture_pass.png")


def runs_of(table):
    """The rows of a table, run by run."""
    return np.split(table, np.nonzero(np.diff(table["run"]))[0] + 1)


def copy_figure(plt, tables, images):
    figure, (scan, contour, tilt) = plt.subplots(1, 3, figsize=(13.5, 4.4), constrained_layout=True)
    for run in runs_of(read_table(os.path.join(tables, "feed_pass_smooth.csv"))):
        scan.plot(run["x"], run["z"] - 3.0, color=SMOOTH_COLOUR, linewidth=0.9)
    head(scan, "Scanning lines, Y = 24 mm")
    scan.set(xlabel="x [mm]",
             ylabel="lowest point of the ball, z [mm]")

    table = read_table(os.path.join(tables, "contour_path.csv"))
    levels = np.unique(table["z"])
    colours = plt.get_cmap("viridis")(np.linspace(0, 0.9, len(levels)))
    shown = set()
    for run in runs_of(table):
        level = np.searchsorted(levels, run["z"][0])
        contour.plot(run["x"], run["y"], color=colours[level], linewidth=0.8,
                     label=None if level in shown else "z = %g mm" % (levels[level] - 3.0))
        shown.add(level)
    contour.set(xlabel="x [mm]", ylabel="y [mm]")
    head(contour, "Contour lines", legend=True)

    table = read_table(os.path.join(tables, "posture_pass_y40_smooth.csv"))
    start, end = last_run(table)
    table = table[(table["s"] >= start) & (table["s"] <= end)]
    angle = np.radians(table["b"])
    tilt.plot(table["x"], table["z"], color=SMOOTH_COLOUR, linewidth=1.2)
    at = np.searchsorted(table["s"], np.arange(start, end, 2.5))
    for i in at[at < len(table)]:
        x, z = table["x"][i], table["z"][i]
        tilt.plot([x, x + 12 * np.sin(angle[i])], [z, z + 12 * np.cos(angle[i])],
                  color=STAIRS_COLOUR, linewidth=0.7)
    head(tilt, "Below an overhang, Y = 40 mm")
    tilt.set(xlabel="x [mm]",
             ylabel="ball centre and axis, z [mm]")
    for axes in (scan, contour, tilt):
        axes.set_aspect("equal")
    save(plt, figure, images, "copy_paths.png")


def head(axes, title, legend=False):
    """Title at the left above the axes, the legend at the right beside it: neither covers a curve."""
    axes.set_title(title, loc="left", fontsize=10)
    if legend:
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncol=3, fontsize=7, frameon=False,
                    borderaxespad=0.1, columnspacing=1.0)


def save(plt, figure, folder, name):
    figure.savefig(os.path.join(folder, name), dpi=110)
    plt.close(figure)


def main(tables, images):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    feed_figures(plt, tables, images)
    posture_figures(plt, tables, images)
    copy_figure(plt, tables, images)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: dcm_plots.py FOLDER_OF_TABLES FOLDER_OF_IMAGES")
    main(sys.argv[1], sys.argv[2])
