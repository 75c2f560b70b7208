"""Which points of a sphere are neighbours, and how far apart.

Neighbours are those of Delaunay's triangulation. Seen from p by stereographic projection,

    q ↦ (q − (p·q) p) / (1 − p·q),

the circles through p become straight lines, and those through p and two others that hold no fourth point the
sides of the convex hull: p's neighbours are the corners of the hull of all other images (K. Q. Brown,
*Voronoi diagrams from convex hulls*, Inf. Process. Lett. 9 (1979)).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import numpy as np

NEAREST = 40  # looked at around each point
ALIKE = 1e-9  # of an image's size: three of them on a line


def pairs(points):
    """(m, 2) numbers i < j of neighbouring unit vectors, (n, 3)."""
    found = set()
    for i, around in enumerate(_nearest(points, NEAREST)):
        for j in around[_hull(_seen_from(points[i], points[around]))]:
            found.add((min(i, int(j)), max(i, int(j))))
    return np.array(sorted(found), dtype=int).reshape(-1, 2)


def spread(points, taken=None):
    """Straight distances of neighbouring unit vectors over their mean: dict of mean (over the radius),
    least, greatest and rms (of the change). `taken`: pairs, those of the points if None."""
    taken = pairs(points) if taken is None else taken
    apart = np.linalg.norm(points[taken[:, 1]] - points[taken[:, 0]], axis=1)
    mean = float(apart.mean())
    shares = apart / mean
    rms = float(np.sqrt(np.mean((shares - 1.0) ** 2)))
    return {"mean": mean, "least": float(shares.min()), "greatest": float(shares.max()), "rms": rms}


def _nearest(points, count):
    """For each point the numbers of the `count` nearest others."""
    count = min(count, len(points) - 1)
    block = max(1, 4_000_000 // len(points))
    for first in range(0, len(points), block):
        close = points[first : first + block] @ points.T
        rows = np.arange(len(close))
        close[rows, first + rows] = -2.0
        yield from np.argpartition(-close, count - 1, axis=1)[:, :count]


def _seen_from(point, others):
    """(n, 2) stereographic images of unit vectors on the plane at right angles to `point`."""
    aside = np.eye(3)[np.argmin(np.abs(point))]
    x = np.cross(point, aside)
    x /= np.linalg.norm(x)
    y = np.cross(point, x)
    return np.column_stack([others @ x, others @ y]) / (1.0 - others @ point)[:, None]


def _hull(images):
    """Numbers of the corners of the convex hull of (n, 2) points (Andrew's chains)."""
    order = np.lexsort((images[:, 1], images[:, 0]))
    tolerance = ALIKE * float(np.abs(images).max()) ** 2
    return sorted(set(_chain(images, order, tolerance) + _chain(images, order[::-1], tolerance)))


def _chain(images, order, tolerance):
    chain: list = []
    for n in map(int, order):
        while len(chain) > 1:
            (ax, ay), (bx, by), (cx, cy) = images[chain[-2]], images[chain[-1]], images[n]
            if (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > tolerance:
                break
            chain.pop()
        chain.append(n)
    return chain
