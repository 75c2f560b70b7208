"""The ways to keep the phase, each from dimples to ToolPath and to the text of FreeCAD's Path.

    Constant feed                 Xu & Sasahara 2016: polygons of a length (docs/constant-feed.md)
    Constant feed, fitted stops   the same, with legs fitted to the machine's stops
    Feed per move                 straight on, F = d / T
    Spindle-locked                straight on, K = d / Lambda: G33 (docs/synchronisation.md)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass

import _patchmill as core
from _patchmill import InputError

from patchmill.textures import tool_posture
from patchmill.textures.order import rows

CONSTANT, FITTED, FEED, LOCKED = NAMES = (
    "Constant feed",
    "Constant feed, fitted stops",
    "Feed per move",
    "Spindle-locked",
)


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


def make(given, dimples, rule, machine, path_of=None, posture=None):
    """Pacing of the dimples. `given` is a TextureInput, `machine` a machines.Machine or None, `posture` a
    tool_posture.Posture or None; `path_of`, if given, makes the ToolPath of a Spindle instead of the
    strategy.
    Raises InputError naming Strategy, Machine or what the core names."""
    if given.strategy not in NAMES:
        raise InputError("Strategy", given.strategy, "give one of: %s." % "; ".join(NAMES))
    if given.strategy != CONSTANT and machine is None:
        raise InputError("Machine", "''", "the strategy '%s' needs a machine file." % given.strategy)
    if given.strategy == LOCKED and not machine.model.spindle_lock:
        raise InputError(
            "Strategy",
            given.strategy,
            "the machine %s says that its controller cannot follow the spindle." % machine.key,
        )
    clearances = []

    def plan(spindle):
        if path_of:
            path, clearance = path_of(spindle), None
        else:
            turning = posture.turning if posture else []
            path, clearance = _path(given, dimples, rule, machine, spindle, turning)
        clearances.append(clearance)
        return path

    path = plan(given.spindle)
    clearance = clearances[0]
    feed = core.posted_feed(given.feed, given.decimals)
    verdict = None
    if machine is not None:
        verdict = core.judge_plan(plan, dimples, given.tool, given.spindle, rule, machine.model)
        period = core.phase_period(given.tool.flutes, rule)
        if not given.calibrating and machine.start_phase:
            path = core.with_start_phase(path, machine.start_phase % period, period, given.decimals)
    if posture is not None:
        text = tool_posture.finish(posture, path, given, machine)
        return Pacing(posture.work.path, text, feed, verdict, clearance, posture)
    return Pacing(path, _text(given, path, feed, machine), feed, verdict, clearance)


def path_at(given, dimples, rule, machine, spindle, posture=None):
    """The ToolPath of the dimples with another spindle, for the ball centre. Raises InputError as make()."""
    return _path(given, dimples, rule, machine, spindle, posture.turning if posture else [])[0]


def _path(given, dimples, rule, machine, spindle, turning):
    heights = {"safe_height": given.safe_height, "clearance_height": given.clearance_height}
    if given.strategy in (CONSTANT, FITTED):
        path = core.constant_feed_path(
            dimples, given.tool, spindle, given.feed, rule, decimals=given.decimals, **heights
        )
        if given.strategy == FITTED:
            feed = core.posted_feed(given.feed, given.decimals)
            path = core.fit_to_stops(path, machine.model, feed, rule, given.decimals)
        return path, None
    across = rows.across_patches(given)
    paced = core.PacedRule(
        given.strategy == LOCKED, rule, given.lift, **heights, turning=turning, rows=across
    )
    return core.paced_path(dimples, given.tool, spindle, paced, machine.model, given.decimals)


def _text(given, path, feed, machine):
    if given.strategy in (CONSTANT, FITTED):
        # the motion model of a machine without a path tolerance counts on a stop at every vertex
        stops = machine is not None and machine.data["path_tolerance_mm"] == 0.0
        return core.freecad_text(path, feed, given.decimals, exact_stop=stops)
    return core.freecad_paced_text(path, machine.model, given.decimals)
