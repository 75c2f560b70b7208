"""The cylinder that faces make together.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

import numpy as np
from _patchmill import InputError

from patchmill.geometry import shapes

NEAR = 1e-4  # mm, of axes and radii that are one
SAME_AREA = 1e-4  # of the area that is missing or too much


@dataclass(frozen=True)
class Cylinder:
    """A closed cylinder seen from outside: a point on its axis, the axis' unit direction, the radius, and
    where it begins and ends along the axis, counted from the point [mm]."""

    point: np.ndarray
    direction: np.ndarray
    radius: float
    low: float
    high: float

    @property
    def circumference(self):
        return 2.0 * math.pi * self.radius


def cylinder_of(breps):
    """The Cylinder of faces, given as BREP texts. Raises InputError naming Base if they are not one that is
    closed, without holes, and solid inside."""
    faces = [face for text in breps for face in shapes.of_brep(text).Faces]
    first = _axis_of(faces[0])
    low, high, area = math.inf, -math.inf, 0.0
    for face in faces:
        _require_same(first, _axis_of(face))
        points = np.array([tuple(v.Point) for edge in face.Edges for v in edge.Vertexes])
        along = (points - first.point) @ first.direction
        low, high, area = min(low, along.min()), max(high, along.max()), area + face.Area
        _require_outside(face, first)
    whole = first.circumference * (high - low)
    if abs(area - whole) > SAME_AREA * whole:
        said = "%.4g of %.4g mm² of a cylinder" % (area, whole)
        remedy = "a thread goes all the way round: choose all faces of a cylinder that has no holes."
        raise InputError("Base", said, remedy)
    return Cylinder(first.point, first.direction, first.radius, float(low), float(high))


def _axis_of(face):
    surface = face.Surface
    if type(surface).__name__ != "Cylinder":
        remedy = "a thread goes round a cylinder: choose a cylindrical face, or another Order."
        raise InputError("Base", type(surface).__name__, remedy)
    axis = np.array(tuple(surface.Axis))
    return Cylinder(np.array(tuple(surface.Center)), axis / np.linalg.norm(axis), surface.Radius, 0.0, 0.0)


def _require_same(one, other):
    beside = np.cross(other.point - one.point, one.direction)
    turned = np.cross(other.direction, one.direction)
    if max(np.linalg.norm(beside), abs(one.radius - other.radius)) > NEAR or np.linalg.norm(turned) > NEAR:
        raise InputError("Base", "several cylinders", "a thread goes round one: choose faces of one alone.")


def _require_outside(face, cylinder):
    u, v = face.ParameterRange[0], face.ParameterRange[2]
    place = np.array(tuple(face.valueAt(u, v))) - cylinder.point
    outwards = place - (place @ cylinder.direction) * cylinder.direction
    if np.array(tuple(face.normalAt(u, v))) @ outwards < 0.0:
        raise InputError("Base", "a bore", "a thread is milled from outside: choose another Order.")
