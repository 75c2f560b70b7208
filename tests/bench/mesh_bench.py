"""Seconds from a mesh of two million triangles to a path, beside the face that it was made from, in the same
run, and how far the dimples of both are apart.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import time

import FreeCAD
import Part
import _patchmill as core
import numpy as np
from patchmill.textures.plan import TextureInput, plan_texture

SIDE, FIELDS, SPACING = 250.0, 1001, 0.5  # mm; fields along a side; 250 thousand dimples


def wavy_face():
    along = np.linspace(-SIDE / 2, SIDE / 2, 100)
    poles = [[FreeCAD.Vector(x, y, 2 * math.sin(x / 8) * math.cos(y / 9)) for y in along] for x in along]
    surface = Part.BSplineSurface()
    surface.interpolate(poles)
    return surface.toShape().exportBrepToString()


def triangles_of(text):
    """(vertices, corners) of two triangles for each field of a grid whose corners lie on the face."""
    plane = core.texture_plane((0, 0, 0), (0, 0, -1), (1, 0, 0))
    along = np.linspace(-SIDE / 2 + 0.01, SIDE / 2 - 0.01, FIELDS + 1)
    places = np.stack(np.meshgrid(along, along), axis=-1).reshape(-1, 2)
    found = core.FaceSampler([text], plane, 1.4).sample(places)
    first = (np.arange(FIELDS)[:, None] * (FIELDS + 1) + np.arange(FIELDS)).ravel()
    a, b, c, d = first, first + 1, first + FIELDS + 2, first + FIELDS + 1
    corners = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    on_face = found["states"] == core.DimpleState.CUT
    return found["positions"], corners[on_face[corners].all(axis=1)]


def given_on(breps=(), mesh=None):
    return TextureInput(
        breps=list(breps),
        mesh=mesh,
        tool=core.BallEndMill(1.0, 2),
        spindle=core.Spindle(1000 / 60, "M3"),
        feed=10.0,
        safe_height=5.0,
        clearance_height=8.0,
        spacing=SPACING,
        origin=(0.0, 0.0, 0.0),
        rotation=7.0,
    )


def timed(name, call):
    wall, used = time.perf_counter(), time.process_time()
    made = call()
    print("%-32s %6.2f s, of processors %6.2f s" % (
        name, time.perf_counter() - wall, time.process_time() - used))  # fmt: skip
    return made


def main():
    text = wavy_face()
    vertices, corners = triangles_of(text)
    mesh = timed("triangles taken over", lambda: core.TriangleMesh(vertices, corners))
    surface = timed("normals and tree", lambda: core.MeshSurface(mesh, math.radians(60)))
    on_mesh = timed("mesh to path", lambda: plan_texture(given_on(mesh=surface)))
    on_face = timed("face to path", lambda: plan_texture(given_on(breps=[text])))
    both = (on_mesh.dimples.states == core.DimpleState.CUT) & (on_face.dimples.states == core.DimpleState.CUT)
    off = np.linalg.norm(on_mesh.dimples.positions - on_face.dimples.positions, axis=1)[both]
    turned = np.linalg.norm(on_mesh.dimples.normals - on_face.dimples.normals, axis=1)[both]
    print("%d triangles, %d dimples on the mesh, %d on the face" % (
        len(mesh), on_mesh.counts["cut"], on_face.counts["cut"]))  # fmt: skip
    print("apart by at most %.3g mm, chord height %.3g mm; normals by %.3g degrees" % (
        off.max(), surface.chord_height, math.degrees(turned.max())))  # fmt: skip


main()
