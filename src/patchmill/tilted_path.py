"""A path with a tilted tool as FreeCAD commands: rotary words by the machine file, for a controller that
keeps the tool tip (TCP). Timed moves are in inverse time, so that the time of each is the machine's too when
only its axes turn.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill import machines

RAPID = 0
BLEND = 0.005  # mm: LinuxCNC may round corners by so much


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


def with_angles(path, machine):
    """(path, joints [rad] at its start and at the end of each move): moves get the time that the rotary axes
    need. Raises InputError naming ToolAxis or Machine."""
    try:
        posture = core.plan_path_joints(machine.kinematics, path)
    except InputError as error:
        raise InputError("TiltLimit", error.value, "%s Tilt less." % error.remedy) from error
    rates = np.radians([axis["velocity_deg_s"] for axis in machine.data["rotary_axes"]])
    turned = np.abs(np.diff(posture.joints, axis=0))[:, : len(rates)]
    needed = (turned / rates).max(axis=1) * path.spindle.speed
    turns = np.where(path.kinds == RAPID, path.turns, np.fmax(path.turns, needed))
    slowed = core.make_path(
        path.tool, path.spindle, path.start, path.tips, path.axes, list(path.kinds), list(turns)
    )
    return slowed, posture.joints


def write(base, path, source, joints, machine, make_command):
    """The commands of `base` with the tilted moves in place of its own. `source`: number of the base's move
    for each move of the path; `joints` as with_angles gives them."""
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
        for i in range(done, last):
            if kinds[i] == RAPID:
                out.append(make_command("G0", words[i]))
            elif seconds[i] > 0.0:
                out.append(make_command("G1", dict(words[i], F=1.0 / seconds[i])))
        done = last
    home = {letter: 0.0 for letter in letters}
    out += [make_command("G0", home), make_command("G94"), make_command(machine.controller["tcp_off"])]
    return out
