"""Feed and posture of a FreeCAD path from a RemovalModel: what DressupDCM does, without the document object.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import functools
import math
from dataclasses import dataclass
from typing import Optional

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.freecad import host, tool_controller
from patchmill.machine import machines, machining_time
from patchmill.modifiers import cutting_load
from patchmill.modifiers.dcm_input import DcmInput, input_of  # noqa: F401  input_of for macros
from patchmill.path import base_path, tilted_path

STEEP = -0.5  # a move that falls by more than half its length is a plunge


@dataclass
class Result:
    """What was made: Path.Commands, the _patchmill.ToolPath they come from and the base's, and figures."""

    commands: list
    path: core.ToolPath
    base: core.ToolPath
    steps: dict
    not_clear: int
    asked: DcmInput
    load: Optional[cutting_load.LoadAlong] = None  # if it has limits
    joints: Optional[np.ndarray] = None  # [rad] at the start and at the end of each move, if it is tilted

    @functools.cached_property
    def seconds(self):
        """Time of all its moves [s]: see machining_time."""
        rounding = machining_time.UNTOLD if self.joints is None else tilted_path.BLEND
        return self._seconds(self.path, self.joints, rounding)

    @functools.cached_property
    def base_seconds(self):
        return self._seconds(self.base, None, machining_time.UNTOLD)

    def _seconds(self, path, joints, rounding):
        machine = machines.load(self.asked.machine) if self.asked.machine else None
        return machining_time.seconds(path, self.asked.rapids, machine, joints, rounding)

    @property
    def axis_step_degrees(self):
        return math.degrees(max(self.steps["axis_per_move"], self.steps["axis_at_rest"]))


@dataclass
class Controlled:
    """A base path under the voxel model: as it was planned, and as it is now; `source`: the number of the
    planned move of each move."""

    base: base_path.BasePath
    planned: core.ToolPath
    path: core.ToolPath
    source: np.ndarray
    not_clear: int


def control(given, model):
    """Controlled for a DcmInput and its RemovalModel. Raises InputError."""
    _check(given)
    base = base_path.read(given.commands, given.label)
    if not base.tips:
        raise InputError("Base", given.label, "it has no moves: recompute it.")
    planned = base.tool_path(given.tool, given.spindle)
    path, source, not_clear = core.apply_dcm(
        planned,
        model.grid,
        model.feed(given.low, given.high, given.transient) if given.feed else None,
        model.posture if given.posture else None,
        model.part if given.holder else None,
        _above_ball(given),
        clearance=given.clearance,
        reading=given.reading,
        read_at=given.read_at,
        feed_tolerance=given.feed_tolerance,
        axis_tolerance=math.radians(given.axis_tolerance),
        axis_rate=given.axis_rate,
        acceleration=given.acceleration,
    )
    if given.air > 0.0:
        path, pieces = core.hurry_in_air(path, model.grid, given.air)
        source = source[pieces]
    if given.keep_plunges and given.feed:
        path = slow_plunges(path, planned, source)
    if given.load:
        limits, stock = given.load, given.resistance
        path, pieces = cutting_load.limited(path, model.grid, stock, limits, given.acceleration)
        source = source[pieces]
    return Controlled(base, planned, path, source, not_clear)


def apply(given, model):
    """Result for a DcmInput and its RemovalModel. Raises InputError."""
    machine = tilted_path.machine_of(given.machine) if given.posture else None
    made = control(given, model)
    path, joints = made.path, None
    if given.posture:
        path, source, joints = tilted_path.with_angles(path, made.source, machine)
        commands = tilted_path.write(made.base, path, source, joints, machine, host.Path.Command)
    else:
        commands = base_path.write(
            made.base, path, made.source, given.feed_tolerance, host.Path.Command
        )
    load = cutting_load.along(path, model.grid, given.resistance) if given.load else None
    return Result(commands, path, made.planned, core.path_steps(path), made.not_clear, given, load, joints)


def slow_plunges(path, planned, source):
    """The path with moves that fall steeply no faster than they were planned."""
    start = np.vstack([np.array(path.start)[None], path.tips])[:-1]
    way = path.tips - start
    length = np.linalg.norm(way, axis=1)
    planned_start = np.vstack([np.array(planned.start)[None], planned.tips])[:-1]
    planned_length = np.linalg.norm(planned.tips - planned_start, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        slowest = length * (planned.turns / planned_length)[source]
        steep = way[:, 2] < STEEP * length
    turns = np.where(steep & np.isfinite(slowest), np.fmax(path.turns, slowest), path.turns)
    return core.make_path(
        path.tool, path.spindle, path.start, path.tips, path.axes, list(path.kinds), list(turns)
    )


def _check(given):
    if not 0.0 < given.low <= given.high:
        raise InputError(
            "FeedAtProduct",
            "%g mm/min" % (60.0 * given.low),
            "give more than zero and no more than FeedAtSkin, %g mm/min." % (60.0 * given.high),
        )
    if given.air and given.air < given.high:
        raise InputError(
            "FeedInAir", "%g mm/min" % (60.0 * given.air), "give 0 or at least FeedAtSkin."
        )
    if not given.feed_tolerance > 0.0:
        raise InputError("FeedTolerance", "%g mm/s" % given.feed_tolerance, "give more than zero.")
    if not given.axis_tolerance > 0.0:
        raise InputError("AxisTolerance", "%g degrees" % given.axis_tolerance, "give more than zero.")


def _above_ball(given):
    """The holder's frusta with heights from the ball centre; what is at the ball is left to the path."""
    radius = given.tool.radius  # only a ball end mill is tilted
    kept = [tool_controller.above(frustum, 2.0 * radius) for frustum in given.holder]
    return [(f[0] - radius, f[1] - radius, f[2], f[3]) for f in kept if f is not None]
