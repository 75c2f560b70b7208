"""From a cylinder to the dimples of a thread, and from these to the path that mills them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import replace

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.machine import machines
from patchmill.textures import division, heights
from patchmill.textures.order import rows
from patchmill.textures.thread import lattice, path
from patchmill.textures.thread.cylinder import cylinder_of
from patchmill.textures.thread.turning import turning

LEAN = "Normal"


def place(given):
    """The fields of a PlacedTexture, as a dict. Raises InputError naming what is wrong, or what a thread
    cannot have."""
    _require(given)
    size = division.texture_size(given)
    cylinder = cylinder_of(given.breps)
    triangular = core.row_pitch(given.patch_shape) < 1.0
    closed = lattice.closing(cylinder.circumference, size["spacing"], triangular)
    isolated = given.texture_kind == "Isolated"
    found = replace(
        given,
        spacing=closed.spacing,
        mapping="On surface",
        depth=size["depth"] if isolated else 0.0,
        dimple_diameter=0.0,
        area_share=0.0,
        ridge_height=0.0,
    )
    size = division.texture_size(found)
    turned = turning(found, cylinder, closed, machines.load(given.machine), size["sunk"])
    positions, normals, along = turned.places()
    ends = np.sort([(p - turned.origin) @ turned.along for p in _ends(cylinder)])
    on_face = (along >= ends[0]) & (along <= ends[1])
    passes = np.arange(len(along))
    row = (passes / turned.lattice.round).astype(int)
    division.require_memory(_one_patch(found), division.BYTES_PER_DIMPLE, len(passes))
    dimples = core.dimples_at(
        positions,
        normals,
        np.column_stack([passes - closed.steps * row, row]),
        row.tolist(),
        np.where(on_face, core.DimpleState.CUT, core.DimpleState.OFF_FACE).tolist(),
    )
    core.sink(dimples, size["sunk"])
    said: list = []
    plane, _, low, high = division.sampler_on(found, said)
    return {
        "input": found,
        "plane": plane,
        "division": _one_patch(found),
        "dimples": dimples,
        "size": size,
        "extent": (low, high),
        "thread": turned,
        "remarks": said + _remarks(given, turned, int(on_face.sum())),
    }


def in_view(placed):
    """The dimples of a PlacedTexture; of a thread or a ball with those of the milled ones as undercut that
    look away from where the texture is seen from, or are steeper than SteepestSlope to there."""
    if placed.thread is None and placed.ball is None:
        return placed.dimples
    dimples, states = placed.dimples, np.array(placed.dimples.states)
    steepest = math.cos(math.radians(placed.input.steepest_slope))
    away = dimples.normals @ np.asarray(placed.plane.direction) > -steepest
    states[(states == core.DimpleState.CUT) & away] = core.DimpleState.UNDERCUT
    lattice_points = dimples.lattice[:, :2].astype(int)
    patches = dimples.patches.tolist()
    found = core.dimples_at(dimples.positions, dimples.normals, lattice_points, patches, states.tolist())
    core.sink(found, placed.size["sunk"])
    return found


def spread_of(turned, dimples):
    """See lattice.spread; of a Turning's dimples that are milled."""
    cut = dimples.states == core.DimpleState.CUT
    return lattice.spread(turned.lattice, dimples.positions[cut])


def rubbing(placed):
    """How many dimples of a PlacedTexture are so near to the tool's tip that it rubs in them."""
    flat = abs(math.radians(placed.input.lead)) < placed.size["least_tilt"]
    return dict(placed.dimples.counts())["cut"] if flat else 0


def _require(given):
    if not given.machine:
        remedy = "a thread needs a machine file with a rotary table, such as four-axis-mill."
        raise InputError("Machine", "''", remedy)
    strategy = given.keeps_phase
    if not strategy.locked:
        remedy = "a thread closes on itself only if the spindle leads the axes: choose Spindle-locked."
        raise InputError("Strategy", given.strategy, remedy)
    strategy.require(machines.load(given.machine))
    if given.tool_axis_mode != LEAN:
        remedy = "on a cylinder that turns the tool has a lead to the surface: choose Normal."
        raise InputError("ToolAxisMode", given.tool_axis_mode, remedy)
    refused = [
        ("SameFlute", given.same_flute and given.tool.flutes > 1, "others would mark in between: allow any."),
        ("Tilt", given.tilt != 0.0, "the tool leans in the plane that the cylinder turns in: give a Lead."),
        ("LeadTowards", any(given.lead_towards), "the tool leans towards the feed: give 0, 0, 0."),
        ("MaskUse", given.mask is not None, "a thread is one locked move: choose None."),
        ("Form", given.form == "Free", "the free form has no lattice: choose another Order."),
        ("PatchesX", given.patches_x or given.patches_y, "a thread covers the whole cylinder: give 0."),
        ("FirstPatch", given.first_patch != 1, "a thread is milled as a whole: give 1."),
        ("LastPatch", given.last_patch != 0, "a thread is milled as a whole: give 0."),
        ("Order", given.surface.planar, "a thread needs a curved texture."),
        ("PatchStops", given.patch_stops, "a thread is one move: set it false."),
    ]  # fmt: skip
    for name, wrong, remedy in refused:
        if wrong:
            value = given.order if name == "Order" else getattr(given, _FIELDS.get(name, ""), "true")
            raise InputError(name, value, remedy)


_FIELDS = {
    "Tilt": "tilt",
    "LeadTowards": "lead_towards",
    "PatchesX": "patches_x",
    "FirstPatch": "first_patch",
    "LastPatch": "last_patch",
    "Form": "form",
}


def _ends(cylinder):
    return [cylinder.point + at * cylinder.direction for at in (cylinder.low, cylinder.high)]


def _one_patch(given):
    return core.patch_block(core.PatchPattern(given.patch_shape, given.spacing, given.patch_side), 1, 1)


def _remarks(given, turned, count):
    """Sentences."""
    closed, letter = turned.lattice, turned.kinematics.letters
    said = [
        "One thread of %d dimples, %.5g to a turn, %.5g mm apart; %s winds to %.2f degrees."
        % (count, closed.round, closed.spacing, letter, math.degrees(turned.angle))
    ]
    if given.margin > 0.0:
        said.append("The margin is not kept: the thread runs over both ends of the cylinder.")
    return said


def pacing(placed):
    """What a PlannedTexture has beside a PlacedTexture with a thread, and the fields of its Pacing, as dicts.
    Raises InputError naming Dimples, SafeHeight or ClearanceHeight."""
    given, dimples, turned = placed.input, placed.dimples, placed.thread
    counts = dict(dimples.counts())
    division.require_some(counts, given)
    numbers = np.where(dimples.states == core.DimpleState.CUT, np.arange(len(dimples)), core.NO_DIMPLE)
    _, axes = turned.poses(
        turned.start, turned.end, (0.0, turned.angle), np.arange(len(dimples)) / (turned.turns * turned.teeth)
    )
    postures = core.plan_postures(turned.kinematics, dimples, axes, given.decimals)
    rule = core.with_azimuths(core.PhaseRule(False, 0.0, 0.0), postures)
    form = core.ProgramForm(False, "tip", 1e-3, 0.0)
    posture = path.ThreadPosture(turned, turned.kinematics, form, postures, numbers)
    told = heights.plan_above(
        given, dimples, placed.remarks, lambda higher: path.told_moves(higher, turned)
    )
    posture.told = told
    posture.work = path.in_pieces(posture, told.path, told.joints)
    speed = given.spindle.speed
    sentence = "Holds: one straight move that follows the spindle, %s at %.4g degrees/s." % (
        turned.kinematics.letters,
        math.degrees(turned.angle) * speed / turned.turns,
    )
    feed = core.posted_feed(given.feed, given.decimals)
    made = {
        "path": posture.work.path,
        "text": path.text(told, turned, given),
        "feed": feed,
        "verdict": path.Held(speed, sentence),
        "posture": posture,
    }
    return {"rule": rule, "counts": counts}, made


def is_thread(given):
    """Whether a TextureInput asks for a thread."""
    return given.order == rows.THREAD
