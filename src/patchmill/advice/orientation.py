"""How a part is to lie, or a tool to lean, so that flutes and not the tip mill its faces.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import replace

import numpy as np
from FreeCAD import Rotation, Vector

from patchmill.geometry import shapes

# Of a lean [degrees]
ANGLES = (10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 90.0, 110.0, 125.0, 140.0, 160.0)
AZIMUTHS = 16  # of its axis
# Between tool axis and face [degrees]: at flatter places the tip comes near, at steeper ones the projected
# lattice is stretched, and outermost rows need a wider margin
BEST_TILTS = (14.0, 28.0)
STEEP, STEEP_COUNTS = 78.0, 0.7  # up to which tilt, and as how much of a good one, the steepest places count
LAID_STEEP, LAID_STEEP_COUNTS = 88.0, 0.97  # of a lattice that lies on the faces: it is not stretched
PER_DEGREE = 0.0005  # of the faces, that a degree of leaning must gain
APART = 15.0  # degrees between inclinations that are both tried
SIDEWAYS = 0.5  # cosine to Z, below which faces are looked at along their own normal
COARSE = 0.02  # of the faces' size: how far triangles may be off a face whose normals are asked for
ACROSS = 15  # places along each parameter of a face where its normals are asked for


def face_normals(given):
    """((n, 3) outward unit normals, (n,) areas [mm²]) of triangles of a TextureInput's faces."""
    normals, areas = [], []
    for text in given.breps:
        shape = shapes.of_brep(text)
        for face in shape.Faces:
            points, triangles = face.tessellate(COARSE * max(face.BoundBox.DiagonalLength, 1e-6))
            corners = np.array([tuple(p) for p in points])[np.array(triangles, dtype=int).reshape(-1, 3)]
            cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            length = np.linalg.norm(cross, axis=1)
            there = length > 0.0
            normals.append(cross[there] / length[there, None])
            areas.append(0.5 * length[there])
    if not normals:
        return np.zeros((0, 3)), np.zeros(0)
    return np.concatenate(normals), np.concatenate(areas)


def surface_normals(given):
    """(n, 3) outward unit normals of a TextureInput's faces at up to ACROSS² places of each, exactly."""
    normals = []
    for face in (face for text in given.breps for face in shapes.of_brep(text).Faces):
        u0, u1, v0, v1 = face.ParameterRange
        for i in range(ACROSS):
            for j in range(ACROSS):
                u, v = u0 + (i + 0.5) / ACROSS * (u1 - u0), v0 + (j + 0.5) / ACROSS * (v1 - v0)
                if face.isPartOfDomain(u, v):
                    normals.append(tuple(face.normalAt(u, v)))
    return np.array(normals).reshape(-1, 3)


def leanings(normals, areas=None, angles=ANGLES, flattest=BEST_TILTS[0], laid=False):
    """(fraction of the faces at good tilts, angle, axis) for axes in the plane, the best first; `axis` turns
    the part by `angle` [degrees], or the tool the other way. A small angle is better than a large one that
    gains next to nothing. `flattest`: the least good tilt [degrees]; `laid`: see good_fraction."""
    weights = np.ones(len(normals)) if areas is None else np.asarray(areas)
    found = []
    for angle in angles:
        for k in range(AZIMUTHS):
            azimuth = 2.0 * math.pi * k / AZIMUTHS
            axis = (math.cos(azimuth), math.sin(azimuth), 0.0)
            good = good_fraction(normals, weights, up_of(axis, angle), flattest, laid)
            found.append((round(good - PER_DEGREE * angle, 4), -angle, -k, round(good, 3), axis))
    return [(good, -angle, axis) for _, angle, _, good, axis in sorted(found, reverse=True)]


def apart(leanings):
    """The best of those that lean clearly less than the first, and of those that lean clearly more."""
    first = leanings[0][1]
    less = [lean for lean in leanings if lean[1] <= first - APART][:1]
    more = [lean for lean in leanings if lean[1] >= first + APART][:1]
    return sorted(less + more, reverse=True)


def seen_from(normals, areas):
    """Fields that look at faces from where they are seen, if that is not from above."""
    mean = (normals * areas[:, None]).sum(axis=0) / areas.sum()
    return {"auto_direction": True} if mean[2] < SIDEWAYS * max(float(np.linalg.norm(mean)), 1e-9) else {}


def good_fraction(normals, weights, up, flattest=BEST_TILTS[0], laid=False):
    """Of the faces, what lies at good tilts to a tool axis `up`; steep places count for a part, most of
    it where the lattice is `laid` on the faces."""
    tilts = np.degrees(np.arccos(np.clip(normals @ np.asarray(up), -1.0, 1.0)))
    steepest, least = (LAID_STEEP, LAID_STEEP_COUNTS) if laid else (STEEP, STEEP_COUNTS)
    counts = np.interp(tilts, (BEST_TILTS[1], steepest), (1.0, least))
    return float((weights * counts * (tilts > flattest) * (tilts < steepest)).sum() / weights.sum())


def reached_fraction(normals, areas):
    """Of the faces, what one setup reaches at most: what looks up at LAID_STEEP or less, as the part lies or
    leant."""
    ups = [(0.0, 0.0, 1.0)]
    for angle in ANGLES:
        for k in range(AZIMUTHS):
            azimuth = 2.0 * math.pi * k / AZIMUTHS
            ups.append(up_of((math.cos(azimuth), math.sin(azimuth), 0.0), angle))
    least = math.cos(math.radians(LAID_STEEP))
    return float(((normals @ np.array(ups).T >= least) * areas[:, None]).sum(axis=0).max() / areas.sum())


def seen_fraction(given, direction):
    """Of the faces' area, what looks against `direction`, no steeper than the texture's SteepestSlope."""
    normals, areas = face_normals(given)
    if not len(normals):
        return 1.0
    least = math.cos(math.radians(given.steepest_slope))
    return float(areas[-(normals @ np.asarray(direction)) >= least].sum() / areas.sum())


def up_of(axis, angle):
    """The direction that becomes Z when a part is turned by `angle` [degrees] about `axis`."""
    return tuple(Rotation(Vector(*axis), -angle).multVec(Vector(0, 0, 1)))


def turned(given, axis, angle, model=()):
    """`given` with its faces turned by `angle` [degrees] about `axis` through the origin. Heights stay as far
    above the top of the `model`, BREP texts, as they are: a job's stock, from which they follow, is turned
    with it. Of the faces where it is empty."""
    rotation = Rotation(Vector(*axis), angle)
    breps, solids = (turned_texts(texts, axis, angle) for texts in (given.breps, model))
    origin = None if given.origin is None else tuple(rotation.multVec(Vector(*given.origin)))
    above = given.safe_height - max(_top(text) for text in model or given.breps)
    clear = given.clearance_height - given.safe_height
    safe = max(_top(text) for text in solids or breps) + above
    return replace(given, breps=breps, origin=origin, safe_height=safe, clearance_height=safe + clear)


def turned_texts(texts, axis, angle):
    """BREP texts of what is turned by `angle` [degrees] about `axis` through the origin."""
    return [_turned_text(text, axis, angle) for text in texts]


def _turned_text(text, axis, angle):
    shape = shapes.of_brep(text)
    shape.rotate(Vector(0, 0, 0), Vector(*axis), angle)
    return shape.exportBrepToString()


def _top(text):
    return shapes.of_brep(text).BoundBox.ZMax
