"""From faces to ToolPath, without a document: the pipeline of one texture.

    faces -> SurfacePoint -> Dimple -> ToolPath

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field
from math import radians

import _patchmill as core
from _patchmill import InputError

from patchmill import machines, strategies


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
    spacing: float = 0.5
    patch_shape: str = "Square"
    patch_side: int = 14
    patches_x: int = 0  # 0 with patches_y: as many as cover the faces
    patches_y: int = 0
    helix_order: str = "Inward"
    helix_start: str = "Same corner"
    direction: tuple = (0.0, 0.0, -1.0)
    rotation: float = 0.0
    origin: tuple = None  # None: the middle of the faces as seen along the direction
    steepest_slope: float = 80.0
    minimum_tilt: float = 1.0
    margin: float = 0.0
    minimum_dimples: int = 0
    same_flute: bool = True
    extra_turns: float = 5.0
    phase_step: float = 0.0
    decimals: int = 3
    strategy: str = strategies.CONSTANT
    machine: str = ""  # key of a machine file; '' for none
    lift: float = 0.1  # clearance of paced paths between rows [mm]
    calibrating: bool = False  # the machine's start phase is being looked for, not applied


@dataclass
class PlannedTexture:
    """A texture with its path and everything a report needs."""

    input: TextureInput
    plane: core.TexturePlane
    division: core.PatchDivision
    dimples: core.Dimples
    rule: core.PhaseRule
    pacing: strategies.Pacing
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


VERTICAL = (0.0, 0.0, 1.0)


def _plane(given, origin):
    direction = given.direction
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


def _division(given, low, high):
    pattern = core.PatchPattern(
        given.patch_shape, given.spacing, given.patch_side, given.helix_order, given.helix_start
    )
    outline = core.patch_block(pattern, 1, 1).outlines()[0]
    size, room = outline.max(axis=0) - outline.min(axis=0), high - low
    if (size > room).any():
        raise InputError(
            "PatchSide",
            given.patch_side,
            "a patch of %.3f x %.3f mm is larger than the faces (%.3f x %.3f mm seen along the "
            "projection direction): choose a smaller side." % (*size, *room),
        )
    if given.patches_x == 0 and given.patches_y == 0:
        return core.cover(pattern, low, high)
    return core.patch_block(pattern, given.patches_x, given.patches_y)


@dataclass
class PlacedTexture:
    """Dimples on the faces, before any timing: what a preview shows."""

    input: TextureInput
    plane: core.TexturePlane
    division: core.PatchDivision
    dimples: core.Dimples


def place_texture(given, progress=None):
    """PlacedTexture of a TextureInput, or None if `progress` (share -> bool) returned False.

    Raises InputError naming the property that is wrong."""
    if not given.spacing > 0.0:  # also NaN; before the faces are looked at
        raise InputError("Spacing", "%g mm" % given.spacing, "give a value greater than zero.")
    plane, sampler, low, high = _sampler(given)
    division = _division(given, low, high)
    dimples = sampler.place(division, plane, given.surface, progress)
    if dimples is None:
        return None
    core.keep_off_borders(dimples, given.breps, given.margin)
    core.mark_tool_tip(dimples, VERTICAL, radians(given.minimum_tilt))
    core.drop_slivers(dimples, given.minimum_dimples)
    return PlacedTexture(given, plane, division, dimples)


def plan_texture(given, progress=None):
    """PlannedTexture of a TextureInput, or None if `progress` (share -> bool) returned False.

    Raises InputError naming the property that is wrong."""
    placed = place_texture(given, progress)
    if placed is None:
        return None
    dimples = placed.dimples
    rule = core.PhaseRule(given.same_flute, given.extra_turns, radians(given.phase_step))
    machine = machines.load(given.machine) if given.machine else None
    pacing = strategies.make(given, dimples, rule, machine)
    return PlannedTexture(
        given,
        placed.plane,
        placed.division,
        dimples,
        rule,
        pacing,
        machine,
        dict(dimples.counts()),
    )
