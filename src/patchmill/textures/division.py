"""From faces to the texture plane, its sampler, the sizes of the texture and its patches.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from math import cos, radians

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.geometry import faces_or_mesh
from patchmill.system import memory
from patchmill.textures import masks

# measured by tests/bench/jobs_memory_bench.py, from 10 thousand dimples to two million
BYTES_PER_POINT = {"Projected": 125, "On surface": 380}  # of the lattice, while dimples are placed
BYTES_PER_DIMPLE = 4100  # to be cut, with its moves in the document
BYTES_AT_LEAST = 9e6  # the threads' own
SAMPLES = 32  # along each side of what the faces cover, where it is foreseen how many dimples there will be
SURELY = 0.8  # of what samples say


def _direction(given, remarks):
    """The direction of projection: as given, or from where the faces look largest. Faces that look to all
    sides alike are projected on as given, or, if little of them is seen so, from the side that shows most."""
    if not given.auto_direction:
        return given.direction
    direction, even = faces_or_mesh.seen_best(given)
    if even:
        remarks.append(
            "The faces look to all sides alike: they are projected on along (%.4g, %.4g, %.4g)."
            % tuple(direction)
        )
    return tuple(direction)


def _plane(given, origin, direction):
    along_x = abs(direction[0]) > 0.9 * sum(c * c for c in direction) ** 0.5
    hint = (0.0, 1.0, 0.0) if along_x else (1.0, 0.0, 0.0)
    return core.texture_plane(origin, direction, hint, radians(given.rotation))


def sampler_on(given, remarks):
    """The texture plane, with its origin as given or in the middle of the faces; the sampler on it; and
    the rectangle that the faces cover there, as its least and greatest corner. What is decided for the user
    is appended to `remarks`, a list of sentences."""
    direction = _direction(given, remarks)
    plane = _plane(given, given.origin or (0.0, 0.0, 0.0), direction)
    sampler = faces_or_mesh.sampler(given, plane)
    low, high = sampler.extent()
    if given.origin is None:
        middle = 0.5 * (low + high)
        origin = plane.origin + middle[0] * plane.x_axis + middle[1] * plane.y_axis
        plane = _plane(given, origin, direction)
        sampler = faces_or_mesh.sampler(given, plane)
        low, high = low - middle, high - middle
    return plane, sampler, low, high


def texture_size(given):
    """All sizes of the texture. Raises InputError naming the one that is missing or at odds."""
    return core.texture_size(
        given.texture_kind,
        given.patch_shape,
        given.tool.radius,
        spacing=given.spacing or None,
        depth=given.depth or None,
        diameter=given.dimple_diameter or None,
        area_share=given.area_share or None,
        ridge_height=given.ridge_height or None,
    )


def require_apart(given):
    """Isolated dimples must not touch at the greatest depth that a mask gives them either."""
    mask = given.mask
    if given.texture_kind != "Isolated" or mask.use != masks.DEPTH:
        return
    deepest = max(mask.depth_at_black, mask.depth_at_white)
    shape, radius = given.patch_shape, given.tool.radius
    if deepest > 0.0:
        core.texture_size("Isolated", shape, radius, spacing=given.spacing, depth=deepest)


def _pattern(given, side, across):
    return core.PatchPattern(
        given.patch_shape, given.spacing, side, given.helix_order, given.helix_start, across
    )


def _fits(given, side, across, room):
    outline = core.patch_block(_pattern(given, side, across), 1, 1).outlines()[0]
    return outline.max(axis=0) - outline.min(axis=0) <= room


def _greatest(wanted, least, fits):
    """The greatest number from `least` to `wanted` that fits; at least `least`."""
    if fits(wanted):
        return wanted
    while wanted - least > 1:
        middle = (least + wanted) // 2
        least, wanted = (middle, wanted) if fits(middle) else (least, middle)
    return least


def _fitting(given, room, remarks):
    """The pattern as it is given, or, if one patch is larger than `room`, with the greatest sides that are
    not; at least the smallest patch there is. That is said in `remarks`."""
    side, across = given.patch_side, given.patch_side_across
    if _fits(given, side, across, room).all():
        return _pattern(given, side, across)
    least = core.least_patch_side(given.patch_shape)
    if core.two_sided(given.patch_shape):
        fitting = _greatest(side, 1, lambda n: _fits(given, n, 1, room)[0])
        across = _greatest(across or side, 1, lambda n: _fits(given, 1, n, room)[1])
        remarks.append(
            "A patch of side %d is larger than the faces (%.4g x %.4g mm): its sides are made %d and %d."
            % (side, *room, fitting, across)
        )
    else:
        fitting = _greatest(side, least, lambda n: _fits(given, n, 0, room).all())
        remarks.append(
            "A patch of side %d is larger than the faces (%.4g x %.4g mm): its side is made %d."
            % (side, *room, fitting)
        )
    return _pattern(given, fitting, across)


def divide(given, plane, sampler, low, high, remarks, progress):
    """The patches, and the _patchmill.LaidOnFaces or None; None if `progress` returned False. What is
    decided for the user is appended to `remarks`."""
    covering = given.patches_x == 0 and given.patches_y == 0
    if given.mapping not in ("Projected", "On surface"):
        raise InputError("Mapping", given.mapping, "give Projected, On surface or Ball.")
    if given.mapping == "Projected":
        pattern = _fitting(given, high - low, remarks)
        if covering:
            return _foreseen(given, core.cover(pattern, low, high)), None
        return _foreseen(given, core.patch_block(pattern, given.patches_x, given.patches_y)), None
    pattern = _pattern(given, given.patch_side, given.patch_side_across)
    laid = core.lay_on_faces(
        pattern,
        given.breps,
        plane,
        sampler,
        radians(given.steepest_slope),
        radians(given.rotation),
        _start_on_faces(given, sampler),
        progress,
    )
    if laid is None:
        return None
    if covering:
        return _foreseen(given, laid.cover()), laid
    return _foreseen(given, core.patch_block(pattern, given.patches_x, given.patches_y)), laid


def _foreseen(given, division):
    """The division. Raises InputError naming Spacing if there is no memory for its lattice points."""
    (outline,) = core.patch_block(division.pattern, 1, 1).outlines()
    x, y = outline.T
    area = 0.5 * abs(x @ np.roll(y, -1) - y @ np.roll(x, -1))
    points = len(division) * area / division.pattern.cell_area
    require_memory(division, BYTES_PER_POINT[given.mapping], points)
    return division


def require_memory(division, each, count):
    """Raises InputError naming Spacing if so many dimples, of so many bytes each, take more memory than there
    is."""
    remedy = "there would be %.3g dimples. Choose a larger spacing, fewer patches or fewer faces." % count
    memory.require(each * count + BYTES_AT_LEAST, "Spacing", "%g mm" % division.pattern.spacing, remedy)


def require_memory_to_plan(given, sampler, low, high, upright):
    """Raises InputError naming Spacing where the dimples that will surely be cut on faces from `low` to
    `high` of the texture plane take more memory than there is, before the lattice itself takes some. Patches
    that are counted, and masks, are left to when it is known what they leave. `upright`: whether the tool
    is."""
    if given.patches_x or given.patches_y or given.mask:
        return
    shares = (np.arange(SAMPLES) + 0.5) / SAMPLES
    places = np.stack(np.meshgrid(shares, shares), axis=-1).reshape(-1, 2)
    seen = sampler.sample(low + places * (high - low))
    cut = seen["states"] == core.DimpleState.CUT
    if upright:  # what is flatter is left out
        cut &= seen["normals"][:, 2] <= cos(radians(given.minimum_tilt))
    pattern = _pattern(given, given.patch_side, given.patch_side_across)
    count = SURELY * cut.mean() * float(np.prod(high - low)) / pattern.cell_area
    remedy = "there would be about %.3g dimples. Choose a larger spacing or fewer faces." % count
    needed = BYTES_PER_DIMPLE * count
    memory.require(needed, "Spacing", "%g mm" % given.spacing, remedy)


def _start_on_faces(given, sampler):
    """The point where a lattice on the surface begins, or None for the middle of the faces."""
    if given.origin is None:
        return None
    sample = sampler.sample(np.zeros((1, 2)))
    if sample["states"][0] != core.DimpleState.CUT:
        raise InputError(
            "Origin",
            "(%g, %g, %g) mm" % tuple(given.origin),
            "a texture on the surface begins there, and no face can be cut there: move it.",
        )
    return sample["positions"][0]


def divide_through_plane(given, pattern, plane, sampler, low, high, progress):
    """The patches and a _patchmill.SurfaceLattice without gaps, of the faces as they are seen along the
    projection; None if `progress` returned False."""
    start = lattice_start(given, sampler, low, high)
    block = None
    if given.patches_x or given.patches_y:
        block = core.patch_block(pattern, given.patches_x, given.patches_y)
        outlines = np.concatenate(block.outlines())  # flat: on slopes it takes less of the plane
        slack = 2.0 * pattern.spacing
        low = np.maximum(low, start + outlines.min(axis=0) - slack)
        high = np.minimum(high, start + outlines.max(axis=0) + slack)
    lattice = core.lay_lattice(pattern, sampler, plane, start, low, high, progress)
    if lattice is None:
        return None
    if block is None:
        return core.cover_lattice(pattern, lattice, low, high), lattice
    return block, lattice.counted_from(block.anchor, pattern)


def lattice_start(given, sampler, low, high):
    """Where a lattice laid on the surface begins: the texture's origin, or, if that is automatic and off
    the faces, the nearest place on them."""
    origin = np.zeros(2)
    if given.origin is None:
        try:
            return core.nearest_start(origin, low, high, sampler)
        except InputError as error:
            raise InputError("Direction", "%g, %g, %g" % given.direction, error.remedy) from None
    if sampler.sample(origin[None])["states"][0] != core.DimpleState.CUT:
        raise InputError(
            "Origin",
            "(%g, %g, %g) mm" % tuple(given.origin),
            "a texture on the surface begins there, and no face can be cut there: move it.",
        )
    return origin


# What helps if nothing is left to mill, by the reason that most dimples were left out for.
_REMEDIES = {
    "off the face": "choose other faces, or move the texture's origin",
    "too steep": "raise SteepestSlope, or project from another Direction",
    "tool tip": "incline the part or lean the tool, for the tip of a ball does not cut",
    "undercut": "project from another Direction, or lean the tool towards the face",
    "near an edge": "lower Margin",
    "sliver": "lower MinimumDimples, or choose smaller patches",
    "masked": "change the mask",
    "no facet": "project from another Direction, or choose smaller patches",
    "off the net": "choose the projected mapping, or divide the faces",
    "crowded": "choose a smaller spacing, or fewer faces",
}


_SIDEWAYS = "the faces look sideways or down: incline the part, or project from where they are seen"
_NOT_SEEN = {"off the face", "undercut", "too steep"}


def require_some(counts, given):
    """Raises InputError naming Dimples, with what helps, if none is left to be cut. `counts`: of dimples by
    the name of their state."""
    if counts["cut"]:
        return
    reasons = sorted((n, name) for name, n in counts.items() if n)[::-1]
    remedy = _REMEDIES[reasons[0][1]]
    if {name for _, name in reasons} <= _NOT_SEEN and _look_aside(given):
        remedy = _SIDEWAYS
    raise InputError(
        "Dimples",
        "0",
        "every lattice point was left out (%s): %s."
        % (", ".join("%s: %d" % (name, n) for n, name in reasons), remedy),
    )


def _look_aside(given):
    """Whether faces without a dimple look largest from 60 degrees or more beside the projection."""
    if given.auto_direction:
        return False
    best, _ = faces_or_mesh.seen_best(given)
    cosine = np.dot(best, given.direction) / np.linalg.norm(given.direction)
    return cosine < 0.5
