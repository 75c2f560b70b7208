"""A job as a mould maker has it: face, pocket with arcs, drilling G81 to G83, profile, two textures and a
copy milling, with three tools, for tests of whole programs.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os

import FreeCAD
import Part
import patchmill
from milling_jobs import native
from patchmill.freecad import host
from patchmill.machine import machines

V = FreeCAD.Vector
ROOF = {"locked": 12.0, "tilted": -12.0}  # slopes of the two faces that are textured [degrees]
HOLES = ((4.0, 4.0), (4.0, 14.0), (40.0, 4.0))

BOTH = ("G54", "G55")
LOCKED, TIMED, CONSTANT = "Spindle-locked", "Feed per move", "Constant feed"
CASES = [  # post, machine of the textures, strategy of the first, work offsets, decimals
    ("patchmill_linuxcnc", "table-table-ac", LOCKED, BOTH, 4),
    ("patchmill_fanuc", "locked-head-head-ca", LOCKED, BOTH, 4),
    ("patchmill_siemens", "locked-head-table-bc", LOCKED, BOTH, 4),
    ("patchmill_heidenhain", "nutating-table-bc-45", TIMED, ("G54",), 4),
    ("patchmill_grblhal", "", CONSTANT, BOTH, 4),
    ("patchmill_haas", "", CONSTANT, BOTH, 4),
    ("linuxcnc", "table-table-ac", TIMED, ("G54",), 4),
]


def locked_machines(folder):
    """Machine files like two shipped ones, but with controls that can follow the spindle."""
    os.environ["PATCHMILL_MACHINES"] = folder
    for key in ("head-head-ca", "head-table-bc"):
        data = dict(machines.load(key).data, spindle_lock=True)
        with open(os.path.join(folder, "locked-%s.json" % key), "w", encoding="utf-8") as file:
            json.dump(data, file)


def block():
    """A block of 44 x 18 x 16 mm with rounded upright edges, a round pocket, three holes, and two slopes."""
    shape = Part.makeBox(44, 18, 16)
    shape = shape.makeFillet(3, [e for e in shape.Edges if abs(e.tangentAt(e.FirstParameter).z) > 0.9])
    shape = shape.cut(Part.makeCylinder(4.5, 5, V(11, 9, 11)))
    for x, y in HOLES:
        shape = shape.cut(Part.makeCylinder(1.5, 20, V(x, y, -1)))
    for angle, x in ((ROOF["locked"], 17.0), (ROOF["tilted"], 37.0)):
        wedge = Part.makeBox(9, 40, 20, V(-4.5, -5, 0))
        wedge.rotate(V(), V(0, 1, 0), angle)
        wedge.translate(V(x + (4.5 if x < 27 else -4.5), 0, 13.5))
        shape = shape.cut(wedge)
    return shape


def slopes(shape):
    """Names of the two sloping faces, by rising X."""
    found = []
    for number, face in enumerate(shape.Faces, 1):
        normal = face.normalAt(0, 0)
        if normal.z > 0.9 and abs(normal.x) > 0.1:
            found.append((face.CenterOfMass.x, "Face%d" % number))
    return [name for _, name in sorted(found)]


def floor_of_pocket(shape):
    """The name of the pocket's floor."""
    for number, face in enumerate(shape.Faces, 1):
        if face.normalAt(0, 0).z > 0.99 and abs(face.CenterOfMass.z - 11.0) < 1e-6:
            return "Face%d" % number
    raise LookupError("no floor")


def three_tools(job):
    """Tool controllers of an end mill (T1), a drill (T2) and a ball end mill (T3)."""
    mill = host.tool_controllers(job)[0]
    mill.ToolNumber = 1
    mill.SpindleSpeed, mill.SpindleDir = 6000.0, "Forward"
    mill.HorizFeed, mill.VertFeed = 10.0, 3.0
    drill = host.append_controller(job)
    drill.Label, drill.SpindleSpeed, drill.SpindleDir = "Drill", 2500.0, "Forward"
    drill.HorizFeed, drill.VertFeed = 4.0, 2.0
    drill.Tool.Diameter = 3.0
    ball = host.append_controller(job)
    host.add_ball_end_controller(job, 2.0, 2, 600.0, 1000.0, controller=ball)
    for controller in (mill, drill):
        controller.HorizRapid = controller.VertRapid = 100.0
    return mill, drill, ball


def _native_operations(job, model):
    """Made while there is one tool: FreeCAD would ask which with a dialog."""
    face = native("MillFace").Create("Face", parentJob=job)
    pocket = native("PocketShape").Create("Pocket", parentJob=job)
    pocket.Base, pocket.StepDown = [(model, [floor_of_pocket(model.Shape)])], 3.0
    profile = native("Profile").Create("Profile", parentJob=job)
    profile.StepDown = 8.0
    drilling = native("Custom").Create("Drilling", parentJob=job)
    lines = ["G0 Z25", "G90", "G98"]
    cycles = ("G81 X%g Y%g Z2 R18 F2", "G82 X%g Y%g Z2 R18 P0.5 F2", "G83 X%g Y%g Z-1 R18 Q3 F2")
    lines += [cycle % hole for cycle, hole in zip(cycles, HOLES)] + ["G80", "G0 Z25"]
    drilling.Gcode = lines
    return [face, pocket, drilling, profile]


def texture(job, face, ball, label, machine, **properties):
    operation = patchmill.CurvedTexture.Create(label, parentJob=job)
    operation.Base = [(job.Model.Group[0], [face])]
    operation.ToolController, operation.PatchSide, operation.Machine = ball, 4, machine
    operation.PostUnheld = operation.PostGouging = True
    for name, value in properties.items():
        setattr(operation, name, value)
    return operation


def mould_job(machine, strategy="Spindle-locked", decimals=4, offsets=("G54", "G55"), patches=0):
    """(job, textures): recomputed. `machine`: of both textures, the second of which is milled with the tool
    tilted; '' for none, with both upright. `strategy`: of the first one. `patches`: of each texture along
    either side, 0: over the whole face."""
    document = FreeCAD.newDocument("mould")
    part = document.addObject("Part::Feature", "Mould")
    part.Shape = block()
    document.recompute()
    job = host.create_job("Job", [part])
    job.Stock.ExtZpos = 1.0
    model = job.Model.Group[0]
    order = _native_operations(job, model)
    mill, drill, ball = three_tools(job)
    for operation in order:
        operation.ToolController = drill if operation.Label == "Drilling" else mill
    document.recompute()
    first, second = slopes(model.Shape)
    locked = texture(job, first, ball, "Locked", machine, Decimals=decimals)
    locked.Strategy = strategy
    if strategy != "Constant feed":
        locked.SameFlute, locked.ExtraTurns = False, 0.0
    tilted = texture(job, second, ball, "Tilted", machine, Decimals=decimals)
    if machine:
        tilted.FixedAxis = V(0.0, 0.2, 1.0)
    locked.PatchesX = locked.PatchesY = tilted.PatchesX = tilted.PatchesY = patches
    copy = patchmill.CopyMilling.Create("Copy", parentJob=job)
    copy.ToolController, copy.Base = ball, [(model, [second])]
    copy.Passes, copy.RadialDepth, copy.AxialDepth = "Finishing", 1.0, 2.0
    job.Operations.Group = order + [copy, locked, tilted]
    job.Fixtures = list(offsets)
    job.PostProcessorArgs = "--no-header --precision=%d" % decimals
    document.recompute()
    return job, [locked, tilted]
