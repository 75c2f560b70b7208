"""What DressupDCM asks for, read from its properties, its job and its operation, with an InputError where
that is wrong; dcm computes with it.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field
from typing import Optional

import _patchmill as core
from _patchmill import InputError

from patchmill.freecad import host, made_from, tool_controller
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.machine import machines
from patchmill.modifiers import cutting_load
from patchmill.voxels import removal_model

INFINITE = float("inf")


@dataclass
class DcmInput:
    """mm, s, degrees; feeds in mm/s."""

    model: removal_model.ModelInput
    commands: list = field(compare=False)
    length: float  # of the base's path: with its label, what `commands` are compared by
    label: str
    tool: core.Tool
    spindle: core.Spindle
    feed: bool
    posture: bool
    low: float
    high: float
    air: float
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
    rapids: tuple = (0.0, 0.0)  # of the tool controller, across and up or down
    load: Optional[cutting_load.Limits] = None  # of the cutting load; None: there are none
    resistance: Optional[cutting_load.Resistance] = None
    transient: tuple = ()  # time [s], step [s], diffusivity [mm^2/s], sub-steps; empty: steady


def input_of(obj):
    """DcmInput of a DressupDCM object. Raises InputError naming the property."""
    job = made_from.job_of(obj)
    feed, posture = obj.Controls != "Posture", obj.Controls != "Feed"
    operation = _operation(obj)
    if kind_of(operation) == TEXTURE:
        raise InputError(
            "Base",
            operation.Label,
            "a texture's feed is its timing and its axis sets the phase: choose another operation.",
        )
    model = removal_model.input_of(obj, job, posture)
    limits = _limits(obj, model)
    load = cutting_load.limits_of(obj) if feed else None
    if load:
        require_known_load(obj, operation.ToolController)
    holder = _holder(obj)
    return DcmInput(
        model=model,
        commands=obj.Base.Path.Commands,
        length=obj.Base.Path.Length,
        label=obj.Base.Label,
        tool=_tool(operation, posture, obj.FeedInAir.Value, holder),
        spindle=_spindle(operation),
        feed=feed,
        posture=posture,
        low=obj.FeedAtProduct.Value,
        high=obj.FeedAtSkin.Value,
        air=obj.FeedInAir.Value,
        keep_plunges=obj.KeepPlunges,
        reading=obj.Reading,
        read_at=obj.ReadAt,
        feed_tolerance=obj.FeedTolerance.Value,
        axis_tolerance=obj.AxisTolerance.Value,
        holder=holder,
        clearance=obj.HolderClearance.Value,
        machine=obj.Machine,
        rapids=tool_controller.rapids(operation.ToolController),
        load=load,
        resistance=cutting_load.resistance_of(obj) if load else None,
        transient=_transient(obj),
        **limits,
    )


def _operation(obj):
    """The operation under one or more dressups."""
    while hasattr(getattr(obj, "Base", None), "Path"):
        obj = obj.Base
    if not hasattr(obj, "ToolController"):
        raise InputError("Base", obj.Label, "there is no operation with a tool controller below it.")
    return obj


def _tool(operation, posture, air, holder):
    """With the dressup's own holder where it has one, else with that of the operation."""
    controller = operation.ToolController
    tool_controller.require_tool(controller)
    if posture:
        remedy = "only a ball end mill can be tilted: choose one, or set Controls to Feed."
        tool_controller.require_ball_end(controller, remedy)
    _require_known_end(operation, air)
    tool = tool_controller.any_cutter(controller, operation)
    return tool_controller.with_holder(tool, holder) if holder else tool


def _transient(obj):
    if obj.Diffusion == "Steady":
        return ()
    return (obj.DiffusionTime, obj.TimeStep, obj.Diffusivity, obj.SubSteps)


def _require_known_end(operation, air):
    """For air cuts the tool's shape must be known."""
    bit = operation.ToolController.Tool
    if air > 0.0 and not tool_controller.is_known(bit):
        raise InputError(
            "FeedInAir",
            "%g mm/min" % (60.0 * air),
            "what a tool of kind '%s' leaves is not known: give 0." % (host.tool_kind(bit) or "unknown"),
        )


def require_known_load(obj, controller):
    """For the cutting load the tool's shape and flutes must be known. Raises InputError naming a limit of the
    DressupDCM `obj`, or Flutes."""
    tool_controller.require_flutes(controller)
    if not tool_controller.is_known(controller.Tool):
        limits = [(name, value) for name, value in cutting_load.given(obj).items() if value]
        name, value = limits[0] if limits else ("ForceLimit", 0.0)
        kind = host.tool_kind(controller.Tool) or "unknown"
        text = "%g %s" % (value, cutting_load.UNITS[name])
        raise InputError(name, text, "how a tool of kind '%s' cuts is not known: choose another tool." % kind)


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
