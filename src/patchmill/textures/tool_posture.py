"""Tool axes and postures of a texture: from what the operation asks of the tool axis to the angles of the
machine's rotary axes, and to the path that its controller is told (docs/five-axis.md).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass
from math import degrees, floor, radians

import _patchmill as core
import numpy as np
from _patchmill import InputError

VERTICAL = (0.0, 0.0, 1.0)
MODES = ("Fixed", "Normal", "Minimum lead", "Field")
FORMS = ("As the machine", "With TCP", "Without TCP")


@dataclass
class Posture:
    """How a path is milled with rotary axes. `work`: _patchmill.PosturePath of tool tips in the work frame;
    `told`: of the programmed points; `machine`: _patchmill.Kinematics with the tool in it."""

    kinematics: core.Kinematics
    form: core.ProgramForm
    reference: str
    postures: core.Postures
    turning: list
    work: core.PosturePath = None
    told: core.PosturePath = None
    load: dict = None


def is_vertical(given):
    """Whether the tool stands upright everywhere, as on three axes."""
    x, y, z = given.fixed_axis
    return given.tool_axis_mode == "Fixed" and x == 0.0 and y == 0.0 and z > 0.0


def field_ready(given, progress=None):
    """Makes the voxel model that the axes come from, if they do; False if `progress` (share -> bool) returned
    False. Raises InputError."""
    prepare = getattr(given.posture_field, "prepare", None)
    return prepare is None or prepare(progress)


def axes(given, dimples):
    """(n, 3) unit tool axes for dimples, as the operation asks for them. Raises InputError."""
    if given.tool_axis_mode not in MODES:
        raise InputError("ToolAxisMode", given.tool_axis_mode, "give one of: %s." % ", ".join(MODES))
    field = None
    if given.tool_axis_mode == "Field":
        if given.posture_field is None:
            raise InputError("PostureField", "none", "give a function of positions and normals.")
        field = np.asarray(given.posture_field(dimples.positions, dimples.normals), dtype=float)
    found = core.tool_axes(
        dimples,
        given.tool_axis_mode,
        axis=given.fixed_axis,
        lead=radians(given.lead),
        tilt=radians(given.tilt),
        least_lead=radians(given.minimum_lead),
        towards=given.lead_towards,
        field=field,
        smoothing=radians(given.axis_smoothing),
        widest=radians(given.widest_tilt),
    )
    return given.keeps_phase.tool_axes(given, dimples, found)


def keep_off_tip(placed):
    """Leaves out of a PlacedTexture what the tip of the ball would rub. Raises InputError naming
    AvoidRubbing if it would rub in all of them."""
    given, dimples = placed.input, placed.dimples
    least = placed.size["least_tilt"]
    if not is_vertical(given):
        limit = max(radians(given.minimum_tilt), least if given.avoid_rubbing else 0.0)
        core.mark_tool_tip_along(dimples, axes(given, dimples), limit)
        return
    core.mark_tool_tip(dimples, VERTICAL, radians(given.minimum_tilt))
    if not given.avoid_rubbing or least <= radians(given.minimum_tilt):
        return
    tilts = core.tilts(dimples, VERTICAL)[dimples.states == core.DimpleState.CUT]
    if len(tilts) and tilts.max() <= least:
        raise InputError(
            "AvoidRubbing",
            "true",
            "in dimples %.4g mm deep the tip of the ball would rub under a tilt of %.3f degrees, and "
            "the faces have %.3f at most: incline the part or choose shallower dimples."
            % (placed.size["depth"], degrees(least), degrees(tilts.max())),
        )
    core.mark_tool_tip(dimples, VERTICAL, least)


def program_form(machine, name, gauge_length, chord_clear):
    """(_patchmill.ProgramForm, programmed point) for one of FORMS on a machine with rotary axes."""
    controller = machine.controller
    tcp = {"With TCP": True, "Without TCP": False}.get(name, controller["tcp"])
    if tcp and not controller["tcp"]:
        raise InputError("ProgramForm", name, "the machine %s has no TCP." % machine.key)
    heads = [a for a in machine.data["rotary_axes"] if a["side"] == "head"]
    if heads and not tcp and not gauge_length > 0.0:
        remedy = "without TCP a tilting head needs the length from its gauge point to the tip."
        raise InputError("GaugeLength", "0 mm", remedy)
    return core.ProgramForm(tcp, controller["reference"], 1e-3, chord_clear), controller["reference"]


def plan(given, dimples, machine):
    """Posture of dimples on `machine` (a machines.Machine), without a path yet. Raises InputError naming
    Machine, ToolAxis, ProgramForm or GaugeLength."""
    if machine is None or not machine.rotary_letters:
        raise InputError(
            "Machine",
            machine.key if machine else "''",
            "tool axes other than Z need a machine file with rotary axes.",
        )
    form, reference = program_form(machine, given.program_form, given.gauge_length, 0.5 * given.lift)
    kinematics = core.with_tool(machine.kinematics, given.gauge_length, form, given.tool)
    postures = core.plan_postures(kinematics, dimples, axes(given, dimples), given.decimals)
    turning = given.keeps_phase.turning_seconds(kinematics, dimples, postures, given, machine, form)
    return Posture(kinematics, form, reference, postures, turning)


def finish(posture, path, given, machine):
    """Fills in the posture's paths from `path`, which a strategy planned for the ball centre, and returns
    the text for Path.Path(). Raises InputError naming the axis that is too slow."""
    posture.work = core.with_postures(path, posture.postures, posture.kinematics, given.decimals)
    return _told(posture, machine, given.decimals, given.keeps_phase.polygons)


def _told(posture, machine, decimals, polygons=False):
    """Fills in what the controller is told of posture.work; returns the text."""
    posture.told = core.programmed(posture.work, posture.kinematics, posture.form, decimals)
    posture.load = load = core.axis_load(posture.kinematics, posture.work)
    if load["rate"] > 1.0:
        most = floor(60.0 * posture.work.path.spindle.speed / load["rate"])
        slower = "turn the spindle more slowly"
        if polygons:  # they take the same turns at any speed; other paths take as few as the machine can
            slower = "add ExtraTurns, or turn the spindle at %d rpm or less" % most
        raise InputError(
            "ToolAxis",
            "axis %s" % load["rate_axis"],
            "it would have to turn at %.1f times its greatest velocity in move %d: smooth the tool axes, "
            "or %s."
            % (load["rate"], load["rate_move"], slower),
        )
    if load["overtravel_mm"] > 0.0:
        raise InputError(
            "Machine",
            machine.key,
            "axis %s would leave its limits by %.3f mm." % (load["overtravel_axis"], load["overtravel_mm"]),
        )
    before, after = _tcp_words(posture, machine)
    return core.freecad_rotary_text(
        posture.told,
        machine.rotary_letters,
        machine.model,
        decimals,
        before,
        after,
        as_set="smoothing_on" in machine.controller,
    )


def of_path(path, machine, decimals, gauge_length=0.0, form_name=FORMS[0], pole_tolerance=1e-6):
    """(Posture, text for Path.Path()) of any ToolPath whose tool axes are set, such as a copy-milling path
    with its posture field: angles over the whole path, unwinding in rapids only. Raises InputError naming
    ToolAxis, Machine, ProgramForm or GaugeLength."""
    form, reference = program_form(machine, form_name, gauge_length, 0.0)
    kinematics = core.with_tool(machine.kinematics, gauge_length, form, path.tool)
    posture = Posture(kinematics, form, reference, None, [])
    posture.work = core.plan_path_joints(kinematics, path, pole_tolerance, decimals)
    return posture, _told(posture, machine, decimals)


def _tcp_words(posture, machine):
    """Words that switch TCP on and off, as FreeCAD's paths can hold them; the dialects write their own."""
    if not posture.form.tcp:
        return "", ""
    controller = machine.controller
    words = controller.get("tcp_on", ""), controller.get("tcp_off", "")
    plain = all(w[:1] in "GM" and w[1:].replace(".", "").isdigit() for w in words if w)
    return words if all(words) and plain else ("G43.4", "G49")


def read_back(section, posture, machine, tolerance_mm):
    """Compares a section of a posted program with what it was to say; returns (match, ToolPath of tips in
    the work frame). `match` is a _patchmill.PlanMatch; the angles count as a miss of the same number."""
    match = core.match_plan(section.path, posture.told.path, tolerance_mm)
    told = np.degrees(posture.told.joints[1:])
    read = np.degrees(section.angles[1:])[:, ["ABC".index(c) for c in posture.kinematics.letters]]
    ends = np.flatnonzero(section.path.kinds != core.MoveKind.RAPID)
    planned = np.flatnonzero(posture.told.path.kinds != core.MoveKind.RAPID)
    complete = match.complete and len(ends) == len(planned)
    if complete:
        off = np.abs(read[ends] - told[planned][:, : read.shape[1]]).max(initial=0.0)
        complete = off <= tolerance_mm + 1e-9 and bool((section.tcp[ends] == posture.form.tcp).all())
    if hasattr(posture, "in_work"):  # one move of a thread is many dimples
        return complete, match, posture.in_work(section)
    return complete, match, core.section_in_work(section, posture.kinematics, posture.form)
