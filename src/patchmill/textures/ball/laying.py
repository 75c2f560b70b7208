"""From a ball to its dimples.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, replace
from typing import Any

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.textures import division
from patchmill.textures.ball import lattice, neighbours, order
from patchmill.textures.ball.sphere import sphere_of
from patchmill.textures.order import rows

MAPPING = "Ball"
SHAPE = "Hexagon"  # of a triangular lattice
SETUPS = ONE, TWO = ("One", "Two")
STEEPEST = 89.9  # that faces are sampled to [degrees]
LEVEL = 1e-9  # of a normal: it looks neither up nor down


@dataclass
class Ball:
    """`sphere`, unit vectors of its whole lattice, (n, 3), the `pairs` of neighbours among them, the number
    in it of each of the PlacedTexture's dimples, and neighbours.spread of the whole."""

    sphere: Any
    whole: np.ndarray
    pairs: np.ndarray
    numbers: np.ndarray
    spread: dict


def is_ball(given):
    """Whether a TextureInput asks for a ball's own lattice."""
    return given.mapping == MAPPING


def place(given):
    """The fields of a PlacedTexture, as a dict, before anything is left out for margins or the tool's tip.
    Raises InputError naming what is wrong, or what a ball cannot have."""
    _require(given)
    sphere = sphere_of(given.breps)
    count = given.ball_dimples or _count(given, sphere)
    whole = lattice.points(given.ball_lattice, count) @ sphere.axes
    pairs = neighbours.pairs(whole)
    spread = neighbours.spread(whole, pairs)
    spacing = round(sphere.radius * spread["mean"], 6)  # as a message says it
    found, size = sized(replace(given, spacing=spacing, patch_shape=SHAPE), sphere.radius, len(whole))
    said: list = []
    seen = replace(found, steepest_slope=min(found.steepest_slope, STEEPEST))
    plane, _, low, high = division.sampler_on(seen, said)
    up = -np.asarray(plane.direction)
    milled = _milled(given, whole, up, sphere)
    inside = milled[pairs[:, 0]] == milled[pairs[:, 1]]
    numbers, run = order.runs(whole, pairs[inside], up)
    division.require_memory(_one_patch(found), division.BYTES_PER_DIMPLE, len(whole))
    states = _states(sphere, whole[numbers], up, milled[numbers])
    dimples = core.dimples_at(
        sphere.points(whole[numbers]),
        whole[numbers],
        np.column_stack([np.arange(len(whole)), run]),
        run.tolist(),
        states.tolist(),
    )
    core.sink(dimples, size["sunk"])
    return {
        "input": found,
        "plane": plane,
        "division": _one_patch(found),
        "dimples": dimples,
        "size": size,
        "extent": (low, high),
        "ball": Ball(sphere, whole, pairs, numbers, spread),
        "remarks": said + _remarks(found, sphere, spread, len(whole), size),
    }


def belongs(normals, up, axes):
    """Whether each of (n, 3) unit vectors is in the half that looks along `up`: of any two opposite halves
    exactly one has it. One that looks neither way goes by the part's own `axes`."""
    height = normals @ up
    for axis in axes:
        level = np.abs(height) < LEVEL
        height = np.where(level, (normals @ axis) * _sense(up, axes), height)
    return height > 0.0


def _sense(up, axes):
    """1 or -1: the other of two opposite directions has the other one."""
    along = axes @ up
    return 1.0 if along[np.argmax(np.abs(along))] > 0.0 else -1.0


def sized(given, radius, count):
    """(the TextureInput with its sizes, all sizes as division.texture_size has them) on a ball of `radius`
    with `count` dimples. A dimple of diameter D is deeper there than in a plane by the ball's own sagitta,

        d = (R - √(R² - D²/4)) + (R_ball - √(R_ball² - D²/4)).

    Raises InputError naming DimpleDiameter or what texture_size names."""
    if given.texture_kind != "Isolated":
        return given, division.texture_size(given)
    tool, rim = given.tool.radius, 0.5 * given.dimple_diameter
    depth = given.depth
    if rim > 0.0:
        if rim >= min(tool, radius):
            remedy = "give less than the tool's diameter, %g mm, and the ball's." % (2.0 * tool)
            raise InputError("DimpleDiameter", "%g mm" % given.dimple_diameter, remedy)
        if depth > 0.0:
            remedy = "on a ball one follows from the other: give 0 for one of them."
            raise InputError("Depth", "%g mm" % depth, remedy)
        depth = _sagitta(tool, rim) + _sagitta(radius, rim)
    found = replace(given, depth=depth, dimple_diameter=0.0, area_share=0.0, ridge_height=0.0)
    size = dict(division.texture_size(found))
    apart = tool + radius - depth
    height = (apart**2 + radius**2 - tool**2) / (2.0 * apart)
    rim = math.sqrt(radius**2 - height**2)
    size["diameter"] = 2.0 * rim
    size["area_share"] = count * 0.5 * (1.0 - height / radius)
    size["least_tilt"] = math.asin(min(1.0, rim / tool))
    return found, size


def _sagitta(radius, rim):
    return radius - math.sqrt(radius**2 - rim**2)


def _count(given, sphere):
    wanted = round(lattice.count_of(sphere.radius, division.texture_size(given)["spacing"]))
    if given.ball_lattice == lattice.ICOSAHEDRAL:
        return lattice.nearest_count(wanted)[0]
    return wanted


def _milled(given, normals, up, sphere):
    """Whether each of (n, 3) unit vectors is one that this set-up mills, if there is a face."""
    if given.ball_setups == TWO:
        return belongs(normals, up, sphere.axes)
    return normals @ up >= math.cos(math.radians(given.steepest_slope))


def _states(sphere, normals, up, milled):
    """A DimpleState for each of (n, 3) unit vectors."""
    states = np.full(len(normals), core.DimpleState.CUT, dtype=np.uint8)
    states[~milled] = core.DimpleState.TOO_STEEP
    states[~milled & (normals @ up <= 0.0)] = core.DimpleState.UNDERCUT
    states[~sphere.on_faces(normals)] = core.DimpleState.OFF_FACE
    return states


def _one_patch(given):
    return core.patch_block(core.PatchPattern(SHAPE, given.spacing, given.patch_side), 1, 1)


def _remarks(given, sphere, spread, count, size):
    """Sentences."""
    f = sphere.radius * spread["mean"]
    said = [
        "%d dimples on the whole ball, neighbours %.4g to %.4g mm apart, %.4g on average."
        % (count, f * spread["least"], f * spread["greatest"], f)
    ]
    if given.texture_kind == "Isolated" and size["diameter"] > f * spread["least"]:
        said.append("Some dimples, %.4g mm wide, run into each other." % size["diameter"])
    return said


def spread_of(ball):
    """Of a Ball's whole lattice: as _patchmill.spacing_spread, distances over their mean; `nearest` beside
    them. Angles are those of an equilateral lattice, 0 for want of two directions that run through."""
    spread = ball.spread
    kept = {name: spread[name] for name in ("least", "greatest", "rms")}
    return dict(kept, least_angle=0.0, greatest_angle=0.0, nearest=spread["least"])


def _require(given):
    refused = [
        ("Order", given.order != rows.HELIX, given.order, "a ball's lattice has no rows: choose Helix."),
        ("Form", given.form == "Free", given.form, "the free form has no lattice: choose another Mapping."),
        ("MaskUse", given.mask is not None, "a mask", "a ball's lattice takes none: choose None."),
        ("PatchesX", given.patches_x or given.patches_y, given.patches_x, "a ball is covered whole: give 0."),
        ("AreaShare", given.area_share, given.area_share, "on a ball give a depth or a diameter."),
        ("RidgeHeight", given.ridge_height, given.ridge_height, "on a ball give the spacing."),
        ("Mapping", given.surface.planar, MAPPING, "a ball needs a curved texture."),
        ("BallSetups", given.ball_setups not in SETUPS, given.ball_setups, "give One or Two."),
    ]  # fmt: skip
    for name, wrong, value, remedy in refused:
        if wrong:
            raise InputError(name, value, remedy)
