"""From a mesh to a program that was read back and checked, without a job: FreeCAD's jobs are made of shapes.

    made = patchmill.mesh_texture("scan.stl", "scan.ngc", nearest=(0, 0, 12), spacing=0.5)
    print(made.text())
    print(patchmill.simulate(made.plan, program="scan.ngc").text())

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, fields
from types import SimpleNamespace
from typing import Any, Callable, Dict, Optional

import _patchmill as core
from _patchmill import InputError

from patchmill.collision.clearance_check import UNKNOWN, VIOLATED, CheckInput, CheckResult, run_check
from patchmill.freecad import host
from patchmill.geometry import mesh_parts
from patchmill.macros.jobs import tool_values
from patchmill.path.read_text import path_of, text_of
from patchmill.system import files
from patchmill.textures.input import TextureInput
from patchmill.textures.plan import PlannedTexture, plan_texture
from patchmill.verify import posted_texture
from patchmill.verify.posted_program import PostedProgram

GOUGE_TOLERANCE, CLEARANCE = 0.01, 0.1  # mm: what a new operation allows
SAFE, CLEAR = 3.0, 5.0  # mm over the highest place of the mesh
PHASE_TOLERANCE = 2.0  # degrees
NOT_GIVEN = {"breps", "mesh", "tool", "spindle", "feed", "surface", "machine", "strategy", "calibrating"}
REGION = ("nearest", "angle", "triangles", "crease")


@dataclass
class MeshTexture:
    """A texture on a mesh, and its program as it was read back. `whole`: all triangles of the part."""

    plan: PlannedTexture
    posted: posted_texture.PostedTexture
    check: CheckResult
    whole: core.TriangleMesh
    program: str  # name of the file, or '' for none

    def text(self) -> str:
        """What was made, in a few lines."""
        surface = self.plan.input.mesh
        lines = [
            "%d dimples on %d of %d triangles."
            % (self.plan.counts["cut"], surface.triangle_count, len(self.whole)),
            "Normals are smoothed by up to %.3g degrees; a smooth surface would rise up to %.3g mm over the "
            "triangles' edges." % (math.degrees(surface.normal_deviation), surface.chord_height),
            self.check.sentence,
        ]
        return "\n".join(lines + list(self.plan.remarks))


def mesh_texture(
    part: Any,
    program: Optional[str] = None,
    tool: Optional[Dict[str, Any]] = None,
    kind: str = "Curved",
    dialect: str = "linuxcnc",
    unchecked: bool = False,
    progress: Optional[Callable[[float], bool]] = None,
    **values: Any,
) -> Optional[MeshTexture]:
    """MeshTexture of `part`, as patchmill.mesh takes it, or None if `progress` (share -> bool) returned
    False.

    program: name of the file that is written, None: none. tool: as patchmill.job takes it. kind: Planar or
    Curved. dialect: of the program, as _patchmill.write_program takes it. unchecked: the program is written
    though nobody knows whether the tool gouges, since the mesh is open. `values`: the region, as
    patchmill.mesh_region takes it (nearest, angle, triangles, crease), and what else the texture has
    (spacing, patch_side, order, margin, ...) [mm, degrees], by the names of
    patchmill.textures.input.TextureInput.

    The program is read back, and holds every dimple in its phase, before it is written; it is not written if
    the tool gouges the mesh. Raises InputError naming what is wrong."""
    whole = mesh_parts.mesh(part)
    region = {name: values.pop(name) for name in REGION if name in values}
    given = _input(whole, mesh_parts.mesh_region(whole, **region), tool or {}, kind, values)
    plan = plan_texture(given, progress)
    if plan is None:
        return None
    text = _program_text(plan, dialect)
    read = PostedProgram(text, dialect)
    asked = SimpleNamespace(Label="Texture", PhaseTolerance=SimpleNamespace(Value=PHASE_TOLERANCE))
    posted, _ = posted_texture.find(asked, plan, posted_texture.told_by(plan), read, 0)
    check = _checked(plan, posted, whole, progress)
    if program is not None:
        _require_clear(check, unchecked)
        files.write(program, text)
    return MeshTexture(plan, posted, check, whole, program or "")


def _input(whole: Any, surface: Any, tool: Dict[str, Any], kind: str, values: Dict[str, Any]) -> TextureInput:
    if kind not in ("Planar", "Curved"):
        raise InputError("kind", repr(kind), "give Planar or Curved.")
    known = {field.name for field in fields(TextureInput)} - NOT_GIVEN
    for name in values:
        if name not in known:
            raise InputError(name, repr(values[name]), "a texture on a mesh has no such value.")
    cutter = tool_values(tool)
    top = float(whole.vertices[:, 2].max())
    heights: Dict[str, Any] = {"safe_height": top + SAFE, "clearance_height": top + CLEAR}
    spindle = core.Spindle(cutter["speed"] / 60.0, "M3" if cutter["direction"] == "Forward" else "M4")
    return TextureInput(
        breps=[],
        mesh=surface,
        tool=core.BallEndMill(0.5 * cutter["diameter"], int(cutter["flutes"])),
        spindle=spindle,
        feed=cutter["feed"] / 60.0,
        surface=core.PatchSurface(kind),
        **{**heights, **values},
    )


def _program_text(plan: PlannedTexture, dialect: str) -> str:
    """The program of a plan whose tool stands upright."""
    if plan.posture is not None:
        remedy = "a program of a mesh has three axes: choose Fixed along (0, 0, 1)."
        raise InputError("ToolAxisMode", plan.input.tool_axis_mode, remedy)
    commands = host.begin_upright(path_of(str(plan.pacing.text)).Commands)
    spindle = plan.input.spindle
    head = "M6 T1\n%s S%d\n" % (spindle.sense, round(60.0 * spindle.speed))
    text = head + text_of(host.Path.Path(commands))
    return core.write_program([text], dialect, precision=plan.input.decimals, own=[True])


def _checked(plan: PlannedTexture, posted: Any, whole: Any, progress: Any) -> CheckResult:
    """What was read back against the mesh, from where X, Y and Z are known on: above it, or nobody knows."""
    asked = CheckInput(posted.path, [], GOUGE_TOLERANCE, CLEARANCE, plan, mesh=whole)
    check = run_check(asked, first_move=posted.unplaced, progress=progress)
    if posted.blind < whole.vertices[:, 2].max() and check.outcome != VIOLATED:
        check.outcome = UNKNOWN
        check.reason = "the tool goes down to Z%.3f before X and Y are known." % posted.blind
    return check


def _require_clear(check: CheckResult, unchecked: bool) -> None:
    if check.clear or (unchecked and check.outcome == UNKNOWN):
        return
    remedy = "change the tool, the region or the margin."
    if check.outcome == UNKNOWN:
        remedy = "close the mesh, or give unchecked=True."
    raise InputError("unchecked", unchecked, "%s Nothing is written: %s" % (check.sentence, remedy))
