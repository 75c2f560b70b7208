"""A texture read back from a posted program: every move of its plan, with the spindle, the turns and the
phase that the plan counts on.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import re
from dataclasses import dataclass

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.textures import strategies, tool_posture
from patchmill.verify.posted_program import HALF_LEAD, SAVED_FEED, other_angles, trimmed

SAME_TIME = 5e-6  # of a move's: see posted_milling.SAME_FEED


@dataclass
class PostedTexture:
    """One texture of a posted program, as read back from its text: with the rapids before and after it."""

    operation: object  # document object
    path: core.ToolPath
    match: core.PlanMatch
    errors: dict  # of _patchmill.phase_errors
    unplaced: int = 0  # moves at the beginning of the path that start nobody knows where
    check: object = None  # the checks.CheckResult of gouge and collision
    offset: str = ""  # work offset of this copy
    blind: float = math.inf  # lowest Z [mm] that is told while nobody knows X and Y


def told_by(plan):
    """posted_program.Told of a PlannedTexture; feeds are looked at as turns."""
    posture = plan.posture
    path = plan.path if posture is None else posture.told.path
    ends = np.hstack([path.tips, np.zeros((len(path), 3))])
    if posture is not None:
        joints = np.degrees(posture.told.joints[1:])
        for number, letter in enumerate(plan.machine.rotary_letters):
            ends[:, 3 + "ABC".index(letter)] = joints[:, number]
    tcp = np.full(len(path), posture is not None and posture.form.tcp)
    return trimmed(ends, path.kinds != core.MoveKind.RAPID, tcp=tcp)


def find(operation, plan, told, program, after):
    """(PostedTexture, posted_program.Run) of a texture in a PostedProgram from its move `after` on. Raises
    InputError naming the operation, SpindleSpeed or PhaseTolerance."""
    half_unit = 0.5 * 10.0**-plan.input.decimals
    run = program.find(told, half_unit, after)
    if not run.complete:
        begun = told.cuts[: run.found].sum()
        timed = plan.path.dimples[plan.path.kinds != core.MoveKind.RAPID]
        dimples = (timed[:begun] != core.NO_DIMPLE).sum() if plan.posture is None else 0
        raise InputError(
            operation.Label,
            "%d of %d dimples read back" % (dimples, plan.counts["cut"]),
            other_angles(program, told, half_unit, after),
        )
    last = run.end + next(iter(np.flatnonzero(program.cuts[run.end :])), len(program) - run.end)
    last = min(last, int(program.begins[program.section_of(run.end - 1)[0] + 1]))
    section = program.part(after, last, plan.input.tool)
    if plan.posture is not None:
        complete, match, path = tool_posture.read_back(section, plan.posture, plan.machine, half_unit)
    else:
        path = section.path
        match = core.match_plan(path, plan.path, half_unit)
        complete = match.complete
    if not complete:
        said = "%d of %d dimples read back" % (match.found, plan.counts["cut"])
        raise InputError(
            operation.Label, said, "the post-processor changed the path: use another one."
        )
    _check_spindle(plan, path)
    _require_paces(operation, plan, section, program)
    path = as_rounded(plan, path)
    blind = program.lowest_blind(section.lines[: section.unplaced])
    errors = _errors(operation, plan, path)
    return PostedTexture(operation, path, match, errors, section.unplaced, blind=blind), run


def as_rounded(plan, path):
    """The ToolPath of a section that was read, a locked one with the turns that its K words amount to: at a
    rounded corner the way is shorter, and K is smaller by as much. So moves take the plan's turns, times what
    they are told over what the planned words tell. They are led by the spindle, and their corners are as the
    plan has them: those words are checked by themselves."""
    if plan.thread is not None or not strategies.of(plan.input.strategy).locked:
        return path
    planned = _planned_words(plan).path
    timed, told = (one.kinds != core.MoveKind.RAPID for one in (path, planned))
    own = plan.path.kinds != core.MoveKind.RAPID
    if not timed.sum() == told.sum() == own.sum():
        return path
    path = core.with_pacing_of(path, plan.path)
    turns = np.array(path.turns)
    turns[timed] *= plan.path.turns[own] / planned.turns[told]
    return core.with_turns(path, turns.tolist())


def _planned_words(plan):
    """The section that the plan's own words are read as."""
    head = "%s S%d\n" % (plan.input.spindle.sense, round(60.0 * plan.input.spindle.speed))
    words = re.sub(
        r"F([0-9.]+)", lambda f: "F%.9f" % (60.0 * float(f.group(1))), str(plan.pacing.text)
    )
    return core.read_gcode(head + words, plan.input.tool, rotary=plan.posture is not None)[-1]


def _errors(op, plan, path):
    """Phase errors of what was read back. Raises InputError if they are not the plan's."""
    if plan.thread is None and not strategies.of(plan.input.strategy).phase_in_text:
        return plan.predicted_errors()
    errors = plan.phase_errors(path)
    largest = math.degrees(errors["largest"])
    if not largest <= op.PhaseTolerance.Value or errors["runs"] != 1:
        raise InputError(
            "PhaseTolerance",
            "%.4g degrees" % op.PhaseTolerance.Value,
            "the posted text has a phase error of %.4g degrees in %d runs: post more decimals."
            % (largest, errors["runs"]),
        )
    return errors


def _require_paces(op, plan, section, program):
    """Every timed move of a section has the F or K that the planned words say, to the last decimal that the
    program writes. Where a control has no inverse time, F is what takes as long."""
    want, have = (_paces(one) for one in (_planned_words(plan), section))
    if len(want["feeds"]) == len(have["feeds"]):
        near = program.half_feed + SAVED_FEED + 1e-9 * np.nan_to_num(want["feeds"])
        off = np.abs(want["feeds"] - have["feeds"]) > near
        off |= np.isnan(want["feeds"]) != np.isnan(have["feeds"])
        off |= np.abs(want["leads"] - have["leads"]) > HALF_LEAD * have["slants"]
        other = want["inverse"] != have["inverse"]
        timed = np.abs(want["turns"] - have["turns"]) > want["turns"] * (
            SAME_TIME + program.half_feed / np.nan_to_num(have["feeds"], nan=1.0)
        )
        off = np.where(other & ~np.isnan(want["turns"]), timed, off)
        if not off.any():
            return
        line = section.lines[int(have["moves"][np.flatnonzero(off)[0]])]
        said = "other K or F words in line %d" % line
    else:
        said = "other K or F words"
    raise InputError(op.Label, said, "the post-processor does not keep them: use patchmill_linuxcnc.")


def _paces(section):
    """What the timed moves of a section are told, by name, and their numbers under "moves"."""
    path = section.path
    moves = np.flatnonzero(path.kinds != core.MoveKind.RAPID)
    steps = np.diff(np.vstack([np.array(path.start)[None], path.tips]), axis=0)
    way, longest = np.linalg.norm(steps, axis=1), np.abs(steps).max(axis=1)
    locked = np.isnan(section.feeds)
    with np.errstate(divide="ignore", invalid="ignore"):
        leads = np.where(locked, way / path.turns, np.nan)
        slants = way / longest
    named = {"feeds": section.feeds, "inverse": section.inverse & ~locked, "leads": leads}
    named |= {"turns": path.turns, "slants": slants}
    return {name: values[moves] for name, values in named.items()} | {"moves": moves}


def _check_spindle(plan, path):
    want, have = plan.input.spindle, path.spindle
    if have.sense != want.sense or abs(have.speed - want.speed) > 1e-9:
        raise InputError(
            "SpindleSpeed",
            "%g rpm %s" % (60.0 * want.speed, want.sense),
            "the posted text turns the spindle at %g rpm %s." % (60.0 * have.speed, have.sense),
        )
