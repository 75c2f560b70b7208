"""Meshes of FreeCAD and of files, and regions of them: a mesh has no faces and edges that could be named.

    mesh = patchmill.mesh("scan.stl")                                  # STL, OBJ, PLY, or a Mesh object
    surface = patchmill.mesh_region(mesh, nearest=(0, 0, 12), angle=20)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
from itertools import chain
from math import radians
from typing import Any, Iterable, Optional, Sequence

import _patchmill as core
import Mesh
import numpy as np
from _patchmill import InputError

from patchmill.geometry import shapes

ENDINGS = (".stl", ".obj", ".ply")
ANGLE = 30.0  # degrees between triangles that belong to one region
CREASE = 60.0  # degrees between triangles over which normals are smoothed


def mesh(part: Any) -> core.TriangleMesh:
    """The triangles of `part`: a Mesh object of a document, where it is drawn there, a Mesh.Mesh, or the name
    of an STL, OBJ or PLY file [mm]. Raises InputError naming Mesh."""
    if isinstance(part, (str, os.PathLike)):
        return _of_topology(_read(os.fspath(part)).Topology)
    if isinstance(part, Mesh.Mesh):
        return _of_topology(part.Topology)
    if not shapes.is_mesh(part):
        label = getattr(part, "Label", repr(part))
        raise InputError("Mesh", label, "give a Mesh object, or an STL, OBJ or PLY file.")
    found = part.Mesh
    around = shapes.placement_around(part)
    if not around.isIdentity():
        found = found.copy()
        found.Placement = around.multiply(found.Placement)
    return _of_topology(found.Topology)


def mesh_region(
    whole: core.TriangleMesh,
    nearest: Optional[Sequence[float]] = None,
    angle: float = ANGLE,
    triangles: Optional[Iterable[int]] = None,
    crease: float = CREASE,
) -> core.MeshSurface:
    """A region of a mesh, to be textured: all that is reached from the triangle nearest to the point
    `nearest` [mm] over edges whose two triangles make at most `angle` [degrees], or the triangles with the
    numbers `triangles`, or, with neither, the whole mesh. Normals are smoothed over edges of at most `crease`
    [degrees, 0 to 90]. Raises InputError naming Region, Point, Angle, Triangles, Crease or Mesh."""
    if nearest is not None and triangles is not None:
        raise InputError("Region", "nearest and triangles", "give one of them.")
    if nearest is not None:
        triangles = whole.region(whole.nearest(_point(nearest)), radians(_degrees(angle, "Angle")))
    part = whole if triangles is None else whole.part(_numbers(triangles))
    return core.MeshSurface(part, radians(_degrees(crease, "Crease")))


def _read(filename: str) -> Any:
    if os.path.splitext(filename)[1].lower() not in ENDINGS:
        raise InputError("Mesh", filename, "give a file that ends in %s." % ", ".join(ENDINGS))
    if not os.path.isfile(filename):
        raise InputError("Mesh", filename, "there is no such file.")
    try:
        found = Mesh.Mesh(filename)
    except Exception as error:  # FreeCAD's readers raise errors of many kinds
        raise InputError("Mesh", filename, "it cannot be read (%s)." % error) from error
    if not found.CountFacets:
        raise InputError("Mesh", filename, "it holds no triangles.")
    return found


def _of_topology(topology: Any) -> core.TriangleMesh:
    """Of FreeCAD's (points, corners)."""
    points, corners = topology
    if not corners:
        raise InputError("Mesh", "0 triangles", "give a mesh that has some.")
    vertices = np.fromiter(chain.from_iterable(points), float, 3 * len(points)).reshape(-1, 3)
    numbers = np.fromiter(chain.from_iterable(corners), np.int64, 3 * len(corners)).reshape(-1, 3)
    return core.TriangleMesh(vertices, numbers)


def _point(given: Sequence[float]) -> np.ndarray:
    try:
        point = np.asarray(given, float)
    except (TypeError, ValueError):
        point = np.zeros(0)
    if point.shape != (3,) or not np.isfinite(point).all():
        raise InputError("Point", given, "give three finite numbers in mm.")
    return point


def _degrees(given: float, name: str) -> float:
    if isinstance(given, bool) or not isinstance(given, (int, float)):
        raise InputError(name, given, "give degrees.")
    return float(given)


def _numbers(given: Iterable[int]) -> np.ndarray:
    try:
        numbers = np.asarray(list(given))
    except TypeError:
        numbers = np.zeros(0)
    if numbers.ndim != 1 or not len(numbers) or not np.issubdtype(numbers.dtype, np.integer):
        raise InputError("Triangles", given, "give the numbers of some triangles.")
    return numbers.astype(np.int64)
