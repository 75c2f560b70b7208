"""What a measured texture says of the machine: docs/measured-machine.md.

The marks beside those of the plan's own relief, found in the same way: start phase, spindle error and play
by where they lie (late_marks), runout by how deep each flute's are, the tool's radius by how curved. The
plan is then cut again with what was found, measured in the same way, and what that shows amiss is taken off.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

import numpy as np

import patchmill  # its simulate, which stands over this module
from patchmill.areal.dimples import find_dimples
from patchmill.areal.filters import form_at, without_form
from patchmill.areal.late_marks import late_marks

NEAR = 0.25  # of the spacing: a mark of the plan's relief so near to its dimple is its own
TRUSTED = 0.3  # of what is taken off, a standard deviation of the rest
# standard deviations of what is left out: a controller's own path, the paraboloid (docs/measured-machine.md)
LATE, SPEED, PLAY, DEEP, CURVED = 4e-4, 2e-6, 7e-4, 3e-5, 0.003  # mm, share, mm, mm, 1/mm
LEANING = 2e-4  # of a slope
FAR = 4.0  # robust standard deviations beyond which a mark counts nothing


@dataclass
class Deviations:
    """What a machine does otherwise than a plan. `late` [rad]: of the flutes in the middle of the program;
    `error` of the spindle's speed over what the plan takes it for; `play` (2,) of X and Y [mm]; `runout`
    (flutes,) [mm] over the flute that cuts the first dimple; `curvature` [1/mm] of the marks over the
    plan's."""

    late: float
    error: float
    play: np.ndarray
    runout: np.ndarray
    curvature: float

    def values(self):
        """All of them in one array."""
        return np.concatenate([[self.late, self.error], self.play, self.runout, [self.curvature]])


def samples_with(plan, marks, late, error, play):
    """Rows (time, x, y, z, azimuth of flute 0) of a PlannedTexture's path as a machine with these deviations
    moves it, for patchmill.simulate. Between rapids the phase is right at the first dimple but for `late`."""
    path, spindle = plan.path, plan.input.spindle
    tips = np.vstack([path.start, path.tips])
    for axis in (0, 1):
        at = float(tips[0, axis])
        for number, wanted in enumerate(tips[:, axis].tolist()):
            at = min(max(at, wanted - 0.5 * play[axis]), wanted + 0.5 * play[axis])
            tips[number, axis] = at
    known = np.isfinite(path.turns)
    turned = np.concatenate([[0.0], np.cumsum(np.where(known, path.turns, 0.0))])
    run = np.concatenate([[0], np.cumsum(~known)])
    middle = float(np.median(marks.turns[marks.straight])) if marks.straight.any() else 0.0
    normals = plan.dimples.normals[marks.numbers]
    azimuth = np.arctan2(-normals[:, 1], -normals[:, 0])
    first = {int(run[end + 1]): k for k, end in reversed(list(enumerate(marks.ends)))}
    angle = np.zeros(len(tips))
    before = 0.0  # turns, so that the spindle only goes on
    for number in range(int(run.max()) + 1):
        here = np.flatnonzero(run == number)
        since = turned[here] - turned[here[0]]
        slow = since - error * (since - middle)
        k = first.get(number)
        at_first = 0.0
        if k is not None:
            flute = 2.0 * math.pi * marks.flutes[k] / plan.input.tool.flutes
            at_first = (spindle.sign * (azimuth[k] - flute) - late) / (2.0 * math.pi) - marks.turns[k]
        slow = slow + at_first
        slow += math.ceil(before + 1.0 - slow[0])
        angle[here], before = spindle.sign * 2.0 * math.pi * slow, float(slow[-1])
    return np.column_stack([np.arange(len(tips), dtype=float), tips, angle])


class Reference:
    """The plan's marks as the finder of dimples sees them in the plan's own relief. `step` [mm] and `form`
    as those of the measurement, so that both are found alike. Raises InputError naming Spacing."""

    def __init__(self, plan, marks, step, form):
        self.plan, self.marks, self.step, self.form = plan, marks, step, form
        found, levels = self._found_with(0.0, 0.0, (0.0, 0.0), ())
        away = np.array([np.hypot(*(found.places - place).T) for place in marks.places])
        near = away.argmin(axis=1)
        own = away.min(axis=1) < NEAR * plan.input.spacing
        self.places = np.where(own[:, None], found.places[near], marks.places)
        self.bottoms = np.where(own, found.heights[near], np.nan)
        self.levels = np.where(own, levels[near], np.nan)  # with the form that was taken away
        self.curvatures = np.where(own, curvatures(found)[near], np.nan)

    def found_with(self, late, error, play, runout):
        """FoundDimples of the relief of the plan with deviations."""
        return self._found_with(late, error, play, runout)[0]

    def _found_with(self, late, error, play, runout):
        samples = samples_with(self.plan, self.marks, late, error, play)
        relief = patchmill.simulate(self.plan, samples=samples, step=self.step, runout=tuple(runout))
        surface = relief.height_map()
        left = without_form(surface, self.form)
        found = find_dimples(left, self.plan.input.spacing)
        return found, found.heights + form_at(surface, left, found.places)


def curvatures(found):
    """Mean curvature of FoundDimples [1/mm]."""
    return 0.5 * (1.0 / found.radii).sum(axis=1)


def slopes(levels, places, reference, fit):
    """Slopes (2,) of a measurement along its x and y over the plan's relief, by its marks' `levels` [mm] at
    `places` (n, 2), and their standard deviations. `fit`: LateMarks of the same marks. Nothing is raised."""
    j, k = fit.pairs.T
    over = levels[j] - reference.levels[k]
    good = np.isfinite(over)
    terms = np.column_stack([np.ones(len(j)), places[j]])[good]
    over = over[good]
    for _ in range(3):
        solved = np.linalg.lstsq(terms, over, rcond=None)[0]
        rest = over - terms @ solved
        near = abs(rest) < FAR * max(1.4826 * np.median(abs(rest)), 1e-9)
        terms, over = terms[near], over[near]
    rest = over - terms @ np.linalg.lstsq(terms, over, rcond=None)[0]
    spread = np.sqrt((rest**2).mean() * np.diag(np.linalg.pinv(terms.T @ terms))[1:])
    return solved[1:], np.hypot(spread, LEANING)


def _estimated(found, reference, starts):
    """(Deviations, their standard deviations as another, LateMarks) of FoundDimples, or None."""
    plan, marks = reference.plan, reference.marks
    fit = late_marks(found.places, marks, reference.places, plan.input.spacing, starts)
    if fit is None:
        return None
    count, sign = plan.input.tool.flutes, round(plan.input.spindle.sign)
    j, k = fit.pairs.T
    flute = (marks.flutes[k] - sign * fit.passed) % count
    runout, of_runout = _by_flute(reference.bottoms[k] - found.heights[j], flute, reference.places[k], count)
    more = curvatures(found)[j] - reference.curvatures[k]
    more = more[np.isfinite(more)]
    spread = fit.spread
    values = Deviations(fit.late, fit.error, fit.play, runout, float(np.median(more)))
    of_curvature = 1.2533 * 1.4826 * float(np.median(abs(more - np.median(more)))) / math.sqrt(len(more))
    spreads = Deviations(spread["late"], spread["error"], np.array([spread["play_x"], spread["play_y"]]),
                         of_runout, of_curvature)  # fmt: skip
    return values, spreads, fit


def _by_flute(depth, flute, places, count):
    """How much deeper each flute's marks are than those of flute 0 [mm], beside what is smooth over the
    places, and the standard deviations; nan of a flute with fewer than three marks."""
    known = np.isfinite(depth)
    depth, flute, places = depth[known], flute[known], places[known]
    size = np.maximum(np.ptp(places, axis=0), 1e-9)
    x, y = ((places - places.mean(axis=0)) / size).T
    smooth = [np.ones_like(x), x, y, x * x, x * y, y * y]
    terms = np.column_stack(smooth + [flute == i for i in range(1, count)])
    good = np.ones(len(depth), bool)
    for _ in range(3):
        solved = np.linalg.lstsq(terms[good], depth[good], rcond=None)[0]
        rest = depth - terms @ solved
        good = abs(rest) < FAR * max(1.4826 * np.median(abs(rest)), 1e-9)
    variance = (rest[good] ** 2).sum() / max(good.sum() - terms.shape[1], 1)
    spread = np.sqrt(variance * np.diag(np.linalg.pinv(terms[good].T @ terms[good])))
    enough = np.array([(flute[good] == i).sum() >= 3 for i in range(count)])
    over, of_over = (np.concatenate([[0.0], a[6:]]) for a in (solved, spread))
    unknown = ~(enough & enough[0])
    return np.where(unknown, np.nan, over), np.where(unknown, np.nan, of_over)


def deviations(found, reference, starts):
    """(Deviations, their standard deviations as another, LateMarks) that FoundDimples show beside a
    Reference, or None where they lie on no rows of the plan. `starts`: (angle, shift) to begin with. Nothing
    is raised."""
    plan = reference.plan
    told = _estimated(found, reference, starts)
    if told is None:
        return None
    values, spreads, fit = told
    raw, flutes = values.values(), plan.input.tool.flutes
    given = np.nan_to_num(raw)
    given[2:4] = np.maximum(given[2:4], 0.0)
    given[-1] = 0.0
    again = reference.found_with(given[0], given[1], given[2:4], given[4 : 4 + flutes])
    seen = _estimated(again, reference, [(0.0, np.zeros(2))])
    off = np.zeros(len(raw)) if seen is None else np.nan_to_num(seen[0].values() - given)
    off[0] = math.remainder(off[0], 2.0 * math.pi / flutes)
    ahead = 2.0 * math.pi / flutes / float(np.median(reference.marks.pitch[reference.marks.straight]))
    left_out = Deviations(LATE * ahead, SPEED, np.full(2, PLAY), np.full(flutes, DEEP), CURVED).values()
    left_out[4] = 0.0
    sizes = np.sqrt(spreads.values() ** 2 + (TRUSTED * off) ** 2 + left_out**2)
    return _taken(raw - off, flutes), _taken(sizes, flutes), fit


def _taken(values, flutes):
    """Deviations from one array."""
    runout = values[4 : 4 + flutes]
    return Deviations(float(values[0]), float(values[1]), values[2:4], runout, float(values[-1]))
