"""What copy milling needs of a document, checked: tool, feeds, depths and shapes.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass
from typing import Optional

import _patchmill as core
from _patchmill import InputError

from patchmill.freecad import made_from, tool_controller
from patchmill.geometry import shapes
from patchmill.machine import machines
from patchmill.voxels import removal_model

UNDERCUTS = "Scanning with undercuts"
MODES = ["Scanning", "Contour", UNDERCUTS]
PASSES = ["Roughing and finishing", "Roughing", "Finishing"]


@dataclass
class CopyInput:
    """What copy milling needs of a document, so that it can run in any thread. mm, s; BREP texts."""

    mode: str
    passes: str
    radial: float
    axial: float
    finishing_radial: float
    allowance: float
    tolerance: float
    safe_height: float
    feed: float
    plunge_feed: float  # greatest velocity downwards
    cutting_edge: float  # length of the tool's edges; infinite if its bit does not say
    tool: core.Tool
    spindle: core.Spindle
    stock: str
    model: str
    faces: str  # '' for the whole model
    face_count: int = 0
    rapids: tuple = (0.0, 0.0)  # across, and up or down
    machine: Optional[machines.Machine] = None

    @property
    def chosen(self):
        """How many faces, in words."""
        return "1 face" if self.face_count == 1 else "%d faces" % self.face_count

    @property
    def last_radial(self):
        """Distance of the lines of the last pass."""
        own = self.finishing_radial
        return own if own > 0.0 and self.passes != "Roughing" else self.radial

    def each_pass(self, height):
        """(radial depth, axial depth, allowance) of each pass over a stock of this height."""
        passes = []
        if self.passes != "Finishing":
            passes.append((self.radial, self.axial, self.allowance))
        # the layers themselves finish the surface, unless an allowance or finer lines are asked for
        unfinished = self.allowance > 0.0 or self.last_radial != self.radial
        if self.passes == "Finishing" or (self.passes != "Roughing" and unfinished):
            # one layer from the top to the bottom of the stock; contours keep their levels
            axial = self.axial if self.mode == "Contour" else 2.0 * height + 1.0
            passes.append((self.last_radial, axial, 0.0))
        return passes


def input_of(obj):
    """CopyInput of a CopyMilling object. Raises InputError naming the property."""
    tool, feed, plunge_feed, cutting_edge = _cutting(obj)
    _check(obj, tool)
    job = made_from.job_of(obj)
    faces = _faces(obj, job)
    stock, model = removal_model.job_shapes(job)
    return CopyInput(
        mode=obj.Mode,
        passes=obj.Passes,
        radial=obj.RadialDepth.Value,
        axial=obj.AxialDepth.Value,
        finishing_radial=obj.FinishingRadialDepth.Value,
        allowance=obj.Allowance.Value,
        tolerance=obj.Tolerance.Value,
        safe_height=obj.SafeHeight.Value,
        feed=feed,
        plunge_feed=plunge_feed,
        cutting_edge=cutting_edge,
        tool=tool,
        spindle=_spindle(obj.ToolController),
        stock=stock,
        model=model,
        faces=_compound(faces) if faces else "",
        face_count=len(faces),
        rapids=tool_controller.rapids(obj.ToolController),
        machine=machines.load(obj.Machine) if obj.Machine else None,
    )


def _faces(obj, job):
    """The faces in Base, of the job's model. Raises InputError if there is anything else."""
    faces = []
    for base, names in obj.Base:
        chosen = [name for name in names if name]
        model = shapes.model_of(job, base) if chosen else None
        faces += made_from.faces_of(model, chosen, "choose faces, or nothing.") if chosen else []
    return faces


def _compound(faces):
    import Part

    return Part.makeCompound(faces).exportBrepToString()


def _cutting(obj):
    controller = obj.ToolController
    tool = tool_controller.cutter(controller, obj)
    if tool.corner_radius == 0.0 and tool.taper == 0.0:
        remedy = "copy milling takes a ball, bull nose, tapered or conical end mill: choose one."
        raise InputError("ToolController", "%s (%s)" % (controller.Label, tool.name), remedy)
    for name in ("HorizFeed", "VertFeed"):
        feed = getattr(controller, name).Value
        if not (math.isfinite(feed) and feed > 0.0):
            raise InputError(
                name, "%g mm/min" % (60.0 * feed), "give %s more than zero." % controller.Label
            )
    edge = float(getattr(controller.Tool, "CuttingEdgeHeight", 0.0) or 0.0)
    return tool, controller.HorizFeed.Value, controller.VertFeed.Value, edge if edge > 0.0 else math.inf


def _spindle(controller):
    speed = controller.SpindleSpeed
    if not (math.isfinite(speed) and speed > 0.0):
        raise InputError("SpindleSpeed", "%g rpm" % speed, "give %s more than zero." % controller.Label)
    return core.Spindle(speed / 60.0, tool_controller.sense(controller))


def _check(obj, tool):
    for name in ("RadialDepth", "AxialDepth"):
        value = getattr(obj, name).Value
        if not value > 0.0:
            raise InputError(name, "%g mm" % value, "give more than zero.")
    axial, allowance = obj.AxialDepth.Value, obj.Allowance.Value
    if obj.Passes == PASSES[0] and not allowance <= axial:
        remedy = "give no more than AxialDepth, %g mm: the last pass takes it all at once." % axial
        raise InputError("Allowance", "%g mm" % allowance, remedy)
    if not 1e-4 <= obj.Tolerance.Value <= tool.radius:
        raise InputError(
            "Tolerance", "%g mm" % obj.Tolerance.Value, "give 0.0001 to %g mm." % tool.radius
        )
