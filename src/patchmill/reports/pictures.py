"""Pictures of a texture for reports: dimples over patches, path, phase error. matplotlib, no display.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import matplotlib

matplotlib.use("Agg")
import _patchmill as core  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Line3DCollection  # noqa: E402
from patchmill.system import files  # noqa: E402

# One colour per dimple state; readable for colour-blind eyes and in print.
STATE_COLOURS = {
    "cut": "#1f77b4",
    "tool tip": "#d62728",
    "too steep": "#ff7f0e",
    "undercut": "#8c564b",
    "near an edge": "#e377c2",
    "sliver": "#9467bd",
    "masked": "#bcbd22",
    "off the face": "#c7c7c7",
}


def _draw_states(axes, plan, places, size, chosen):
    states = plan.dimples.states
    for state, name in zip(core.DimpleState, core.state_names()):
        those = chosen & (states == state)
        if those.any():
            axes.scatter(
                *places[those].T,
                s=size,
                linewidths=0,
                color=STATE_COLOURS.get(name, "k"),
                label="%s (%d)" % (name, those.sum()),
            )


def _outlines(axes, plan):
    axes.add_collection(
        PolyCollection(plan.outlines(), facecolors="none", edgecolors="#444", linewidths=0.6)
    )


def draw_dimples(plan, filename):
    """All dimples by state over the patches; one patch enlarged, in milling order. Returns filename."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(14, 7.6))
    places = plan.places()
    everything = np.ones(len(places), bool)
    per_mm = plan.input.spacing / max(1e-9, np.ptp(places, axis=0).max())
    _draw_states(left, plan, places, max(0.5, (330 * per_mm) ** 2), everything)
    _outlines(left, plan)
    left.set_title("Dimples over %d patches" % len(plan.division))
    left.legend(loc="upper center", bbox_to_anchor=(0.5, -0.08), ncol=3, markerscale=4, frameon=False)

    patches = plan.dimples.patches
    patch = patches[len(patches) // 2]
    chosen = patches == patch
    cut = plan.dimples.states == core.DimpleState.CUT
    right.plot(*places[chosen & cut].T, "-", color="#999", lw=0.8, zorder=0)
    _draw_states(right, plan, places, 40, chosen)
    _outlines(right, plan)
    low, high = places[chosen].min(axis=0), places[chosen].max(axis=0)
    margin = 1.6 * plan.input.spacing
    right.set_xlim(low[0] - margin, high[0] + margin)
    right.set_ylim(low[1] - margin, high[1] + margin)
    neighbours = ~chosen
    _draw_neighbours(right, places[neighbours])
    right.set_title("Patch %d and its neighbours' dimples, with the milling order" % (patch + 1))
    for axes in (left, right):
        axes.set_aspect("equal")
        axes.set_xlabel("x of the texture plane [mm]")
        axes.set_ylabel("y [mm]")
    figure.tight_layout()
    with files.replacing(filename) as file:
        figure.savefig(file, format="png", dpi=110)
    plt.close(figure)
    return filename


def _draw_neighbours(axes, places):
    (x0, x1), (y0, y1) = axes.get_xlim(), axes.get_ylim()
    near = (places[:, 0] > x0) & (places[:, 0] < x1) & (places[:, 1] > y0) & (places[:, 1] < y1)
    axes.scatter(*places[near].T, s=40, linewidths=0.6, facecolors="none", edgecolors="#1f77b4")


def _moves(tips, kinds, kind):
    """The moves of one kind as segments (n, 2, 3); tips[0] is where the first one starts."""
    ends = np.flatnonzero(kinds == kind)
    ends = ends[ends > 0]
    return np.stack([tips[ends - 1], tips[ends]], axis=1)


def draw_path(plan, path, filename):
    """The tool tip over one patch, with the link that leads to it, in 3-D and from the side."""
    tips, dimples = path.tips, path.dimples
    ends = np.flatnonzero(dimples != core.NO_DIMPLE)
    patch_of_end = plan.dimples.patches[dimples[ends]]
    wanted = patch_of_end[len(patch_of_end) // 2]
    inside = ends[patch_of_end == wanted]
    first = max(0, inside[0] - 3)  # the link that leads here
    part, kinds = tips[first : inside[-1] + 1], path.kinds[first : inside[-1] + 1]
    figure = plt.figure(figsize=(14, 6.6))
    space = figure.add_subplot(1, 2, 1, projection="3d")
    ways = {"link": ("#d62728", 1.2), "cut": ("#1f77b4", 0.6)}
    for name, number in (("cut", core.MoveKind.CUT), ("link", core.MoveKind.LINK)):
        colour, width = ways[name]
        space.add_collection(
            Line3DCollection(_moves(part, kinds, number), colors=colour, linewidths=width, label=name)
        )
    space.auto_scale_xyz(*part.T)
    space.scatter(*tips[inside].T, s=5, color="k", label="dimples")
    space.set_xlabel("X [mm]")
    space.set_ylabel("Y [mm]")
    space.set_zlabel("Z [mm]")
    space.set_title("Tool tip over patch %d" % (wanted + 1))
    space.legend(loc="upper right")

    side = figure.add_subplot(1, 2, 2)
    few = tips[inside[0] : inside[min(len(inside) - 1, 8)] + 1]
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(few[:, :2], axis=0).T))])
    side.plot(along, few[:, 2], "-", color="#1f77b4", lw=1.2)
    number = dimples[inside[0] : inside[min(len(inside) - 1, 8)] + 1]
    on_dimple = number != core.NO_DIMPLE
    side.plot(along[on_dimple], few[on_dimple, 2], "o", color="k", ms=5, label="dimples")
    side.set_aspect("equal")
    side.set_xlabel("way along XY [mm]")
    side.set_ylabel("Z of the tip [mm]")
    side.set_title("The first steps of the patch, from the side")
    side.legend(loc="upper center", bbox_to_anchor=(0.5, -0.25), frameon=False)
    space.set_box_aspect(None, zoom=0.92)
    figure.subplots_adjust(left=0.02, right=0.98, wspace=0.18)
    with files.replacing(filename) as file:
        figure.savefig(file, format="png", dpi=110)
    plt.close(figure)
    return filename


def draw_phase_error(errors, filename):
    """Phase error [degrees] over the dimples in milling order. Returns filename."""
    figure, axes = plt.subplots(figsize=(14, 3.6))
    degrees = np.degrees(errors["error"])
    axes.plot(degrees, ".", ms=2, mew=0, color="#1f77b4")
    axes.axhline(0, color="#444", lw=0.6)
    axes.set_xlim(0, len(degrees))
    axes.set_xlabel("dimple, in milling order")
    axes.set_ylabel("phase error [degrees]")
    axes.set_title(
        "Phase error: largest %.3f°, rms %.3f°"
        % (np.abs(degrees).max(), np.sqrt((degrees**2).mean()))
    )
    figure.tight_layout()
    with files.replacing(filename) as file:
        figure.savefig(file, format="png", dpi=110)
    plt.close(figure)
    return filename
