"""Areal parameters of a scale-limited surface, ISO 25178-2: heights, space, hybrid, volume. Lengths in mm.
Words and symbols are the standard's.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import numpy as np
from _patchmill import InputError

SHARE_OF_LAG = 0.2  # 5.3: to what the autocorrelation falls at Sal
PEAK, CORE = 0.10, 0.80  # 5.5: material ratios that part peaks, core and valleys


def areal_parameters(surface, lags=True):
    """{symbol: value} of a HeightMap whose form and waviness are taken away (patchmill.areal.filters):

      Sq, Sa [mm], Ssk, Sku, Sp, Sv, Sz [mm]   heights, 4.2; over the known points, from their mean
      Sal [mm], Str                            autocorrelation length and aspect ratio, 4.3; nan if it falls
                                               to 0.2 nowhere on the surface (`lags` False: not computed)
      Sdq, Sdr                                 root mean square gradient, and developed area less 1, 4.4
      Vmp, Vmc, Vvc, Vvv [mm]                  volumes per area, mm³/mm², 4.5, between 10 % and 80 %

    Raises InputError naming Heights if fewer than four neighbouring points are known or all are equal."""
    known = surface.known
    heights = surface.heights[known].astype(float)
    if len(heights) < 4:
        raise InputError("Heights", "%d known" % len(heights), "measure more points.")
    mean = heights.mean()
    from_mean = heights - mean
    sq = math.sqrt(np.mean(from_mean**2))
    if sq <= 1e-12 * max(abs(mean), 1e-6):
        raise InputError("Heights", "all equal", "a plane has no texture: measure a textured part.")
    found = {
        "Sq": sq,
        "Sa": float(np.mean(abs(from_mean))),
        "Ssk": float(np.mean(from_mean**3)) / sq**3,
        "Sku": float(np.mean(from_mean**4)) / sq**4,
        "Sp": float(from_mean.max()),
        "Sv": float(-from_mean.min()),
        "Sz": float(from_mean.max() - from_mean.min()),
    }
    if lags:
        found.update(zip(("Sal", "Str"), autocorrelation_lengths(surface)))
    found.update(gradients(surface))
    found.update(volumes(from_mean))
    return found


def gradients(surface):
    """Sdq and Sdr: of each cell of four known points, as four triangles that meet in its middle at the mean
    height. Raises InputError naming Heights if there is no such cell."""
    z = surface.heights
    dx, dy = surface.step
    square, area, cells = 0.0, 0.0, 0
    for first in range(0, z.shape[0] - 1, 256):
        block = z[first : first + 257].astype(float)
        a, b, c, d = block[:-1, :-1], block[:-1, 1:], block[1:, 1:], block[1:, :-1]
        there = np.isfinite(a + b + c + d)
        a, b, c, d = a[there], b[there], c[there], d[there]
        middle = 0.25 * (a + b + c + d)
        for p, q, along, across in ((a, b, dx, dy), (b, c, dy, dx), (d, c, dx, dy), (a, d, dy, dx)):
            slope = ((q - p) / along) ** 2 + ((2 * middle - p - q) / across) ** 2
            square += slope.sum() / 4.0
            area += np.sum(np.sqrt(1.0 + slope) - 1.0) / 4.0
        cells += len(a)
    if not cells:
        raise InputError("Heights", "no cell of four known points", "measure neighbouring points.")
    return {"Sdq": math.sqrt(square / cells), "Sdr": area / cells}


def volumes(from_mean):
    """Vmp, Vmc, Vvc, Vvv of heights over the mean [mm], from the areal material ratio curve."""
    curve = np.sort(from_mean)[::-1]

    def over(ratio):
        """Volume of material per area above the height that the curve has at a ratio, and that height."""
        level = float(np.interp(ratio * len(curve) - 0.5, np.arange(len(curve)), curve))
        return np.maximum(curve - level, 0.0).mean(), level

    def under(ratio):
        """Volume of voids per area below that height."""
        return over(ratio)[0] - (curve.mean() - over(ratio)[1])

    return {
        "Vmp": float(over(PEAK)[0]),
        "Vmc": float(over(CORE)[0] - over(PEAK)[0]),
        "Vvc": float(under(PEAK) - under(CORE)),
        "Vvv": float(under(CORE)),
    }


def autocorrelation_lengths(surface):
    """Sal [mm] and Str: distance to the nearest and, over it, to the farthest place at which the
    autocorrelation around the middle falls to 0.2. Unknown heights count nothing. nan, nan if it falls so far
    nowhere."""
    known = surface.known
    heights = np.where(known, surface.heights - np.mean(surface.heights[known]), 0.0)
    rows, columns = surface.shape
    size = [2 * rows, 2 * columns]
    product = np.fft.irfft2(abs(np.fft.rfft2(heights, size)) ** 2, size)
    if known.all():
        count = np.outer(*[_overlap(n) for n in (rows, columns)])
    else:
        count = np.fft.irfft2(abs(np.fft.rfft2(known.astype(float), size)) ** 2, size)
    enough = count > 0.25 * known.sum()  # beyond it too few pairs say anything
    change = np.where(enough, product / np.maximum(count, 0.5), np.nan)
    change = np.fft.fftshift(change / change[0, 0])
    distances = _first_falls(change, (rows, columns), surface.step)
    if not len(distances):
        return math.nan, math.nan
    least, most = float(distances.min()), float(distances.max())
    return least, least / most


def _overlap(count):
    """How many points of a line of `count` meet others at each cyclic shift of twice the length."""
    shift = np.minimum(np.arange(2 * count), 2 * count - np.arange(2 * count))
    return np.maximum(count - shift, 0).astype(float)


def _first_falls(change, middle, step, directions=720):
    """Distances [mm] along rays of a half turn at which the autocorrelation first falls to 0.2."""
    found = []
    longest = int(np.hypot(*middle))
    for angle in np.arange(directions) * math.pi / directions:
        # half a point at a time along the ray
        along = 0.5 * np.arange(2 * longest)
        toward = np.array([math.sin(angle) / step[1], math.cos(angle) / step[0]]) * min(step)
        values = _at(change, middle[0] + along * toward[0], middle[1] + along * toward[1])
        low = np.flatnonzero(~(values > SHARE_OF_LAG))
        if not len(low) or not math.isfinite(values[low[0]]):
            continue
        end = low[0]
        share = (values[end - 1] - SHARE_OF_LAG) / (values[end - 1] - values[end])
        found.append((along[end - 1] + 0.5 * share) * min(step))
    return np.array(found)


def _at(table, row, column):
    """Bilinear values of a table; nan outside."""
    rows, columns = table.shape
    inside = (row >= 0) & (column >= 0) & (row < rows - 1) & (column < columns - 1)
    r, c = np.where(inside, row, 0).astype(int), np.where(inside, column, 0).astype(int)
    u, v = row - r, column - c
    low = table[r, c] * (1 - v) + table[r, c + 1] * v
    high = table[r + 1, c] * (1 - v) + table[r + 1, c + 1] * v
    return np.where(inside, low * (1 - u) + high * u, np.nan)
