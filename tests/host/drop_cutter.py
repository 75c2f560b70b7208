"""A stand-in for OpenCAMLib's Python module `ocl`, as far as FreeCAD's 3D Surface uses it with a ball end
mill: so its own code runs where OpenCAMLib is not installed. The ball is lowered on each triangle's face,
edges and corners in closed form, all triangles at a time; slow, and written without PatchMill's probe.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib
import math
import sys
import types

import numpy as np

NONE = -np.inf
FLAT = 1e-12


def real_module():
    """OpenCAMLib's own module, by its old or its new name, or None."""
    for name in ("ocl", "opencamlib"):
        try:
            module = importlib.import_module(name)
        except ImportError:
            continue
        if not getattr(module, "stand_in", False):
            return module
    return None


def install():
    """Makes `import ocl` give OpenCAMLib, or else the stand-in; returns whether that was needed."""
    real = real_module()
    if real is not None:
        sys.modules["ocl"] = real
        return False
    module = types.ModuleType("ocl")
    module.stand_in = True
    for name in (Point, Line, Path, Triangle, STLSurf, BallCutter, PathDropCutter):
        setattr(module, name.__name__, name)
    sys.modules["ocl"] = module
    return True


class Heights:
    """Height of the tip of a resting ball over triangles (n, 3, 3) [mm]."""

    def __init__(self, triangles, radius):
        self.t, self.r = np.asarray(triangles, dtype=float), radius
        self.low, self.high = self.t.min(axis=1)[:, :2] - radius, self.t.max(axis=1)[:, :2] + radius

    def at(self, x, y):
        """-inf where no triangle is within reach."""
        near = ((self.low <= (x, y)) & (self.high >= (x, y))).all(axis=1)
        t = self.t[near]
        if not len(t):
            return NONE
        centre = np.array([x, y])
        edges = ((t[:, i], t[:, (i + 1) % 3]) for i in range(3))
        best = [self._on_faces(t, centre), self._on_corners(t.reshape(-1, 3), centre)]
        best += [self._on_edges(a, b, centre) for a, b in edges]
        return max(best) - self.r

    def _on_corners(self, p, centre):
        square = self.r**2 - ((p[:, :2] - centre) ** 2).sum(axis=1)
        on = square >= 0
        return (p[on, 2] + np.sqrt(square[on])).max(initial=NONE)

    def _on_edges(self, a, b, centre):
        way = b - a
        run = np.linalg.norm(way[:, :2], axis=1)
        a, way, run = a[run > FLAT], way[run > FLAT], run[run > FLAT]
        along, slope = way[:, :2] / run[:, None], way[:, 2] / run
        off = centre - a[:, :2]
        u = (off * along).sum(axis=1)
        square = self.r**2 - (off[:, 0] * along[:, 1] - off[:, 1] * along[:, 0]) ** 2
        reach = np.sqrt(np.maximum(square, 0.0))
        steep = np.sqrt(1.0 + slope**2)
        contact = u + reach * slope / steep
        on = (square >= 0) & (contact >= 0) & (contact <= run)
        return (a[:, 2] + slope * u + reach * steep)[on].max(initial=NONE)

    def _on_faces(self, t, centre):
        normal = np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])
        size = np.linalg.norm(normal, axis=1)
        up = np.abs(normal[:, 2]) > 1e-9 * np.maximum(size, FLAT)
        t, normal = t[up], normal[up] / size[up, None]
        normal *= np.sign(normal[:, 2])[:, None]
        touch = centre - self.r * normal[:, :2]
        inside = np.ones((3, len(t)))
        for i in range(3):
            a, b = t[:, i, :2], t[:, (i + 1) % 3, :2]
            e, f = b - a, touch - a
            inside[i] = e[:, 0] * f[:, 1] - e[:, 1] * f[:, 0]
        on = (inside >= 0).all(axis=0) | (inside <= 0).all(axis=0)
        height = t[:, 0, 2] - ((touch - t[:, 0, :2]) * normal[:, :2]).sum(axis=1) / normal[:, 2]
        return (height + self.r * normal[:, 2])[on].max(initial=NONE)


class Point:
    def __init__(self, x, y, z):
        self.x, self.y, self.z = x, y, z


class Line:
    def __init__(self, a, b):
        self.a, self.b = a, b


class Triangle:
    def __init__(self, a, b, c):
        self.corners = [(p.x, p.y, p.z) for p in (a, b, c)]


class Path(list):
    """Lines, one after another."""


class STLSurf:
    def __init__(self):
        self.triangles = []

    def addTriangle(self, triangle):
        self.triangles.append(triangle.corners)


class BallCutter:
    def __init__(self, diameter, length):
        self.diameter = diameter

    def getDiameter(self):
        return self.diameter


class PathDropCutter:
    def __init__(self):
        self.floor, self.sampling = 0.0, 0.1
        self.heights = self.surface = None

    def setSTL(self, surface):
        self.surface = surface

    def setCutter(self, cutter):
        self.heights = Heights(self.surface.triangles, cutter.diameter / 2.0)

    def setZ(self, floor):
        self.floor = floor

    def setSampling(self, sampling):
        self.sampling = sampling

    def setPath(self, path):
        self.path = path

    def run(self):
        self.points = []
        for line in self.path:
            a, b = line.a, line.b
            n = max(1, math.ceil(math.hypot(b.x - a.x, b.y - a.y) / self.sampling))
            for i in range(n + 1):
                x, y = a.x + (b.x - a.x) * i / n, a.y + (b.y - a.y) * i / n
                self.points.append(Point(x, y, max(self.floor, self.heights.at(x, y))))

    def getCLPoints(self):
        return self.points
