"""Takes choices and remedies over into documents: an operation's properties, its tool controller's feed and
speed where nobody else uses it, and how the part lies in the job.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
from FreeCAD import Placement, Rotation, Vector

from patchmill.freecad import host
from patchmill.properties.property_table import property_of

CONTROLLER = ("feed", "spindle")  # fields that are the tool controller's


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
    """`feed` [mm/s], across and down, or `spindle`, a _patchmill.Spindle."""
    if name == "feed":
        for own in ("HorizFeed", "VertFeed"):
            _set(controller, own, value)
    else:
        _set(controller, "SpindleSpeed", float(round(60.0 * value.speed)))


def _set(obj, name, value):
    now = getattr(obj, name)
    if getattr(now, "Value", now) != value:
        setattr(obj, name, value)


def take(obj, remedy):
    """Takes a remedies.Remedy over."""
    if remedy.kind == "incline":
        incline(host.PathUtils.findParentJob(obj), remedy.axis, remedy.angle)
    set_fields(obj, remedy.fields)
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


def model_of(obj):
    """BREP texts of the job's model, all of which incline() turns; () where it may not be turned."""
    if not can_incline(obj):
        return ()
    return [model.Shape.exportBrepToString() for model in host.PathUtils.findParentJob(obj).Model.Group]
