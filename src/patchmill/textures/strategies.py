"""A texture's path by the strategy that keeps its phase, from dimples to ToolPath and to the text of
FreeCAD's Path, judged for the machine. The strategies themselves: patchmill.textures.strategy.table.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass

import _patchmill as core
import numpy as np

from patchmill.machine import calibrated
from patchmill.textures import tool_posture
from patchmill.textures.strategy.table import NAMES, of  # noqa: F401  also for those that choose

CONSTANT, FITTED, FEED, LOCKED = NAMES


@dataclass
class Pacing:
    """A path made by one strategy. `text` is a _patchmill.PathText for
    Path.Path(). `verdict` is a _patchmill.Verdict, or
    None where no machine was named. `clearance`: see _patchmill.paced_path; None for polygons."""

    path: core.ToolPath
    text: core.PathText
    feed: float
    verdict: object = None
    clearance: float = None
    posture: object = None  # tool_posture.Posture where rotary axes are used


def make(given, dimples, rule, machine, path_of=None, posture=None, whole=None, before=0, slower=True):
    """Pacing of the dimples. `given` is a TextureInput, `machine` a machines.Machine or None, `posture` a
    tool_posture.Posture or None; `path_of`, if given, makes the ToolPath of a Spindle instead of the
    strategy; `whole` is a plan of which these are some dimples, `before` of it come before them: a locked
    path gets its phase. `slower`: whether the verdict looks for a lower speed where its own does not hold.
    Raises InputError naming Strategy, Machine or what the core names."""
    strategy = of(given.strategy)
    strategy.require(machine)
    clearances = []

    def plan(spindle):
        if path_of:
            path, clearance = path_of(spindle), None
        else:
            turning = posture.turning if posture else []
            path, clearance = strategy.path(given, dimples, rule, machine, spindle, turning)
        clearances.append(clearance)
        return path

    def started(spindle):
        """As it is posted: a lock's path begins with its start phase, and takes other steps for it."""
        return _with_start_phase(plan(spindle), given, dimples, rule, machine)

    partly = whole is not None and strategy.locked
    path = plan(given.spindle)
    clearance = clearances[0]
    feed = core.posted_feed(given.feed, given.decimals)
    verdict = None
    if machine is not None:
        judged = plan if partly else started
        verdict = core.judge_plan(judged, dimples, given.tool, given.spindle, rule, machine.model, slower)
        path = (
            _in_phase_of(whole, before, path, given, rule)
            if partly
            else _with_start_phase(path, given, dimples, rule, machine)
        )
    if posture is not None:
        text = tool_posture.finish(posture, path, given, machine)
        return Pacing(posture.work.path, text, feed, verdict, clearance, posture)
    return Pacing(path, strategy.text(given, path, feed, machine), feed, verdict, clearance)


def _in_phase_of(whole, before, path, given, rule):
    """A locked path whose first dimple comes after `before` others of a plan, so that the spindle is there
    where it is in the plan, each counted from where its lock begins. Getting to speed takes both alike."""
    turned = []
    for one, number in ((path, 0), (whole.path, before)):
        turns = np.cumsum(np.where(one.kinds != core.MoveKind.RAPID, one.turns, 0.0))
        turned.append(turns[one.dimples != core.NO_DIMPLE][number])
    period = core.phase_period(given.tool.flutes, rule)
    start = 2.0 * np.pi * (turned[0] - turned[1]) % period
    return core.with_start_phase(path, start, period, given.decimals)


def _with_start_phase(path, given, dimples, rule, machine):
    """The path with the machine's start phase taken off, and for a lock the path's own one, from the
    spindle's index to its dimples: so programs of any texture have the phase that one calibration found."""
    start = 0.0 if given.calibrating else machine.start_phase
    if of(given.strategy).locked:
        from_index = calibrated.from_index(machine.data)
        start += core.own_start_phase(path, dimples, rule, machine.model, from_index)
    period = core.phase_period(given.tool.flutes, rule)
    start %= period
    return core.with_start_phase(path, start, period, given.decimals) if start else path


def path_at(given, dimples, rule, machine, spindle, posture=None):
    """The ToolPath of the dimples with another spindle, for the ball centre. Raises InputError as make()."""
    turning = posture.turning if posture else []
    path = of(given.strategy).path(given, dimples, rule, machine, spindle, turning)[0]
    return path if machine is None else _with_start_phase(path, given, dimples, rule, machine)
