"""A measured texture beside its plan, and what it says of the machine: docs/areal-parameters.md.

    measured = measured_texture(op, patchmill.measured("scan.x3p"))
    print(measured.text())

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

import _patchmill as core
import numpy as np

from patchmill.areal.dimples import FoundDimples, find_dimples
from patchmill.areal.filters import without_form
from patchmill.areal.registration import Registration, register
from patchmill.operations.computed import planned

COVERAGE = 2.0  # standard deviations of the uncertainties that are given
AMBIGUOUS = 0.98  # from this doubt on nothing that depends on the dimples' numbers is said
SQUARE, HEXAGONAL = 4, 6  # how often a lattice comes onto itself in a turn


@dataclass
class Finding:
    """One property of the machine or the part as the measurement has it: its value and its uncertainty (two
    standard deviations) in `unit`; both None where the measurement cannot tell it, and `why` then says so."""

    name: str
    value: float | None
    uncertainty: float | None
    unit: str
    why: str = ""

    def text(self):
        """The finding as a phrase."""
        if self.value is None:
            return "unknown: %s" % self.why
        return "%.3g ± %.2g %s" % (self.value, self.uncertainty, self.unit)


@dataclass
class MeasuredTexture:
    """A measurement laid on the plan. Lengths in mm. `registration` pairs found dimples with planned ones;
    `findings` are of the machine; `array` is core.classify_alignment of the found places."""

    found: FoundDimples
    registration: Registration
    array: dict
    findings: list
    spacing: float

    @property
    def quality(self):
        """As that of a simulated texture: 1 as planned, 0 if no mark is within a quarter spacing."""
        one = self.registration
        share = np.hypot(*one.moved.T) / (0.25 * self.spacing)
        every = len(one.pairs) + len(one.missing) + len(one.extra)
        return float(np.maximum(0.0, 1.0 - share**2).sum() / every)

    def rows(self):
        """Pairs of a name and what is to be said of it."""
        one = self.registration
        yield "Dimples found", "%d, of them %d planned" % (len(self.found.places), len(one.pairs))
        yield "missing in the measured area", "%d" % len(one.missing)
        yield "marks that nobody planned", "%d" % len(one.extra)
        yield "off their places, rms", "%.1f µm" % (1e3 * one.rms)
        yield "array", self.array["state"]
        yield "quality, 0 to 1", "%.3f" % self.quality
        if one.doubt >= AMBIGUOUS:
            yield "which dimple is which", "unknown: the measured area looks the same from another place"
        for finding in self.findings:
            yield finding.name, finding.text()

    def text(self):
        """The table as text."""
        return "\n".join("%-32s %s" % row for row in self.rows())


def measured_texture(texture, surface, angle=None, form="quadric"):
    """MeasuredTexture of a texture operation or its plan and a HeightMap, seen along the projection
    direction. `angle` [rad]: about how the measurement is turned to the texture plane, if known; `form`:
    what is taken away first (filters.without_form). Raises InputError naming Dimples, Spacing,
    Heights or Form."""
    plan = texture if hasattr(texture, "pacing") else planned(texture)
    spacing = plan.input.spacing
    level, tilts = _level(surface)
    found = find_dimples(without_form(level, form), spacing)
    cut = np.flatnonzero(plan.dimples.states == core.DimpleState.CUT)
    pitch = core.row_pitch(plan.input.patch_shape)
    fold = SQUARE if pitch == 1.0 else HEXAGONAL
    places = plan.places()[cut]
    one = register(found.places, places, spacing, angle, fold)
    placed = one.placed(found.places)
    array = core.classify_alignment(placed, (1.0, 0.0), spacing, spacing * pitch)
    findings = [*tilts, travel_shift(_travel(plan, cut), places, one)]
    return MeasuredTexture(found, one, array, findings, spacing)


def _level(surface):
    """The surface less its plane, and the plane's tilts as findings. Their uncertainty takes the texture
    itself for noise that is independent from point to point of a grid eight times as coarse: a bound."""
    level = without_form(surface, "plane")
    taken = surface.heights - level.heights
    noise, found = float(np.nanstd(level.heights)), []
    count = max(4.0, surface.known.sum() / 64.0)
    for name, axis in (("tilt along x", 1), ("tilt along y", 0)):
        slope = np.nanmedian(np.diff(taken, axis=axis)) / surface.step[1 - axis]
        length = surface.shape[axis] * surface.step[1 - axis]
        spread = noise * math.sqrt(12.0 / count) / length
        found.append(Finding(name, math.degrees(slope), COVERAGE * math.degrees(spread), "degrees"))
    return level, found


def _travel(plan, cut):
    """Direction of the move that ends on each milled dimple, in the texture plane: (n, 2) in the order of
    `cut`; NaN where none does."""
    path = plan.path
    ends = np.flatnonzero(path.dimples != core.NO_DIMPLE)
    step = path.tips[ends] - np.vstack([path.start, path.tips])[ends]
    flat = np.column_stack([step @ plan.plane.x_axis, step @ plan.plane.y_axis])
    travel = np.full((len(plan.dimples), 2), np.nan)
    with np.errstate(invalid="ignore"):
        travel[path.dimples[ends]] = flat / np.linalg.norm(flat, axis=1, keepdims=True)
    return travel[cut]


def travel_shift(directions, planned_places, one):
    """How far the dimples lie beyond their places along the tool's own travel: a start phase that is off, or
    a lag of the axes such as backlash, which a measurement alone cannot tell apart. Shift and turn of the
    registration are unknowns beside it: rows that all go one way cannot tell it from a shift.

    `directions` (n, 2) of the travel to the planned dimples and their places (n, 2), as `one` has them."""
    name, index = "off along the travel", one.pairs[:, 1]
    along, place = directions[index], planned_places[index]
    good = np.isfinite(along).all(axis=1)
    if good.sum() < 6:
        return Finding(name, None, None, "µm", "fewer than six dimples with a known travel.")
    u, p, moved = along[good], place[good] - place[good].mean(axis=0), one.moved[good]
    terms = np.zeros((2 * len(u), 4))
    terms[0::2, 0], terms[1::2, 0] = u[:, 0], u[:, 1]
    terms[0::2, 1], terms[1::2, 2] = 1.0, 1.0
    terms[0::2, 3], terms[1::2, 3] = -p[:, 1], p[:, 0]
    values, _, rank, sizes = np.linalg.lstsq(terms, moved.ravel(), rcond=None)
    if rank < 4 or sizes[-1] < 1e-3 * sizes[0]:
        return Finding(name, None, None, "µm", "all rows go one way.")
    rest = moved.ravel() - terms @ values
    variance = (rest**2).sum() / (2 * len(u) - 4)
    spread = math.sqrt(variance * np.linalg.inv(terms.T @ terms)[0, 0])
    return Finding(name, 1e3 * float(values[0]), 1e3 * COVERAGE * spread, "µm")
