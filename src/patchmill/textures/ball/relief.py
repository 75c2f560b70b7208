"""What a texture leaves all over a ball: one relief for each of several views, seen from its own side.

    result = patchmill.simulate_ball(op, program="first.ngc")
    print(result.marks_of_dimples())

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, replace
from typing import Any

import _patchmill as core
import numpy as np

ZONES = ((0.0, 1), (36.0, 6), (70.0, 10), (100.0, 10))  # degrees from where the tool comes from, views
REACH = 24.0  # degrees from a view to what is nearest to it, at most
STEEPEST = 60.0  # degrees, of what a view looks at


@dataclass
class SimulatedBall:
    """`views`: a simulated_texture.SimulatedTexture for each of the unit vectors `looks`, (n, 3), out of the
    ball. Numbers are those of the ball's whole lattice."""

    plan: Any  # plan.PlannedTexture
    views: list
    looks: np.ndarray

    def marks_of_dimples(self):
        """How many marks there are at each of the lattice's dimples, (n,): a dimple is looked at in the view
        nearest to it, and has a mark nearer than half a spacing or none. Those that this set-up does not
        mill, too: a mark there is one that nobody planned."""
        count = np.zeros(len(self.plan.ball.whole), dtype=int)
        for number in self._nearest_dimples(self._points()):
            count[number] += 1
        return count

    @property
    def extra(self):
        """How many marks lie at none of the dimples that this set-up mills."""
        milled = np.zeros(len(self.plan.ball.whole), dtype=int)
        cut = self.plan.dimples.states == core.DimpleState.CUT
        milled[self.plan.ball.numbers[cut]] = 1
        marks = self.marks_of_dimples()
        far = len(self._points()) - marks.sum()
        return int(far + np.maximum(0, marks - milled).sum())

    def _points(self):
        """(m, 3) unit vectors to all marks, each as the view nearest to it has it."""
        ball, kept = self.plan.ball.sphere, []
        for number, view in enumerate(self.views):
            points = view.found["points"] - ball.centre
            points = points / np.linalg.norm(points, axis=1, keepdims=True)
            kept.append(points[np.argmax(points @ self.looks.T, axis=1) == number])
        return np.vstack(kept)

    def _nearest_dimples(self, points):
        """Of each unit vector the number of the dimple that it lies at; of those at none nothing."""
        ball = self.plan.ball
        if not len(points):
            return []
        near = np.argmax(points @ ball.whole.T, axis=1)
        apart = np.linalg.norm(points - ball.whole[near], axis=1)
        return near[apart < 0.5 * ball.spread["mean"]]

    def heights(self, normals):
        """Deviations from the ball [mm] at (n, 3) unit vectors; NaN where no view looks."""
        out = np.full(len(normals), np.nan)
        nearest = np.argmax(normals @ self.looks.T, axis=1)
        for number, view in enumerate(self.views):
            of_view = np.flatnonzero(nearest == number)
            points = self.plan.ball.sphere.points(normals[of_view]) - view.plan.plane.origin
            for_each = []
            axes = view.plan.plane.x_axis, view.plan.plane.y_axis
            for axis, first in zip(axes[::-1], view.origin[::-1]):
                for_each.append((points @ np.asarray(axis) - first) / view.step)
            out[of_view] = _between(np.asarray(view.heights, float), *for_each)
        return out


def _between(grid, row, column):
    """Bilinear values at rows and columns of a grid; NaN outside."""
    r, c = np.floor(row).astype(int), np.floor(column).astype(int)
    inside = (r >= 0) & (c >= 0) & (r < grid.shape[0] - 1) & (c < grid.shape[1] - 1)
    out, r, c = np.full(len(row), np.nan), r[inside], c[inside]
    y, x = row[inside] - r, column[inside] - c
    low = (1.0 - x) * grid[r, c] + x * grid[r, c + 1]
    high = (1.0 - x) * grid[r + 1, c] + x * grid[r + 1, c + 1]
    out[inside] = (1.0 - y) * low + y * high
    return out


def looks(up, beside):
    """(n, 3) unit vectors that views look against, about `up`."""
    across = np.cross(up, beside)
    made = []
    for lean, many in ZONES:
        lean = math.radians(lean)
        for turn in 2.0 * math.pi * np.arange(many) / many:
            aside = math.cos(turn) * np.asarray(beside) + math.sin(turn) * across
            made.append(math.cos(lean) * np.asarray(up) + math.sin(lean) * aside)
    return np.array(made)


def seen_along(plan, look):
    """(the PlannedTexture as it is seen against a unit vector, window of that view as simulate takes it)."""
    sphere = plan.ball.sphere
    origin = sphere.points(look[None])[0]
    plane = core.texture_plane(origin, -look, np.eye(3)[np.argmin(np.abs(look))], 0.0)
    across = sphere.radius * math.sin(math.radians(REACH)) + plan.input.spacing
    limits = replace(plan.input, steepest_slope=STEEPEST)
    return replace(plan, plane=plane, input=limits), ((-across, -across), (across, across))
