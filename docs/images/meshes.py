"""Draws docs/images/meshes.png: a block as an STL file with its region and dimples, and what the program
leaves.

    tools/freecad docs/images/meshes.py

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
import _patchmill as core  # noqa: E402
import patchmill  # noqa: E402
from meshes_made import block_of, mesh_of, wavy_face, write_stl  # noqa: E402

LIGHT = np.array([-0.5, 0.4, 0.77])


def made_of(folder):
    """(MeshTexture, SimulatedTexture) of the block, from file to program and back."""
    part, program = (os.path.join(folder, name) for name in ("block.stl", "block.ngc"))
    write_stl(part, *block_of(*mesh_of(wavy_face(), 0.5)))
    made = patchmill.mesh_texture(
        part, program, nearest=(0, 0, 9), angle=45, spacing=0.5, patch_side=6, decimals=4, margin=0.8
    )
    print(made.text())
    found = patchmill.simulate(made.plan, program=program)
    print(found.text())
    return made, found


def shaded(points):
    along, across = np.gradient(points, axis=1), np.gradient(points, axis=0)
    normals = np.cross(along, across)
    normals /= np.linalg.norm(normals, axis=2, keepdims=True)
    return normals @ LIGHT


def main():
    with tempfile.TemporaryDirectory() as folder:
        made, found = made_of(folder)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 5.4), constrained_layout=True)
    vertices, corners = made.whole.vertices, made.whole.triangles
    sides = np.cross(vertices[corners[:, 1]] - vertices[corners[:, 0]],
                     vertices[corners[:, 2]] - vertices[corners[:, 0]])  # fmt: skip
    top = corners[sides[:, 2] > 0.0]
    left.triplot(vertices[:, 0], vertices[:, 1], top, linewidth=0.3, color="#8090a0")
    dimples = made.plan.dimples
    for state, colour, text in ((core.DimpleState.CUT, "#c05020", "cut"),
                                (core.DimpleState.NEAR_EDGE, "#b0b0b0", "within the margin")):  # fmt: skip
        there = dimples.positions[dimples.states == state]
        left.plot(there[:, 0], there[:, 1], ".", color=colour, markersize=3, label=text)
    counts = made.plan.input.mesh.triangle_count, len(made.whole), made.plan.counts["cut"]
    left.set_title("%d of %d triangles, %d dimples" % counts)
    left.legend(loc="upper right", fontsize=8)
    points, _ = found.surface(stride=1)
    low, high = np.nanmin(points, axis=(0, 1)), np.nanmax(points, axis=(0, 1))
    right.imshow(shaded(points), cmap="gray", origin="lower", extent=(low[0], high[0], low[1], high[1]))
    right.set_title("as the program leaves it, quality %.2f" % found.quality)
    for axes in (left, right):
        axes.set_aspect("equal")
        axes.set_xlabel("x [mm]")
        axes.set_ylabel("y [mm]")
    figure.savefig(ROOT / "docs" / "images" / "meshes.png", dpi=100)


main()
