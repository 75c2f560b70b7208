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
from patchmill.verify.posted_program import other_angles, trimmed


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
    return trimmed(ends, path.kinds > 0)


def find(operation, plan, told, program, after):
    """(PostedTexture, posted_program.Run) of a texture in a PostedProgram from its move `after` on. Raises
    InputError naming the operation, SpindleSpeed or PhaseTolerance."""
    half_unit = 0.5 * 10.0**-plan.input.decimals
    run = program.find(told, half_unit, after)
    if not run.complete:
        begun = told.cuts[: run.found].sum()
        dimples = (plan.path.dimples[plan.path.kinds > 0][:begun] >= 0).sum() if plan.posture is None else 0
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
    blind = program.lowest_blind(section.lines[: section.unplaced])
    errors = _errors(operation, plan, path)
    return PostedTexture(operation, path, match, errors, section.unplaced, blind=blind), run


def _errors(op, plan, path):
    """Phase errors of what was read back. Raises InputError if they, or the paces, are not the plan's."""
    if not strategies.of(plan.input.strategy).phase_in_text:
        _check_paces(op, plan, path)
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


def _check_paces(op, plan, path):
    """Every timed move of the text takes the turns that the planned words say: K and F are whole."""
    spindle = plan.input.spindle
    head = "%s S%d\n" % (spindle.sense, round(60.0 * spindle.speed))
    words = re.sub(
        r"F([0-9.]+)", lambda f: "F%.6f" % (60.0 * float(f.group(1))), str(plan.pacing.text)
    )
    rotary = plan.posture is not None
    planned_path = core.read_gcode(head + words, plan.input.tool, rotary=rotary)[-1].path
    core.match_plan(planned_path, plan.posture.told.path if rotary else plan.path, 1e-6)
    timed = [p.turns[p.kinds > 0] for p in (planned_path, path)]
    if len(timed[0]) == len(timed[1]):
        both_unknown = np.isnan(timed[0]) & np.isnan(timed[1])
        off = np.where(both_unknown, 0.0, np.abs(timed[0] - timed[1]) / np.maximum(timed[0], 1e-3))
        if np.nanmax(off) < 1e-4 and not np.isnan(off).any():
            return
    raise InputError(
        op.Label,
        "other K or F words",
        "the post-processor does not keep them: use patchmill_linuxcnc.",
    )


def _check_spindle(plan, path):
    want, have = plan.input.spindle, path.spindle
    if have.sense != want.sense or abs(have.speed - want.speed) > 1e-9:
        raise InputError(
            "SpindleSpeed",
            "%g rpm %s" % (60.0 * want.speed, want.sense),
            "the posted text turns the spindle at %g rpm %s." % (60.0 * have.speed, have.sense),
        )
