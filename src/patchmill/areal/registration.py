"""A measurement laid on the plan: the turn and the shift that bring found dimples onto planned ones.

Coarse: the lattice's directions give the turn, up to the lattice's symmetry; of all shifts by which a few
found dimples fall on planned ones, the one counts by which most do, and which leaves fewest planned ones
inside the measured area without a mark. Fine: least squares over all pairs, taken again with the pairs that
it gives, until they stay. Kabsch 1976 in two dimensions.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

import numpy as np
from _patchmill import InputError

NEAR = 0.25  # of the spacing: a found dimple this near to a planned one is its mark
SAMPLE = 60  # found dimples by which a shift is judged at first
BEST = 12  # shifts that are then judged by all
LEAST = 6  # dimples that a registration needs
FITTING = 0.5  # of the found dimples must be planned ones: a fifth of random places are so by chance
ROUNDS = 30


@dataclass
class Registration:
    """From the measured frame to the plan's: place = turned(place) + shift. Lengths in mm, angles in radians.

    `pairs` (m, 2): indices of found and planned dimples; `moved` (m, 2): found less planned, in the plan's
    frame; `missing`: indices of planned dimples inside the measured area without a mark; `extra`: of found
    ones that nobody planned; `doubt`: how good the next best different registration is beside this one, 1
    for as good: the lattice then looks the same from there, and which dimple is which is unknown."""

    angle: float
    shift: np.ndarray
    pairs: np.ndarray
    moved: np.ndarray
    missing: np.ndarray
    extra: np.ndarray
    doubt: float

    def placed(self, places):
        """Places (n, 2) of the measured frame in the plan's."""
        return _turned(places, self.angle) + self.shift

    @property
    def rms(self):
        """Root mean square of `moved` [mm]."""
        return float(np.sqrt((self.moved**2).sum(axis=1).mean()))


def register(found, planned, spacing, angle=None, fold=4):
    """Registration of found places (n, 2) [mm] on planned ones (m, 2) [mm]. `angle` [rad]: of the turn, known
    within the half of 2 pi/`fold`; None: any. `fold`: how often the lattice comes onto itself in a turn, 4
    for squares, 6 for hexagons. Raises InputError naming Dimples if too few are there or fit."""
    found, planned = (np.asarray(a, float).reshape(-1, 2) for a in (found, planned))
    if min(len(found), len(planned)) < LEAST:
        said = "%d found, %d planned" % (len(found), len(planned))
        raise InputError("Dimples", said, "measure at least %d dimples of the texture." % LEAST)
    index = _Cells(planned, NEAR * spacing)
    turns = _turns(found, planned, spacing, angle, fold)
    tried = [one for each in turns for one in _shifts(found, planned, each, index)]
    tried = sorted(tried, key=lambda one: -one[0])[:BEST]
    fine = [_refined(found, planned, each, shift, index) for _, each, shift in tried]
    fine.sort(key=_worth, reverse=True)
    if not fine or len(fine[0].pairs) < max(LEAST, FITTING * len(found)):
        remedy = "give the spacing of this texture, and a measurement of it without its form."
        said = "%d of %d fit the plan" % (len(fine[0].pairs) if fine else 0, len(found))
        raise InputError("Dimples", said, remedy)
    best = fine[0]
    others = [_worth(o) for o in fine[1:] if not _same(o, best, found, spacing)]
    best.doubt = max(0.0, max(others, default=0.0) / _worth(best))
    return best


def _worth(one):
    return len(one.pairs) - 0.5 * (len(one.missing) + len(one.extra))


def _same(one, other, found, spacing):
    """Whether two registrations say the same of the dimples' numbers."""
    return bool(np.hypot(*(one.placed(found) - other.placed(found)).T).max() < 0.5 * spacing)


def _turned(places, angle):
    c, s = math.cos(angle), math.sin(angle)
    return places @ np.array([[c, s], [-s, c]])


class _Cells:
    """Nearest planned dimple within a reach, by square cells."""

    def __init__(self, points, reach):
        self.cells: dict = {}
        self.points, self.reach = points, reach
        for number, cell in enumerate(np.floor(points / reach).astype(int).tolist()):
            self.cells.setdefault(tuple(cell), []).append(number)

    def nearest(self, places):
        """Index of the nearest point within reach of each place, -1: none."""
        best = np.full(len(places), -1)
        for at, (place, cell) in enumerate(zip(places, np.floor(places / self.reach).astype(int).tolist())):
            near = self.reach
            for i in (-1, 0, 1):
                for j in (-1, 0, 1):
                    for number in self.cells.get((cell[0] + i, cell[1] + j), ()):
                        away = math.hypot(*(self.points[number] - place))
                        if away <= near:
                            near, best[at] = away, number
        return best


def _lattice_angle(places, spacing, fold):
    """Direction of the lattice modulo a turn / fold [rad]: the mean of those to neighbours, times fold."""
    sample = places[np.linspace(0, len(places) - 1, min(len(places), 400)).astype(int)]
    total = 0j
    for place in sample:
        step = places - place
        length = np.hypot(*step.T)
        step = step[(length > 0.5 * spacing) & (length < 1.25 * spacing)]
        total += np.exp(1j * fold * np.arctan2(step[:, 1], step[:, 0])).sum()
    return float(np.angle(total)) / fold


def _shifts(found, planned, angle, index):
    """(score, angle, shift) of shifts that bring the found dimple in the middle onto each planned one."""
    turned = _turned(found, angle)
    middle = turned[np.argmin(np.hypot(*(turned - turned.mean(axis=0)).T))]
    chance = np.random.default_rng(0)
    sample = turned[chance.permutation(len(turned))[:SAMPLE]]
    cells = set(index.cells)
    scores = np.zeros(len(planned))
    base = np.floor((sample[None, :, :] - middle + planned[:, None, :]) / index.reach).astype(int)
    for i in (-1, 0, 1):
        for j in (-1, 0, 1):
            flat = (base + (i, j)).reshape(-1, 2)
            scores += np.array([tuple(c) in cells for c in flat.tolist()]).reshape(base.shape[:2]).sum(axis=1)
    best = np.argsort(-scores, kind="stable")[:BEST]
    return [(float(scores[k]), angle, planned[k] - middle) for k in best]


def starts(found, planned, spacing, angle=None, fold=4):
    """(angle, shift) [rad, mm] that lay the middle of what the found places cover on that of the planned
    ones, for each turn by which the lattice comes onto itself; arguments as for register(). For textures
    measured whole."""
    found, planned = (np.asarray(a, float).reshape(-1, 2) for a in (found, planned))
    low, high = planned.min(axis=0), planned.max(axis=0)
    made = []
    for each in _turns(found, planned, spacing, angle, fold):
        there = _turned(found, each)
        made.append((float(each), 0.5 * (low + high) - 0.5 * (there.min(axis=0) + there.max(axis=0))))
    return made


def laid(found, planned, spacing, angle, shift):
    """The Registration of a turn and a shift as they are."""
    found, planned = (np.asarray(a, float).reshape(-1, 2) for a in (found, planned))
    return _paired(found, planned, angle, shift, _Cells(planned, NEAR * spacing))


def _turns(found, planned, spacing, angle, fold):
    """Turns that bring the found lattice onto the planned one; of those the one next to `angle` if it is
    given."""
    turn = _lattice_angle(planned, spacing, fold) - _lattice_angle(found, spacing, fold)
    turns = turn + 2 * math.pi / fold * np.arange(fold)
    if angle is None:
        return turns
    away = abs((turns - angle + math.pi) % (2 * math.pi) - math.pi)
    return turns[[np.argmin(away)]]


def _refined(found, planned, angle, shift, index):
    """The Registration near a turn and a shift."""
    before = None
    for _ in range(ROUNDS):
        near = index.nearest(_turned(found, angle) + shift)
        here = np.flatnonzero(near >= 0)
        if len(here) < 3 or (before is not None and np.array_equal(near, before)):
            break
        before = near
        a, b = found[here], planned[near[here]]
        p, q = a - a.mean(axis=0), b - b.mean(axis=0)
        angle = math.atan2((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum(), (p * q).sum())
        shift = b.mean(axis=0) - _turned(a.mean(axis=0)[None], angle)[0]
    return _paired(found, planned, angle, shift, index)


def _paired(found, planned, angle, shift, index):
    """The Registration of a turn and a shift: each found dimple with the nearest planned one."""
    placed = _turned(found, angle) + shift
    near = index.nearest(placed)
    here = np.flatnonzero(near >= 0)
    inside = _inside(planned, placed, 4.0 * index.reach)
    missing = np.setdiff1d(np.flatnonzero(inside), near[here])
    pairs = np.column_stack([here, near[here]])
    moved = placed[here] - planned[near[here]]
    return Registration(angle, shift, pairs, moved, missing, np.flatnonzero(near < 0), 0.0)


def _inside(planned, placed, spacing):
    """Which planned dimples lie well inside the measured area: with a found one in each quarter around, two
    spacings away at most."""
    cells: dict = {}
    for number, cell in enumerate(np.floor(placed / (2 * spacing)).astype(int).tolist()):
        cells.setdefault(tuple(cell), []).append(number)
    inside = np.zeros(len(planned), bool)
    for at, (place, cell) in enumerate(zip(planned, np.floor(planned / (2 * spacing)).astype(int).tolist())):
        near = [n for i in (-1, 0, 1) for j in (-1, 0, 1) for n in cells.get((cell[0] + i, cell[1] + j), ())]
        if near:
            step = placed[near] - place
            step = step[np.hypot(*step.T) < 2 * spacing]
            quarters = set(zip((step[:, 0] > 0).tolist(), (step[:, 1] > 0).tolist()))
            inside[at] = len(quarters) == 4
    return inside
