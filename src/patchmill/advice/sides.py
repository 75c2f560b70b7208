"""Faces that are closed, as of a shaft or a bore, of which one setup reaches less than half: several
textures share them, each from another side.

A lattice that is laid on the faces is the same from wherever a texture is projected. So each of the
textures mills what is no steeper to its own direction than where the next one's begins: no dimple twice, and
none left. Where all normals of the faces are at one angle alpha to an axis, as of cylinders, cones, prisms
and extruded profiles, directions that stand evenly around it, all at an angle theta to it, see a normal that
is turned by phi from their own azimuth under a cosine of cos(alpha) cos(theta) + sin(alpha) sin(theta)
cos(phi); of n of them the next begins at phi = 180°/n.

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
from patchmill.textures.order import rows
from patchmill.textures.plan import place_texture

AROUND = 3  # textures around an axis
# Of their directions to it [degrees]: a bore hides its walls from the first
LEANS = (50.0, 30.0, 25.0, 20.0)
FIRST_AZIMUTH = 0.1  # [rad]: where no column of a lattice lies between two textures
_STATES = core.DimpleState
NOT_ASKED_FOR = [_STATES.OFF_FACE, _STATES.OFF_NET, _STATES.MASKED, _STATES.NEAR_EDGE]
ABOUT = 0.9
PARALLEL = 1e-6  # sine of the angle between axes
EVEN = 0.02  # that cosines of normals to their axis may differ by: STEP files have cones of splines


@dataclass
class Side:
    """One of several textures. `fields`: of its TextureInput; `axis` and `angle` [degrees]: how its part is
    turned, from where it is; None where the tool is leant instead."""

    fields: dict = field(default_factory=dict)
    axis: tuple = None
    angle: float = 0.0


def find(functions, given, free, can_incline, model=()):
    """(Sides with the values that suit the first of them, Assessment of all) by which the faces become good;
    ([], None) where nothing does. `functions`: assess and choose of remedies.Finder, whose the other
    arguments are, too, room.touches and choice.first_ways."""
    machine = machines.load(given.machine) if given.machine else None
    for shared in _tries(given, machine, can_incline):
        try:
            made, together = _made_of(functions, given, shared, free, model)
        except InputError:
            continue
        if made and together.good:
            return made, together
    return [], None


def _made_of(functions, given, shared, free, model):
    """The same for some Sides; ([], None) where one of them does not reach its part or is not good, or where
    its tool would run into the part. The values are those of the first side that suit all."""
    assess, choose, touches, ways = functions
    if not _reaches_its_part(asked(given, shared[0], model), len(shared)):
        return [], None
    turned = _turned_model(model, shared[0])
    if not any(_is_clear(touches, way, turned) for way in ways(asked(given, shared[0], model), free)):
        return [], None  # whatever the values, which take long to find
    for chosen in shared:
        suits = choose(asked(given, chosen, model), free)
        if suits is None or not suits.assessment.remains_good:
            continue
        for fields in _with_rows_across(suits.fields):
            inputs = [asked(replace(given, **fields), side, model) for side in shared]
            found = _assessments(assess, touches, inputs, shared, model)
            if found:
                made = [replace(side, fields={**fields, **side.fields}) for side in shared]
                return made, together(found, inputs)
    return [], None


def _is_clear(touches, given, model):
    """Whether a TextureInput can be planned and keeps off a model."""
    try:
        return not touches(given, model)
    except InputError:
        return False


def _with_rows_across(fields):
    """Fields, and the same with rows in the other direction: rows run in and out at their ends."""
    yield fields
    if fields.get("order") == rows.ROWS and fields.get("row_direction") in rows.ACROSS:
        yield dict(fields, row_direction=rows.ACROSS[fields["row_direction"]])


def _assessments(assess, touches, inputs, shared, model):
    """Those of the TextureInputs of Sides; none where one is not good, or its tool touches the part."""
    if any(touches(each, _turned_model(model, side)) for side, each in zip(shared, inputs)):
        return []
    found = []
    for each in inputs:
        found.append(assess(each, 3, whole=True))
        if not found[-1].remains_good:
            return []
    return found


def _turned_model(model, side):
    return model if side.axis is None else orientation.turned_texts(model, side.axis, side.angle)


def _tries(given, machine, can_incline):
    """Yields lists of Sides by which a TextureInput's faces may be reached whole: the tool leant on a machine
    with rotary axes, the part turned in a clamping of its own for each on others, if it may be."""
    rotary = machine is not None and bool(machine.rotary_letters)
    if not rotary and not can_incline:
        return
    for ups, steepest in _directions(given, from_above=rotary):
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


def _directions(given, from_above=True):
    """Yields (unit vectors that look at the tool, steepest slope to each [degrees]). `from_above`: a tool
    that leans does not come from below; a part can be turned over."""
    axis, cosine = _common_axis(given)
    if axis is None:
        up = np.array(orientation.up_of(*_best_leaning(given)))
        yield (up, -up), orientation.LAID_STEEP
        return
    if from_above and axis[2] < 0.0:
        axis, cosine = -axis, -cosine
    across = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    across /= np.linalg.norm(across)
    other = np.cross(axis, across)
    level = math.sqrt(1.0 - cosine**2) * math.cos(math.pi / AROUND)
    for lean in (math.radians(angle) for angle in LEANS):
        azimuths = (FIRST_AZIMUTH + 2.0 * math.pi * k / AROUND for k in range(AROUND))
        ups = [
            math.cos(lean) * axis + math.sin(lean) * (math.cos(a) * across + math.sin(a) * other)
            for a in azimuths
        ]
        steepest = math.degrees(math.acos(cosine * math.cos(lean) + level * math.sin(lean)))
        if steepest < orientation.LAID_STEEP:
            yield ups, steepest


def _best_leaning(given):
    normals, areas = orientation.face_normals(given)
    _, angle, axis = orientation.leanings(normals, areas, laid=True)[0]
    return axis, angle


def _common_axis(given):
    """(unit axis, cosine of the normals to it), if that is the same of all normals of the faces and they do
    not all lie in a plane with it; else (None, None). The axis goes where the normals do, and upwards where
    they are square to it."""
    normals = orientation.surface_normals(given)
    if not len(normals):
        return None, None
    middle = normals.mean(axis=0)
    spread, axes = np.linalg.eigh((normals - middle).T @ (normals - middle) / len(normals))
    axis = axes[:, 0]
    cosines = normals @ axis
    if spread[1] < EVEN or np.ptp(cosines) > EVEN:
        return None, None
    cosine = float(cosines.mean())
    sign = math.copysign(1.0, cosine if abs(cosine) > EVEN else axis[2])
    return sign * axis, sign * cosine


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
