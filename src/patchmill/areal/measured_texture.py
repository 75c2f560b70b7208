"""A measured texture beside its plan, and what it says of the machine: docs/measured-machine.md.

    measured = measured_texture(op, patchmill.measured("scan.x3p"))
    print(measured.text())

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.areal.dimples import FoundDimples, find_dimples
from patchmill.areal.filters import form_at, without_form
from patchmill.areal.machine_deviations import Reference, deviations, slopes
from patchmill.areal.planned_marks import planned_marks
from patchmill.areal.registration import Registration, laid, register, starts
from patchmill.operations.computed import planned

COVERAGE = 2.0  # standard deviations of the uncertainties that are given
FITTING = 0.5  # of the found marks in rows: their fit then counts
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
    deviations: object = None  # machine_deviations.Deviations where the marks tell them

    def finding(self, name):
        """The Finding of a name. Raises KeyError if there is none."""
        return {one.name: one for one in self.findings}[name]

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


def measured_texture(texture, surface, angle=None, form="quadric", reference=None):
    """MeasuredTexture of a texture operation or its plan and a HeightMap, seen along the projection
    direction. `angle` [rad]: about how the measurement is turned to the texture plane, if known; `form`:
    what is taken away first (filters.without_form). `reference`: of marks_of(), for many measurements of one
    texture. Raises InputError naming Dimples, Spacing, Heights or Form."""
    plan = texture if hasattr(texture, "pacing") else planned(texture)
    spacing = plan.input.spacing
    level, tilts = _level(surface, spacing)
    left = without_form(level, form)
    found = find_dimples(left, spacing)
    cut = np.flatnonzero(plan.dimples.states == core.DimpleState.CUT)
    pitch = core.row_pitch(plan.input.patch_shape)
    fold = SQUARE if pitch == 1.0 else HEXAGONAL
    places = plan.places()[cut]
    one, fault = None, None
    try:
        one = register(found.places, places, spacing, angle, fold)
    except InputError as error:  # marks that all came late may still lie on their rows
        fault = error
    begin = starts(found.places, places, spacing, angle, fold) if len(found.places) else []
    if one is not None:
        begin.append((one.angle, one.shift))
    if reference is None and _compared(plan):
        reference = marks_of(plan, max(surface.step), form)
    told, why = _told(plan, found, begin, reference)
    if one is None or (told is not None and one.doubt < AMBIGUOUS and told[2].share > FITTING):
        if told is None:
            raise fault
        doubt = 0.0 if one is None else one.doubt
        one = laid(found.places, places, spacing, told[2].angle, told[2].shift)
        one.doubt = doubt
    if angle is None and one.doubt >= AMBIGUOUS:
        told, why = None, "the measured area looks the same from another place: say how it is turned."
    if told is not None:
        levels = found.heights + form_at(surface, left, found.places)
        tilts = _tilts(*slopes(levels, found.places, reference, told[2]))
    placed = one.placed(found.places)
    array = core.classify_alignment(placed, (1.0, 0.0), spacing, spacing * pitch)
    findings = [*tilts, travel_shift(_travel(plan, cut), places, one), *_machine(plan, told, why)]
    return MeasuredTexture(found, one, array, findings, spacing, told and told[0])


def marks_of(texture, step, form="quadric"):
    """What measured_texture() compares marks with: those of a plan's own relief on a grid of `step` [mm],
    less its form. Raises InputError naming Spacing or Form."""
    plan = texture if hasattr(texture, "pacing") else planned(texture)
    return Reference(plan, planned_marks(plan), step, form)


def _compared(plan):
    """Whether the plan's marks can follow each other along rows: else its own relief is not asked for."""
    if plan.posture is not None or plan.free is not None:
        return False
    return bool(planned_marks(plan).straight.any())


def _told(plan, found, begin, reference):
    """What deviations() says, or None and why there is nothing."""
    if not _compared(plan):
        return None, "only paths of an upright tool, on a lattice, in rows of marks, are compared."
    if not begin:
        return None, "no dimple is found."
    told = deviations(found, reference, begin)
    return told, "" if told else "the marks are on no rows of the plan, or the tool lifts between dimples."


def _machine(plan, told, why):
    """Findings of the machine, from what deviations() says or why it says nothing."""
    flutes = plan.input.tool.flutes
    radius = plan.input.tool.radius
    of_flutes = ["runout of flute %d over flute 1" % (i + 1) for i in range(1, flutes)]
    names = ["flutes late", "spindle error", "play of X", "play of Y", *of_flutes, "radius of the tool"]
    if told is None:
        return [Finding(name, None, None, "", why) for name in names]
    values, spreads = told[0].values(), told[1].values()
    units = ["degrees", "%", "µm", "µm"] + ["µm"] * (flutes - 1)
    scales = np.array([math.degrees(1.0), 100.0] + [1e3] * (flutes + 1))
    pick = np.concatenate([np.arange(4), 5 + np.arange(flutes - 1)])
    made = []
    for name, unit, value, spread in zip(names, units, scales * values[pick], scales * spreads[pick]):
        if math.isfinite(value) and math.isfinite(spread):
            made.append(Finding(name, float(value), COVERAGE * float(spread), unit))
        else:
            made.append(Finding(name, None, None, unit, "the measured marks cannot tell it from others."))
    curved = 1.0 / radius + values[-1]
    made.append(Finding(names[-1], 1.0 / curved, COVERAGE * float(spreads[-1]) / curved**2, "mm"))
    return made


def _level(surface, spacing):
    """The surface less its plane, and the plane's tilts as findings. Their uncertainty takes each dimple for
    one point of noise that is as large as the texture: what lies beyond its borders tilts the plane as
    well."""
    level = without_form(surface, "plane")
    taken = surface.heights - level.heights
    noise, slopes, spreads = float(np.nanstd(level.heights)), [], []
    count = max(4.0, 0.25 * surface.known.sum() * surface.step[0] * surface.step[1] / spacing**2)
    for axis in (1, 0):
        slopes.append(np.nanmedian(np.diff(taken, axis=axis)) / surface.step[1 - axis])
        spreads.append(noise * math.sqrt(12.0 / count) / (surface.shape[axis] * surface.step[1 - axis]))
    return level, _tilts(slopes, spreads)


def _tilts(slopes, spreads):
    """Findings of slopes along x and y and their standard deviations."""
    angles = np.degrees(np.arctan(slopes)), COVERAGE * np.degrees(spreads)
    return [
        Finding("tilt along %s" % name, float(angle), float(spread), "degrees")
        for name, angle, spread in zip("xy", *angles)
    ]


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
