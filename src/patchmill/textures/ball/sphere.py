"""The sphere that faces make together, and its own directions, which turn with the part.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from _patchmill import InputError
from FreeCAD import Vector

from patchmill.geometry import shapes

NEAR = 1e-4  # mm, of centres and radii that are one
FOURTH = 0.5 * math.pi


@dataclass(frozen=True)
class Sphere:
    """`centre` and `radius` [mm], `axes`: its own x, y and pole as rows, and its `faces`, Part.Face each."""

    centre: np.ndarray
    radius: float
    axes: np.ndarray
    faces: Any

    def points(self, normals):
        """Places [mm] at (n, 3) unit vectors."""
        return self.centre + self.radius * normals

    def on_faces(self, normals):
        """Whether there is a face at each of (n, 3) unit vectors."""
        places = [Vector(*map(float, p)) for p in self.points(normals)]
        return np.array([any(_holds(face, place) for face in self.faces) for place in places], dtype=bool)


def sphere_of(breps):
    """The Sphere of faces, given as BREP texts. Raises InputError naming Base if they are not parts of one
    that is solid inside."""
    faces = [face for text in breps for face in shapes.of_brep(text).Faces]
    first = _of_face(faces[0])
    for face in faces:
        other = _of_face(face)
        if np.linalg.norm(other.centre - first.centre) > NEAR or abs(other.radius - first.radius) > NEAR:
            remedy = "a ball's lattice is that of one: choose its faces alone."
            raise InputError("Base", "several spheres", remedy)
        _require_outside(face, other)
    return Sphere(first.centre, first.radius, first.axes, faces)


def _of_face(face):
    surface = face.Surface
    if type(surface).__name__ != "Sphere":
        remedy = "a ball's lattice lies on a spherical face: choose one, or another Mapping."
        raise InputError("Base", type(surface).__name__, remedy)
    centre = np.array(tuple(surface.Center))
    ways = [surface.value(0.0, 0.0), surface.value(FOURTH, 0.0), surface.value(0.0, FOURTH)]
    axes = np.array([tuple(way) for way in ways]) - centre
    return Sphere(centre, surface.Radius, axes / np.linalg.norm(axes, axis=1, keepdims=True), [face])


def _holds(face, place):
    return face.isPartOfDomain(*face.Surface.parameter(place))


def _require_outside(face, sphere):
    u, v = (0.5 * (a + b) for a, b in (face.ParameterRange[:2], face.ParameterRange[2:]))
    if np.array(tuple(face.normalAt(u, v))) @ (np.array(tuple(face.valueAt(u, v))) - sphere.centre) < 0.0:
        remedy = "a ball's lattice is milled from outside: choose another Mapping."
        raise InputError("Base", "a hollow", remedy)
