"""A height map: heights over a rectangular grid, as a simulation gives them or an instrument measures them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, field

import numpy as np
from _patchmill import InputError

MOST_POINTS = 1 << 28  # 2 GiB of heights
LONGEST = 1e6  # mm: no grid is longer


@dataclass
class HeightMap:
    """Heights over a grid. Lengths in mm.

    `heights`: (rows, columns), row r at y = origin[1] + r * step[1], column c at x = origin[0] + c * step[0];
    NaN where nothing is known. `step`: (x, y) distance of points, above 0. `title`: one line of text.
    `notes`: {name: text} that a file may keep. Raises InputError naming Heights, GridStep or Origin."""

    heights: np.ndarray
    step: tuple
    origin: tuple = (0.0, 0.0)
    title: str = ""
    notes: dict = field(default_factory=dict)

    def __post_init__(self):
        self.heights = np.asarray(self.heights)
        if self.heights.dtype not in (np.float32, np.float64):
            self.heights = self.heights.astype(np.float64)
        if self.heights.ndim != 2 or min(self.heights.shape) < 2:
            shape = " x ".join(map(str, self.heights.shape)) or "one number"
            raise InputError("Heights", shape, "give a grid of at least 2 x 2 heights in mm.")
        if np.isinf(self.heights).any():
            raise InputError("Heights", "infinite", "give NaN where a height is not known.")
        self.step = tuple(float(s) for s in np.broadcast_to(self.step, 2))
        if not all(math.isfinite(s) and 0 < s <= LONGEST for s in self.step):
            raise InputError("GridStep", "%g x %g mm" % self.step, "give distances above 0 mm.")
        self.origin = tuple(float(o) for o in np.broadcast_to(self.origin, 2))
        if not all(math.isfinite(o) and abs(o) <= LONGEST for o in self.origin):
            raise InputError("Origin", "%g, %g mm" % self.origin, "give a place within 1 km.")

    @property
    def shape(self):
        """(rows, columns)."""
        return self.heights.shape

    @property
    def known(self):
        """Where heights are known: bool (rows, columns)."""
        return np.isfinite(self.heights)

    @property
    def size(self):
        """(x, y) of the area that the points stand for [mm]: a step for each."""
        rows, columns = self.heights.shape
        return columns * self.step[0], rows * self.step[1]

    def x(self):
        """x of each column [mm]."""
        return self.origin[0] + self.step[0] * np.arange(self.heights.shape[1])

    def y(self):
        """y of each row [mm]."""
        return self.origin[1] + self.step[1] * np.arange(self.heights.shape[0])

    def points(self, first, end):
        """Points of rows first <= row < end: (rows, columns, 3) [mm]; z is NaN where no height is known."""
        x, y = np.meshgrid(self.x(), self.y()[first:end])
        return np.dstack([x, y, self.heights[first:end]])

    def filled(self):
        """A copy of the heights with each unknown one as the mean of its known neighbours, from the rims of
        the holes inwards. Raises InputError if no height is known."""
        heights = np.array(self.heights, dtype=float)
        if not self.known.any():
            raise InputError("Heights", "none is known", "give a surface with measured points.")
        while True:
            unknown = np.isnan(heights)
            if not unknown.any():
                return heights
            mean = _mean_of_neighbours(heights, unknown)
            heights[unknown] = mean[unknown]


def _mean_of_neighbours(heights, unknown):
    """Mean of the known ones of eight neighbours; NaN where there is none."""
    total, count = np.zeros(heights.shape), np.zeros(heights.shape)
    padded = np.pad(np.where(unknown, 0.0, heights), 1)
    known = np.pad(np.where(unknown, 0.0, 1.0), 1)
    rows, columns = heights.shape
    for down in range(3):
        for right in range(3):
            total += padded[down : down + rows, right : right + columns]
            count += known[down : down + rows, right : right + columns]
    return np.where(count > 0, total / np.maximum(count, 1.0), np.nan)


def require_grid(rows, columns, what, room=None, each=1):
    """Raises InputError naming Surface if a file's grid cannot be taken: too few or too many points, or more
    than the `room` [bytes] that is there, at `each` bytes a point."""
    if rows < 2 or columns < 2 or rows * columns > MOST_POINTS:
        remedy = "give a grid of 2 x 2 to %d points." % MOST_POINTS
        raise InputError("Surface", "%s: %d x %d points" % (what, columns, rows), remedy)
    if room is not None and rows * columns * each > room:
        remedy = "it has only %d bytes of them: the file is cut off or damaged." % room
        raise InputError("Surface", "%s: %d x %d points" % (what, columns, rows), remedy)
