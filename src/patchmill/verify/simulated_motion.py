"""What moves the tool in a simulation of cutter marks: the planned path, a path or program read back, one of
them as a machine would run it, or a recording.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.system import files
from patchmill.machine import machines
from patchmill.textures import tool_posture
from patchmill.verify import posted_texture
from patchmill.verify.posted_program import PostedProgram


def motion_of(plan, path, program, dialect, machine, samples):
    """(_patchmill.ToolMotion, a phrase that says where it comes from); the arguments are those of
    simulation.simulate. Raises InputError naming Path, Program, Machine or Samples."""
    if sum(given is not None for given in (path, program, samples)) > 1:
        raise InputError("Path", "several motions", "give one of path, program and samples.")
    if samples is not None:
        if plan.posture is not None:
            raise InputError("Samples", "rotary axes", "recordings are cut with an upright tool only.")
        if machine is not None:
            raise InputError("Machine", machine, "a recording has its machine in it: leave it out.")
        return _recorded(plan, samples), "recorded on a machine"
    if program is not None:
        path, source = read_program(plan, program, dialect), "the program " + os.path.basename(program)
    elif path is not None:
        source = "the posted text, read back"
    else:
        path, source = plan.path, "the plan"
    housing = _housing(plan, path)
    if machine is None:
        return core.motion_of_path(path, plan.dimples, plan.rule, housing=housing), source
    if not isinstance(machine, machines.Machine):
        machine = machines.load(machine)
    if plan.thread is not None:  # one straight move of all axes, which the spindle leads
        motion = core.motion_of_path(path, plan.dimples, plan.rule, housing=housing)
        return motion, "%s, as %s would run it" % (source, machine.data["name"])
    known, reason, moved = core.path_on_machine(path, machine.model)
    if not known:
        raise InputError("Machine", machine.key, "its motion is not known: %s." % reason)
    start = core.best_start_phase(moved, plan.dimples, plan.rule)
    motion = core.motion_of_path(moved, plan.dimples, plan.rule, start, housing)
    return motion, "%s, as %s would run it" % (source, machine.data["name"])


def _housing(plan, path):
    """Azimuth 0 of the spindle's housing in the work frame at a path's start and at each move's end,
    (n + 1, 3), as the planned angles of the rotary axes make it; None for an upright tool. The timed moves of
    `path` are those of the plan."""
    if plan.posture is None:
        return None
    planned = core.housing_x(plan.posture.kinematics, plan.posture.work.joints)
    if len(path) == len(plan.path):
        return planned
    timed = path.kinds != core.MoveKind.RAPID
    number = np.concatenate([[0], np.flatnonzero(plan.path.kinds != core.MoveKind.RAPID) + 1])
    if timed.sum() + 1 != len(number):
        raise InputError("Path", "%d timed moves" % timed.sum(), "give a path of this texture's plan.")
    return planned[number[np.concatenate([[0], np.cumsum(timed)])]]


def _recorded(plan, samples):
    try:
        rows = np.asarray(samples, float)
    except ValueError:
        rows = np.zeros(0)
    if rows.ndim != 2 or rows.shape[1] != 5 or len(rows) < 2 or not np.isfinite(rows).all():
        raise InputError(
            "Samples", "shape %s" % (rows.shape,), "give finite rows (time, x, y, z, spindle azimuth)."
        )
    given = plan.input
    return core.motion_of_samples(
        rows[:, 0], rows[:, 1:4], rows[:, 4], given.spindle, given.tool.radius
    )


def read_program(plan, filename, dialect):
    """The ToolPath of the section of a G-code file that holds the plan, with the turns that its words amount
    to. Raises InputError naming Program."""
    return posted_texture.as_rounded(plan, _section(plan, filename, dialect))


def _section(plan, filename, dialect):
    text = files.read_text(filename, "Program", other="latin-1")
    best, found = None, -1
    half_unit = 0.5 * 10.0**-plan.input.decimals
    program = PostedProgram(text, dialect)
    run = program.find(posted_texture.told_by(plan), half_unit)
    if run.complete:  # also between other operations of its tool
        section = program.part(run.first, run.end, plan.input.tool)
        if plan.posture is not None:
            return tool_posture.read_back(section, plan.posture, plan.machine, half_unit)[2]
        path = section.path
        core.match_plan(path, plan.path, half_unit)
        return path
    for section in core.read_gcode(text, plan.input.tool, dialect, rotary=plan.posture is not None):
        path = section.path
        if plan.posture is None:
            match = core.match_plan(path, plan.path, half_unit)
        else:
            _, match, path = tool_posture.read_back(section, plan.posture, plan.machine, half_unit)
        if match.found > found:
            best, found = path, match.found
    if found < 1:
        raise InputError("Program", filename, "none of its moves end on the texture's dimples.")
    return best
