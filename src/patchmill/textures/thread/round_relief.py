"""What a thread leaves all round its cylinder: one relief for each of several sectors, seen from its own
side, and all of them unrolled.

    result = patchmill.simulate_round(op, program="roller.ngc")
    print(result.quality, result.missing)
    relief = result.unrolled()

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass
from typing import Any

import _patchmill as core
import numpy as np

from patchmill.surface.height_map import HeightMap

UP = np.array([0.0, 0.0, 1.0])


@dataclass
class SimulatedRound:
    """`sectors`: a simulated_texture.SimulatedTexture for each; `angles`: of their middles about the rotary
    axis, from the top [rad]."""

    plan: Any  # plan.PlannedTexture
    sectors: list
    angles: np.ndarray

    @property
    def quality(self):
        """That of all sectors, each counted by its marks."""
        marks = [len(one.found["dimple"]) + len(one.found["extra"]) for one in self.sectors]
        return float(np.average([one.quality for one in self.sectors], weights=marks))

    @property
    def dimples(self):
        """Numbers of the planned dimples that lie in the sectors, each once, and of those found."""
        each = [one.found for one in self.sectors]
        looked = np.unique(np.concatenate([f["dimple"] for f in each]))
        found = np.unique(np.concatenate([f["dimple"][f["found"] >= 0] for f in each]))
        return looked, found

    @property
    def missing(self):
        """How many planned dimples were found in no sector."""
        looked, found = self.dimples
        return len(looked) - len(found)

    @property
    def extra(self):
        """How many marks nobody planned."""
        return sum(len(one.found["extra"]) for one in self.sectors)

    def unrolled(self, step=None):
        """The HeightMap of the deviations from the cylinder, x along the rotary axis and y round it from the
        top [mm]. `step`: distance of its points [mm]; None: as they were simulated."""
        turned = self.plan.thread
        step = self.sectors[0].step if step is None else step
        low, high = ends(turned)
        x = np.arange(low, high, step)
        y = np.arange(0.0, turned.cylinder.circumference, step)
        heights = np.full((len(y), len(x)), np.nan, np.float32)
        number = np.rint(y / turned.cylinder.radius / (2.0 * math.pi) * len(self.sectors)).astype(int)
        for k, one in enumerate(self.sectors):
            rows = np.flatnonzero(number % len(self.sectors) == k)
            off = y[rows] / turned.cylinder.radius - self.angles[k]
            across = turned.cylinder.radius * np.sin(off)
            r = np.rint((across - one.origin[1]) / one.step).astype(int)
            c = np.rint((x - 0.5 * (low + high) - one.origin[0]) / one.step).astype(int)
            inside_r = (r >= 0) & (r < one.heights.shape[0])
            inside_c = (c >= 0) & (c < one.heights.shape[1])
            block = one.heights[np.ix_(r[inside_r], c[inside_c])]
            heights[np.ix_(rows[inside_r], np.flatnonzero(inside_c))] = block
        return HeightMap(heights, step, (low, 0.0), "Thread cut by %s, unrolled" % self.sectors[0].source)


def plane_of(turned, angle, middle):
    """The texture plane of the sector at `angle` [rad] about the rotary axis from the top, x along the axis
    and y with the angle."""
    beside = np.cross(UP, turned.along)
    out = math.cos(angle) * UP + math.sin(angle) * beside
    origin = turned.origin + middle * turned.along
    return core.texture_plane(origin, -out, turned.along, 0.0)


def ends(turned):
    """Where the cylinder begins and ends along the rotary axis [mm]."""
    cylinder = turned.cylinder
    ends = [cylinder.point + at * cylinder.direction for at in (cylinder.low, cylinder.high)]
    return tuple(sorted(float((end - turned.origin) @ turned.along) for end in ends))
