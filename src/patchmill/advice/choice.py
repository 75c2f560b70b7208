"""Which values suit a texture: strategy, flutes, turns and feed that a machine holds, tried from the fastest
on.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, replace

from _patchmill import InputError

from patchmill.advice.found import GOOD
from patchmill.machine import machines
from patchmill.textures import strategies
from patchmill.textures.input import TextureInput
from patchmill.textures.plan import plan_texture

FLAT = 12.0  # degrees to the tool axis, below which the tip comes near whatever the strategy
EXTRA_TURNS = (1.0, 2.0, 5.0)
FEEDS = (1.0, 2.0)  # times the tool controller's


@dataclass
class Choice:
    """Values of a texture's fields by name, and what they give. `feed_factor`: of the controller's feed."""

    fields: dict
    feed_factor: float
    assessment: object  # Assessment


def candidates(given, machine, any_feed):
    """(fields, feed factor) pairs to be tried, the fastest first. `any_feed`: the feed may be changed."""
    if machine is not None and machine.model.spindle_lock:
        yield _fields(strategies.LOCKED, False, 0.0), 1.0
    polygons = [strategies.CONSTANT]
    if machine is not None and _stops_are_known(machine):
        polygons = [strategies.FITTED]
    for strategy in polygons:
        for factor in reversed(FEEDS) if any_feed else (1.0,):
            for turns in EXTRA_TURNS:
                yield _fields(strategy, given.tool.flutes < 2, turns), factor
    if machine is not None:
        yield _fields(strategies.FEED, False, 0.0), 1.0


def _fields(strategy, same_flute, extra_turns):
    return {"strategy": strategy, "same_flute": same_flute, "extra_turns": extra_turns}


def _stops_are_known(machine):
    axes = machine.data["linear_axes"]
    return machine.data["path_tolerance_mm"] == 0.0 and axes["jerk_mm_s3"] is None


def choose(assess, given, any_feed=False, progress=None):
    """The Choice for a TextureInput: the fastest that is good at all places that were looked at, else the one
    that is good at most. `assess`: see assessment.with_simulation. None if `progress` (fraction -> bool)
    returned False. Raises InputError where no dimple can be placed whatever the strategy."""
    machine = machines.load(given.machine) if given.machine else None
    tried = list(candidates(given, machine, any_feed))
    choices: list[tuple[TextureInput, Choice]] = []
    for number, (fields, factor) in enumerate(tried):
        if progress and not progress(number / len(tried)):
            return None
        asked = replace(given, feed=given.feed * factor, **fields)
        try:
            found = assess(asked, 3, first=1)
        except InputError:
            if number + 1 == len(tried) and not choices:
                raise
            continue
        choice = Choice(fields, factor, found)
        choices.append((asked, choice))
        if _good_but_where_flat(found.patches) and _can_be_planned(asked):
            return choice
    choices.sort(key=lambda pair: _rank(pair[1].assessment), reverse=True)
    planned = (choice for asked, choice in choices if _can_be_planned(asked))
    return next(planned, choices[0][1] if choices else None)


def _good_but_where_flat(patches):
    """Whether all are good, or all but those that no strategy makes good: near to the tool's tip, and flatter
    than every good one."""
    good = [patch.tilt for patch in patches if patch.quality >= GOOD]
    bad = [patch.tilt for patch in patches if patch.quality < GOOD]
    return bool(good) and max(bad, default=0.0) < min(min(good), FLAT)


def _can_be_planned(given):
    """Whether the whole texture can be planned, and its phase holds. Polygons go from patch to patch as they
    go within one: for them the patches that were looked at say it."""
    if given.keeps_phase.polygons:
        return True
    try:
        return plan_texture(given).pacing.verdict.holding == "holds"
    except InputError:
        return False


def _rank(found):
    held = all(patch.holds for patch in found.patches)
    return held, found.good_fraction, sum(patch.quality for patch in found.patches)
