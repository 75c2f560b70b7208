"""Which values suit a texture: margin, strategy, order, flutes, turns, feed and spindle speed that a machine
holds, tried from the fastest on.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, replace
from itertools import islice

import _patchmill as core
import FreeCAD
from _patchmill import InputError

from patchmill.advice.found import GOOD, GOOD_FRACTION, SMALL, Assessment
from patchmill.geometry import shapes
from patchmill.machine import machines
from patchmill.system.stops import stoppable
from patchmill.textures import strategies
from patchmill.textures.division import texture_size
from patchmill.textures.order import rows
from patchmill.textures.plan import plan_texture

FLAT = 12.0  # degrees to the tool axis, below which the tip comes near whatever the strategy
EXTRA_TURNS = (1.0, 2.0, 5.0)
FEEDS = (1.0, 2.0)  # times the tool controller's
SPEED_STEP = 1.15  # from one spindle speed that is tried to the next
HIGHEST_SPEED = 4.0  # times the tool controller's
# Of the spacing: a dimple nearer to a border is not whole. The first for all; the others where that leaves
# the outermost row open, as on small inclined faces
MARGINS = (0.48, 0.85, 1.1)
ALIKE = 0.011  # of the faces, by which choices that are good alike may differ
LARGE, FEW = 30000, 4  # dimples; of more, and of polygons, only every so many of the speeds are tried
TRIED, TRIED_LARGE = 6, 2  # of the fastest choices, whose borders are looked at until they are good
NEAR = 0.85  # quality of a whole, below which its order and direction are no better at the next speeds
POLYGONS = (strategies.CONSTANT, strategies.FITTED)
MIN_PERIODS_OF_TOOTH = 11.0  # servo periods, in which a lock follows a tooth (docs/rows.md)


@dataclass
class Choice:
    """Values of a texture's fields by name, the tool controller's `feed` and `spindle` among them where
    they may be changed, and what they give."""

    fields: dict
    assessment: Assessment


def candidates(given, machine, free):
    """Fields to be tried, the fastest first. `free`: the tool controller may be changed."""
    if machine is not None and machine.model.spindle_lock:
        for direction in _directions(given):
            yield dict(_fields(strategies.LOCKED, False, 0.0, rows.ROWS), row_direction=direction)
        yield _fields(strategies.LOCKED, False, 0.0)
    polygons = [strategies.CONSTANT]
    if machine is not None and _stops_are_known(machine):
        polygons = [strategies.FITTED]
    for strategy in polygons:
        for factor in reversed(FEEDS) if free else (1.0,):
            for turns in EXTRA_TURNS:
                fields = _fields(strategy, given.tool.flutes < 2, turns)
                yield dict(fields, feed=given.feed * factor) if free else fields
    if machine is not None:
        yield _fields(strategies.FEED, False, 0.0)


def first_ways(given, free):
    """TextureInputs with the values of the strategy that choose() tries first, one for each way to go along
    the texture. `free`: see choose."""
    machine = machines.load(given.machine) if given.machine else None
    tried = list(candidates(given, machine, free))
    ways = {_way(fields): fields for fields in tried if fields["strategy"] == tried[0]["strategy"]}
    return [replace(given, **fields, **_own_margin(given)) for fields in ways.values()]


def _fields(strategy, same_flute, extra_turns, order=rows.HELIX):
    return {"strategy": strategy, "same_flute": same_flute, "extra_turns": extra_turns, "order": order}


def _directions(given):
    """Both directions of rows, the one with the longer rows first. Up and down a slope the tip reaches the
    dimple before, and across it does not: which of them is good is to be tried, and a single patch does not
    say which takes the least time."""
    turned = abs(math.cos(math.radians(given.rotation))) < math.sqrt(0.5)
    along_x = _length(given, 0) >= _length(given, 1)
    both = (rows.ALONG_X, rows.ALONG_Y)
    return both if along_x != turned else both[::-1]


def _length(given, axis):
    """Of the box around all faces along X or Y [mm]."""
    box = FreeCAD.BoundBox()
    for text in given.breps:
        box.add(shapes.of_brep(text).BoundBox)
    return (box.XLength, box.YLength)[axis]


def _stops_are_known(machine):
    return machine.data["path_tolerance_mm"] == 0.0 and machine.data["linear_axes"]["jerk_mm_s3"] is None


@stoppable
def choose(assess, given, free=False, progress=None):
    """The Choice for a TextureInput: the fastest that is good at all places that were looked at, else the one
    that is good at most. `assess`: see assessment.with_simulation; `free`: the tool controller's feed and
    speed may be changed. A margin is chosen where none is given. None if `progress` (fraction -> bool)
    returned False. Raises InputError where no dimple can be placed whatever the strategy."""
    machine = machines.load(given.machine) if given.machine else None
    own = _own_margin(given)
    tried = [dict(fields, **own) for fields in candidates(given, machine, free)]
    locked = sum(1 for fields in tried if fields["strategy"] == strategies.LOCKED)
    rpms = speeds(given, machine) if free else []
    choices: list[Choice] = []
    best, stopped = None, []

    def go_on(fraction):
        if progress and not progress(fraction):
            stopped.append(fraction)
        return not stopped

    for number, fields in enumerate(tried):
        if not go_on(number / len(tried)):
            return None
        try:
            choice = Choice(fields, assess(replace(given, **fields), 3, middle_first=True))
        except InputError:
            if number + 1 == len(tried) and not choices:
                raise
            choice = None
        if choice is not None:
            if not choice.assessment.dimples:
                return choice  # and there are none whatever the strategy
            choices.append(choice)
        if number + 1 == locked:
            best = _of_locked(assess, given, choices, rpms, go_on)
        elif number >= locked and choice is not None and _good_but_where_flat(choice.assessment.patches):
            best = _fastest(assess, given, [choice], rpms, go_on)
        if best is not None:
            break
    choices.sort(key=lambda choice: _rank(choice.assessment), reverse=True)
    for choice in choices if best is None else ():
        best = best or _fastest(assess, given, [choice], rpms, go_on)
    best = best or (choices[0] if choices else None)
    if stopped:
        return None
    return best and _with_borders(assess, given, best, own)


def _of_locked(assess, given, choices, rpms, progress):
    """The fastest Choice of those locked to the spindle that are good alike; where a lock holds and is short,
    the one that is good at most, for then it is not the phase that is short; else None: others are tried."""
    good = [choice for choice in choices if _good_but_where_flat(choice.assessment.patches)]
    if good:
        most = max(choice.assessment.good_fraction for choice in good)
        enough = min(most - ALIKE, GOOD_FRACTION) - 1e-9  # of more than that the fastest is best
        alike = [choice for choice in good if choice.assessment.good_fraction >= enough]
        return _fastest(assess, given, alike, rpms, progress)
    for choice in sorted(choices, key=lambda choice: _rank(choice.assessment), reverse=True):
        if all(patch.holds and not patch.problem for patch in choice.assessment.patches):
            found = _fastest(assess, given, [choice], rpms, progress)
            if found is not None:
                return found
    return None


def _margin(given, of_spacing):
    """Margin [mm] for a TextureInput."""
    return round(of_spacing * texture_size(given)["spacing"], 4)


def _own_margin(given):
    """Fields with the margin that is tried first; none where the TextureInput has the user's."""
    return {} if given.margin else {"margin": _margin(given, MARGINS[0])}


def _with_borders(assess, given, choice, own):
    """The Choice with the first margin with which a texture is good as a whole, else with the best of
    them; the Choice itself where its margin is the user's or it is short for other reasons."""
    best = choice
    if not own or choice.assessment.borders_are_good:
        return choice
    for of_spacing in MARGINS[1:]:
        fields = dict(choice.fields, margin=_margin(given, of_spacing))
        asked = replace(given, **fields)
        try:
            other = Choice(fields, assess(asked, whole=True, known=choice.assessment))
        except InputError:
            continue
        if (other.assessment.whole or 0.0) > best.assessment.whole:
            best = other
        if best.assessment.remains_good:
            break
    return best


def speeds(given, machine):
    """Whole spindle speeds [rpm] above the texture's, ascending, that a machine may hold its phase at."""
    if machine is None:
        return []
    own = 60.0 * given.spindle.speed
    highest = HIGHEST_SPEED * own
    if machine.model.spindle_lock:
        periods = MIN_PERIODS_OF_TOOTH * given.tool.flutes * machine.data["servo_period_s"]
        highest = min(highest, 60.0 / periods)
    found: list[int] = []
    while own * SPEED_STEP ** (len(found) + 1) < highest:
        found.append(int(own * SPEED_STEP ** (len(found) + 1)))
    return found + [int(highest)] if highest >= own + 1.0 else []


def _fastest(assess, given, choices, rpms, progress):
    """Of Choices, each at its own spindle speed and at `rpms`, the one of least time over the whole that is
    as good as it was at its own, borders included; else of the fastest ones that whose borders are best. None
    where none can be planned whole, or `progress` returned False."""
    best = None
    far: set[tuple] = set()  # ways to go that are not looked at again
    tried = TRIED if max(choice.assessment.dimples for choice in choices) <= SMALL else TRIED_LARGE
    for choice in islice(_by_time(assess, given, choices, rpms, progress, far), tried):
        if not choice.assessment.remains_good:
            return best or choice
        whole = assess(replace(given, **choice.fields), whole=True, known=choice.assessment)
        if best is None or whole.worth > best.assessment.worth:
            best = Choice(choice.fields, whole)
        if whole.borders_are_good:
            return best
        if whole.whole < NEAR:
            far.add(_way(choice.fields))
    return best


def _way(fields):
    """How a texture is gone along: what a higher or lower speed leaves."""
    return tuple(fields.get(name) for name in ("strategy", "order", "row_direction"))


def _by_time(assess, given, choices, rpms, progress, far=frozenset()):
    """Yields Choices at their own spindle speed, and at `rpms` where they are as good, or good enough, the
    one of least time over the whole first, none of the ways `far`, which may grow meanwhile; no more once
    `progress` returned False. A higher speed takes longer where it makes single steps too fast."""
    timed: list[tuple] = []
    for choice in choices:
        polygons = choice.fields["strategy"] in POLYGONS
        few = choice.assessment.dimples > LARGE or polygons
        slow = polygons and not choice.assessment.remains_good  # to be planned, for what nobody wants
        held = False
        for rpm in (None, *(() if slow else rpms[FEW - 1 :: FEW] if few else rpms)):
            if not progress(0.5):
                return
            fields = choice.fields if rpm is None else _at_speed(given, choice.fields, rpm)
            seconds = _seconds(replace(given, **fields))
            if seconds is not None:
                timed.append((seconds, len(timed), rpm or 0.0, choice, fields))
                held = True
            elif not held and (polygons or rpm):
                break  # lost at all higher ones; only a lock may hold at one speed and not at a slower one
    too_fast: dict[int, float] = {}
    for _, _, rpm, choice, fields in sorted(timed, key=lambda one: one[:2]):
        if rpm >= too_fast.get(id(choice), math.inf) or _way(fields) in far:
            continue
        if not rpm:
            yield choice
            continue
        found = assess(replace(given, **fields), 3, middle_first=True)
        if found.good_fraction >= min(choice.assessment.good_fraction, GOOD_FRACTION) - 1e-9:
            yield Choice(fields, found)
        else:
            too_fast[id(choice)] = rpm


def _at_speed(given, fields, rpm):
    """Fields with another spindle speed; polygons keep their shape, for the feed goes with the speed."""
    found = dict(fields, spindle=core.Spindle(rpm / 60.0, given.spindle.sense))
    if fields["strategy"] in POLYGONS:
        found["feed"] = rpm / (60.0 * given.spindle.speed) * fields.get("feed", given.feed)
    return found


def _good_but_where_flat(patches):
    """Whether all are good, or all but those that no strategy makes good: near to the tool's tip, and flatter
    than every good one."""
    good = [patch.tilt for patch in patches if patch.quality >= GOOD]
    bad = [patch.tilt for patch in patches if patch.quality < GOOD]
    return bool(good) and max(bad, default=0.0) < min(min(good), FLAT)


def _seconds(given):
    """Of milling the whole texture; None where it cannot be planned or its phase is lost. Polygons go from
    patch to patch as they go within one: of them the patches that were looked at say whether it is."""
    try:
        plan = plan_texture(given, slower=False)
    except InputError:
        return None
    verdict = plan.pacing.verdict
    lost = not given.keeps_phase.polygons and verdict.holding != "holds"
    return None if lost else plan.path.statistics()["timed_seconds"]


def _rank(found):
    held = all(patch.holds for patch in found.patches)
    return held, found.good_fraction, sum(patch.quality for patch in found.patches)
