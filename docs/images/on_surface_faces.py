"""Draws dimples of lattices laid on bent faces, coloured by the distance to the nearest other dimple:

    tools/freecad docs/images/on_surface_faces.py

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys

import matplotlib
import numpy as np
import Part
from _patchmill import DimpleState

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tests" / "host"))
from random_faces import V, judged, placed_on  # noqa: E402


def saddle():
    surface, grid = Part.BSplineSurface(), np.linspace(-1, 1, 7)
    surface.interpolate([[V(9 * x, 9 * y, 4 * x * x - 4 * y * y) for y in grid] for x in grid])
    return surface.toShape()


FACES = [
    ("Roller, all the way round", Part.makeCylinder(4, 12).Faces[0], "Hexagon", 0.55, (12, 30)),
    ("Cone", Part.makeCone(7, 2, 9, V(), V(0, 0, 1), 200).Faces[0], "Square", 0.55, (20, 100)),
    ("Whole sphere", Part.makeSphere(6).Faces[0], "Triangle", 0.6, (20, 30)),
    ("Saddle", saddle(), "Square", 0.6, (35, 40)),
]


def draw(axes, title, face, shape, spacing, view):
    placed = placed_on(face, spacing, shape, auto_direction=True)
    found = judged(placed, face)
    left = (DimpleState.OFF_FACE, DimpleState.OFF_NET, DimpleState.CROWDED)
    on = ~np.isin(placed.dimples.states, left)
    points = placed.dimples.positions[on]
    nearest = np.array([np.partition(np.linalg.norm(points - p, axis=1), 1)[1] for p in points]) / spacing
    elevation, azimuth = np.radians(view)
    eye = [np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)]
    seen = placed.dimples.normals[on] @ eye > 0.05
    drawn = axes.scatter(*points[seen].T, c=nearest[seen], s=5, vmin=0.9, vmax=1.1, cmap="viridis")
    axes.view_init(*view)
    axes.set_box_aspect(np.ptp(points, axis=0))
    axes.set_axis_off()
    axes.dist = 7.5
    axes.set_title(
        "%s\n%d dimples, %.0f %% of the area\nnearest %.3f f"
        % (title, len(points), 100 * found["laid"], nearest.min()),
        fontsize=8,
    )
    return drawn


def main():
    figure = plt.figure(figsize=(11, 3.8))
    for k, face in enumerate(FACES):
        drawn = draw(figure.add_subplot(1, 4, k + 1, projection="3d"), *face)
    figure.subplots_adjust(0.0, 0.0, 0.92, 0.86, 0.0)
    bar = figure.colorbar(drawn, cax=figure.add_axes([0.93, 0.15, 0.01, 0.6]))
    bar.set_label("distance to the nearest / f", fontsize=8)
    figure.savefig(HERE / "on-surface-faces.png", dpi=130)


main()
