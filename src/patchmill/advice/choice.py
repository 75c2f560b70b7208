"""Which values suit a texture: strategy, order, flutes, turns, feed and spindle speed that a machine holds,
tried from the fastest on.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, replace

import _patchmill as core
import FreeCAD
import Part
from _patchmill import InputError

from patchmill.advice.found import GOOD
from patchmill.machine import machines
from patchmill.textures import strategies
from patchmill.textures.input import TextureInput
from patchmill.textures.order import rows
from patchmill.textures.plan import plan_texture

FLAT = 12.0  # degrees to the tool axis, below which the tip comes near whatever the strategy
EXTRA_TURNS = (1.0, 2.0, 5.0)
FEEDS = (1.0, 2.0)  # times the tool controller's
SPEED_STEP = 1.15  # from one spindle speed that is tried to the next
HIGHEST_SPEED = 4.0  # times the tool controller's
MIN_PERIODS_OF_TOOTH = 11.0  # servo periods, in which a lock follows a tooth (docs/rows.md)


@dataclass
class Choice:
    """Values of a texture's fields by name, the tool controller's `feed` and `spindle` among them where
    they may be changed, and what they give."""

    fields: dict
    assessment: object  # Assessment


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
        shape = Part.Shape()
        shape.importBrepFromString(text)
        box.add(shape.BoundBox)
    return (box.XLength, box.YLength)[axis]


def _stops_are_known(machine):
    axes = machine.data["linear_axes"]
    return machine.data["path_tolerance_mm"] == 0.0 and axes["jerk_mm_s3"] is None


def choose(assess, given, free=False, progress=None):
    """The Choice for a TextureInput: the fastest that is good at all places that were looked at, else the one
    that is good at most. `assess`: see assessment.with_simulation; `free`: the tool controller's feed and
    speed may be changed. None if `progress` (fraction -> bool) returned False. Raises InputError where no
    dimple can be placed whatever the strategy."""
    machine = machines.load(given.machine) if given.machine else None
    tried = list(candidates(given, machine, free))
    choices: list[tuple[TextureInput, Choice]] = []
    for number, fields in enumerate(tried):
        if progress and not progress(number / len(tried)):
            return None
        asked = replace(given, **fields)
        try:
            found = assess(asked, 3, first=1)
        except InputError:
            if number + 1 == len(tried) and not choices:
                raise
            continue
        choice = Choice(fields, found)
        choices.append((asked, choice))
        if _good_but_where_flat(found.patches) and _can_be_planned(asked):
            return _sped_up(assess, given, choice, machine, progress) if free else choice
    choices.sort(key=lambda pair: _rank(pair[1].assessment), reverse=True)
    planned = (choice for asked, choice in choices if _can_be_planned(asked))
    best = next(planned, choices[0][1] if choices else None)
    return _sped_up(assess, given, best, machine, progress) if best and free else best


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


def _sped_up(assess, given, choice, machine, progress):
    """The Choice at the highest speed, found by bisection, at which as much is good and the whole can be
    planned; polygons keep their shape, for the feed goes with the speed. None as choose()."""
    ladder = speeds(given, machine)
    low, high, best = 0, len(ladder), choice
    while low < high:
        if progress and not progress(low / len(ladder)):
            return None
        middle = (low + high + 1) // 2
        faster = _at_speed(assess, given, choice, ladder[middle - 1])
        if faster is not None and faster.assessment.good_fraction >= choice.assessment.good_fraction:
            low, best = middle, faster
        else:
            high = middle - 1
    return best


def _at_speed(assess, given, choice, rpm):
    """The Choice with another spindle speed; None where that cannot be planned."""
    factor = rpm / (60.0 * given.spindle.speed)
    fields = dict(choice.fields, spindle=core.Spindle(rpm / 60.0, given.spindle.sense))
    if fields["strategy"] in (strategies.CONSTANT, strategies.FITTED):
        fields["feed"] = factor * fields.get("feed", given.feed)
    asked = replace(given, **fields)
    try:
        found = assess(asked, 3, first=1)
    except InputError:
        return None
    return Choice(fields, found) if _can_be_planned(asked) else None


def _good_but_where_flat(patches):
    """Whether all are good, or all but those that no strategy makes good: near to the tool's tip, and flatter
    than every good one."""
    good = [patch.tilt for patch in patches if patch.quality >= GOOD]
    bad = [patch.tilt for patch in patches if patch.quality < GOOD]
    return bool(good) and max(bad, default=0.0) < min(min(good), FLAT)


def _can_be_planned(given):
    """Whether the whole texture can be planned, and its phase holds. Polygons go from patch to patch as they
    go within one: of them the patches that were looked at say whether the phase does."""
    try:
        verdict = plan_texture(given).pacing.verdict
    except InputError:
        return False
    return given.keeps_phase.polygons or verdict.holding == "holds"


def _rank(found):
    held = all(patch.holds for patch in found.patches)
    return held, found.good_fraction, sum(patch.quality for patch in found.patches)
