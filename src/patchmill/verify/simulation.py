"""What a path leaves on the faces: relief, dimples found, and how they compare with the plan.

    result = patchmill.simulate(op)                              # the planned path
    result = patchmill.simulate(op, program="texture.ngc")       # the posted text, read back
    result = patchmill.simulate(op, machine="linuxcnc-mill")     # as its motion model runs it
    result = patchmill.simulate(op, samples=rows)                # as recorded on a machine
    print(result.text())                                         # a table
    points, heights = result.surface(stride=4)                   # a mesh

Method: docs/cutter-marks.md (Matsuda, Sasahara & Tsutsumi 2008, section 2.2).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import replace

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.geometry import faces_or_mesh
from patchmill.operations.computed import planned
from patchmill.textures.ball import relief as ball_relief
from patchmill.textures.plan import PlannedTexture
from patchmill.textures.thread import round_relief
from patchmill.textures.thread.laying import in_view
from patchmill.verify.simulated_motion import motion_of
from patchmill.verify.simulated_texture import SimulatedTexture
from patchmill.system.stops import stoppable

SLACK = 1.25  # of the highest peak that is expected: so high is the stock over the base


@stoppable
def simulate(
    texture,
    path=None,
    program=None,
    machine=None,
    samples=None,
    window=None,
    step=None,
    stock=None,
    helix=0.0,
    runout=(),
    memory_limit=None,
    dialect="linuxcnc",
    progress=None,
):
    """Simulates a texture and returns a SimulatedTexture, or None if `progress` (share -> bool) returned
    False.

    `texture`: a texture operation, or its PlannedTexture. What moves the tool is one of
      `path`      a ToolPath with the plan's dimple numbers, such as the one of a PostedTexture;
      `program`   the name of a G-code file, which is read back and matched with the plan;
      `samples`   a recording: rows (time [s], x, y, z of the tip [mm], azimuth of flute 0 [rad], unwrapped:
                  falling with M3, growing with M4);
    or by default the planned path. `machine`: a machine file's name or machines.Machine: its motion model
    then says how long each move takes, and the start phase that suits best is taken, as a calibration patch
    would find it. Without one the machine does as it is told, and the phase is right at the first dimple of
    every run between rapids.

    `window`: ((x, y) least, (x, y) greatest) in the texture plane [mm]; None: all of the texture. `step`:
    distance of cells [mm]; None: 1/25 of the spacing. `stock`: height of the uncut surface over the base
    [mm]; None: a little more than the peaks between dimples, or 0 for isolated ones. `helix`: of the edges
    [degrees]. `runout`: how far each flute's edge stands out [mm]. `memory_limit` [bytes].
    `dialect`: of the program, as _patchmill.read_gcode takes it.

    Raises InputError naming what is wrong: Path, Program, Machine, Samples, Window, GridStep, Stock
    and what the core names."""
    plan = _plan_of(texture)
    motion, source = motion_of(plan, path, program, dialect, machine, samples)
    low, high = _window(plan, window)
    base, reach = _base(plan)
    marks = _marks_around(
        plan,
        motion,
        (low, high),
        (step, stock),
        base=base,
        reach=reach,
        helix=math.radians(helix),
        runout=list(runout),
        memory_limit=4e9 if memory_limit is None else memory_limit,
        progress=progress,
    )
    if not marks.complete:
        return None
    found = core.compare_window(marks, in_view(plan), low, high, plan.input.spacing)
    alignment = _alignment(plan, found["places"][~found["at_edge"]])
    return SimulatedTexture(
        plan, marks, (low, high), found, alignment, source, base, reach, motion.untimed_moves
    )


@stoppable
def simulate_round(texture, sectors=12, along=None, progress=None, **options):
    """round_relief.SimulatedRound of a texture operation, or its PlannedTexture, whose Order is Thread; None
    if `progress` (share -> bool) returned False. `sectors`: how many, 6 to 360; `along`: (least, greatest)
    place along the rotary axis [mm] to be looked at, None: all; other `options` as simulate takes them, but
    for window. Raises InputError naming Order, Sectors or what simulate names."""
    plan = _plan_of(texture)
    if plan.thread is None:
        raise InputError("Order", plan.input.order, "only a thread goes all round: use patchmill.simulate.")
    if not 6 <= sectors <= 360:
        raise InputError("Sectors", sectors, "give 6 to 360.")
    ends = round_relief.ends(plan.thread)
    middle = 0.5 * sum(ends)
    first, last = ends if along is None else along
    across = plan.thread.cylinder.radius * math.sin(math.pi / sectors)
    window = ((first - middle, -across), (last - middle, across))
    angles = 2.0 * math.pi / sectors * np.arange(sectors)
    made = []
    for number, angle in enumerate(angles):
        share = progress and (lambda part, n=number: progress((n + part) / sectors))
        seen = replace(plan, plane=round_relief.plane_of(plan.thread, angle, middle))
        made.append(simulate(seen, window=window, progress=share, **options))
        if made[-1] is None:
            return None
    return round_relief.SimulatedRound(plan, made, angles)


@stoppable
def simulate_ball(texture, progress=None, **options):
    """ball.relief.SimulatedBall of a texture operation, or its PlannedTexture, whose Mapping is Ball; None if
    `progress` (share -> bool) returned False. `options`: as simulate takes them, but for window. Raises
    InputError naming Mapping or what simulate names."""
    plan = _plan_of(texture)
    if plan.ball is None:
        remedy = "only a ball is seen from all sides: use patchmill.simulate."
        raise InputError("Mapping", plan.input.mapping, remedy)
    looks = ball_relief.looks(-np.asarray(plan.plane.direction), np.asarray(plan.plane.x_axis))
    made = []
    for number, look in enumerate(looks):
        share = progress and (lambda part, n=number: progress((n + part) / len(looks)))
        seen, window = ball_relief.seen_along(plan, look)
        made.append(simulate(seen, window=window, progress=share, **options))
        if made[-1] is None:
            return None
    return ball_relief.SimulatedBall(plan, made, looks)


def _marks_around(plan, motion, window, sizes, **options):
    """_patchmill.TextureMarks of a window, simulated one spacing beyond it on all sides, so that the dimples
    at its border have their neighbours. `sizes`: step and stock, as simulate takes them."""
    (low, high), (step, stock), spacing = window, sizes, plan.input.spacing
    return core.simulate_texture(
        motion,
        plan.input.tool,
        plan.plane,
        low - spacing,
        high + spacing,
        spacing / 25.0 if step is None else step,
        _stock(plan) if stock is None else stock,
        least_depth=0.002,
        halo=2.0 * spacing,
        **options,
    )


def _alignment(plan, places):
    """How the marks at (n, 2) places line up: see _patchmill.classify_alignment."""
    given = plan.input
    if plan.free is not None:
        return _alignment_of_sector(plan, places)
    return core.classify_alignment(places, (1.0, 0.0), given.spacing, _across(plan))


def _across(plan):
    """Distance of neighbouring passes [mm]."""
    if plan.free is not None:
        return plan.input.cross_feed
    return plan.input.spacing * core.row_pitch(plan.input.patch_shape)


def _alignment_of_sector(plan, places):
    """Of the sector between the centre and one side of a patch of the free form that holds most marks: there
    the passes are parallel."""
    best: tuple = ([], None)
    for outline in plan.outlines():
        if not np.isfinite(outline).all():
            continue
        centre = outline.mean(axis=0)
        for a, b in zip(outline, np.roll(outline, -1, axis=0)):
            share = np.linalg.solve(np.column_stack([a - centre, b - centre]), (places - centre).T)
            inside = (share > 0.02).all(axis=0) & (share.sum(axis=0) < 1.01)
            if inside.sum() > len(best[0]):
                best = places[inside], (b - a) / np.linalg.norm(b - a)
    marks, along = best
    if along is None:
        marks, along = np.zeros((0, 2)), (1.0, 0.0)
    return core.classify_alignment(marks, along, plan.input.feed_per_tooth, plan.input.cross_feed)


def _plan_of(texture):
    if isinstance(texture, PlannedTexture):
        return texture
    return planned(texture)


def _window(plan, window):
    """Least and greatest corner of the window; of all dimples that are milled if None."""
    cut = plan.dimples.states == core.DimpleState.CUT
    if window is None:
        if not cut.any():
            raise InputError("Window", "no dimples", "the texture has nothing to look at.")
        places = plan.places()[cut]
        half = 0.5 * plan.input.spacing
        return places.min(axis=0) - half, places.max(axis=0) + half
    try:
        corners = np.asarray(window, float)
    except ValueError:
        corners = np.zeros(0)
    if corners.shape != (2, 2) or not (np.isfinite(corners).all() and (corners[1] > corners[0]).all()):
        raise InputError("Window", window, "give finite ((x, y) least, (x, y) greatest) in mm.")
    return corners[0], corners[1]


def _base(plan):
    """What heights are measured from, and how far the plane of a dimple reaches [mm]: the faces, or the
    patches' own planes."""
    given = plan.input
    if given.surface.planar:
        return plan.dimples, given.spacing
    return faces_or_mesh.sampler(given, plan.plane), 1.0


def _stock(plan):
    """Height of the uncut surface over the base [mm]. Where the faces slope, the lattice is stretched and
    the peaks between dimples are higher."""
    given, radius = plan.input, plan.input.tool.radius
    if given.texture_kind == "Isolated":
        return 0.0
    cut = plan.dimples.states == core.DimpleState.CUT
    cosine = -(plan.dimples.normals[cut] @ np.asarray(plan.plane.direction))
    stretch = 1.0
    if given.mapping == "Projected" and not given.surface.planar and len(cosine):
        stretch = 1.0 / max(0.2, float(cosine.min()))
    square = ((given.spacing * stretch) ** 2 + _across(plan) ** 2) / 4.0
    peak = radius - math.sqrt(max(radius**2 - square, 0.25 * radius**2))
    return SLACK * peak - plan.size["sunk"]
