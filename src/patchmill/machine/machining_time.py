"""How long a path takes: rapids, links, accelerations and turns of the rotary axes counted by the motion
model of the machine; without a machine by the feeds and by the tool controller's rapids. All that shows a
time takes it from here: properties, FreeCAD's CycleTime, header, panel and reports.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
import numpy as np

# mm within which corners are taken to be rounded by a control that is told nothing of them: LinuxCNC's G64
# without P rounds by a quarter of the shorter move, and its log is met best by this (docs/posts.md)
UNTOLD = 0.1


def seconds(path, rapids=(0.0, 0.0), machine=None, joints=None, rounding=0.0):
    """Time [s] of a _patchmill.ToolPath. `rapids`: the tool controller's, across and up or down [mm/s], 0: in
    no time; taken where no machine is named. `machine`: a machines.Machine, whose own limits are taken;
    `joints`: (n + 1, 2) angles of its rotary axes [rad] at the path's start, to which they turn from zero,
    and at the end of each move. `rounding`: corners are rounded within so much [mm] where the program allows
    more than the machine file does."""
    if not len(path):
        return 0.0
    if machine is None:
        return float(_without_acceleration(path, *rapids).sum())
    model = machine.rounding(max(rounding, machine.data["path_tolerance_mm"]))
    known, _, moved = core.path_on_machine(path, model)
    if known:
        each = moved.turns / path.spindle.speed
    else:  # such as with a limit of jerk: rapids from rest to rest, feeds as planned
        each = _stop_to_stop(path, model)
    if joints is not None:
        alone = path.kinds == core.MoveKind.RAPID
        alone |= _lengths(path) == 0.0
        each = np.where(alone, np.fmax(each, _turning(joints, machine)), each)
        before = _turning(np.vstack([np.zeros(joints.shape[1]), joints[:1]]), machine)
        each = np.concatenate([before, each])
    return float(np.nansum(each))


def clock(seconds):
    """A time as FreeCAD's CycleTime has it, HH:MM:SS."""
    minutes, rest = divmod(round(seconds), 60)
    return "%02d:%02d:%02d" % (*divmod(minutes, 60), rest)


def in_words(seconds):
    """A time as programs and reports have it."""
    return "%d min %02d s" % divmod(round(seconds), 60)


def _ways(path):
    return np.diff(np.vstack([np.array(path.start)[None], path.tips]), axis=0)


def _lengths(path):
    return np.linalg.norm(_ways(path), axis=1)


def _without_acceleration(path, across, upright):
    ways = _ways(path)
    vertical = (ways[:, :2] == 0.0).all(axis=1)
    speed = np.where(vertical, upright, across)
    with np.errstate(divide="ignore", invalid="ignore"):
        rapid = np.where(speed > 0.0, np.linalg.norm(ways, axis=1) / speed, 0.0)
    return np.where(path.kinds == core.MoveKind.RAPID, rapid, np.nan_to_num(path.turns) / path.spindle.speed)


def _stop_to_stop(path, model):
    """Of rapids by the axis that goes the farthest, of others as planned."""
    farthest = np.abs(_ways(path)).max(axis=1)
    rapid = _from_rest(farthest, model.velocity, model.acceleration)
    return np.where(path.kinds == core.MoveKind.RAPID, rapid, path.turns / path.spindle.speed)


def _turning(joints, machine):
    """Time of each move's turns of the rotary axes, from rest to rest."""
    turns = np.abs(np.diff(np.degrees(joints), axis=0))
    limits = [(a["velocity_deg_s"], a["acceleration_deg_s2"]) for a in machine.data.get("rotary_axes", [])]
    each = [_from_rest(turns[:, k], *limit) for k, limit in enumerate(limits)]
    return np.max(each, axis=0) if each else np.zeros(len(turns))


def _from_rest(ways, velocity, acceleration):
    """Time from rest to rest over each of `ways`, without a limit of jerk."""
    short = ways < velocity**2 / acceleration
    return np.where(short, 2.0 * np.sqrt(ways / acceleration), ways / velocity + velocity / acceleration)
