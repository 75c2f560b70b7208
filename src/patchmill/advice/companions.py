"""Operations that share the faces of a texture, each from another side (sides.py): in the same job where the
tool leans, in a job of its own for each clamping.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.freecad import host, kinds
from patchmill.operations.base import create

LAID = "On surface"  # of Mapping: then the lattice is the same from all sides
LATTICE = ("Mapping", "TextureKind", "Spacing", "Rotation", "Margin", "AutoOrigin", "Origin")


def of(obj):
    """The other active texture operations of the document on the faces of `obj`, with a lattice that is laid
    on them; whether it is the same lattice is said by have_lattice_of()."""
    with host.active_document(obj.Document):
        others = [other for job in host.jobs() for other in job.Operations.Group if other is not obj]
    textures = [other for other in others if kinds.kind_of(other) == kinds.TEXTURE and host.is_active(other)]
    here = _faces_of(obj)
    return [other for other in textures if _is_laid(other) and _faces_of(other) == here]


def inputs(obj):
    """TextureInputs of those of them that mill dimples of the same lattice as `obj`. Raises InputError."""
    if not _is_laid(obj):
        return []
    lattice = _lattice_of(obj)
    return [other.Proxy.texture_input(other) for other in of(obj) if _lattice_of(other) == lattice]


def _is_laid(obj):
    return getattr(obj, "Mapping", "") == LAID


def _lattice_of(obj):
    values = [getattr(obj, name, None) for name in LATTICE]
    return [getattr(value, "Value", value) for value in values]


def _faces_of(obj):
    """[(document object that the job's model stands for, names of faces)]."""
    job = host.PathUtils.findParentJob(obj)
    return [(_part_of(job, model).Name, sorted(names)) for model, names in obj.Base]


def _part_of(job, model):
    return host.base_of(job, model) if model in job.Model.Group else model


def make(obj, in_same_job):
    """A further texture operation of the same kind on the faces of `obj`; in a job of its own over the same
    parts, with a tool, a stock and a post like those of the job of `obj`, if not `in_same_job`."""
    job = host.PathUtils.findParentJob(obj)
    own = job if in_same_job else _another_job(job, obj.ToolController)
    made = create(type(obj.Proxy), obj.Name, None, own)
    made.ToolController = obj.ToolController if in_same_job else host.tool_controllers(own)[0]
    models = dict(zip(job.Model.Group, own.Model.Group))
    made.Base = [(models.get(model, model), list(names)) for model, names in obj.Base]
    return made


def copy_values(obj, other):
    """Gives `other` the values of all properties of `obj` that a user sets."""
    for row in obj.Proxy.properties():
        setattr(other, row[1], getattr(obj, row[1]))
    other.CoolantMode = obj.CoolantMode


def _another_job(job, controller):
    made = host.create_job("Job", [host.base_of(job, model) for model in job.Model.Group])
    for name in ("PostProcessor", "PostProcessorArgs", "Fixtures"):
        setattr(made, name, getattr(job, name))
    tool, feed = controller.Tool, 60.0 * controller.HorizFeed.Value
    flutes, speed = tool.Flutes, controller.SpindleSpeed
    host.add_ball_end_controller(made, tool.Diameter.Value, flutes, feed, speed, controller.SpindleDir)
    for name in ("ExtXneg", "ExtXpos", "ExtYneg", "ExtYpos", "ExtZneg", "ExtZpos"):
        if hasattr(job.Stock, name) and hasattr(made.Stock, name):
            setattr(made.Stock, name, getattr(job.Stock, name))
    made.Document.recompute([*made.Model.Group, made.Stock])
    return made
