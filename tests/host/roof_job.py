"""A job over two boxes whose tops slope, with a texture on each slope, for tests of posting.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import Part
import patchmill
from milling_jobs import native
from patchmill.freecad import host

V = FreeCAD.Vector
ARGUMENTS = "--no-header --precision=3"


def roof():
    """Two boxes whose tops slope by 20 and 25 degrees."""
    boxes = []
    for angle, x in ((20.0, -8.0), (-25.0, 9.0)):
        box = Part.makeBox(12, 10, 4, V(-6, -5, -4))
        box.rotate(V(), V(0, 1, 0), angle)
        box.translate(V(x, 0, 0))
        boxes.append(box)
    return Part.makeCompound(boxes)


def custom(job, lines):
    """FreeCAD's own operation of lines of G-code."""
    operation = native("Custom").Create("Custom", parentJob=job)
    operation.Gcode = lines
    operation.ToolController = host.tool_controllers(job)[0]
    job.Document.recompute()
    return operation


def roof_job(*strategies):
    """(job, textures): a texture of each strategy on the slopes."""
    document = FreeCAD.newDocument("roof")
    part = document.addObject("Part::Feature", "Part")
    part.Shape = roof()
    document.recompute()
    job = host.create_job("Job", [part])
    host.add_ball_end_controller(job, 2.0, 2, 600.0, 1000.0)
    job.PostProcessorArgs = ARGUMENTS
    model = job.Model.Group[0]
    tops = [k for k, face in enumerate(model.Shape.Faces, 1) if face.normalAt(0, 0).z > 0.8]
    textures = []
    for number, strategy in zip(tops, strategies):
        op = patchmill.CurvedTexture.Create("Texture%d" % number, parentJob=job)
        op.Base = [(model, ["Face%d" % number])]
        op.PatchSide, op.Strategy = 4, strategy
        if strategy != "Constant feed":
            op.Machine, op.SameFlute, op.ExtraTurns, op.PostUnheld = "linuxcnc-mill", False, 0.0, True
        textures.append(op)
    document.recompute()
    return job, textures
