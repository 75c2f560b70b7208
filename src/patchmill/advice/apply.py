"""Takes choices and remedies over into documents: an operation's properties, its tool controller's feed and
speed where nobody else uses it, how the part lies in the job, and the other operations that share its faces.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import patchmill
from _patchmill import InputError
from FreeCAD import Placement, Rotation, Vector

from patchmill.advice import assessment, cells, choice, companions
from patchmill.freecad import host, tool_controller
from patchmill.geometry import shapes
from patchmill.properties.property_table import property_of

CONTROLLER = ("feed", "spindle", "tool")  # fields that are the tool controller's


def others_of(obj):
    """The other operations of an operation's job."""
    job = host.PathUtils.findParentJob(obj)
    return [o for o in job.Operations.Group if o is not obj] if job else []


def controller_is_free(obj):
    """Whether no other operation uses the tool controller of `obj`."""
    return all(getattr(other, "ToolController", None) is not obj.ToolController for other in others_of(obj))


def set_fields(obj, fields):
    """Gives the operation, and its tool controller if that is free, the values of TextureInput's fields;
    those that they have stay untouched."""
    for name, value in fields.items():
        if name not in CONTROLLER:
            value = Vector(*value) if isinstance(value, tuple) else value
            _set(obj, property_of(name), value)
        elif controller_is_free(obj):
            _set_controller(obj.ToolController, name, value)


def _set_controller(controller, name, value):
    """`feed` [mm/s], across and down, `spindle`, a _patchmill.Spindle, or `tool`, a ball that is another
    _patchmill.Tool."""
    if name == "feed":
        for own in ("HorizFeed", "VertFeed"):
            _set(controller, own, value)
    elif name == "tool":
        tool_controller.set_ball(controller, 2.0 * value.radius, value.cutting_length)
    else:
        _set(controller, "SpindleSpeed", float(round(60.0 * value.speed)))


def _set(obj, name, value):
    now = getattr(obj, name)
    if getattr(now, "Value", now) != value:
        setattr(obj, name, value)


def take_for(operation):
    """Gives a texture operation the values that suit it, as a new one gets them in the GUI. Returns the
    choice.Choice; None, and nothing is changed, where the texture cannot be made whatever they are:
    patchmill.recompute says why."""
    assess = assessment.with_simulation(cells.Once(patchmill.simulate))
    free = controller_is_free(operation)
    try:
        found = choice.choose(assess, operation.Proxy.texture_input(operation), free)
    except InputError:
        return None
    if found is not None:
        set_fields(operation, found.fields)
    return found


def take(obj, remedy):
    """Takes a remedies.Remedy over; returns the other operations that share the faces from then on: what
    earlier ones did that are not needed any more is as it was."""
    job = host.PathUtils.findParentJob(obj)
    lay = [model.Placement for model in job.Model.Group]
    earlier = companions.of(obj) if remedy.others else []
    _take_side(obj, remedy)
    made = []
    for side in remedy.others:
        other = earlier.pop(0) if earlier else companions.make(obj, in_same_job=side.axis is None)
        companions.copy_values(obj, other)
        if side.axis is not None:
            for model, placement in zip(host.PathUtils.findParentJob(other).Model.Group, lay):
                model.Placement = placement
        _take_side(other, side)
        made.append(other)
    return made


def _take_side(obj, side):
    """Turns the part, if `side`, a sides.Side or a remedies.Remedy, says so, and sets the fields."""
    if side.axis is not None and "fixed_axis" not in side.fields:
        incline(host.PathUtils.findParentJob(obj), side.axis, side.angle)
    set_fields(obj, side.fields)
    obj.Proxy.refresh_heights(obj)


def incline(job, axis, angle):
    """Turns all of a job's model by `angle` [degrees] about `axis` through its middle: how it is clamped. A
    stock that FreeCAD makes around the model goes with it, which by itself it would not."""
    before = _box_of(job)
    turn = Placement(Vector(), Rotation(Vector(*axis), angle), before.Center)
    for model in job.Model.Group:
        model.Placement = turn.multiply(model.Placement)
    if hasattr(job.Stock, "ExtZneg"):  # made around the model, from the corner where that was at first
        job.Stock.Placement.Base += _least_corner(_box_of(job)) - _least_corner(before)
    job.Document.recompute([*job.Model.Group, job.Stock])


def _box_of(job):
    """The BoundBox of a job's model."""
    box = FreeCAD.BoundBox()
    for model in job.Model.Group:
        box.add(model.Shape.BoundBox)
    return box


def _least_corner(box):
    return Vector(box.XMin, box.YMin, box.ZMin)


def can_incline(obj):
    """Whether the job's part can be turned without spoiling what else the job does."""
    return not others_of(obj)


def model_of(obj, texts=None):
    """BREP texts of the job's model: all of it is turned when the part is, and the tool is to keep off it.
    `texts`: a shapes.BrepTexts that keeps them for the next time."""
    drawn = [shapes.drawn(model) for model in host.PathUtils.findParentJob(obj).Model.Group]
    texts = texts or shapes.BrepTexts()
    return texts.of([[shape] for shape in drawn if shape is not None], lambda group: group[0])
