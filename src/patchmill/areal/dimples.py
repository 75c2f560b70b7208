"""Dimples of a measured surface: where their bottoms are, how deep and how curved they are.

Each local minimum of the smoothed surface that is the deepest within half a spacing gets a paraboloid of
least squares, whose vertex is the dimple's place: noise moves single points about.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

import numpy as np
from _patchmill import InputError

from patchmill.areal.filters import smoothed

SMOOTH = 0.35  # of the spacing: waves shorter than that make no dimple
REACH = 0.25  # of the spacing: radius of the paraboloid
APART = 0.5  # of the spacing: nearer minima are one dimple
ENOUGH = 0.6  # of a paraboloid's points must be known
SHALLOW = 0.25  # of the rise that nine of ten do not exceed: what rises less within reach is no dimple
CHUNK = 2048


@dataclass
class FoundDimples:
    """One entry for each dimple. Lengths in mm, in the height map's frame.

    `places` (n, 2); `heights` of their bottoms; `depths` from the mean of the surface within one spacing;
    `radii` (n, 2) of curvature, the smaller first (inf: flat); `residuals`: root mean square of what the
    paraboloid leaves, which is the surface's noise where the dimple is one."""

    places: np.ndarray
    heights: np.ndarray
    depths: np.ndarray
    radii: np.ndarray
    residuals: np.ndarray


def find_dimples(surface, spacing):
    """FoundDimples of a HeightMap whose form is taken away; `spacing` [mm] is that of the dimples. Raises
    InputError naming Spacing if the grid is too coarse for it, Heights if nothing is known."""
    least = 8.0 * max(surface.step)
    if not (math.isfinite(spacing) and spacing >= least):
        remedy = "give at least eight steps of the grid, %g mm." % least
        raise InputError("Spacing", "%g mm" % spacing, remedy)
    if not surface.known.any():
        raise InputError("Heights", "none is known", "give a surface with measured points.")
    smooth = smoothed(surface, SMOOTH * spacing).heights
    rows, columns = _minima(np.where(surface.known, smooth, np.inf))
    keep = _deepest(rows * surface.step[1], columns * surface.step[0], smooth[rows, columns], APART * spacing)
    return _fitted(surface, rows[keep], columns[keep], spacing)


def _minima(z):
    """Rows and columns of the points that are lower than their eight neighbours, the border left out."""
    middle = z[1:-1, 1:-1]
    lower = np.isfinite(middle)
    for down in range(3):
        for right in range(3):
            if (down, right) != (1, 1):
                other = z[down : down + middle.shape[0], right : right + middle.shape[1]]
                lower &= middle < other if (down, right) > (1, 1) else middle <= other
    rows, columns = np.nonzero(lower)
    return rows + 1, columns + 1


def _deepest(y, x, z, apart):
    """Indices of the points that have no deeper one kept within `apart`: the deepest first."""
    cells: dict = {}
    kept: list = []
    for index in np.argsort(z, kind="stable").tolist():
        cell = (int(x[index] / apart), int(y[index] / apart))
        near = (other for i in (-1, 0, 1) for j in (-1, 0, 1)
                for other in cells.get((cell[0] + i, cell[1] + j), ()))  # fmt: skip
        if all(math.hypot(x[index] - x[o], y[index] - y[o]) >= apart for o in near):
            cells.setdefault(cell, []).append(index)
            kept.append(index)
    return np.sort(np.array(kept, int))


def _fitted(surface, rows, columns, spacing):
    """Paraboloids around the minima; those with too few known points, or no bottom within reach, are none."""
    reach = REACH * spacing
    dy, dx = (np.arange(-math.ceil(reach / s), math.ceil(reach / s) + 1) for s in surface.step[::-1])
    down, right = (grid.ravel() for grid in np.meshgrid(dy, dx, indexing="ij"))
    v, u = down * surface.step[1] / reach, right * surface.step[0] / reach
    inside = u**2 + v**2 <= 1.0
    down, right, u, v = (a[inside] for a in (down, right, u, v))
    terms = np.stack([np.ones_like(u), u, v, u**2, u * v, v**2])
    border = ((dy[-1], dy[-1]), (dx[-1], dx[-1]))
    padded = np.pad(surface.heights.astype(float), border, constant_values=np.nan)
    parts = [(np.zeros((0, 6)), np.zeros(0))]
    for first in range(0, len(rows), CHUNK):
        r, c = (a[first : first + CHUNK, None] for a in (rows, columns))
        z = padded[r + dy[-1] + down, c + dx[-1] + right]
        parts.append(_paraboloids(z, terms))
    weights, residuals = (np.concatenate(part) for part in zip(*parts))
    place, bottom, curved = _vertices(weights)
    good = np.isfinite(bottom) & (np.hypot(*place.T) <= 1.5)
    rise = 0.5 * curved.sum(axis=1)
    if good.any():
        good &= rise >= SHALLOW * np.quantile(rise[good], 0.9)
    at = np.column_stack([surface.x()[columns], surface.y()[rows]]) + reach * place
    mean = smoothed(surface, 2.0 * spacing).heights[rows, columns]
    with np.errstate(divide="ignore"):
        radii = np.where(curved > 0, reach**2 / np.maximum(curved, 1e-300), np.inf)
    return FoundDimples(at[good], bottom[good], (mean - bottom)[good], radii[good], residuals[good])


def _paraboloids(z, terms):
    """Coefficients (n, 6) of least squares and the rms of the rest, for (n, k) heights with NaN for unknown;
    NaN where too little is known."""
    known = np.isfinite(z)
    weight = known.astype(float)
    matrix = np.einsum("nk,ik,jk->nij", weight, terms, terms, optimize=True)
    right = np.einsum("nk,ik->ni", np.where(known, z, 0.0), terms)
    enough = known.mean(axis=1) >= ENOUGH
    matrix[~enough] = np.eye(6)
    found = np.linalg.solve(matrix, right[..., None])[..., 0]
    found[~enough] = np.nan
    rest = np.where(known, z - found @ terms, 0.0)
    freedom = np.maximum(known.sum(axis=1) - 6, 1)
    return found, np.sqrt((rest**2).sum(axis=1) / freedom)


def _vertices(weights):
    """Places of the vertices and their heights, in units of the reach, and both principal curvatures, the
    larger first; NaN where the paraboloid has no bottom."""
    c, gx, gy, xx, xy, yy = weights.T
    determinant = 4.0 * xx * yy - xy**2
    bowl = (determinant > 0) & (xx + yy > 0)
    safe = np.where(bowl, determinant, np.nan)
    x, y = (xy * gy - 2.0 * yy * gx) / safe, (xy * gx - 2.0 * xx * gy) / safe
    half, spread = xx + yy, np.hypot(xx - yy, xy)
    curved = np.column_stack([half + spread, half - spread])
    return np.column_stack([x, y]), c + 0.5 * (gx * x + gy * y), curved
