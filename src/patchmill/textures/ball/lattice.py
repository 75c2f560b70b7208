"""Lattices of a sphere, as unit vectors.

    Icosahedral   D. L. D. Caspar & A. Klug, Cold Spring Harbor Symp. Quant. Biol. 27 (1962): the triangular
                  lattice on the 20 faces of an icosahedron whose corners are (h, k) steps apart,
                  T = h² + h k + k², N = 10 T + 2, twelve of them with five neighbours; then steps
                  downhill (relaxed) make neighbours alike
    Fibonacci     R. Swinbank & R. J. Purser, Q. J. R. Meteorol. Soc. 132 (2006): any N, on one spiral
    Rings         parallels of a pole that are √3/2 of a spacing apart, any N

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import functools
import itertools
import math

import numpy as np
from _patchmill import InputError

from patchmill.textures.ball import neighbours

LATTICES = ICOSAHEDRAL, FIBONACCI, RINGS = ("Icosahedral", "Fibonacci", "Rings")
GOLDEN = 0.5 * (1.0 + math.sqrt(5.0))
CELL = math.sqrt(0.75)  # of a triangular lattice's spacing squared
LEAST, MOST = 12, 100_000  # dimples of a whole ball
STEPS = tuple(itertools.product((-1, 0, 1), repeat=3))
SAME = 1e-6  # of the radius: two faces of the icosahedron have the same point


def points(name, count):
    """(n, 3) unit vectors of one of LATTICES with `count` points. Raises InputError naming BallLattice, or
    BallDimples where it has none of so many points, with the nearest that it has."""
    if name not in LATTICES:
        raise InputError("BallLattice", name, "give one of: %s." % ", ".join(LATTICES))
    if not LEAST <= count <= MOST:
        raise InputError("BallDimples", count, "give %d to %d." % (LEAST, MOST))
    if name == FIBONACCI:
        return fibonacci(count)
    if name == RINGS:
        return rings(count)
    found = nearest_count(count)
    if found[0] != count:
        below, above = (nearest_count(count, way)[0] for way in (-1, 1))
        remedy = "an icosahedral lattice has %d or %d: choose one of these, or another lattice."
        raise InputError("BallDimples", count, remedy % (below, above))
    return _icosahedral_relaxed(*found[1])


@functools.lru_cache(maxsize=8)
def _icosahedral_relaxed(h, k):
    """Not to be changed: a panel that shows other values of the same ball asks for it again."""
    found = relaxed(icosahedral(h, k))
    found.setflags(write=False)
    return found


def count_of(radius, spacing):
    """How many dimples a ball of `radius` has at a `spacing`, of cells as in a plane [same unit]."""
    return 4.0 * math.pi * radius**2 / (CELL * spacing**2)


def spacing_of(radius, count):
    """The inverse of count_of."""
    return radius * math.sqrt(4.0 * math.pi / (CELL * count))


def nearest_count(wanted, way=0):
    """(N, (h, k)) of the icosahedral lattice whose N is nearest to `wanted`: no greater if `way` is -1, no
    less if it is 1."""
    most = int(math.sqrt(max(wanted, LEAST) / 10.0)) + 2
    all_of = [(10 * (h * h + h * k + k * k) + 2, (h, k)) for h in range(1, most + 1) for k in range(h + 1)]
    kept = [one for one in all_of if way * (one[0] - wanted) >= 0] or all_of
    return min(kept, key=lambda one: (abs(one[0] - wanted), one[0]))


def icosahedral(h, k):
    """(10 T + 2, 3) unit vectors of the lattice (h, k) on the faces of an icosahedron with a corner at z,
    drawn out to the sphere from its middle."""
    corners = _icosahedron()
    size = h * h + h * k + k * k
    i, j = (g.ravel() for g in np.meshgrid(np.arange(-k, h + 1), np.arange(0, h + 2 * k + 1)))
    b, c = i * (h + k) + j * k, j * h - i * k  # shares of two corners, of `size`
    inside = (b >= 0) & (c >= 0) & (b + c <= size)
    shares = np.column_stack([size - b - c, b, c])[inside] / size
    found = np.vstack([shares @ corners[list(face)] for face in _faces(corners)])
    return _each_once(found / np.linalg.norm(found, axis=1, keepdims=True))


def _icosahedron():
    """(12, 3) unit vectors, the first one z."""
    ring = 2.0 * math.pi / 5.0 * np.arange(5)
    z, across = 1.0 / math.sqrt(5.0), 2.0 / math.sqrt(5.0)
    upper, lower = (
        np.column_stack([across * np.cos(angle), across * np.sin(angle), np.full(5, height)])
        for angle, height in ((ring, z), (ring + math.pi / 5.0, -z))
    )
    return np.vstack([[0.0, 0.0, 1.0], upper, lower, [0.0, 0.0, -1.0]])


def _faces(corners):
    """The 20 faces, each three numbers of corners, counter-clockwise as seen from outside."""
    near = corners @ corners.T > 0.4  # 1/√5 between neighbours
    for a in range(12):
        for b in range(a + 1, 12):
            for c in range(b + 1, 12):
                if near[a, b] and near[b, c] and near[a, c]:
                    out = np.linalg.det(corners[[a, b, c]]) > 0.0
                    yield (a, b, c) if out else (a, c, b)


def _each_once(found):
    """The points of which none is another, in the order of their first place."""
    kept, taken = [], set()
    for number, key in enumerate(np.round(found / SAME).astype(np.int64).tolist()):
        around = (tuple(k + s for k, s in zip(key, step)) for step in STEPS)
        if not any(one in taken for one in around):
            taken.add(tuple(key))
            kept.append(number)
    return found[kept]


def relaxed(found, steps=400, share=0.2):
    """Unit vectors moved along the sphere so that the sum of the squares of (d / mean - 1), d the straight
    distances of neighbours, gets least: `steps` steps downhill."""
    pairs = neighbours.pairs(found)
    for _ in range(steps):
        found = _downhill(found, pairs, share)
    return found


def _downhill(found, pairs, share):
    """One step of relaxed()."""
    ways = found[pairs[:, 1]] - found[pairs[:, 0]]
    long = np.linalg.norm(ways, axis=1, keepdims=True)
    pull = share * (long - long.mean()) * ways / long
    pulled = [np.bincount(end, part, len(found)) for part in pull.T for end in pairs.T]
    found = found + np.column_stack(pulled[0::2]) - np.column_stack(pulled[1::2])
    return found / np.linalg.norm(found, axis=1, keepdims=True)


def fibonacci(count):
    """(count, 3) unit vectors on a spiral about z, the golden angle apart."""
    number = np.arange(count)
    z = 1.0 - (2.0 * number + 1.0) / count
    return _on_parallels(z, 2.0 * math.pi * number / GOLDEN)


def rings(count):
    """(count, 3) unit vectors on parallels of z, as many on each as its length asks for, every second ring
    turned by half a step."""
    rows = max(2, round(math.pi / (CELL * spacing_of(1.0, count))))
    angles = math.pi * (np.arange(rows) + 0.5) / rows
    exact = count * np.sin(angles) / np.sin(angles).sum()
    on_ring = np.floor(exact).astype(int)
    left = count - on_ring.sum()
    on_ring[np.argsort(on_ring - exact, kind="stable")[:left]] += 1
    made = []
    for row, (angle, many) in enumerate(zip(angles, on_ring)):
        turned = 2.0 * math.pi * (np.arange(many) + 0.5 * (row % 2)) / max(many, 1)
        made.append(_on_parallels(np.full(many, math.cos(angle)), turned))
    return np.vstack(made)


def projected(spacing, steepest=90.0):
    """Unit vectors of a triangular lattice of `spacing` (over the radius) seen along z, from either side, no
    steeper than `steepest` [degrees]: what projecting it, as the papers do, gives. To compare with."""
    reach = math.ceil(2.0 / spacing)
    i, j = (g.ravel() for g in np.meshgrid(np.arange(-reach, reach + 1), np.arange(-reach, reach + 1)))
    x, y = spacing * (i + 0.5 * j), spacing * CELL * j
    inside = np.hypot(x, y) < math.sin(math.radians(steepest))
    z = np.sqrt(1.0 - x[inside] ** 2 - y[inside] ** 2)
    upper = np.column_stack([x[inside], y[inside], z])
    return np.vstack([upper, upper * (1.0, 1.0, -1.0)])


def _on_parallels(z, angle):
    across = np.sqrt(1.0 - z**2)
    return np.column_stack([across * np.cos(angle), across * np.sin(angle), z])
