"""What a plan says of the marks that its path leaves: where each is, which way the tool comes, how far it
moves from one passing flute to the next, which flute cuts it, and how far a play of the axes would move it.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass
from typing import Any

import _patchmill as core
import numpy as np

STRAIGHT = 0.95  # cosine of the bend up to which a row goes on
LEAST_PITCH = 0.6  # of the spacing: with flutes that pass nearer the tool is lifted between dimples


@dataclass
class PlannedMarks:
    """One entry for each milled dimple, in milling order. Lengths in mm.

    `numbers` (n,): of the plan's dimples; `places` (n, 2) in the texture plane; `travel` (n, 2): unit
    direction there; `pitch` (n,): way from one passing flute to the next; `turns` (n,): of the spindle since
    the run began; `flutes` (n,): which one cuts it, the one of the first dimple being 0; `rows` (n,): number
    of its row; `straight` (n,): whether one mark follows the other there, so that one that is late or early
    lies in the row; `ends` (n,): the move that ends on it."""

    numbers: np.ndarray
    places: np.ndarray
    travel: np.ndarray
    pitch: np.ndarray
    turns: np.ndarray
    flutes: np.ndarray
    rows: np.ndarray
    straight: np.ndarray
    plan: Any
    ends: np.ndarray

    def moved_by_play(self, axis, play):
        """Displacement (n, 2) of each mark [mm] where a machine's axis, 0 for X or 1 for Y, has a play [mm]:
        it stays behind by half of it, whichever way it came. An upright tool."""
        path = self.plan.path
        at, lag = float(path.start[axis]), np.zeros(len(path))
        for number, wanted in enumerate(path.tips[:, axis].tolist()):
            at = min(max(at, wanted - 0.5 * play), wanted + 0.5 * play)
            lag[number] = at - wanted
        normals = self.plan.dimples.normals[self.numbers]
        step = np.zeros((len(self.numbers), 3))
        step[:, axis] = lag[self.ends]
        step -= (step * normals).sum(axis=1)[:, None] * normals
        plane = self.plan.plane
        return np.column_stack([step @ np.asarray(plane.x_axis), step @ np.asarray(plane.y_axis)])


def planned_marks(plan):
    """PlannedMarks of a PlannedTexture, in milling order."""
    path, places = plan.path, plan.places()
    ends = np.flatnonzero(path.dimples != core.NO_DIMPLE)
    ends = ends[plan.dimples.states[path.dimples[ends]] == core.DimpleState.CUT]
    numbers = path.dimples[ends]
    turns, runs = _turns(path)
    travel = _travel(path, plan.plane)[ends]
    rows = _rows(travel, runs[ends])
    pitch = _pitch(places[numbers], turns[ends], rows) / plan.input.tool.flutes
    straight = np.isfinite(travel).all(axis=1) & (pitch >= LEAST_PITCH * plan.input.spacing)
    flutes = _flutes(plan, numbers, turns[ends])
    return PlannedMarks(
        numbers, places[numbers], travel, pitch, turns[ends], flutes, rows, straight, plan, ends
    )


def _travel(path, plane):
    """Direction in the texture plane of each move, (n, 2); NaN of one that does not move in it."""
    steps = path.tips - np.vstack([path.start, path.tips[:-1]])
    flat = np.column_stack([steps @ np.asarray(plane.x_axis), steps @ np.asarray(plane.y_axis)])
    length = np.linalg.norm(flat, axis=1, keepdims=True)
    return np.where(length > 1e-9, flat / np.maximum(length, 1e-9), np.nan)


def _pitch(places, turns, rows):
    """Way of the marks in a turn [mm] at each dimple, from its neighbours in the row; NaN of a row of one."""
    pitch = np.full((2, len(rows)), np.nan)
    same = rows[1:] == rows[:-1]
    way = np.hypot(*np.diff(places, axis=0).T)
    with np.errstate(invalid="ignore", divide="ignore"):
        each = np.where(same, way / np.diff(turns), np.nan)
    pitch[0, 1:], pitch[1, :-1] = each, each
    known = np.isfinite(pitch)
    total = np.where(known, pitch, 0.0).sum(axis=0)
    return np.where(known.any(axis=0), total / np.maximum(known.sum(axis=0), 1), np.nan)


def _turns(path):
    """Spindle turns at each move's end since the last move of unknown turns, and the number of such moves."""
    known = np.isfinite(path.turns)
    total = np.cumsum(np.where(known, path.turns, 0.0))
    before = np.where(~known, np.arange(len(path)), -1)
    last = np.maximum.accumulate(before)
    return total - np.where(last >= 0, total[np.maximum(last, 0)], 0.0), np.cumsum(~known)


def _flutes(plan, numbers, turns):
    """Which flute is over the contact point of each dimple if the machine does as it is told; that of the
    first one is 0."""
    count, sign = plan.input.tool.flutes, plan.input.spindle.sign
    normals = plan.dimples.normals[numbers]
    azimuth = np.arctan2(-normals[:, 1], -normals[:, 0]) / (2.0 * math.pi)
    passed = count * (azimuth - sign * turns)
    return np.round(passed - passed[0]).astype(int) % count


def _rows(travel, runs):
    """Number of the row of each dimple: rows end where the way bends or a run does."""
    with np.errstate(invalid="ignore"):
        on = ((travel[1:] * travel[:-1]).sum(axis=1) >= STRAIGHT) & (np.diff(runs) == 0)
    return np.concatenate([[0], np.cumsum(~on)])
