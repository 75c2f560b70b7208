"""What a path leaves of the stock, seen from above: heights over a grid, and how far they lie over the part.

    given = patchmill.verify.checks.check_input(op)            # of copy milling, or of a modifier on it
    surface = milled_surface(given.path, given.breps)
    print(surface.text())

Each cell of the grid keeps the least height that the tool's end had over it (a z-buffer: Van Hook 1986), at
places along the cutting moves that are so near to each other that what stays between them is below ALONG.
Walls and what lies below an overhang are not seen from above. A tilted tool is known by its ball alone.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.system.stops import stoppable

ALONG = 5e-4  # mm: the ridges across a path that come from looking at single places of it
CELLS, ACROSS = 250000, 40  # of the grid, at most about; to a radius of the tool
STEEPEST = math.radians(85.0)  # of faces to the horizontal: of steeper ones a cell says nothing
LOOK_EVERY = 500  # places, whether to go on


@dataclass
class MilledSurface:
    """`points` (rows, columns, 3) of what is left [mm], and `left` (rows, columns): how far it lies over the
    part along the part's normal [mm], below 0 where it is cut too deep; NaN where there is no part, or where
    the tool has not been. `step`: distance of cells [mm]. `milled`: share of the part, as seen from above."""

    points: np.ndarray
    left: np.ndarray
    step: float
    milled: float

    def rows(self):
        """The table: pairs of a name and what is to be said of it. Heights hold for all but 0.1 % of the
        cells at either end, where a cell meets the border of the part."""
        known = self.left[np.isfinite(self.left)]
        low, high = np.percentile(known, (0.1, 99.9))
        yield "part that is milled, seen from above", "%.1f %%" % (100.0 * self.milled)
        yield "left over the part, mean", "%.1f µm" % (1e3 * known.mean())
        yield "left over the part, at most", "%.1f µm" % (1e3 * high)
        yield "cut below the part, at most", "%.1f µm" % (1e3 * max(0.0, -low))
        yield "grid", "%.3f mm" % self.step

    def text(self):
        """The table as text."""
        return "\n".join("%-38s %s" % row for row in self.rows())


@stoppable
def milled_surface(path, breps, step=None, progress=None):
    """MilledSurface of a ToolPath over a part, BREP texts in `breps`; None if `progress` (share -> bool)
    returned False. `step`: distance of cells [mm]; None: fine enough for the tool and coarse enough for the
    part. Raises InputError naming ToolAxis of a tilted tool that is no ball, GridStep, or Path where none of
    it is over the part."""
    tool = path.tool
    places = _places(path, _spacing(tool))
    down = core.texture_plane((0.0, 0.0, 0.0), (0.0, 0.0, -1.0), (1.0, 0.0, 0.0))
    sampler = core.FaceSampler(breps, down, STEEPEST)
    low, high = (np.asarray(corner) for corner in sampler.extent())
    if step is None:
        step = max(tool.radius / ACROSS, math.sqrt(float(np.prod(high - low)) / CELLS))
    if not (math.isfinite(step) and 0.0 < step <= min(high - low)):
        raise InputError("GridStep", "%g mm" % step, "give more than zero and less than the part's width.")
    x, y = (np.arange(low[k] + 0.5 * step, high[k], step) for k in range(2))
    across = np.stack(np.meshgrid(x, y), axis=-1)
    heights = _heights(places, tool, (x, y), progress)
    if heights is None:
        return None
    seen = sampler.sample(across.reshape(-1, 2))
    there = (seen["states"] == int(core.DimpleState.CUT)).reshape(heights.shape)
    known = there & np.isfinite(heights)
    if not known.any():
        raise InputError("Path", "none over the part", "let the operation mill a face of the job's model.")
    part, normals = (seen[name].reshape(*heights.shape, 3) for name in ("positions", "normals"))
    points = np.where(known[..., None], part, np.nan)
    points[..., 2] = np.where(known, heights, np.nan)
    left = np.where(known, (heights - part[..., 2]) * normals[..., 2], np.nan)
    return MilledSurface(points, left, step, float(known.sum() / there.sum()))


def _spacing(tool):
    """Distance of places along the path [mm]."""
    corner = tool.corner_radius
    return math.sqrt(8.0 * corner * ALONG) if corner > 0.0 else tool.radius / ACROSS


def _places(path, spacing):
    """(n, 3) places of the tool's tip along the cutting moves [mm]; of a tilted ball the tip of an upright
    one with the same centre. Raises InputError naming ToolAxis."""
    tips, tool = np.vstack([path.start, path.tips]), path.tool
    axes = np.vstack([path.axes[:1], path.axes])
    if (axes[:, 2] < 1.0 - 1e-9).any():
        if not tool.is_ball:
            raise InputError("ToolAxis", "tilted", "a ball end mill alone can be seen so: choose one.")
        tips = tips + tool.radius * (axes - (0.0, 0.0, 1.0))
    moves = np.flatnonzero(path.kinds == int(core.MoveKind.CUT))
    begin, end = tips[moves], tips[moves + 1]
    count = np.maximum(1, np.ceil(np.linalg.norm(end - begin, axis=1) / spacing)).astype(int)
    which = np.repeat(np.arange(len(moves)), count)
    share = (np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count) + 1) / count[which]
    return np.vstack([begin[:1], begin[which] + share[:, None] * (end - begin)[which]])


def end_heights(tool, distances):
    """Heights of an upright tool's end and flank over its tip at distances from its axis [mm]; infinite
    beyond."""
    corner, flat = tool.corner_radius, tool.radius - tool.corner_radius
    cones = [(rf, rt, zf, zt) for part, zf, zt, rf, rt in tool.sections if part == "flute" and rt > rf]
    reach = cones[0][0] if cones else tool.radius
    out = np.clip(distances - flat, 0.0, corner)
    made = np.where(distances <= reach, corner - np.sqrt(corner**2 - out**2), np.inf)
    for inner, outer, low, high in cones:
        on = (distances > inner) & (distances <= outer)
        made[on] = low + (distances[on] - inner) * (high - low) / (outer - inner)
    return made


def _heights(places, tool, grid, progress):
    """Least height that the tool had over each cell, infinite where it has not been; None if stopped.
    `grid`: x of the columns and y of the rows [mm]."""
    x, y = grid
    cones = [outer for part, _, _, _, outer in tool.sections if part == "flute"]
    reach = max([tool.radius, *cones])
    heights = np.full((len(y), len(x)), np.inf)
    first, last = (np.searchsorted(x, places[:, 0] + side * reach) for side in (-1, 1))
    lower, upper = (np.searchsorted(y, places[:, 1] + side * reach) for side in (-1, 1))
    for k in np.flatnonzero((first < last) & (lower < upper)):
        if k % LOOK_EVERY == 0 and not progress(k / len(places)):
            return None
        rows, columns = slice(lower[k], upper[k]), slice(first[k], last[k])
        away = (y[rows, None] - places[k, 1]) ** 2 + (x[columns] - places[k, 0]) ** 2
        cells = heights[rows, columns]
        np.minimum(cells, places[k, 2] + end_heights(tool, np.sqrt(away)), out=cells)
    return heights
