"""From faces to ToolPath, without a document: the pipeline of one texture.

    faces -> SurfacePoint -> Dimple -> ToolPath

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field, replace
from math import degrees, radians

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill import machines, strategies, texture_mask


@dataclass
class TextureInput:
    """What a texture is made from. Lengths in mm, angles in degrees, feed in mm/s."""

    breps: list  # faces as BREP texts
    tool: core.BallEndMill
    spindle: core.Spindle
    feed: float
    safe_height: float
    clearance_height: float
    surface: core.PatchSurface = field(default_factory=lambda: core.PatchSurface("Curved"))
    # sizes: give what is known, 0 for the rest; in a plan `spacing` is the one that was found
    spacing: float = 0.5
    texture_kind: str = "Overlapping"
    depth: float = 0.0
    dimple_diameter: float = 0.0
    area_share: float = 0.0
    ridge_height: float = 0.0
    mapping: str = "Projected"
    patch_shape: str = "Square"
    patch_side: int = 14
    patches_x: int = 0  # 0 with patches_y: as many as cover the faces
    patches_y: int = 0
    helix_order: str = "Inward"
    helix_start: str = "Same corner"
    direction: tuple = (0.0, 0.0, -1.0)
    auto_direction: bool = False  # from where the faces look largest; `direction` is not used
    rotation: float = 0.0
    origin: tuple = None  # None: the middle of the faces as seen along the direction
    steepest_slope: float = 80.0
    minimum_tilt: float = 1.0
    avoid_rubbing: bool = False
    margin: float = 0.0
    minimum_dimples: int = 0
    mask: texture_mask.MaskInput = None
    same_flute: bool = True
    extra_turns: float = 5.0
    phase_step: float = 0.0
    decimals: int = 3
    strategy: str = strategies.CONSTANT
    machine: str = ""  # key of a machine file; '' for none
    lift: float = 0.1  # clearance of paced paths between rows [mm]
    calibrating: bool = False  # the machine's start phase is being looked for, not applied


VERTICAL = (0.0, 0.0, 1.0)


@dataclass
class PlacedTexture:
    """Dimples on the faces, before any timing: what a preview shows. `size` is a dict of all sizes (see
    _patchmill.texture_size); `lattice` a _patchmill.SurfaceLattice, or None if projected."""

    input: TextureInput
    plane: core.TexturePlane
    division: core.PatchDivision
    dimples: core.Dimples
    size: dict
    lattice: core.SurfaceLattice = None
    asked: TextureInput = None  # as it was given; `input` has its sizes completed

    def places(self):
        """Texture-plane coordinates [mm] of each lattice point, (n, 2)."""
        if self.lattice is None:
            return self.division.places(self.dimples)
        return self.lattice.places(self.dimples.lattice[:, :2])

    def outlines(self, pieces=8):
        """Each patch's outline in the texture plane [mm], a list of (k, 2); on a lattice laid on the
        surface each side is cut into `pieces`, and NaN where the lattice ends."""
        if self.lattice is None:
            return self.division.outlines()
        share = np.arange(pieces)[:, None] / pieces
        found = []
        for corners in self.division.lattice_outlines():
            sides = [a + share * (b - a) for a, b in zip(corners, np.roll(corners, -1, axis=0))]
            found.append(self.lattice.places(np.concatenate(sides)))
        return found

    def spread(self):
        """Distances of neighbouring dimples as measured: see _patchmill.spacing_spread."""
        return core.spacing_spread(self.dimples, self.division.pattern)

    def rubbing(self):
        """How many milled dimples are so near to the tool's tip that it rubs in them."""
        tilts = core.tilts(self.dimples, VERTICAL)[self.dimples.states == 0]
        return int((tilts < self.size["least_tilt"]).sum())


@dataclass
class PlannedTexture(PlacedTexture):
    """A texture with its path and everything a report needs."""

    rule: core.PhaseRule = None
    pacing: strategies.Pacing = None
    machine: machines.Machine = None
    counts: dict = field(default_factory=dict)

    @property
    def path(self):
        return self.pacing.path

    @property
    def feed(self):
        """As posted [mm/s]."""
        return self.pacing.feed

    def phase_errors(self, path=None):
        """Phase errors [rad] of `path` (the planned one if None) if the machine does as it is told."""
        return core.phase_errors(path or self.path, self.dimples, self.rule)

    def predicted_errors(self):
        """Phase errors [rad] that the machine's motion model predicts, or None without a machine."""
        if self.machine is None:
            return None
        return core.predicted_phase(self.path, self.machine.model, self.dimples, self.rule)


def _plane(given, origin):
    direction = given.direction
    if given.auto_direction:
        direction = tuple(-core.facing(given.breps))
    along_x = abs(direction[0]) > 0.9 * sum(c * c for c in direction) ** 0.5
    hint = (0.0, 1.0, 0.0) if along_x else (1.0, 0.0, 0.0)
    return core.texture_plane(origin, direction, hint, radians(given.rotation))


def _sampler(given):
    """The texture plane, with its origin as given or in the middle of the faces; the sampler on it; and
    the rectangle that the faces cover there, as its least and greatest corner."""
    steepest = radians(given.steepest_slope)
    plane = _plane(given, given.origin or (0.0, 0.0, 0.0))
    sampler = core.FaceSampler(given.breps, plane, steepest)
    low, high = sampler.extent()
    if given.origin is None:
        middle = 0.5 * (low + high)
        origin = plane.origin + middle[0] * plane.x_axis + middle[1] * plane.y_axis
        plane = _plane(given, origin)
        sampler = core.FaceSampler(given.breps, plane, steepest)
        low, high = low - middle, high - middle
    return plane, sampler, low, high


def _size(given):
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


def _require_apart(given):
    """Isolated dimples must not touch at the greatest depth that a mask gives them either."""
    mask = given.mask
    if given.texture_kind != "Isolated" or mask.use != texture_mask.DEPTH:
        return
    deepest = max(mask.depth_at_black, mask.depth_at_white)
    shape, radius = given.patch_shape, given.tool.radius
    if deepest > 0.0:
        core.texture_size("Isolated", shape, radius, spacing=given.spacing, depth=deepest)


def _require_room(given, pattern, low, high):
    outline = core.patch_block(pattern, 1, 1).outlines()[0]
    size, room = outline.max(axis=0) - outline.min(axis=0), high - low
    if (size > room).any():
        raise InputError(
            "PatchSide",
            given.patch_side,
            "a patch of %.3f x %.3f mm is larger than the faces (%.3f x %.3f mm seen along the "
            "projection direction): choose a smaller side." % (*size, *room),
        )


def _division(given, plane, sampler, low, high, progress):
    """The patches, and the lattice laid on the surface or None; None if `progress` returned False."""
    pattern = core.PatchPattern(
        given.patch_shape, given.spacing, given.patch_side, given.helix_order, given.helix_start
    )
    covering = given.patches_x == 0 and given.patches_y == 0
    if given.mapping not in ("Projected", "On surface"):
        raise InputError("Mapping", given.mapping, "give Projected or On surface.")
    if given.mapping == "Projected":
        _require_room(given, pattern, low, high)
        if covering:
            return core.cover(pattern, low, high), None
        return core.patch_block(pattern, given.patches_x, given.patches_y), None
    start = _start(given, sampler, low, high)
    lattice = core.lay_lattice(pattern, sampler, plane, start, low, high, progress)
    if lattice is None:
        return None
    if covering:
        return core.cover_lattice(pattern, lattice, low, high), lattice
    division = core.patch_block(pattern, given.patches_x, given.patches_y)
    return division, lattice.counted_from(division.anchor, pattern)


def _start(given, sampler, low, high):
    """Where a lattice laid on the surface begins: the texture's origin, or, if that is automatic and off
    the faces, the nearest place on them."""
    origin = np.zeros(2)
    if given.origin is None:
        return core.nearest_start(origin, low, high, sampler)
    if sampler.sample(origin[None])["states"][0] != 0:
        raise InputError(
            "Origin",
            "(%g, %g, %g) mm" % tuple(given.origin),
            "a texture on the surface begins there, and no face can be cut there: move it.",
        )
    return origin


def place_texture(given, progress=None):
    """PlacedTexture of a TextureInput, or None if `progress` (share -> bool) returned False.

    Raises InputError naming the property that is wrong."""
    asked, size = given, _size(given)  # before the faces are looked at
    given = replace(given, spacing=size["spacing"])
    plane, sampler, low, high = _sampler(given)
    divided = _division(given, plane, sampler, low, high, progress)
    if divided is None:
        return None
    division, lattice = divided
    dimples = sampler.place(division, plane, given.surface, lattice, progress)
    if dimples is None:
        return None
    core.sink(dimples, size["sunk"])
    core.keep_off_borders(dimples, given.breps, given.margin)
    placed = PlacedTexture(given, plane, division, dimples, size, lattice, asked)
    if given.mask:
        _require_apart(given)
        mask = texture_mask.make_mask(given.mask, plane, low, high)
        texture_mask.apply_mask(given.mask, mask, dimples, division, lattice)
    _keep_off_tip(placed)
    core.drop_slivers(dimples, given.minimum_dimples)
    return placed


def _keep_off_tip(placed):
    """Leaves out what the tip of the ball would rub. Raises InputError naming AvoidRubbing if it would
    rub in all of them."""
    given, dimples = placed.input, placed.dimples
    core.mark_tool_tip(dimples, VERTICAL, radians(given.minimum_tilt))
    least = placed.size["least_tilt"]
    if not given.avoid_rubbing or least <= radians(given.minimum_tilt):
        return
    tilts = core.tilts(dimples, VERTICAL)[dimples.states == 0]
    if len(tilts) and tilts.max() <= least:
        raise InputError(
            "AvoidRubbing",
            "true",
            "in dimples %.4g mm deep the tip of the ball would rub under a tilt of %.3f degrees, and "
            "the faces have %.3f at most: incline the part or choose shallower dimples."
            % (placed.size["depth"], degrees(least), degrees(tilts.max())),
        )
    core.mark_tool_tip(dimples, VERTICAL, least)


def plan_texture(given, progress=None):
    """PlannedTexture of a TextureInput, or None if `progress` (share -> bool) returned False.

    Raises InputError naming the property that is wrong."""
    placed = place_texture(given, progress)
    if placed is None:
        return None
    given, dimples = placed.input, placed.dimples
    rule = core.PhaseRule(given.same_flute, given.extra_turns, radians(given.phase_step))
    machine = machines.load(given.machine) if given.machine else None
    pacing = strategies.make(given, dimples, rule, machine)
    return PlannedTexture(
        **vars(placed),
        rule=rule,
        pacing=pacing,
        machine=machine,
        counts=dict(dimples.counts()),
    )
