"""From faces to ToolPath, without a document: the pipeline of one texture.

    faces -> SurfacePoint -> Dimple -> ToolPath

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import functools
from dataclasses import dataclass, field, replace
from typing import Any, Callable, Optional
from math import radians

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.geometry import faces_or_mesh
from patchmill.machine import machines, machining_time
from patchmill.textures import division, free_form, heights, laid, masks, strategies, tool_posture
from patchmill.textures.ball import laying as balls
from patchmill.textures.division import divide, require_apart, sampler_on, texture_size
from patchmill.textures.input import TextureInput
from patchmill.textures.order import rows
from patchmill.textures.outlines import in_pieces
from patchmill.textures.thread import laying as threads
from patchmill.system.stops import stoppable

__all__ = ["PlacedTexture", "PlannedTexture", "TextureInput", "place_texture", "plan_texture"]

Progress = Optional[Callable[[float], bool]]
NEAREST = 0.9  # spacings: no dimples of a lattice laid on the surface are nearer


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
    extent: tuple = None  # least and greatest corner of what the faces cover of the plane [mm]
    asked: TextureInput = None  # as it was given; `input` has its sizes completed
    laid: core.LaidOnFaces = None  # of a lattice laid on the surface
    remarks: list = field(default_factory=list)  # sentences: what was decided for the user
    direction: Optional[int] = None  # of rows: see rows.ordered
    patches: int = 0  # with dimples to be cut, before FirstPatch leaves some out
    free: core.FreeTexture = None  # of Matsuda's free form; then `division` are the patches' stands
    thread: Any = None  # thread.turning.Turning of a cylinder that is milled all round
    ball: Any = None  # ball.laying.Ball of a lattice that is a sphere's own

    def places(self):
        """Texture-plane coordinates [mm] of each lattice point, (n, 2)."""
        if any(own is not None for own in (self.free, self.thread, self.ball)):
            return self._on_plane(self.dimples.positions)
        if self.lattice is None:
            return self.division.places(self.dimples)
        return self.lattice.places(self.dimples.lattice[:, :2])

    def outlines(self, pieces=1):
        """Each patch's outline in the texture plane [mm], a list of (k, 2), each side cut into `pieces`
        (of 8 at least on a lattice laid on the surface); NaN where the lattice or the faces end."""
        if self.thread is not None or self.ball is not None:
            return []
        if self.free is not None:
            return [in_pieces(self._on_plane(o), pieces) for o in self.free.outlines()]
        if self.lattice is None:
            return [in_pieces(o, pieces) for o in self.division.outlines()]
        corners = self.division.lattice_outlines()
        return [self.lattice.places(in_pieces(c, max(8, pieces))) for c in corners]

    def _on_plane(self, points):
        from_origin = np.asarray(points) - self.plane.origin
        return np.column_stack([from_origin @ self.plane.x_axis, from_origin @ self.plane.y_axis])

    def spread(self):
        """Distances of neighbouring dimples as measured: see _patchmill.spacing_spread. None in the free
        form, whose marks are on no lattice."""
        if self.free is not None:
            return None
        if self.thread is not None:
            return threads.spread_of(self.thread, self.dimples)
        if self.ball is not None:
            return balls.spread_of(self.ball)
        spread = core.spacing_spread(self.dimples, self.division.pattern)
        nearest = core.nearest_distances(self.dimples)
        spread["nearest"] = nearest.min() / self.input.spacing if len(nearest) > 1 else 0.0
        return spread

    def rubbing(self):
        """How many milled dimples are so near to the tool's tip that it rubs in them."""
        if self.thread is not None:
            return threads.rubbing(self)
        tilts = core.tilts(self.dimples, tool_posture.VERTICAL)[self.dimples.states == core.DimpleState.CUT]
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
    def posture(self):
        """The tool_posture.Posture, or None for a tool that stands upright."""
        return self.pacing.posture

    @functools.cached_property
    def seconds(self):
        """Time of all its moves, rapids and turns of the table too [s]: see machining_time."""
        if self.posture is None:
            return machining_time.seconds(self.path, self.input.rapids, self.machine)
        told = self.posture.told
        return machining_time.seconds(told.path, self.input.rapids, self.machine, np.array(told.joints))

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
        if self.thread is not None:  # the lock itself leads all axes
            return self.phase_errors()
        return core.predicted_phase(self.path, self.machine.model, self.dimples, self.rule)


@stoppable
def place_texture(given, progress=None, to_plan=False):
    """PlacedTexture of a TextureInput, or None if `progress` (share -> bool) returned False. `to_plan`: its
    path will be planned, and the memory for that is foreseen. Raises InputError naming the property that is
    wrong."""
    faces_or_mesh.require_possible(given)
    if threads.is_thread(given):
        return PlacedTexture(asked=given, **threads.place(given))
    if balls.is_ball(given):
        fields = balls.place(given)
    elif given.form == "Free":
        fields = free_form.place(given, progress)
    else:
        fields = _place_lattice(given, progress, to_plan)
    if fields is None:
        return None
    placed = PlacedTexture(asked=given, **fields)
    faces_or_mesh.keep_off_border(given, placed.dimples)
    if given.mask:
        _apply_mask(placed)
    if not tool_posture.field_ready(given, _share(progress, 0.0, 0.0)):
        return None
    tool_posture.keep_off_tip(placed)
    if placed.laid is not None:
        core.keep_apart(placed.dimples, NEAREST * placed.input.spacing)
    core.drop_slivers(placed.dimples, given.minimum_dimples)
    placed.remarks.extend(laid.remarks(placed))
    _put_in_order(placed)
    return placed


def _put_in_order(placed: PlacedTexture, direction: Optional[int] = None) -> None:
    """Puts the dimples in the order in which they are to be milled; see rows.ordered."""
    if not rows.in_rows(placed.input):
        return
    placed.dimples = rows.ordered(placed.input, placed.dimples, placed.division, direction)
    if not tool_posture.is_vertical(placed.input):
        tool_posture.keep_off_tip(placed)  # rows have axes of their own


def _place_lattice(given: TextureInput, progress: Progress, to_plan: bool = False) -> Optional[dict]:
    """The fields of a PlacedTexture whose dimples are on a lattice, as a dict."""
    size = texture_size(given)  # before the faces are looked at
    given = replace(given, spacing=size["spacing"])
    remarks: list[str] = []
    plane, sampler, low, high = sampler_on(given, remarks)
    if to_plan:
        division.require_memory_to_plan(given, sampler, low, high, tool_posture.is_vertical(given))
    laying = given.mapping != "Projected"
    divided = divide(given, plane, sampler, low, high, remarks, _share(progress, 0.0, 0.7))
    if divided is None:
        return None
    patches, on_faces = divided
    lattice = on_faces and on_faces.lattice
    if on_faces is not None and (given.patches_x or given.patches_y):
        lattice = lattice.counted_from(patches.anchor, patches.pattern)
    rest = _share(progress, 0.7 if laying else 0.0, 1.0)
    dimples = sampler.place(patches, plane, given.surface, lattice, rest)
    if dimples is None:
        return None
    core.sink(dimples, size["sunk"])
    return {
        "input": given,
        "plane": plane,
        "division": patches,
        "dimples": dimples,
        "size": size,
        "lattice": lattice,
        "laid": on_faces,
        "remarks": remarks,
        "extent": (low, high),
    }


def _share(progress, first, last):
    """`progress` as seen by a stage that takes the work from one share to another, or None."""
    return progress and (lambda share: progress(first + share * (last - first)))


def _apply_mask(placed):
    given = placed.input
    if placed.free is not None:
        raise InputError("MaskUse", given.mask.use, "masks need dimples on a lattice: choose None.")
    require_apart(given)
    mask = masks.make_mask(given.mask, placed.plane, *placed.extent)
    masks.apply_mask(given.mask, mask, placed.dimples, placed.division, placed.lattice)


@stoppable
def plan_texture(given, progress=None, slower=True):
    """PlannedTexture of a TextureInput, or None if `progress` (share -> bool) returned False. `slower`:
    whether its verdict looks for a lower spindle speed where its own does not hold.

    Raises InputError naming the property that is wrong."""
    placed = place_texture(given, progress, to_plan=True)
    if placed is None:
        return None
    division.require_memory(placed.division, division.BYTES_PER_DIMPLE, dict(placed.dimples.counts())["cut"])
    machine = machines.load(placed.input.machine) if placed.input.machine else None
    if placed.thread is not None:
        fields, made = threads.pacing(placed)
        return PlannedTexture(**vars(placed), pacing=strategies.Pacing(**made), machine=machine, **fields)
    tried = [
        _paced(replace(placed, remarks=list(placed.remarks)), direction, machine, slower=slower)
        for direction in rows.candidates(placed.input, placed.division)
    ]
    best = min(tried, key=lambda plan: plan.path.statistics()["timed_seconds"])
    if placed.input.first_patch == 1 and placed.input.last_patch == 0:
        return best
    return _paced(placed, best.direction, machine, best, slower)


def _paced(placed, direction, machine, whole=None, slower=True):
    """PlannedTexture of a PlacedTexture. `direction`: see rows.ordered. `whole`: the PlannedTexture whose
    patches from FirstPatch to LastPatch are to be milled, in its phase. Raises InputError."""
    _put_in_order(placed, direction)
    placed.direction, placed.patches = direction, len(core.milled_patches(placed.dimples))
    before = 0
    if whole is not None:
        placed.dimples, before = rows.chosen_patches(placed)
    given, dimples = placed.input, placed.dimples
    counts = dict(dimples.counts())
    division.require_some(counts, given)
    if placed.free is not None:
        rule = core.PhaseRule(False, 0.0, 0.0)
        pacing = heights.plan_above(
            given, dimples, placed.remarks,
            lambda g: free_form.pacing(g, placed.free, dimples, rule, machine),
        )  # fmt: skip
    else:
        rule = core.PhaseRule(given.same_flute, given.extra_turns, radians(given.phase_step))
        posture = None
        if not tool_posture.is_vertical(given):
            posture = tool_posture.plan(given, dimples, machine)
            rule = core.with_azimuths(rule, posture.postures)
        pacing = heights.plan_above(
            given, dimples, placed.remarks,
            lambda g: strategies.make(g, dimples, rule, machine, None, posture, whole, before, slower),
        )  # fmt: skip
    return PlannedTexture(**vars(placed), rule=rule, pacing=pacing, machine=machine, counts=counts)
