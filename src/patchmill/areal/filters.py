"""What is done to a surface before its parameters are computed: the F-operation takes the form away, the
S-filter what is shorter than a wavelength, the L-filter what is longer (ISO 25178-2, 3.1; ISO 16610-61).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import replace

import numpy as np
from _patchmill import InputError

ALPHA = math.sqrt(math.log(2.0) / math.pi)  # ISO 16610-61, 3.1: half of the amplitude passes at the cut-off
REACH = 1.0  # cut-offs to which the weights are taken: below 1e-6 of the middle beyond it
FORMS = {"none": -1, "plane": 1, "quadric": 2, "cubic": 3}
BLOCK_ROWS = 256


def without_form(surface, form="plane"):
    """A HeightMap less its form, the polynomial of least squares over the known points: "plane", "quadric"
    (degree 2), "cubic", or "none" (unchanged). Raises InputError naming Form or Heights."""
    if form not in FORMS:
        raise InputError("Form", repr(form), "give one of %s." % ", ".join(FORMS))
    degree = FORMS[form]
    if degree < 0:
        return surface
    powers = [(i, j) for i in range(degree + 1) for j in range(degree + 1 - i)]
    rows, columns = surface.shape
    x, y = np.linspace(-1.0, 1.0, columns), np.linspace(-1.0, 1.0, rows)
    if surface.known.sum() < len(powers):
        remedy = "measure more points than the form has terms."
        raise InputError("Heights", "%d known" % surface.known.sum(), remedy)
    matrix, right = np.zeros((len(powers), len(powers))), np.zeros(len(powers))
    for first in range(0, rows, BLOCK_ROWS):
        heights = surface.heights[first : first + BLOCK_ROWS].astype(float)
        known = np.isfinite(heights)
        terms = _terms(x, y[first : first + BLOCK_ROWS], powers)[:, known]
        matrix += terms @ terms.T
        right += terms @ heights[known]
    weights = np.linalg.lstsq(matrix, right, rcond=None)[0]
    left = np.empty(surface.shape)
    for first in range(0, rows, BLOCK_ROWS):
        block = slice(first, first + BLOCK_ROWS)
        form_there = np.tensordot(weights, _terms(x, y[block], powers), axes=1)
        left[block] = surface.heights[block] - form_there
    return replace(surface, heights=left)


def form_at(surface, left, places):
    """What without_form() took from a HeightMap at places (n, 2) of its frame [mm]: `left` is what it left.
    Exact, for a form is a polynomial. Raises InputError naming Heights if fewer than ten points are known."""
    rows, columns = np.nonzero(surface.known)
    if len(rows) < 10:
        raise InputError("Heights", "%d known" % len(rows), "measure more points.")
    some = np.linspace(0, len(rows) - 1, min(len(rows), 4000)).astype(int)
    rows, columns = rows[some], columns[some]
    at = np.column_stack([surface.x()[columns], surface.y()[rows]])
    middle, half = at.mean(axis=0), np.maximum(np.ptp(at, axis=0), 1e-9)
    powers = [(i, j) for i in range(4) for j in range(4 - i)]

    def terms(points):
        u, v = ((np.asarray(points, float) - middle) / half).T
        return np.array([u**i * v**j for i, j in powers]).T

    taken = surface.heights[rows, columns].astype(float) - left.heights[rows, columns]
    return terms(places) @ np.linalg.lstsq(terms(at), taken, rcond=None)[0]


def _terms(x, y, powers):
    """x^i y^j at all points: (powers, rows, columns)."""
    return np.array([np.outer(y**j, x**i) for i, j in powers])


def smoothed(surface, cut_off):
    """A HeightMap through the Gaussian low pass of ISO 16610-61 with a nesting index of `cut_off` [mm].
    Weights beyond the border and in holes count nothing, and the others for more: a deviation from the
    standard's examples, which leave the border out. Raises InputError naming CutOff."""
    _require_cut_off(surface, cut_off)
    known = surface.known
    weight = _convolved(known.astype(float), surface.step, cut_off)
    sum_of = _convolved(np.where(known, surface.heights, 0.0), surface.step, cut_off)
    heights = np.where(known, sum_of / np.maximum(weight, 1e-300), np.nan)
    return replace(surface, heights=heights)


def without_waviness(surface, cut_off):
    """A HeightMap less what the Gaussian low pass leaves (L-filter), so that waves longer than `cut_off` [mm]
    are gone. As smoothed()."""
    return replace(surface, heights=surface.heights - smoothed(surface, cut_off).heights)


def _convolved(values, step, cut_off):
    """Gaussian weighted sums along rows and columns, by Fourier transforms of one direction at a time."""
    for axis, distance in ((1, step[0]), (0, step[1])):
        reach = min(int(REACH * cut_off / distance) + 1, values.shape[axis] - 1)
        x = np.arange(-reach, reach + 1) * distance
        kernel = np.exp(-math.pi * (x / (ALPHA * cut_off)) ** 2)
        kernel /= kernel.sum()
        length = _good_length(values.shape[axis] + 2 * reach)
        change = np.fft.rfft(kernel, length)
        out = np.empty(values.shape)
        others = values.shape[1 - axis]
        for first in range(0, others, BLOCK_ROWS):
            block = (slice(first, first + BLOCK_ROWS), slice(None))[:: 1 if axis else -1]
            moved = np.moveaxis(values[block], axis, -1)
            sums = np.fft.irfft(np.fft.rfft(moved, length) * change, length)
            out[block] = np.moveaxis(sums[:, reach : reach + values.shape[axis]], -1, axis)
        values = out
    return values


def _good_length(least):
    """A length of 2^a 3^b 5^c from `least` on: short transforms of others take long."""
    best = 1 << (least - 1).bit_length()
    for fives in (1, 5, 25, 125):
        for threes in (1, 3, 9, 27):
            length = fives * threes
            while length < least:
                length *= 2
            best = min(best, length)
    return best


def _require_cut_off(surface, cut_off):
    if not (math.isfinite(cut_off) and cut_off >= 2.0 * max(surface.step)):
        remedy = "give at least two steps of the grid, %g mm." % (2.0 * max(surface.step))
        raise InputError("CutOff", "%g mm" % cut_off, remedy)
