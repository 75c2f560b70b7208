"""Takes choices and remedies over into documents: an operation's properties, its tool controller's feed where
nobody else uses it, and how the part lies in the job.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
from FreeCAD import Placement, Rotation, Vector

from patchmill.freecad import host
from patchmill.properties.property_table import property_of


def others_of(obj):
    """The other operations of an operation's job."""
    job = host.PathUtils.findParentJob(obj)
    return [o for o in job.Operations.Group if o is not obj] if job else []


def feed_is_free(obj):
    """Whether no other operation uses the tool controller of `obj`."""
    return all(getattr(other, "ToolController", None) is not obj.ToolController for other in others_of(obj))


def set_fields(obj, fields, feed_factor=1.0):
    """Gives the operation the values of TextureInput's fields; those that it has stay untouched."""
    for name, value in fields.items():
        own = property_of(name)
        value = Vector(*value) if isinstance(value, tuple) else value
        if getattr(obj, own) != value:
            setattr(obj, own, value)
    if feed_factor != 1.0 and feed_is_free(obj):
        set_feed(obj, obj.ToolController.HorizFeed.Value * feed_factor)


def set_feed(obj, feed):
    """Gives the operation's tool controller a feed [mm/s], across and down."""
    for name in ("HorizFeed", "VertFeed"):
        if getattr(obj.ToolController, name).Value != feed:
            setattr(obj.ToolController, name, feed)


def take(obj, remedy):
    """Takes a remedies.Remedy over."""
    if remedy.kind == "incline":
        incline(host.PathUtils.findParentJob(obj), remedy.axis, remedy.angle)
    set_fields(obj, remedy.fields, remedy.feed_factor)
    obj.Proxy.refresh_heights(obj)


def incline(job, axis, angle):
    """Turns all of a job's model by `angle` [degrees] about `axis` through its middle: how it is clamped."""
    box = FreeCAD.BoundBox()
    for model in job.Model.Group:
        box.add(model.Shape.BoundBox)
    turn = Placement(Vector(), Rotation(Vector(*axis), angle), box.Center)
    for model in job.Model.Group:
        model.Placement = turn.multiply(model.Placement)
    job.Document.recompute([*job.Model.Group, job.Stock])


def can_incline(obj):
    """Whether the job's part can be turned without spoiling what else the job does."""
    return not others_of(obj)
