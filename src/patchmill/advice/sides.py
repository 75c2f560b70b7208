"""Faces that are closed, as of a shaft or a bore, of which one setup reaches less than half: several
textures share them, each from another side.

A lattice that is laid on the faces is the same from wherever a texture is projected. So each of the
textures mills what is no steeper to its own direction than where the next one's begins: no dimple twice, and
none left. Directions that stand evenly around the axis of a cylinder, all at an angle theta to it, see a
normal that is turned by phi from their own azimuth under a cosine of sin(theta) cos(phi); of n of them the
next begins at phi = 180°/n.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, field, replace

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.advice import orientation
from patchmill.advice.found import Assessment
from patchmill.machine import machines
from patchmill.textures.plan import place_texture

AROUND = 3  # textures around a cylinder
# Of their directions to its axis [degrees]: a bore hides its walls from the first
LEANS = (50.0, 30.0, 25.0, 20.0)
FIRST_AZIMUTH = 0.1  # [rad]: where no column of a lattice lies between two textures
_STATES = core.DimpleState
NOT_ASKED_FOR = [_STATES.OFF_FACE, _STATES.OFF_NET, _STATES.MASKED, _STATES.NEAR_EDGE]
ABOUT = 0.9
PARALLEL = 1e-6  # sine of the angle between axes


@dataclass
class Side:
    """One of several textures. `fields`: of its TextureInput; `axis` and `angle` [degrees]: how its part is
    turned, from where it is; None where the tool is leant instead."""

    fields: dict = field(default_factory=dict)
    axis: tuple = None
    angle: float = 0.0


def find(assess, choose, touches, given, free, can_incline, model=()):
    """(Sides with the values that suit the first of them, Assessment of all) by which the faces become good;
    ([], None) where nothing does. `touches`: room.touches; the other arguments are remedies.Finder's."""
    machine = machines.load(given.machine) if given.machine else None
    for shared in _tries(given, machine, can_incline):
        try:
            made, together = _made_of((assess, choose, touches), given, shared, free, model)
        except InputError:
            continue
        if made and together.good:
            return made, together
    return [], None


def _made_of(functions, given, shared, free, model):
    """The same for some Sides; ([], None) where one of them does not reach its part or is not good, or where
    its tool would run into the part. The values are those of the first side that suit all."""
    assess, choose, touches = functions
    if not _reaches_its_part(asked(given, shared[0], model), len(shared)):
        return [], None
    for chosen in shared:
        choice = choose(asked(given, chosen, model), free)
        if choice is None or not choice.assessment.remains_good:
            continue
        inputs = [asked(replace(given, **choice.fields), side, model) for side in shared]
        found = _assessments(assess, touches, inputs, shared, model)
        if found:
            made = [replace(side, fields={**choice.fields, **side.fields}) for side in shared]
            return made, together(found, inputs)
    return [], None


def _assessments(assess, touches, inputs, shared, model):
    """Those of the TextureInputs of Sides; none where one is not good, or its tool touches the part."""
    found = []
    for side, each in zip(shared, inputs):
        turned = model if side.axis is None else orientation.turned_texts(model, side.axis, side.angle)
        found.append(assess(each, 3, whole=True))
        if not found[-1].remains_good or touches(each, turned):
            return []
    return found


def _tries(given, machine, can_incline):
    """Yields lists of Sides by which a TextureInput's faces may be reached whole: the tool leant on a machine
    with rotary axes, the part turned in a clamping of its own for each on others, if it may be."""
    rotary = machine is not None and bool(machine.rotary_letters)
    if not rotary and not can_incline:
        return
    for ups, steepest in _directions(given):
        laid = {"mapping": "On surface", "steepest_slope": steepest}
        yield [_leant(up, laid) if rotary else _turned(up, laid) for up in ups]


def _leant(up, laid):
    away = tuple(-float(c) for c in up)
    tool = {"tool_axis_mode": "Fixed", "fixed_axis": tuple(float(c) for c in up)}
    return Side({**laid, **tool, "direction": away, "auto_direction": False})


def _turned(up, laid):
    x, y, z = (float(c) for c in up)
    level = math.hypot(x, y)
    axis = (y / level, -x / level, 0.0) if level > PARALLEL else (1.0, 0.0, 0.0)
    return Side(dict(laid), axis, math.degrees(math.atan2(level, z)))


def _directions(given):
    """Yields (unit vectors that look at the tool, steepest slope to each [degrees])."""
    axis = _common_axis(given)
    if axis is None:
        up = np.array(orientation.up_of(*_best_leaning(given)))
        yield (up, -up), orientation.LAID_STEEP
        return
    across = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    across /= np.linalg.norm(across)
    other = np.cross(axis, across)
    for lean in (math.radians(angle) for angle in LEANS):
        azimuths = (FIRST_AZIMUTH + 2.0 * math.pi * k / AROUND for k in range(AROUND))
        ups = [
            math.cos(lean) * axis + math.sin(lean) * (math.cos(a) * across + math.sin(a) * other)
            for a in azimuths
        ]
        yield ups, math.degrees(math.acos(math.sin(lean) * math.cos(math.pi / AROUND)))


def _best_leaning(given):
    normals, areas = orientation.face_normals(given)
    _, angle, axis = orientation.leanings(normals, areas, laid=True)[0]
    return axis, angle


def _common_axis(given):
    """The unit axis of all faces, upwards, if they are cylinders that are parallel; else None."""
    axes = []
    for text in given.breps:
        for face in orientation.shape_of(text).Faces:
            if face.Surface.TypeId != "Part::GeomCylinder":
                return None
            axes.append(np.array(face.Surface.Axis))
    if not axes or any(np.linalg.norm(np.cross(axes[0], one)) > PARALLEL for one in axes):
        return None
    return axes[0] if axes[0][2] >= 0.0 else -axes[0]


def asked(given, side, model=()):
    """The TextureInput of a Side; `model`: see orientation.turned."""
    given = replace(given, **side.fields)
    return given if side.axis is None else orientation.turned(given, side.axis, side.angle, model)


def _reaches_its_part(given, count):
    """Whether the texture of one of `count` Sides mills about as much of the faces as it has to: what along
    borders it does not see counts as missing here, though a margin leaves it out."""
    return milled_fraction([given]) >= ABOUT / count


def milled_fraction(inputs):
    """Of the lattice points on the faces, what the textures of TextureInputs mill that are laid on the same
    faces, each dimple counted once. Raises InputError where one of them has no dimple."""
    dimples = [place_texture(given).dimples for given in inputs]
    points, which = np.unique(np.concatenate([one.lattice for one in dimples]), axis=0, return_inverse=True)
    states = np.concatenate([one.states for one in dimples])
    cut, left_out = np.zeros((2, len(points)), dtype=bool)
    np.logical_or.at(cut, which.ravel(), states == _STATES.CUT)
    np.logical_or.at(left_out, which.ravel(), np.isin(states, NOT_ASKED_FOR))  # by one of them: by all
    return cut.sum() / max(1, (cut | ~left_out).sum())


def with_others(assess, found, given, others):
    """The Assessment `found` of a TextureInput, with those of others on its faces that can be made."""
    made, inputs = [found], [given]
    for each in others:
        try:
            made.append(assess(each, 3, whole=True))
            inputs.append(each)
        except InputError:
            continue
    return together(made, inputs) if len(made) > 1 else found


def together(found, inputs):
    """The Assessment of several textures that share faces, from those of each and their TextureInputs."""
    dimples = sum(one.dimples for one in found)
    patches = [
        replace(patch, fraction=patch.fraction * one.dimples / max(1, dimples))
        for one in found
        for patch in one.patches
    ]
    wholes = [one.whole for one in found if one.whole is not None]
    areas = [one.whole_area for one in found if one.whole_area is not None]
    return Assessment(
        dimples,
        milled_fraction(inputs),
        dict(found[0].counts, cut=dimples),
        sorted(patches, key=lambda patch: patch.tilt),
        seconds=sum(one.seconds for one in found),
        away_fraction=max(0.0, 1.0 - sum(1.0 - one.away_fraction for one in found)),
        whole=min(wholes, default=None),
        whole_area=min(areas, default=None),
        touches=any(one.touches for one in found),
    )
