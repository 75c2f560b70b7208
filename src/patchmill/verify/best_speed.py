"""Time and phase error of a texture over the spindle's speed, and the speed that is done first and holds.

    found = patchmill.best_speed(operation)
    found.best.rpm, found.best.seconds          # None where no speed holds
    for point in found.curve: ...

Nothing is changed: the speed of a tool controller is the user's. A point that is proposed was planned and
predicted at that speed.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field
from math import degrees, isfinite

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.operations.base import planned
from patchmill.textures import strategies
from patchmill.textures.plan import PlannedTexture

# what a plan must hold, as the verdict of the core has it [degrees]
RMS, LARGEST = 3.0, 9.0
SLOWEST, FASTEST, STEP = 0.25, 4.0, 1.15  # of the speed that is set


@dataclass
class SpeedPoint:
    """A speed [rpm]: seconds of the timed moves, turns per dimple, phase error [degrees]. `trouble` says why
    there is no plan, or why its phase is not known."""

    rpm: int
    seconds: float = float("nan")
    turns: float = float("nan")
    rms: float = float("nan")
    largest: float = float("nan")
    holds: bool = False
    trouble: str = ""


@dataclass
class BestSpeed:
    """The curve, ascending in speed, and the point of least time among those that hold, or None."""

    curve: list = field(default_factory=list)
    best: SpeedPoint = None


def best_speed(operation, speeds=None, progress=None):
    """BestSpeed of a texture operation on its machine. `speeds`: whole rpm to try; None: from a fourth of the
    speed that is set to four times it. None if `progress` (share -> bool) returned False. Raises InputError
    naming Machine, Form or Speeds."""
    plan = planned(operation)
    if not isinstance(plan, PlannedTexture):
        label = getattr(operation, "Label", repr(operation))
        raise InputError("Operation", label, "choose a texture operation.")
    return of_plan(plan, speeds, progress)


def of_plan(plan, speeds=None, progress=None):
    """The same of a PlannedTexture, without a document."""
    if plan.machine is None:
        remedy = "name a machine file: without one nobody knows what it can follow."
        raise InputError("Machine", "''", remedy)
    if plan.free is not None:
        remedy = "the free form has its spindle speed from the feed per tooth."
        raise InputError("Form", "Free", remedy)
    tried = _speeds(plan, speeds)
    found = BestSpeed()
    for number, rpm in enumerate(tried):
        if progress and not progress(number / len(tried)):
            return None
        found.curve.append(_at(plan, rpm))
    held = [point for point in found.curve if point.holds]
    found.best = min(held, key=lambda point: point.seconds, default=None)
    return found


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


def _at(plan, rpm):
    """SpeedPoint of one speed."""
    point = SpeedPoint(rpm)
    given = plan.input
    spindle = core.Spindle(rpm / 60.0, "M3" if given.spindle.sign < 0 else "M4")
    try:
        path = strategies.path_at(given, plan.dimples, plan.rule, plan.machine, spindle, plan.posture)
        phase = core.predicted_phase(path, plan.machine.model, plan.dimples, plan.rule)
    except InputError as error:
        point.trouble = str(error)
        return point
    statistics = path.statistics()
    point.seconds = statistics["timed_seconds"]
    point.turns = point.seconds * spindle.speed / max(1, statistics["dimples"])
    if not phase["known"]:
        point.trouble = phase["reason"]
        return point
    point.rms, point.largest = degrees(phase["rms"]), degrees(phase["largest"])
    point.holds = isfinite(point.largest) and point.rms <= RMS and point.largest <= LARGEST
    return point
