"""How many moves copy milling will make, before it makes them: a few planes, or levels, are milled as slices
of the stock, and count for those between them. Distances that would make many lines, layers or points are
taken larger in the slices, and what they show is continued in a straight line: moves grow with the number of
layers, with that of the contours of a level, and with the root of 1 / tolerance.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, replace

SLICES = 3  # of the stock across the lines
LEVELS = 8  # of contours, whose number and length jump where a plane of the part begins
LAYERS = 16  # milled of a slice at most
RINGS = 24  # contours of a level at most
NODES = 1e4  # of a grid on which a slice's curves are found, about
THIN = 1e-3  # mm that a slice is wide
MOST = 1e50
ALL = 1e6  # mm between lines or layers: there are none between


@dataclass
class Cut:
    """A box of the stock from `low` to `high`, with its distances of lines and layers. mm."""

    low: tuple
    high: tuple
    radial: float
    axial: float
    tolerance: float

    @property
    def layers(self):
        return max(1, _count(self.high[2] - self.low[2], self.axial))

    def lines(self, beyond):
        """How many planes there are, with those up to `beyond` outside the stock."""
        width = self.high[1] - self.low[1]
        return max(1, _count(width, self.radial)) + 1 + 2 * _count(beyond, self.radial)

    def at_most(self, radius, beyond):
        """More moves than there are on most parts, without a look at them."""
        length = self.high[0] - self.low[0] + 2.0 * radius
        return self.layers * self.lines(beyond) * (8.0 + 4.0 * length / _step(radius, self.tolerance))


def moves(cut, mode, radius, beyond, count):
    """About how many moves a Cut of the whole stock takes with a tool of `radius`, lines going on up to
    `beyond` outside. `mode`: copy milling's; `count` says how many moves a Cut takes, by making them. Raises
    what it raises."""
    if mode == "Contour":
        return _contours(cut, radius, count)
    slices = [_slice(cut, (i + 0.5) / SLICES) for i in range(SLICES)]
    lines = slices[0].lines(beyond)
    each = sum(_of_slice(one, mode, radius, count) for one in slices) / (SLICES * lines)
    return cut.lines(beyond) * each


def _slice(cut, share):
    y = cut.low[1] + share * (cut.high[1] - cut.low[1])
    low, high = (cut.low[0], y, cut.low[2]), (cut.high[0], y + THIN, cut.high[2])
    return replace(cut, low=low, high=high, radial=ALL)


def _of_slice(cut, mode, radius, count):
    """Moves of a slice, from few of its layers."""
    height = cut.high[2] - cut.low[2]
    coarse, more = _coarser(cut, radius, height) if mode != "Scanning" else (cut, 1.0)
    if cut.layers <= LAYERS:
        some, further = count(coarse), 0.0
    else:
        some = count(replace(coarse, axial=height / LAYERS))
        few = count(replace(coarse, axial=2.0 * height / LAYERS))
        further = max(0.0, some - few) * (cut.layers / LAYERS - 1.0) / 0.5
    finer = 0.0
    if more > 1.0:
        axial = max(cut.axial, height / LAYERS)
        finer = _growth(count, replace(coarse, axial=axial), some) * (more - 1.0)
    return some + further + finer


def _contours(cut, radius, count):
    """Moves of contours, from a few levels with few rings each."""
    levels = cut.layers
    some = min(LEVELS, levels)
    width = max(cut.high[0] - cut.low[0], cut.high[1] - cut.low[1])
    sum_ = 0.0
    for i in range(some):
        layer = math.floor(levels * (i + 0.5) / some) + 1
        z = max(cut.low[2], cut.high[2] - layer * cut.axial)
        level = replace(cut, low=(cut.low[0], cut.low[1], min(z, cut.high[2] - THIN)), axial=ALL)
        coarse, more = _coarser(level, radius, cut.high[1] - cut.low[1])
        coarse.radial = max(cut.radial, width / RINGS)
        made = count(coarse)
        finer = 1.0
        if more > 1.0:
            finer += _growth(count, coarse, made) * (more - 1.0) / max(made, 1.0)
        if coarse.radial > cut.radial:
            few = count(replace(coarse, radial=2.0 * coarse.radial))
            made += max(0.0, made - few) * (coarse.radial / cut.radial - 1.0) / 0.5
        sum_ += made * finer
    return levels * sum_ / some


def _coarser(cut, radius, width):
    """(The same with a tolerance of which a grid has few nodes, how many times more points a curve has with
    its own)."""
    area = (cut.high[0] - cut.low[0] + 4.0 * radius) * (width + 4.0 * radius)
    more = math.sqrt(area / NODES) / (0.7 * _step(radius, cut.tolerance))
    tolerance = min(cut.tolerance * max(1.0, more) ** 2, 0.25 * radius)
    tolerance = max(tolerance, cut.tolerance)
    return replace(cut, tolerance=tolerance), math.sqrt(tolerance / cut.tolerance)


def _growth(count, cut, made):
    """Of `made` moves, those that grow with the root of 1 / tolerance."""
    return max(0.0, 2.0 * (made - count(replace(cut, tolerance=4.0 * cut.tolerance))))


def _count(length, step):
    """How many steps make a length; of more than there could be, a number that can be reckoned with."""
    return math.ceil(min(length / step - 1e-9, MOST))


def _step(radius, tolerance):
    """Length of an arc's chord that leaves it by the tolerance."""
    return math.sqrt(8.0 * radius * tolerance)
