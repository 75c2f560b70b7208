"""Random bent faces, and what holds for a lattice laid on any of them: for tests and for tools/fuzz.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import _patchmill as core
import FreeCAD
import numpy as np
import Part

from patchmill.texture_plan import TextureInput, place_texture

V = FreeCAD.Vector
KINDS = ["cylinder", "cone", "fillet", "sphere", "loft", "saddle"]
NOT_ON_FACE = "off the face"


def random_face(rng, kind):
    return globals()["_" + kind](rng)


def _cylinder(rng):
    radius = math.exp(rng.uniform(math.log(0.2), math.log(20)))
    angle = rng.choice([90, 90, 180, 360, rng.uniform(20, 340)])
    return Part.makeCylinder(radius, radius * rng.uniform(0.5, 40), V(), V(0, 0, 1), angle).Faces[0]


def _cone(rng):
    a = math.exp(rng.uniform(math.log(0.5), math.log(15)))
    b, angle = a * rng.choice([0.0, rng.uniform(0, 0.9)]), rng.choice([90, 180, 360])
    return Part.makeCone(a, b, a * rng.uniform(0.3, 6), V(), V(0, 0, 1), angle).Faces[0]


def _fillet(rng):
    """Of a rounded box: along an edge, on a corner, or around a boss's foot."""
    box = Part.makeBox(10, 14, 8)
    radius = rng.uniform(0.5, 3.5)
    if rng.random() < 0.4:
        box = box.fuse(Part.makeCylinder(3, 8, V(5, 7, 6))).removeSplitter()
        rim = [e for e in box.Edges if abs(e.BoundBox.ZMax - e.BoundBox.ZMin) < 1e-6]
        rim = [e for e in rim if type(e.Curve).__name__ == "Circle" and abs(e.BoundBox.ZMax - 8) < 1e-6]
        solid = box.makeFillet(min(radius, 1.5), rim)
    else:
        solid = box.makeFillet(radius, box.Edges)
    round_faces = [f for f in solid.Faces if type(f.Surface).__name__ not in ("Plane", "Cylinder")]
    straight = [f for f in solid.Faces if type(f.Surface).__name__ == "Cylinder"]
    first, second = (round_faces, straight) if rng.random() < 0.6 else (straight, round_faces)
    return rng.choice(first or second)


def _sphere(rng):
    low = rng.choice([-90, rng.uniform(-80, 40)])
    high = rng.choice([90, min(90, low + rng.uniform(20, 120))])
    angle = rng.choice([360, 90, rng.uniform(40, 350)])
    return Part.makeSphere(rng.uniform(2, 20), V(), V(0, 0, 1), low, high, angle).Faces[0]


def _wire(rng, height, closed):
    count = 7 if closed else 5
    points = []
    for k in range(count):
        t = 2 * math.pi * k / count
        if closed:
            r = rng.uniform(6, 9)
            points.append(V(r * math.cos(t), r * math.sin(t), height))
        else:
            points.append(V(4.0 * k, rng.uniform(-2.0, 2.0), height + rng.uniform(-1, 1)))
    curve = Part.BSplineCurve()
    curve.interpolate(points, PeriodicFlag=closed)
    return Part.Wire(curve.toShape())


def _loft(rng):
    closed = rng.random() < 0.3
    wires = [_wire(rng, 6.0 * k, closed) for k in range(rng.choice([2, 2, 3]))]
    return max(Part.makeLoft(wires, False, rng.random() < 0.5).Faces, key=lambda f: f.Area)


def _saddle(rng):
    surface, half = Part.BSplineSurface(), rng.uniform(4, 15)
    a, b = rng.uniform(-0.8, 0.8), rng.uniform(-0.8, 0.8)
    grid = np.linspace(-1, 1, 7)
    surface.interpolate(
        [[V(half * x, half * y, half * (a * x * x - b * y * y + 0.2 * x * y)) for y in grid] for x in grid]
    )
    return surface.toShape()


def turned(face, rng):
    """A copy of the face somewhere else, so that it looks up, leaning by up to 20 degrees to any side (a
    closed one stands anyhow); and the placement that took it there."""
    lean, side = rng.uniform(0.0, 0.35), rng.uniform(0.0, 2.0 * math.pi)
    up = V(math.sin(lean) * math.cos(side), math.sin(lean) * math.sin(side), math.cos(lean))
    looks = V(*(-core.seen_best([face.exportBrepToString()], (0.0, 0.0, -1.0))["direction"]))
    spin = FreeCAD.Rotation(up, rng.uniform(0.0, 360.0))
    there = FreeCAD.Placement(
        V(*(rng.uniform(-50, 50) for _ in range(3))), spin.multiply(FreeCAD.Rotation(looks, up))
    )
    copy = face.copy()
    copy.Placement = there.multiply(copy.Placement)
    return copy, there


def spacing_for(face, rng):
    return math.sqrt(face.Area / rng.uniform(250, 900))


def placed_on(face, spacing, shape, side=3, **more):
    given = TextureInput(
        breps=[face.exportBrepToString()],
        tool=core.BallEndMill(2.0 * spacing, 2),
        spindle=core.Spindle(1000 / 60, "M3"),
        feed=30.0 * spacing,
        safe_height=500.0,
        clearance_height=501.0,
        spacing=spacing,
        mapping="On surface",
        patch_shape=shape,
        patch_side=side,
        minimum_tilt=0.0001,
        **more,
    )
    return place_texture(given)


def laid_positions(placed):
    """Of all lattice points on the face, whether or not they are seen from the direction; sorted."""
    names = core.state_names()
    out = [names.index("off the face")]
    on = ~np.isin(placed.dimples.states, out)
    return placed.dimples.positions[on]


def judged(placed, face):
    """What a lattice is worth, as a dict: nearest distance of milled dimples over the spacing; what was laid
    over the area's worth; dimples by reason."""
    names = core.state_names()
    states, positions = placed.dimples.states, placed.dimples.positions
    left = [names.index(n) for n in ("off the face", "off the net", "crowded")]
    laid = positions[~np.isin(states, left)]
    cell = placed.division.pattern.cell_area
    nearest = core.nearest_distances(placed.dimples)
    return {
        "nearest": nearest.min() / placed.input.spacing if len(nearest) > 1 else math.inf,
        "laid": len(laid) * cell / face.Area,
        "pieces": placed.laid.pieces,
        "counts": {k: v for k, v in placed.dimples.counts().items() if v},
    }


def largest_move(first, second):
    """How far points of a set are from the nearest of another, at most; infinite if they differ in number."""
    first, second = np.asarray(first).reshape(-1, 3), np.asarray(second).reshape(-1, 3)
    if len(first) != len(second):
        return math.inf
    order = [np.lexsort(np.round(p, 4).T) for p in (first, second)]
    moves = np.linalg.norm(first[order[0]] - second[order[1]], axis=1)
    if len(moves) and moves.max() > 1e-3:  # sorted otherwise by rounding
        moves = np.array([np.linalg.norm(second - p, axis=1).min() for p in first])
    return float(moves.max()) if len(moves) else 0.0
