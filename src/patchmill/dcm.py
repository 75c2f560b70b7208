"""Feed and posture of a FreeCAD path from a RemovalModel: what DressupDCM does, without the document object.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, field

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill import base_path, host, machines, made_from, removal_model, tilted_path, tool_controller
from patchmill.texture_operation import ObjectTexture

STEEP = -0.5  # a move that falls by more than half its length is a plunge
INFINITE = float("inf")


@dataclass
class DcmInput:
    """mm, s, degrees; feeds in mm/s."""

    model: removal_model.ModelInput
    commands: list = field(compare=False)
    length: float  # of the base's path: with its label, what `commands` are compared by
    label: str
    tool: core.BallEndMill
    spindle: core.Spindle
    feed: bool
    posture: bool
    low: float
    high: float
    air: float
    flat: bool
    keep_plunges: bool
    reading: str
    read_at: str
    feed_tolerance: float
    axis_tolerance: float
    acceleration: float = INFINITE
    axis_rate: float = INFINITE
    holder: list = field(default_factory=list)
    clearance: float = 1.0
    machine: str = ""
    transient: tuple = ()  # time [s], step [s], diffusivity [mm^2/s], sub-steps; empty: steady


@dataclass
class Result:
    """What was made: Path.Commands, the _patchmill.ToolPath they come from and the base's, and figures."""

    commands: list
    path: core.ToolPath
    base: core.ToolPath
    steps: dict
    not_clear: int
    asked: DcmInput

    @property
    def seconds(self):
        return self.path.statistics()["timed_seconds"]

    @property
    def base_seconds(self):
        return self.base.statistics()["timed_seconds"]

    @property
    def axis_step_degrees(self):
        return math.degrees(max(self.steps["axis_per_move"], self.steps["axis_at_rest"]))


def input_of(obj):
    """DcmInput of a DressupDCM object. Raises InputError naming the property."""
    job = made_from.job_of(obj)
    feed, posture = obj.Controls != "Posture", obj.Controls != "Feed"
    operation = _operation(obj)
    if isinstance(operation.Proxy, ObjectTexture):
        raise InputError(
            "Base",
            operation.Label,
            "a texture's feed is its timing and its axis sets the phase: choose another operation.",
        )
    model = removal_model.input_of(obj, job, posture)
    limits = _limits(obj, model)
    return DcmInput(
        model=model,
        commands=obj.Base.Path.Commands,
        length=obj.Base.Path.Length,
        label=obj.Base.Label,
        tool=_tool(operation, posture),
        spindle=_spindle(operation),
        feed=feed,
        posture=posture,
        low=obj.FeedAtProduct.Value,
        high=obj.FeedAtSkin.Value,
        air=obj.FeedInAir.Value,
        flat=_is_flat(operation, obj.FeedInAir.Value),
        keep_plunges=obj.KeepPlunges,
        reading=obj.Reading,
        read_at=obj.ReadAt,
        feed_tolerance=obj.FeedTolerance.Value,
        axis_tolerance=obj.AxisTolerance.Value,
        holder=_holder(obj),
        clearance=obj.HolderClearance.Value,
        machine=obj.Machine,
        transient=_transient(obj),
        **limits,
    )


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
        path, pieces = core.hurry_in_air(path, model.grid, given.air, given.flat)
        source = source[pieces]
    if given.keep_plunges and given.feed:
        path = slow_plunges(path, planned, source)
    return Controlled(base, planned, path, source, not_clear)


def apply(given, model):
    """Result for a DcmInput and its RemovalModel. Raises InputError."""
    machine = tilted_path.machine_of(given.machine) if given.posture else None
    made = control(given, model)
    path = made.path
    if given.posture:
        path, source, joints = tilted_path.with_angles(path, made.source, machine)
        commands = tilted_path.write(made.base, path, source, joints, machine, host.Path.Command)
    else:
        commands = base_path.write(
            made.base, path, made.source, given.feed_tolerance, host.Path.Command
        )
    return Result(commands, path, made.planned, core.path_steps(path), made.not_clear, given)


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


def _operation(obj):
    """The operation under one or more dressups."""
    while not hasattr(obj, "ToolController") and getattr(obj, "Base", None) is not None:
        obj = obj.Base
    if not hasattr(obj, "ToolController"):
        raise InputError("Base", obj.Label, "there is no operation with a tool controller below it.")
    return obj


def _tool(operation, posture):
    controller = operation.ToolController
    tool_controller.require_tool(controller)
    kind = host.tool_kind(controller.Tool)
    if posture and kind != "ballend":
        raise InputError(
            "ToolController",
            "%s (%s)" % (controller.Label, kind or "unknown kind"),
            "only a ball end mill can be tilted: choose one, or set Controls to Feed.",
        )
    return core.BallEndMill(float(controller.Tool.Diameter) / 2.0, tool_controller.flutes(controller.Tool))


def _transient(obj):
    if obj.Diffusion == "Steady":
        return ()
    return (obj.DiffusionTime, obj.TimeStep, obj.Diffusivity, obj.SubSteps)


def _is_flat(operation, air):
    """Whether the tool is a cylinder; for air cuts its shape must be known."""
    kind = host.tool_kind(operation.ToolController.Tool)
    if air > 0.0 and kind not in ("ballend", "endmill"):
        raise InputError(
            "FeedInAir",
            "%g mm/min" % (60.0 * air),
            "what a tool of kind '%s' leaves is not known: give 0." % (kind or "unknown"),
        )
    return kind == "endmill"


def _spindle(operation):
    controller = operation.ToolController
    if not controller.SpindleSpeed > 0.0:
        raise InputError("SpindleSpeed", controller.SpindleSpeed, "give more than zero.")
    return core.Spindle(controller.SpindleSpeed / 60.0, tool_controller.sense(controller))


def _limits(obj, given):
    """The machine's, as arguments of DcmInput; nothing if no machine is named."""
    if not obj.Machine:
        return {}
    model = machines.load(obj.Machine).model
    largest = max([1.0] + [m.factor for m in given.materials])
    for name, factor in (("FeedAtSkin", largest), ("FeedInAir", 1.0)):
        feed = factor * getattr(obj, name).Value
        if feed > model.velocity:
            raise InputError(
                name,
                "%g mm/min" % (60.0 * feed),
                "the machine goes up to %g mm/min." % (60.0 * model.velocity),
            )
    return {"acceleration": model.acceleration}


def _holder(obj):
    sections = []
    for text in obj.Holder:
        try:
            low, high, d_low, d_high = (float(word) for word in text.split())
        except ValueError as error:
            raise InputError("Holder", repr(text), "give four numbers: from, to, two diameters.") from error
        if not (0.0 <= low < high and min(d_low, d_high) >= 0.0):
            raise InputError("Holder", repr(text), "give 0 <= from < to and diameters of 0 or more.")
        sections.append((low, high, 0.5 * d_low, 0.5 * d_high))
    return sections


def _above_ball(given):
    """The holder's frusta with heights from the ball centre; what is at the ball is left to the path."""
    radius = given.tool.radius
    out = []
    for low, high, r_low, r_high in given.holder:
        if high <= 2.0 * radius:
            continue
        start = max(low, 2.0 * radius)
        r_start = r_low + (start - low) / (high - low) * (r_high - r_low)
        out.append((start - radius, high - radius, r_start, r_high))
    return out
