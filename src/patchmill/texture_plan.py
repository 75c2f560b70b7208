"""From faces to ToolPath, without a document: the pipeline of one curved texture.

    faces -> SurfacePoint -> Dimple -> ToolPath   (Xu & Sasahara 2016)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field
from math import radians

import _patchmill as core
from _patchmill import InputError


@dataclass
class TextureInput:
    """What a curved texture is made from. Lengths in mm, angles in degrees, feed in mm/s."""

    breps: list  # faces as BREP texts
    tool: core.BallEndMill
    spindle: core.Spindle
    feed: float
    safe_height: float
    clearance_height: float
    spacing: float = 0.5
    patch_side: int = 14
    patches_x: int = 0  # 0: as many as cover the faces
    patches_y: int = 0
    outward: bool = False
    direction: tuple = (0.0, 0.0, -1.0)
    rotation: float = 0.0
    origin: tuple = None  # None: the middle of the faces as seen along the direction
    steepest_slope: float = 80.0
    minimum_tilt: float = 1.0
    same_flute: bool = True
    extra_turns: float = 5.0
    phase_step: float = 0.0
    decimals: int = 3


@dataclass
class PlannedTexture:
    """A texture with its path and everything a report needs."""

    input: TextureInput
    plane: core.TexturePlane
    division: core.SquareDivision
    dimples: core.Dimples
    path: core.ToolPath
    rule: core.PhaseRule
    feed: float  # as posted [mm/s]
    counts: dict = field(default_factory=dict)

    def phase_errors(self, path=None):
        """Phase errors [rad] of `path` (the planned one if None), as from _patchmill.phase_errors."""
        return core.phase_errors(path or self.path, self.dimples, self.rule)


VERTICAL = (0.0, 0.0, 1.0)


def _plane(given, origin):
    direction = given.direction
    along_x = abs(direction[0]) > 0.9 * sum(c * c for c in direction) ** 0.5
    hint = (0.0, 1.0, 0.0) if along_x else (1.0, 0.0, 0.0)
    return core.texture_plane(origin, direction, hint, radians(given.rotation))


def _sampler(given):
    """The sampler on a texture plane whose origin is the given one, or the middle of the faces."""
    steepest = radians(given.steepest_slope)
    plane = _plane(given, given.origin or (0.0, 0.0, 0.0))
    sampler = core.FaceSampler(given.breps, plane, steepest)
    low, high = sampler.extent()
    size = high - low
    if given.origin is None:
        middle = 0.5 * (low + high)
        origin = plane.origin + middle[0] * plane.x_axis + middle[1] * plane.y_axis
        plane = _plane(given, origin)
        sampler = core.FaceSampler(given.breps, plane, steepest)
    return plane, sampler, size


def _division(given, size):
    covering = core.patches_to_cover(given.spacing, given.patch_side, size[0], size[1])
    return core.SquareDivision(
        given.spacing,
        given.patch_side,
        given.patches_x or covering[0],
        given.patches_y or covering[1],
        given.outward,
    )


def plan_texture(given, progress=None):
    """PlannedTexture of a TextureInput, or None if `progress` (share -> bool) returned False.

    Raises InputError naming the property that is wrong."""
    if not given.spacing > 0.0:  # also NaN; before the faces are looked at
        raise InputError("Spacing", "%g mm" % given.spacing, "give a value greater than zero.")
    plane, sampler, size = _sampler(given)
    division = _division(given, size)
    dimples = sampler.place(division, progress)
    if dimples is None:
        return None
    core.mark_tool_tip(dimples, VERTICAL, radians(given.minimum_tilt))
    rule = core.PhaseRule(given.same_flute, given.extra_turns, radians(given.phase_step))
    path = core.constant_feed_path(
        dimples,
        given.tool,
        given.spindle,
        given.feed,
        rule,
        given.safe_height,
        given.clearance_height,
        given.decimals,
    )
    feed = core.posted_feed(given.feed, given.decimals)
    return PlannedTexture(
        given, plane, division, dimples, path, rule, feed, dict(dimples.counts())
    )
