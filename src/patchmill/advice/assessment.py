"""How good a texture will be: single patches of it, planned and simulated as the machine's model runs them.

A texture is milled patch by patch, so that one patch simulated alone says what each of its kind is worth. The
patches that are looked at stand for equal parts of the dimples, from the flattest to the steepest place:
quality depends on the tilt between tool axis and face more than on anything else. The flattest dimples have a
patch of their own, for a small flat place spoils a texture that is good elsewhere; if that is bad and no
other, the steepest of them are looked at as well, for near the tip quality falls within a few degrees.
Patches lie away from the borders of the faces, where there are such places: along a border the tip leaves
marks that no neighbour takes away. So besides small textures are simulated as a whole, and of larger ones
squares spread over the whole, as many as one in so many lies along a border.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import replace
from functools import partial

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.advice import cells, orientation
from patchmill.advice.cells import WINDOW
from patchmill.advice.found import GOOD, SMALL, Assessment, PatchQuality
from patchmill.geometry import shapes
from patchmill.system.stops import stoppable
from patchmill.textures import tool_posture
from patchmill.textures.plan import place_texture, plan_texture

MANY_TURNS = 3 * SMALL  # of the spindle, above which the whole is not simulated
SQUARES, FEW_SQUARES = 12, 5  # of the whole, where it is not; fewer where the spindle turns often
BORDERS_COUNT = 20000  # dimples; of more, those along borders are too few to spoil the whole
MANY = 40000  # dimples; of more, a coarser lattice is looked at
ABOUT = 0.95  # of the most neighbours: a place in the middle
NOT_ASKED_FOR = ("off the face", "off the net", "masked", "near an edge")  # states' names
TURNED_AWAY = ("undercut", "too steep")  # of which a projected lattice has few points for much of the faces
STEEP = math.radians(50.0)  # to the direction of projection, above which a relief over the plane is coarse
FLATTEST = 0.05  # of the dimples: the flattest ones, looked at by themselves
STEEPER = (0.5, 0.15)  # of these, the steepest ones, looked at where the flattest are bad and no others
ALIKE = math.radians(0.5)  # tilts that differ by less are looked at once
COARSE = 1.0 / 16.0  # of the spacing: distance of cells by which values are compared
UNCLEAR = 0.87, 0.985  # quality by such cells, between which it is looked at as finely as otherwise


def with_simulation(simulate):
    """assess() as a function of a TextureInput alone; `simulate` is patchmill.simulate, or a cells.Once."""
    return partial(assess, simulate)


@stoppable
def assess(simulate, given, count=5, progress=None, middle_first=False, whole=False, known=None):
    """Assessment of a TextureInput from `count` patches, and one of the flattest dimples; None if `progress`
    (fraction -> bool) returned False. Raises InputError where no dimple can be placed.

    `middle_first`: if the patch of middle tilts is not GOOD, no other is looked at, and they count as it
    does; by coarser cells where these are clear, for many values are compared so. `whole`: a texture whose
    patches are good, however much is left out, is simulated as a whole as well, borders included.
    `known`: the Assessment of its patches."""
    if known is not None:
        if not whole:
            return known
        quality, area = _whole(simulate, given)
        return replace(known, whole=quality, whole_area=area)
    times = _times_spacing(given)
    placed = place_texture(replace(given, spacing=times * given.spacing) if times > 1.0 else given)
    counts = {name: round(times**2 * n) for name, n in placed.dimples.counts().items()}
    cut = placed.dimples.states == core.DimpleState.CUT
    milled, away = _fractions(given, placed, counts)
    found = Assessment(counts["cut"], milled, counts, away_fraction=away)
    if not cut.any() or placed.free is not None or placed.thread is not None or placed.ball is not None:
        return found
    tilts = _tilts(placed)
    parts, middles = _looked_at(placed, tilts, count)
    made: dict[int, PatchQuality] = {}
    first = len(parts) // 2 if middle_first else None
    for k in sorted(range(len(parts)), key=lambda k: k != first):
        if progress and not progress(len(made) / len(parts)):
            return None
        number = middles[k]
        made[k] = _patch(simulate, given, placed, number, float(np.degrees(tilts[number])), middle_first)
        made[k].fraction = len(parts[k]) / cut.sum()
        if k == first and made[k].quality < GOOD:
            break
    found.patches = [made[k] for k in sorted(made)]
    if _flattest_is_bad(found.patches):
        _look_steeper(simulate, given, placed, tilts, parts[0], found.patches)
    rates = [patch.seconds_per_dimple for patch in found.patches if patch.seconds_per_dimple]
    found.seconds = float(np.mean(rates)) * found.dimples if rates else 0.0
    if whole and found.remains_good:
        found.whole, found.whole_area = _whole(simulate, given)
    return found


def _look_steeper(simulate, given, placed, tilts, flattest, patches):
    """Puts a further PatchQuality of the steepest of the `flattest` dimples into `patches`, if it is good."""
    neighbours = _neighbours(placed, placed.dimples.states == core.DimpleState.CUT)
    for share in STEEPER:
        number = _middle(flattest[int((1.0 - share) * len(flattest)) :], neighbours)
        steeper = _patch(simulate, given, placed, number, float(np.degrees(tilts[number])))
        if steeper.quality >= GOOD:
            steeper.fraction = share * patches[0].fraction
            patches[0].fraction -= steeper.fraction
            patches.insert(1, steeper)
            return


def first_patch(simulate, given, placed, progress=None):
    """SimulatedTexture of the patch at the flattest place of a TextureInput, where most textures are worst;
    of the next one that can be made where that one cannot. `placed`: its PlacedTexture. None if there is
    none, or if `progress` returned False before one."""
    cut = placed.dimples.states == core.DimpleState.CUT
    if placed.free is not None or placed.ball is not None or not cut.any():
        return None
    parts, middles = _looked_at(placed, _tilts(placed), 2)
    for k, number in enumerate(middles):
        if progress and not progress(k / len(parts)):
            return None
        asked, few = _around(given, placed, number)
        try:
            return _patch_alone(simulate, asked, few)[1]
        except InputError:
            continue
    return None


def _times_spacing(given):
    """By how much the spacing may be larger where patches are chosen and what is left out is counted, so that
    large faces take no longer than others; 1 where the texture depends on its spacing by more than that."""
    plain = given.texture_kind == "Overlapping" and not given.avoid_rubbing and given.minimum_dimples < 2
    if not plain or given.form == "Free" or given.mapping != "Projected" or not given.spacing:
        return 1.0
    area = sum(shapes.of_brep(text).Area for text in given.breps)
    needed = math.sqrt(area / given.spacing**2 / MANY)
    return max(1.0, min(needed, given.tool.radius / given.spacing))


def _fractions(given, placed, counts):
    """Of the faces, what is milled, and what is TURNED_AWAY. What the user, or a margin, leaves out does not
    count."""
    on_faces = sum(n for name, n in counts.items() if name not in NOT_ASKED_FOR)
    away = sum(counts[name] for name in TURNED_AWAY)
    if placed.input.mapping != "Projected":  # as of a thread, whatever is asked for
        return counts["cut"] / max(1, on_faces), away / max(1, on_faces)
    seen = orientation.seen_fraction(given, placed.plane.direction)
    return seen * counts["cut"] / max(1, on_faces - away), 1.0 - seen


def _whole(simulate, given):
    """(quality, part of the area that is as planned) of a whole texture, its borders included, of SQUARES of
    it where it is not SMALL or the spindle turns often; 0 where it cannot be made or loses its phase, None
    where there are more dimples than BORDERS_COUNT, or where the texture lies on faces too steep for one
    relief over the plane."""
    try:
        plan = plan_texture(given, slower=False)
        if given.mapping != "Projected" and cells.steepest(plan) > STEEP:
            return None, None
        verdict = plan.pacing.verdict
        if verdict is not None and not given.keeps_phase.polygons and verdict.holding != "holds":
            return 0.0, 0.0
        count = plan.counts["cut"]
        if count > BORDERS_COUNT:
            return None, None
        turns = plan.path.statistics()["timed_seconds"] * given.spindle.speed
        if count <= SMALL and turns <= MANY_TURNS:
            return cells.quality_in(simulate, plan, [None])
        often = turns / count > MANY_TURNS / SMALL
        return cells.quality_in(simulate, plan, cells.squares(plan, FEW_SQUARES if often else SQUARES))
    except InputError:
        return 0.0, 0.0


def _looked_at(placed, tilts, count):
    """(parts of the dimples, from the flattest to the steepest, the number of the dimple in the middle of the
    patch that stands for each) of a PlacedTexture with dimples at some `tilts` [rad]."""
    cut = placed.dimples.states == core.DimpleState.CUT
    numbers = np.flatnonzero(cut)
    order = numbers[np.argsort(tilts[numbers], kind="stable")]
    parts = [order] if len(order) <= WINDOW**2 else _parts(order, tilts[order], count)
    neighbours = _neighbours(placed, cut)
    if len(parts) == 1:  # then their order by tilt is that of rounding errors
        return parts, [_central(placed, parts[0], neighbours)]
    return parts, [_middle(part, neighbours) for part in parts]


def _parts(order, tilts, count):
    """Numbers of dimples in `order` of their ascending `tilts` [rad], in parts that a patch each stands for:
    the flattest, and `count` equal ones of the rest; one of all where the tilts are alike."""
    if tilts[-1] - tilts[0] < ALIKE:
        return [order]
    flattest = int(FLATTEST * len(order))
    parts = [order[:flattest], *np.array_split(order[flattest:], count)]
    return [part for part in parts if len(part)]


def _flattest_is_bad(patches):
    """Whether the first of PatchQuality in order of tilt is bad, and no other."""
    good = [patch.quality >= GOOD for patch in patches]
    return len(good) > 1 and not good[0] and all(good[1:])


def _neighbours(placed, cut):
    """How many dimples are milled in a square of WINDOW spacings around each lattice point."""
    places = np.where(np.isfinite(placed.places()), placed.places(), 0.0)
    cells = np.rint(places / placed.input.spacing).astype(int)
    half = WINDOW // 2
    cells += half + 1 - cells.min(axis=0)
    count = np.zeros(cells.max(axis=0) + half + 1, dtype=int)
    np.add.at(count, tuple(cells[cut].T), 1)
    total = count.cumsum(axis=0).cumsum(axis=1)
    (x0, y0), (x1, y1) = (cells - half - 1).T, (cells + half).T
    return total[x1, y1] - total[x0, y1] - total[x1, y0] + total[x0, y0]


def _middle(part, neighbours):
    """Of a part of the dimples the number nearest to its middle among those that have about as many
    neighbours as any of it."""
    full = neighbours[part] >= ABOUT * neighbours[part].max()
    ranks = np.flatnonzero(full)
    return int(part[ranks[np.abs(ranks - len(part) // 2).argmin()]])


def _central(placed, part, neighbours):
    """Of a part of the dimples the number nearest to their centre among those that have about as many
    neighbours as any."""
    full = np.sort(part[neighbours[part] >= ABOUT * neighbours[part].max()])
    away = np.linalg.norm(placed.places()[full] - placed.places()[part].mean(axis=0), axis=1)
    return int(full[(away / placed.input.spacing).round(6).argmin()])


def _tilts(placed):
    """Angle between tool axis and face at each dimple [rad]."""
    if tool_posture.is_vertical(placed.input):
        return np.asarray(core.tilts(placed.dimples, (0.0, 0.0, 1.0)))
    cosine = np.sum(tool_posture.axes(placed.input, placed.dimples) * placed.dimples.normals, axis=1)
    return np.arccos(np.clip(cosine, -1.0, 1.0))


def _patch(simulate, given, placed, number, tilt, coarse=False):
    """PatchQuality of one patch whose middle is where dimple `number` of a PlacedTexture is; `coarse`: by
    COARSE cells where these are clear."""
    looked = PatchQuality(_place(placed, number), tilt)
    asked, few = _around(given, placed, number)
    try:
        plan, result = _patch_alone(simulate, asked, few, coarse)
    except InputError as error:
        looked.problem = str(error)
        return looked
    looked.quality = float(result.quality)
    verdict = plan.pacing.verdict
    looked.holds = verdict is None or verdict.holding in ("holds", "unknown")
    looked.array = result.alignment["state"]
    looked.seconds_per_dimple = plan.path.statistics()["timed_seconds"] / max(1, plan.counts["cut"])
    return looked


def _place(placed, number):
    return tuple(float(c) for c in placed.dimples.positions[number])


def _around(given, placed, number):
    """(TextureInput of the one patch whose middle is where dimple `number` is, whether the dimples are so few
    that they are the patch)."""
    if placed.dimples.counts()["cut"] <= WINDOW**2:
        return given, True
    asked = replace(given, origin=_place(placed, number), patches_x=1, patches_y=1, minimum_dimples=0)
    if given.mapping != "Projected":  # the same dimples from any side: steep ones are seen from theirs
        asked = _seen_along(asked, tuple(-float(c) for c in placed.dimples.normals[number]))
    return asked, False


def _seen_along(given, direction):
    """A TextureInput whose one patch is laid where it begins, seen along `direction`; from where it was seen
    before where that meets another side of the faces first, as in a bore."""
    turned = replace(given, direction=direction, auto_direction=False)
    try:
        place_texture(turned)
    except InputError:
        return given
    return turned


def _patch_alone(simulate, given, few, coarse=False):
    """(PlannedTexture, SimulatedTexture) of one patch, or of all dimples if they are so `few`; `coarse`: by
    COARSE cells where these are clear."""
    plan = plan_texture(given, slower=False)
    half = plan.input.spacing * min(0.5 * WINDOW, 0.5 * given.patch_side)
    window = None if few else ((-half, -half), (half, half))
    if coarse:
        step = COARSE * plan.input.spacing
        result = simulate(plan, machine=plan.machine, window=window, step=step)
        if not UNCLEAR[0] <= result.quality < UNCLEAR[1]:
            return plan, result
    return plan, simulate(plan, machine=plan.machine, window=window)
