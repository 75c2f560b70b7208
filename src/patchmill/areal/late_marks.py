"""How late the flutes were, by where the marks lie: start phase, spindle error and play of the axes.

A flute that comes late by an angle d leaves its mark further along the travel by pitch N d / 2 pi, modulo
the pitch, for the next flute then fills the gap. So with a = a mark's distance along the travel from the
nearest planned place,

    a / pitch = N (d + 2 pi e T) / 2 pi   modulo 1,     T turns since the run began, e the spindle's error,

is searched for as the peak of |sum exp(2 pi i (a / pitch - N e T))| over turns, shifts and e, and refined by
least squares over turn, shift, d, e and the play of X and Y. Variances are those of rows, not of single
marks: what a controller does wrong goes on along a row.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

import numpy as np

ACROSS = 0.25  # of the spacing: a mark so near to a row is one of it
LARGEST_ERROR = 0.01  # of the spindle's speed that is looked for
SAMPLE = 500  # marks by which turn and shift are searched
GRID = np.arange(-4, 5) * 0.125  # of the spacing: shifts that are tried
ROUNDS = 8
FAR = 4.0  # robust standard deviations beyond which a mark counts nothing
PLAYS = (0.001, 0.03)  # mm: between which a play is taken for straight
LEAST_ROWS = 6


@dataclass
class LateMarks:
    """The fit. `angle` [rad] and `shift` (2,) [mm] take found places to the plan's; `late` [rad] of the
    flutes in the middle of the program; `error` of the spindle's speed, `play` (2,) [mm] of X and Y;
    `spread`: their standard deviations, {name: value}, nan where the marks cannot tell; `pairs` (m, 2):
    found and planned marks in rows; `passed` (m,): how many flutes later than planned; `share` of the found
    marks that are in rows."""

    angle: float
    shift: np.ndarray
    late: float
    error: float
    play: np.ndarray
    spread: dict
    pairs: np.ndarray
    passed: np.ndarray
    share: float


def late_marks(found, marks, places, spacing, starts):
    """LateMarks of found places (n, 2) [mm] beside PlannedMarks, or None where they are on no rows. `places`
    (m, 2): where the finder of dimples sees the planned ones; `starts`: (angle, shift) of registrations to
    begin with. Nothing is raised."""
    use = np.flatnonzero(marks.straight)
    if len(use) < 6 or len(np.unique(marks.rows[use])) < 2:
        return None
    task = _Task(marks, use, places, spacing)
    best = _searched(found, task, starts)
    if best is None or best[0] < 0.3:
        return None
    return _refined(found, task, *best[1:])


class _Task:
    """The planned marks in rows, and who is nearest to a place."""

    def __init__(self, marks, use, places, spacing):
        self.marks, self.use, self.spacing = marks, use, spacing
        self.places, self.travel = places[use], marks.travel[use]
        self.across = np.column_stack([-self.travel[:, 1], self.travel[:, 0]])
        self.pitch, self.flutes = marks.pitch[use], marks.plan.input.tool.flutes
        self.middle = float(np.median(marks.turns[use]))
        self.turns = marks.turns[use] - self.middle

    def beside(self, placed):
        """Nearest planned mark of each place, how far the place lies along the travel there and across it."""
        near = np.empty(len(placed), int)
        for first in range(0, len(placed), 512):
            part = placed[first : first + 512]
            square = (self.places**2).sum(axis=1) - 2.0 * part @ self.places.T
            near[first : first + 512] = square.argmin(axis=1)
        away = placed - self.places[near]
        return near, (away * self.travel[near]).sum(axis=1), (away * self.across[near]).sum(axis=1)

    def errors(self):
        """Errors of the spindle that are tried."""
        reach = max(np.ptp(self.turns), 1.0)
        count = min(math.ceil(LARGEST_ERROR * 4.0 * self.flutes * reach), 4000)
        return np.arange(-count, count + 1) / (4.0 * self.flutes * reach)


def turned(places, angle):
    """Places (n, 2) turned by an angle [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    return places @ np.array([[c, s], [-s, c]])


def _searched(found, task, starts):
    """(score, angle, shift, cycles late, error) at which most marks are where a flute passes; None: no
    start."""
    chance, errors, best = np.random.default_rng(0), task.errors(), None
    sample = found[chance.permutation(len(found))[:SAMPLE]]
    moves = [task.spacing * np.array([i, j]) for i in GRID for j in GRID]
    for angle, shift in starts:
        there = turned(sample, angle) + shift
        for move in moves:
            near, along, across = task.beside(there + move)
            inside = (abs(across) < ACROSS * task.spacing) & (abs(along) < 0.75 * task.pitch[near])
            if inside.sum() < 6:
                continue
            cycles = np.exp(2j * math.pi * along[inside] / task.pitch[near[inside]])
            wave = np.exp(-2j * math.pi * task.flutes * np.outer(errors, task.turns[near[inside]]))
            sums = wave @ cycles
            k = int(abs(sums).argmax())
            score = abs(sums[k]) / len(sample)
            if best is None or score > best[0]:
                best = score, angle, shift + move, np.angle(sums[k]) / (2 * math.pi), errors[k]
    return best


def _refined(found, task, angle, shift, cycles, error):
    """The LateMarks near what was searched."""
    play = np.zeros(2)
    weights = np.ones(2)
    for _ in range(ROUNDS):
        trial = np.clip(play, *PLAYS)
        per_play = [task.marks.moved_by_play(k, trial[k])[task.use] / trial[k] for k in (0, 1)]
        placed = turned(found, angle) + shift
        near, along, across = task.beside(placed)
        pitch = task.pitch[near]
        planned = cycles + task.flutes * error * task.turns[near]
        passed = np.round(along / pitch - planned)
        rest = np.column_stack([along - pitch * (planned + passed), across])
        for k in (0, 1):
            by_play = per_play[k][near] * play[k]
            rest[:, 0] -= (by_play * task.travel[near]).sum(axis=1)
            rest[:, 1] -= (by_play * task.across[near]).sum(axis=1)
        inside = (abs(across) < ACROSS * task.spacing) & (abs(along) < 0.75 * pitch)
        inside &= (abs(rest) < FAR * np.maximum(_robust(rest[inside]), 1e-6)).all(axis=1)
        if inside.sum() < 8:
            return None
        j = np.flatnonzero(inside)
        terms = _terms(task, placed[j], near[j], per_play)
        solved, weights = _solved(terms, rest[j], weights)
        rows = task.marks.rows[task.use][near[j]]
        values, spreads = _with_spreads(terms, rest[j], weights, rows, solved)
        angle, shift = angle + values[0], _shifted(shift, values[0], values[1:3], placed[j].mean(axis=0))
        cycles, error = cycles + values[3], error + values[4]
        play = play + values[5:7]
    late = 2.0 * math.pi * cycles / task.flutes
    period = 2.0 * math.pi / task.flutes
    whole = np.round(late / period)
    names = dict(zip(("angle", "x", "y", "late", "error", "play_x", "play_y"), spreads))
    names["late"] *= 2.0 * math.pi / task.flutes
    pairs = np.column_stack([j, task.use[near[j]]])
    late_by = (passed[j] + whole).astype(int)
    share = len(j) / len(found)
    return LateMarks(angle, shift, late - whole * period, error, play, names, pairs, late_by, share)


def _shifted(shift, turn, more, centre):
    """The shift after a further turn about the pairs' centre."""
    return turned((shift - centre)[None], turn)[0] + centre + more


def _robust(rest):
    """Standard deviations of the columns by their median deviation: outliers count little."""
    return 1.4826 * np.median(abs(rest - np.median(rest, axis=0)), axis=0)


def _terms(task, placed, near, per_play):
    """Change of the marks' distance along and across with turn, shift, cycles, error and plays: (n, 2, 7). A
    turn and a shift of the places lower what is left to explain."""
    travel, across = task.travel[near], task.across[near]
    centre = placed - placed.mean(axis=0)
    sideways = np.column_stack([-centre[:, 1], centre[:, 0]])
    terms = np.zeros((len(near), 2, 7))
    for row, direction in enumerate((travel, across)):
        terms[:, row, 0] = -(sideways * direction).sum(axis=1)
        terms[:, row, 1:3] = -direction
        for k in (0, 1):
            terms[:, row, 5 + k] = (per_play[k][near] * direction).sum(axis=1)
    terms[:, 0, 3] = task.pitch[near]
    terms[:, 0, 4] = task.pitch[near] * task.flutes * task.turns[near]
    return terms


def _solved(terms, rest, weights):
    """Least squares, and the weights of along and across by what is left of each."""
    for _ in range(3):
        flat = (terms * weights[None, :, None]).reshape(-1, 7)
        scale = np.maximum(np.linalg.norm(flat, axis=0), 1e-300)
        values = np.linalg.lstsq(flat / scale, (rest * weights).ravel(), rcond=1e-8)[0] / scale
        left = rest - terms @ values
        weights = 1.0 / np.maximum(np.sqrt((left**2).mean(axis=0)), 1e-7)
    return values, weights


def _with_spreads(terms, rest, weights, rows, values):
    """The values, and their standard deviations from the sums of each row (Liang & Zeger 1986); nan of those
    that the marks cannot tell from others."""
    flat = terms * weights[None, :, None]
    left = (rest - terms @ values) * weights
    scale = np.maximum(np.linalg.norm(flat.reshape(-1, 7), axis=0), 1e-300)
    flat = flat / scale
    normal = np.einsum("nij,nik->jk", flat, flat)
    inverse = np.linalg.pinv(normal, rcond=1e-8, hermitian=True)
    sums = np.array([np.einsum("nij,ni->j", flat[rows == row], left[rows == row]) for row in np.unique(rows)])
    count = len(sums)
    spread = np.sqrt(np.diag(inverse @ (sums.T @ sums) @ inverse) * count / max(count - 1, 1)) / scale
    sizes, vectors = np.linalg.eigh(normal)
    unknown = (vectors[:, sizes < 1e-4 * sizes[-1]] ** 2).sum(axis=1) > 1e-3
    if count < LEAST_ROWS:
        unknown[:] = True
    return values, np.where(unknown, np.nan, spread)
