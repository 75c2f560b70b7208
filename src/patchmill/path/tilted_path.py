"""A path with a tilted tool as FreeCAD commands: rotary words by the machine file, for a controller that
keeps the tool tip (TCP). Timed moves are in inverse time, so that the time of each is the machine's too when
only its axes turn.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.machine import machines
from patchmill.path.base_path import CYCLES

# words that would end inverse time or TCP on the way, or have a feed of their own
NOT_TILTED = CYCLES | {"G49", "G94", "M6", "M06"}
CENTRE_ERROR = 0.0005  # mm
MOST_HALVINGS = 12
BLEND = 0.0005  # mm: LinuxCNC may round corners by so much, and does


def machine_of(name):
    """The machines.Machine for a tilted path. Raises InputError naming Machine."""
    if not name:
        raise InputError("Machine", "''", "name a machine file with rotary axes: they tilt the tool.")
    machine = machines.load(name)
    if not machine.rotary_letters:
        raise InputError("Machine", name, "it has no rotary axes: choose a machine that has, or only Feed.")
    if not machine.controller["tcp"]:
        raise InputError("Machine", name, "its controller does not keep the tool tip: choose one with TCP.")
    for word in ("tcp_on", "tcp_off"):
        if not re.fullmatch(r"[GM]\d+(\.\d+)?", machine.controller.get(word, "")):
            raise InputError(
                "Machine file %s: /controller/%s" % (name, word),
                repr(machine.controller.get(word, "")),
                "a path in FreeCAD needs one G or M word here.",
            )
    return machine


def with_angles(path, source, machine):
    """(path, source, joints [rad] at its start and at the end of each move). Moves get the time that the
    rotary axes need, and are halved where the axes, turning evenly, would take the ball centre off its line:
    near a pole one of them turns far while the tool hardly tilts. Raises InputError naming TiltLimit."""
    kinematics = machine.kinematics
    for _ in range(MOST_HALVINGS):
        try:
            joints = core.plan_path_joints(kinematics, path).joints
        except InputError as error:
            raise InputError("TiltLimit", error.value, "%s Tilt less." % error.remedy) from error
        halve = (centre_error(path, joints, kinematics) > CENTRE_ERROR) & (path.kinds != core.MoveKind.RAPID)
        if not halve.any():
            break
        path, source = halved(path, source, halve)
    rates = np.radians([axis["velocity_deg_s"] for axis in machine.data["rotary_axes"]])
    turned = np.abs(np.diff(joints, axis=0))[:, : len(rates)]
    needed = (turned / rates).max(axis=1) * path.spindle.speed
    turns = np.where(path.kinds == core.MoveKind.RAPID, path.turns, np.fmax(path.turns, needed))
    return remade(path, path.tips, path.axes, path.kinds, turns), source, joints


def centre_error(path, joints, kinematics):
    """How far the ball centre is from the middle of its line half-way through each move [mm]."""
    middle = 0.5 * (joints[1:] + joints[:-1])
    axes = np.array([_tool_axis(kinematics, joint) for joint in middle]).reshape(-1, 3)
    before = np.vstack([path.axes[:1], path.axes[:-1]])
    return path.tool.radius * np.linalg.norm(axes - 0.5 * (before + path.axes), axis=1)


def _tool_axis(kinematics, joint):
    return kinematics.tool_axis(joint)  # a function of its own: where these are called a stop is looked for


def halved(path, source, halve):
    """The path with the moves that `halve` says in two, the ball centre on its line and the axis between."""
    radius = path.tool.radius
    axes = np.vstack([path.axes[:1], path.axes])
    centres = np.vstack([np.array(path.start)[None], path.tips]) + radius * axes
    middle_axes = axes[1:] + axes[:-1]
    middle_axes /= np.linalg.norm(middle_axes, axis=1)[:, None]
    middle_tips = 0.5 * (centres[1:] + centres[:-1]) - radius * middle_axes
    at = np.flatnonzero(halve)
    turns = np.where(halve, 0.5 * path.turns, path.turns)
    tips, axes = np.insert(path.tips, at, middle_tips[at], 0), np.insert(path.axes, at, middle_axes[at], 0)
    kinds = np.insert(path.kinds, at, path.kinds[at])
    made = remade(path, tips, axes, kinds, np.insert(turns, at, turns[at]))
    return made, np.insert(source, at, np.asarray(source)[at])


def remade(path, tips, axes, kinds, turns):
    return core.make_path(path.tool, path.spindle, path.start, tips, axes, list(kinds), list(turns))


def _require_tiltable(commands):
    for command in commands:
        if command.Name in NOT_TILTED:
            remedy = "it cannot be with a tilted tool, whose moves are in inverse time: set Controls to Feed."
            raise InputError("Base", command.Name, remedy)


def write(base, path, source, joints, machine, make_command):
    """The commands of `base` with the tilted moves in place of its own. `source`: number of the base's move
    for each move of the path; `joints` as with_angles gives them."""
    _require_tiltable(base.commands)
    letters = machine.rotary_letters
    degrees = np.degrees(joints)[1:, : len(letters)]
    seconds = path.turns / path.spindle.speed
    command_of = np.array(base.source, dtype=int)[source]
    words = [dict(zip("XYZ" + letters, row)) for row in np.hstack([path.tips, degrees]).tolist()]
    out, done, kinds = [], 0, path.kinds
    for number, command in enumerate(base.commands):
        last = done + int(np.searchsorted(command_of[done:], number, side="right"))
        if last == done:
            out.append(command)
            continue
        if done == 0:
            out += [make_command(name) for name in (machine.controller["tcp_on"], "G93")]
            out.append(make_command("G64", {"P": BLEND}))
            # the axes may have been turned before TCP was on: over the start again
            begin = np.concatenate([path.start, np.degrees(joints)[0, : len(letters)]]).tolist()
            out.append(make_command("G0", dict(zip("XYZ" + letters, begin))))
        for i in range(done, last):
            if kinds[i] == core.MoveKind.RAPID:
                out.append(make_command("G0", words[i]))
            elif seconds[i] > 0.0:
                out.append(make_command("G1", dict(words[i], F=1.0 / seconds[i])))
        done = last
    home = {letter: 0.0 for letter in letters}
    out += [make_command("G0", home), make_command("G94"), make_command(machine.controller["tcp_off"])]
    return out
