"""Time and phase error of a texture over the spindle's speed, and over order, extra turns and feed, and the
point that is done first and holds.

    found = patchmill.best_speed(operation)
    found.best.rpm, found.best.seconds          # None where no speed holds
    for point in found.curve: ...
    patchmill.best_speed(operation, orders=("Helix", "Rows"))
    patchmill.best_speed(operation, extra_turns=(4.0, 5.0), feeds=(300.0, 434.413))   # constant feed, mm/min

Nothing is changed: the speed of a tool controller is the user's. A point that is proposed was planned and
judged at that speed, by the verdict that the operation itself would get.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field, replace
from itertools import product
from math import degrees, radians

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.operations.computed import planned
from patchmill.system.stops import stoppable
from patchmill.textures import strategies
from patchmill.textures.order import rows
from patchmill.textures.plan import PlannedTexture, plan_texture

SLOWEST, FASTEST, STEP = 0.25, 4.0, 1.15  # of the speed that is set


@dataclass
class SpeedPoint:
    """A speed [rpm], an order, extra turns and a feed [mm/min; NaN where each move has its own]: seconds of
    the timed moves, turns per dimple, phase error [degrees]. `trouble` says why there is no plan, why its
    phase is not known, or why it does not hold."""

    rpm: int
    seconds: float = float("nan")
    turns: float = float("nan")
    rms: float = float("nan")
    largest: float = float("nan")
    holds: bool = False
    trouble: str = ""
    order: str = rows.HELIX
    extra_turns: float = 0.0
    feed: float = float("nan")


@dataclass
class BestSpeed:
    """The curve, ascending in speed, and the point of least time among those that hold, or None."""

    curve: list = field(default_factory=list)
    best: SpeedPoint = None


@stoppable
def best_speed(operation, speeds=None, orders=None, extra_turns=None, feeds=None, progress=None):
    """BestSpeed of a texture operation on its machine. `speeds`: whole rpm to try; None: from a fourth of the
    speed that is set to four times it. `orders`, `extra_turns`, `feeds` [mm/min]: what else to try; None: the
    operation's own. None if `progress` (share -> bool) returned False. Raises InputError naming Machine,
    Form, Speeds, Order, ExtraTurns or Feed."""
    plan = planned(operation)
    if not isinstance(plan, PlannedTexture):
        label = getattr(operation, "Label", repr(operation))
        raise InputError("Operation", label, "choose a texture operation.")
    return of_plan(plan, speeds, orders, extra_turns, feeds, progress)


@stoppable
def of_plan(plan, speeds=None, orders=None, extra_turns=None, feeds=None, progress=None):
    """The same of a PlannedTexture, without a document."""
    if plan.machine is None:
        remedy = "name a machine file: without one nobody knows what it can follow."
        raise InputError("Machine", "''", remedy)
    if plan.free is not None:
        remedy = "the free form has its spindle speed from the feed per tooth."
        raise InputError("Form", "Free", remedy)
    given = plan.input
    choices = list(
        product(
            _speeds(plan, speeds),
            _known_orders(given, orders),
            _numbers("ExtraTurns", extra_turns, given.extra_turns, _polygons(given)),
            _numbers("Feed", feeds, 60.0 * given.feed, _polygons(given)),
        )
    )
    plans = {}
    found = BestSpeed()
    for number, (rpm, order, extra, feed) in enumerate(choices):
        if progress and not progress(number / len(choices)):
            return None
        if order not in plans:
            plans[order] = _in_order(plan, order)
        point = SpeedPoint(rpm, order=order, extra_turns=extra, feed=feed)
        found.curve.append(_at(plans[order], point))
    held = [point for point in found.curve if point.holds]
    found.best = min(held, key=lambda point: point.seconds, default=None)
    return found


def _polygons(given):
    """Whether the strategy has a feed and extra turns: on paced paths each move has its own feed."""
    return given.keeps_phase.polygons


def _known_orders(given, orders):
    if orders is None:
        return [given.order]
    for order in orders:
        rows.in_rows(replace(given, order=order))  # refuses what is no order
    return list(dict.fromkeys(orders))


def _numbers(name, values, own, there):
    """`values` in ascending order, or the operation's own where none are given."""
    if values is None:
        return [own]
    if not there:
        raise InputError(name, values, "the strategy has none to choose: leave it out.")
    values = sorted({float(value) for value in values})
    if not values or not np.isfinite(values).all() or values[0] < 0.0:
        raise InputError(name, values, "give numbers of zero or more.")
    return values


def _in_order(plan, order):
    """The plan in another order, or the InputError why there is none."""
    if order == plan.input.order:
        return plan
    try:
        return plan_texture(replace(plan.asked or plan.input, order=order))
    except InputError as error:
        return error


def _speeds(plan, speeds):
    if speeds is None:
        set_rpm = 60.0 * plan.input.spindle.speed
        count = int(np.ceil(np.log(FASTEST / SLOWEST) / np.log(STEP))) + 1
        around = set_rpm * np.geomspace(SLOWEST, FASTEST, count)
        speeds = [*np.rint(around).astype(int), round(set_rpm)]
    speeds = sorted({int(rpm) for rpm in speeds})
    if not speeds or speeds[0] < 1:
        raise InputError("Speeds", speeds, "give whole numbers of rpm greater than zero.")
    return speeds


def _at(plan, point):
    """The point, with what comes of it."""
    if isinstance(plan, InputError):
        return replace(point, trouble=str(plan))
    given, rule, feed = plan.input, plan.rule, point.feed
    if _polygons(given):
        given = replace(given, feed=feed / 60.0)
        if point.extra_turns != given.extra_turns:
            rule = core.PhaseRule(given.same_flute, point.extra_turns, radians(given.phase_step))
            if plan.posture is not None:
                rule = core.with_azimuths(rule, plan.posture.postures)
    else:
        point = replace(point, feed=float("nan"))
    spindle = core.Spindle(point.rpm / 60.0, "M3" if given.spindle.sign < 0 else "M4")
    try:
        path, verdict = _judged(plan, given, rule, spindle)
    except InputError as error:
        return replace(point, trouble=str(error))
    statistics = path.statistics()
    seconds = statistics["timed_seconds"]
    return replace(
        point,
        seconds=seconds,
        turns=seconds * spindle.speed / max(1, statistics["dimples"]),
        rms=degrees(verdict.rms) if verdict.holding != "unknown" else float("nan"),
        largest=degrees(verdict.largest) if verdict.holding != "unknown" else float("nan"),
        holds=verdict.holding == "holds",
        trouble=_trouble(verdict),
    )


def _judged(plan, given, rule, spindle):
    """(path, verdict) of a plan's dimples at the speed of `spindle`. A thread is one move whose turns follow
    from the cylinder: it is planned anew."""
    if plan.thread is not None:
        thread = plan_texture(replace(plan.asked or plan.input, spindle=spindle))
        return thread.path, thread.pacing.verdict
    path = strategies.path_at(given, plan.dimples, rule, plan.machine, spindle, plan.posture)
    return path, _verdict_of(path, plan, rule, spindle)


def _trouble(verdict):
    """Why it does not hold; no slower spindle was looked for."""
    if verdict.holding == "holds":
        return ""
    return verdict.sentence.replace(", and no slower spindle helps", "")


def _verdict_of(path, plan, rule, spindle):
    """The core's verdict on this path alone: no slower spindle is looked for."""

    def this_one(asked):
        if abs(asked.speed - spindle.speed) > 1e-9 * spindle.speed:
            raise InputError("SpindleSpeed", asked.speed, "this speed alone is judged.")
        return path

    return core.judge_plan(this_one, plan.dimples, plan.input.tool, spindle, rule, plan.machine.model)
