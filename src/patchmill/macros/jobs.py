"""A job over a part, and a texture in it, in one call each.

    job = patchmill.job("block.step", tool={"diameter": 2, "flutes": 2, "speed": 1000, "feed": 450},
                        machine="linuxcnc-mill")
    op = patchmill.texture(job, "largest free-form", Spacing=0.5, PatchSide=14)
    plan = patchmill.recompute(op)
    patchmill.post(job, "block.ngc")

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import re
from typing import Any, Dict, Optional

import FreeCAD
import Part
import patchmill
from _patchmill import InputError

from patchmill.freecad import host
from patchmill.machine import machines
from patchmill.macros import faces as face_choice
from patchmill.macros import marks
from patchmill.posting import control_match

TOOL = {"diameter": 2.0, "flutes": 2, "speed": 1000.0, "feed": 450.0, "direction": "Forward"}
KINDS = {
    "Planar": "PlanarTexture",
    "Pyramid": "PyramidTexture",
    "Curved": "CurvedTexture",
    "Calibration": "CalibrationPatch",
}

FOLLOWED = {"Machine"}  # properties that the values of one click are chosen for


def job(
    part: Any,
    tool: Optional[Dict[str, Any]] = None,
    machine: Optional[str] = None,
    offset: Optional[str] = None,
    post: Optional[str] = None,
) -> Any:
    """A FreeCAD Job with a ball end mill over `part`: a document object with a shape, or the name of a file
    (STEP, IGES, BREP, FCStd), which is read into a new document.

    tool: diameter [mm], flutes, speed [rpm], feed [mm/min], direction ("Forward" or "Reverse"), each
    TOOL's if not given. machine: name of a machine file, which the textures of the job take. offset:
    work offset, G54 if not given. post: name of a post-processor; if not given, the one for the
    machine's control. Raises InputError naming part, tool, machine or offset."""
    made = host.create_job("Job", [_part_of(part)])
    values = tool_values(tool or {})
    host.add_ball_end_controller(
        made,
        values["diameter"],
        values["flutes"],
        values["feed"],
        values["speed"],
        values["direction"],
    )
    if offset is not None:
        made.Fixtures = [_offset(offset)]
    _set_post(made, machine, post)
    if machine is not None:
        machines.load(machine)
        made.addProperty(
            "App::PropertyString", "PatchMillMachine", "PatchMill", "Machine file of the job"
        )
        made.PatchMillMachine = machine
    return made


def texture(job: Any, faces: Any, kind: str = "Curved", name: str = "Texture", **properties: Any) -> Any:
    """A texture operation of the job on `faces` (as patchmill.faces takes them), not recomputed. kind:
    Planar, Pyramid, Curved or Calibration. `properties`: its properties by name, lengths in mm, angles
    in degrees; without any but Machine a texture gets the values that suit it, as by one click in
    the GUI, feed and speed of a tool controller that no other operation uses among them. Raises InputError
    naming kind, Faces or the property."""
    if kind not in KINDS:
        raise InputError("kind", repr(kind), "give one of: %s." % ", ".join(KINDS))
    model = job.Model.Group[0]
    chosen = face_choice.faces(model, faces)
    operation = getattr(patchmill, KINDS[kind]).Create(name, parentJob=job)
    operation.Base = [(model, chosen)]
    machine = getattr(job, "PatchMillMachine", "")
    if machine and "Machine" not in properties:
        operation.Machine = machine
    if hasattr(operation, "Decimals"):
        operation.Decimals = decimals_of(job)
    set_properties(operation, properties)
    operation.Proxy.refresh_heights(operation)
    if kind != "Calibration" and not set(properties) - FOLLOWED:
        patchmill.choose_values(operation)
    return operation


def decimals_of(job: Any) -> int:
    """Decimals of the coordinates that the job's post-processor writes: its --precision, 3 if not given."""
    found = re.search(r"--precision[= ](\d+)", job.PostProcessorArgs)
    return int(found.group(1)) if found else 3


def set_properties(operation: Any, properties: Dict[str, Any]) -> None:
    """Sets properties of an operation by name. Raises InputError naming the one that it does not have or
    that does not take the value."""
    known = {row[1] for row in operation.Proxy.properties()} | {"SafeHeight", "ClearanceHeight"}
    for name, value in properties.items():
        if name not in known:
            raise InputError(name, repr(value), "the operation has no such property.")
        try:
            setattr(operation, name, FreeCAD.Vector(*value) if _is_vector(operation, name) else value)
        except (TypeError, ValueError, RuntimeError) as error:
            raise InputError(name, repr(value), "it takes no such value (%s)." % error) from error


def _is_vector(operation: Any, name: str) -> bool:
    return operation.getTypeIdOfProperty(name) == "App::PropertyVector"


def _part_of(part: Any) -> Any:
    if isinstance(part, (str, os.PathLike)):
        return read_part(os.fspath(part))
    if not getattr(part, "Shape", None) or not part.Shape.Faces:
        raise InputError(
            "part", getattr(part, "Label", repr(part)), "give a solid or surface, or a file."
        )
    return part


def read_part(filename: str) -> Any:
    """The part of a file as a document object in a new document: a STEP, IGES or BREP file's shape, or of a
    FreeCAD document its one object with solids (without any: with faces) of which no other is made. Raises
    InputError naming part."""
    if not os.path.isfile(filename):
        raise InputError("part", filename, "there is no such file.")
    stem, ending = os.path.splitext(os.path.basename(filename))
    if ending.lower() == ".fcstd":
        return _part_in(FreeCAD.openDocument(filename), filename)
    try:
        shape = Part.read(filename)
    except Exception as error:  # OpenCASCADE's readers raise errors of many kinds
        raise InputError("part", filename, "it cannot be read (%s)." % _first_line(error)) from error
    if shape.isNull() or not shape.Faces:
        raise InputError("part", filename, "it holds no faces.")
    document = FreeCAD.newDocument("part")
    part = document.addObject("Part::Feature", "Part")
    part.Label, part.Shape = stem, shape
    marks.remember(part, filename)
    document.recompute()
    return part


def _first_line(error: BaseException) -> str:
    return (str(error).splitlines() or [type(error).__name__])[0]


def _part_in(document: Any, filename: str) -> Any:
    shaped = [o for o in document.Objects if getattr(o, "Shape", None) and o.Shape.Faces]
    shaped = [o for o in shaped if o.Shape.Solids] or shaped
    whole = [o for o in shaped if not any(p in shaped for p in o.InList)]
    if len(whole) != 1:
        found = ", ".join(o.Label for o in whole) or "none"
        raise InputError("part", filename, "it holds %d parts (%s): keep one." % (len(whole), found))
    return whole[0]


def tool_values(tool: Dict[str, Any]) -> Dict[str, Any]:
    for name in tool:
        if name not in TOOL:
            raise InputError("tool", name, "a tool has: %s." % ", ".join(TOOL))
    values = dict(TOOL, **tool)
    for name in ("diameter", "flutes", "speed", "feed"):
        value = values[name]
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 < value < 1e9:
            raise InputError("tool", "%s %r" % (name, value), "give a number greater than zero.")
    if values["flutes"] != int(values["flutes"]):
        raise InputError("tool", "flutes %r" % values["flutes"], "give a whole number.")
    if values["direction"] not in ("Forward", "Reverse"):
        raise InputError("tool", "direction %r" % values["direction"], "give Forward or Reverse.")
    return values


def _offset(offset: str) -> str:
    known = ["G%d" % n for n in range(54, 60)] + ["G59.%d" % n for n in range(1, 10)]
    if offset not in known:
        raise InputError("offset", repr(offset), "give one of: %s." % ", ".join(known))
    return offset


def _set_post(made: Any, machine: Optional[str], post: Optional[str]) -> None:
    if post is None and machine is not None:
        dialect = machines.load(machine).controller["dialect"]
        post = None if dialect == control_match.ANY else "patchmill_" + dialect
    made.PostProcessorArgs = "--no-header --no-show-editor"
    if post is None:
        post = "linuxcnc"
    if post not in made.getEnumerationsOfProperty("PostProcessor"):
        raise InputError("post", repr(post), "FreeCAD knows no such post-processor.")
    made.PostProcessor = post
    decimals = 3 if post in ("linuxcnc",) else 4
    made.PostProcessorArgs += " --precision=%d" % decimals
