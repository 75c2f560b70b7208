"""Meshes for tests: a wavy face and triangles on it, and a closed block below them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import Mesh
import Part
import _patchmill as core
import numpy as np

V = FreeCAD.Vector
EDGE = 0.25  # mm, of the fields of the wavy mesh


def height(x, y):
    return 0.25 * x + 0.2 * np.sin(0.5 * x) * np.cos(0.4 * y)


def wavy_face():
    """An inclined face with waves over [-6, 6]² mm."""
    poles = [[V(x, y, height(x, y)) for y in np.linspace(-6, 6, 13)] for x in np.linspace(-6, 6, 13)]
    surface = Part.BSplineSurface()
    surface.interpolate(poles)
    return surface.toShape()


def fields(count):
    """Corners of two triangles for each of count x count fields of points in rows."""
    first = (np.arange(count)[:, None] * (count + 1) + np.arange(count)).ravel()
    a, b, c, d = first, first + 1, first + count + 2, first + count + 1
    return np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def mesh_of(face, edge=EDGE):
    """(vertices, triangles) with corners on the face, as it is seen from above."""
    plane = core.texture_plane((0, 0, 0), (0, 0, -1), (1, 0, 0))
    count = round(12 / edge)
    along = np.linspace(-6 + 1e-7, 6 - 1e-7, count + 1)
    places = np.stack(np.meshgrid(along, along), axis=-1).reshape(-1, 2)
    on = core.FaceSampler([face.exportBrepToString()], plane, 1.3).sample(places)
    return on["positions"], fields(count)


def block_of(vertices, triangles):
    """A closed mesh under one that is open: (vertices, triangles)."""
    count = round(len(vertices) ** 0.5) - 1
    number = np.arange(len(vertices)).reshape(count + 1, -1)
    ring = np.concatenate([number[0, :-1], number[:-1, -1], number[-1, :0:-1], number[:0:-1, 0]])
    below = vertices[ring] * (1, 1, 0) + (0, 0, -5)
    low = len(vertices) + np.arange(len(ring))
    after = np.roll(np.arange(len(ring)), -1)
    walls = [np.column_stack([ring, low, low[after]]), np.column_stack([ring, low[after], ring[after]])]
    middle = np.full(len(ring), len(vertices) + len(ring))
    bottom = np.column_stack([low, middle, low[after]])
    return np.vstack([vertices, below, [[0, 0, -5]]]), np.vstack([triangles, *walls, bottom])


def write_stl(name, vertices, triangles):
    Mesh.Mesh([[tuple(vertices[k]) for k in t] for t in triangles]).write(name)
