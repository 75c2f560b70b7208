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
import os
from dataclasses import dataclass, field

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill import machines, tool_posture
from patchmill.texture_plan import PlannedTexture

SLACK = 1.25  # of the highest peak that is expected: so high is the stock over the base


@dataclass
class SimulatedTexture:
    """The relief of a texture, or of a window of it. Lengths in mm; places in plane coordinates.

    `found` holds arrays, one entry per dimple found in the window: places (n, 2), points (n, 3) in the
    work frame, bottoms, depths, diameters, at_edge; per planned dimple `dimple` (its number), `found`
    (index of its mark, -1: missing), `moved` (m, 2); `extra`: indices of marks that nobody planned."""

    plan: PlannedTexture
    marks: core.TextureMarks
    window: tuple  # (low, high)
    found: dict
    alignment: dict
    source: str  # where the motion comes from, a phrase
    base: object = None  # what heights are measured from: FaceSampler, Dimples, or None for the plane
    reach: float = 1.0
    untimed_moves: int = 0
    _rows: list = field(default=None, repr=False)

    @property
    def heights(self):
        """Deviation from the base along its normal [mm], float32 (rows, columns); NaN: no base there."""
        return self.marks.heights

    @property
    def step(self):
        """Distance of cells [mm]."""
        return self.marks.step

    @property
    def origin(self):
        """Plane coordinates of cell [0, 0] [mm]."""
        return tuple(float(c) for c in self.marks.first)

    @property
    def quality(self):
        """1 for a texture as planned, 0 if no mark is nearer to its place than a quarter spacing."""
        return self.found["quality"]

    def surface(self, stride=1, rows=None, columns=None):
        """Points of the relief for a mesh: (points (r, c, 3) [mm] in the work frame, heights (r, c) [mm]).

        Every `stride`-th cell of rows[0] <= row < rows[1] and of the columns alike; all if None. Points are
        NaN where there is no base. Take large reliefs in blocks: a block is computed when it is asked for."""
        r, c = self.heights.shape
        r0, r1 = rows or (0, r)
        c0, c1 = columns or (0, c)
        return self.marks.surface(self.base, self.reach, r0, r1 - r0, c0, c1 - c0, stride)

    def data(self):
        """The figures as a dict of plain values: lengths in mm, shares 0 to 1."""
        f = self.found
        planned, missing = len(f["dimple"]), int(f["missing"])
        inner = ~f["at_edge"]
        return {
            "source": self.source,
            "grid_mm": self.step,
            "window_mm": [[float(v) for v in corner] for corner in self.window],
            "planned": planned,
            "found": planned - missing,
            "missing": missing,
            "extra": len(f["extra"]),
            "place_rms_mm": _number(f["rms_move"]),
            "place_rms_share": _number(f["rms_move"] / self.plan.input.spacing),
            "place_largest_mm": _number(f["largest_move"]),
            "mean_move_mm": [float(v) for v in f["mean_move"]],
            "depth_mm": _number(f["mean_depth"]),
            "depth_deviation_mm": _number(f["depth_deviation"]),
            "diameter_mm": _number(f["diameters"][inner].mean()) if inner.any() else None,
            "spacing_mm": _number(f["mean_spacing"]),
            "alignment": self.alignment["state"],
            "shift": self.alignment["shift"],
            "quality": float(self.quality),
        }

    def rows(self):
        """The table: pairs of a name and what is to be said of it."""
        d = self.data()
        per_cent = lambda share: "-" if share is None else "%.1f %%" % (100.0 * share)  # noqa: E731
        yield "Motion", d["source"]
        yield "Dimples planned", "{:,}".format(d["planned"])
        yield "found", "{:,}, missing {:,}".format(d["found"], d["missing"])
        yield "marks that nobody planned", "{:,}".format(d["extra"])
        yield (
            "off their places, rms",
            "%s (%s of the spacing); at most %s"
            % (_um(d["place_rms_mm"]), per_cent(d["place_rms_share"]), _um(d["place_largest_mm"])),
        )
        yield "depth to the rim", "%s ± %s" % (_um(d["depth_mm"]), _um(d["depth_deviation_mm"]))
        yield "diameter, mean", _mm(d["diameter_mm"])
        yield "distance to the nearest, mean", _mm(d["spacing_mm"])
        yield "array", d["alignment"]
        yield "quality, 0 to 1", "%.3f" % d["quality"]

    def text(self):
        """The table as text."""
        return "\n".join("%-32s %s" % row for row in self.rows())


def _number(value):
    return None if value is None or not math.isfinite(value) else float(value)


def _um(value):
    return "-" if value is None else "%.1f µm" % (1000.0 * value)


def _mm(value):
    return "-" if value is None else "%.3f mm" % value


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

    Raises InputError naming what is wrong: Path, Program, Machine, Samples, Window, GridStep, Stock, Memory
    and what the core names."""
    plan = _plan_of(texture)
    spacing = plan.input.spacing
    if sum(given is not None for given in (path, program, samples)) > 1:
        raise InputError("Path", "several motions", "give one of path, program and samples.")
    motion, source = _motion(plan, path, program, dialect, machine, samples)
    low, high = _window(plan, window)
    base, reach = _base(plan)
    margin = spacing
    marks = core.simulate_texture(
        motion,
        plan.input.tool,
        plan.plane,
        low - margin,
        high + margin,
        spacing / 25.0 if step is None else step,
        _stock(plan) if stock is None else stock,
        base=base,
        reach=reach,
        helix=math.radians(helix),
        runout=list(runout),
        least_depth=0.002,
        halo=2.0 * spacing,
        memory_limit=4e9 if memory_limit is None else memory_limit,
        progress=progress,
    )
    if not marks.complete:
        return None
    found = core.compare_window(marks, plan.dimples, low, high, spacing)
    alignment = _alignment(plan, found["places"][~found["at_edge"]])
    return SimulatedTexture(
        plan, marks, (low, high), found, alignment, source, base, reach, motion.untimed_moves
    )


def _alignment(plan, places):
    """How the marks at (n, 2) places line up: see _patchmill.classify_alignment."""
    given = plan.input
    if plan.free is not None:
        return _alignment_of_sector(plan, places)
    across = given.spacing * (1.0 if given.patch_shape == "Square" else math.sqrt(0.75))
    return core.classify_alignment(places, (1.0, 0.0), given.spacing, across)


def _alignment_of_sector(plan, places):
    """Of the sector between the centre and one side of a patch of the free form that holds most marks: there
    the passes are parallel."""
    best = ([], None)
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
    from patchmill.texture_operation import planned

    return planned(texture)


def _motion(plan, path, program, dialect, machine, samples):
    """(ToolMotion, a phrase that says where it comes from)."""
    if samples is not None:
        if plan.posture is not None:
            raise InputError("Samples", "rotary axes", "recordings are cut with an upright tool only.")
        if machine is not None:
            raise InputError("Machine", machine, "a recording has its machine in it: leave it out.")
        return _recorded(plan, samples), "recorded on a machine"
    if program is not None:
        path, source = read_program(plan, program, dialect), "the program " + os.path.basename(program)
    elif path is not None:
        source = "the posted text, read back"
    else:
        path, source = plan.path, "the plan"
    housing = _housing(plan, path)
    if machine is None:
        return core.motion_of_path(path, plan.dimples, plan.rule, housing=housing), source
    if not isinstance(machine, machines.Machine):
        machine = machines.load(machine)
    known, reason, moved = core.path_on_machine(path, machine.model)
    if not known:
        raise InputError("Machine", machine.key, "its motion is not known: %s." % reason)
    start = core.best_start_phase(moved, plan.dimples, plan.rule)
    motion = core.motion_of_path(moved, plan.dimples, plan.rule, start, housing)
    return motion, "%s, as %s would run it" % (source, machine.data["name"])


def _housing(plan, path):
    """Azimuth 0 of the spindle's housing in the work frame at a path's start and at each move's end,
    (n + 1, 3), as the planned angles of the rotary axes make it; None for an upright tool. The timed moves of
    `path` are those of the plan."""
    if plan.posture is None:
        return None
    planned = core.housing_x(plan.posture.kinematics, plan.posture.work.joints)
    if len(path) == len(plan.path):
        return planned
    timed = path.kinds > 0
    number = np.concatenate([[0], np.flatnonzero(plan.path.kinds > 0) + 1])
    if timed.sum() + 1 != len(number):
        raise InputError("Path", "%d timed moves" % timed.sum(), "give a path of this texture's plan.")
    return planned[number[np.concatenate([[0], np.cumsum(timed)])]]


def _recorded(plan, samples):
    rows = np.asarray(samples, float)
    if rows.ndim != 2 or rows.shape[1] != 5 or len(rows) < 2 or not np.isfinite(rows).all():
        raise InputError(
            "Samples", "shape %s" % (rows.shape,), "give finite rows (time, x, y, z, spindle azimuth)."
        )
    given = plan.input
    return core.motion_of_samples(
        rows[:, 0], rows[:, 1:4], rows[:, 4], given.spindle, given.tool.radius
    )


def read_program(plan, filename, dialect):
    """The ToolPath of the section of a G-code file that holds the plan. Raises InputError naming Program."""
    try:
        with open(filename, encoding="utf-8") as file:
            text = file.read()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError("Program", filename, "it could not be read: %s." % error) from error
    best, found = None, -1
    half_unit = 0.5 * 10.0**-plan.input.decimals
    for section in core.read_gcode(text, plan.input.tool, dialect, rotary=plan.posture is not None):
        path = section.path
        if plan.posture is None:
            match = core.match_plan(path, plan.path, half_unit)
        else:
            _, match, path = tool_posture.read_back(section, plan.posture, plan.machine, half_unit)
        if match.found > found:
            best, found = path, match.found
    if found < 1:
        raise InputError("Program", filename, "none of its moves end on the texture's dimples.")
    return best


def _window(plan, window):
    """Least and greatest corner of the window; of all dimples that are milled if None."""
    cut = plan.dimples.states == 0
    if window is None:
        if not cut.any():
            raise InputError("Window", "no dimples", "the texture has nothing to look at.")
        places = plan.places()[cut]
        half = 0.5 * plan.input.spacing
        return places.min(axis=0) - half, places.max(axis=0) + half
    corners = np.asarray(window, float)
    if corners.shape != (2, 2) or not (corners[1] > corners[0]).all():
        raise InputError("Window", window, "give ((x, y) least, (x, y) greatest) in mm.")
    return corners[0], corners[1]


def _base(plan):
    """What heights are measured from, and how far the plane of a dimple reaches [mm]: the faces, or the
    patches' own planes."""
    given = plan.input
    if given.surface.planar:
        return plan.dimples, given.spacing
    return core.FaceSampler(given.breps, plan.plane, math.radians(given.steepest_slope)), 1.0


def _stock(plan):
    """Height of the uncut surface over the base [mm]. Where the faces slope, the lattice is stretched and
    the peaks between dimples are higher."""
    given, radius = plan.input, plan.input.tool.radius
    if given.texture_kind == "Isolated":
        return 0.0
    cut = plan.dimples.states == 0
    cosine = -(plan.dimples.normals[cut] @ np.asarray(plan.plane.direction))
    stretch = 1.0
    if given.mapping == "Projected" and not given.surface.planar and len(cosine):
        stretch = 1.0 / max(0.2, float(cosine.min()))
    across = given.spacing * (1.0 if given.patch_shape == "Square" else math.sqrt(0.75))
    if plan.free is not None:
        across = given.cross_feed
    square = ((given.spacing * stretch) ** 2 + across**2) / 4.0
    peak = radius - math.sqrt(max(radius**2 - square, 0.25 * radius**2))
    return SLACK * peak - plan.size["sunk"]
