"""A good call of every function that _patchmill shows to Python: its name, what is called, and arguments
that it takes. A name may have a word after a blank, for a second call of the same function.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import operator
import pathlib
import tempfile

import _patchmill as core
import bound_things as t
import numpy as np

CALLS = {}
ROWS3, ROWS2 = np.zeros((3, 3)), np.zeros((3, 2))
UP = np.tile([0.0, 0.0, 1.0], (3, 1))
FILE = str(pathlib.Path(tempfile.mkdtemp()) / "model.voxels")


def call(name, function=None, **arguments):
    CALLS[name] = (function or operator.attrgetter(name.split()[0])(core), arguments)


def on_dimples(function):
    """The function with dimples of its own, for it changes them."""
    return lambda **given: function(t.fresh_dimples(), **given)


def copied(**given):
    return core.copy_mill(t.part, core.CopyOptions(**given))


def with_cutter(plan):
    return lambda radius, flutes, speed: plan(core.BallEndMill(radius, flutes), core.Spindle(speed, "M3"))


def rotary(**given):
    machine = t.bare_machine()
    machine.add_rotary(**given)
    machine.require_valid()


def bare(**given):
    machine = t.bare_machine(**given)
    machine.add_rotary(**t.ROTARY)
    machine.require_valid()


CUTTER = dict(radius=1.0, flutes=2, speed=16.0)
PLANNED = dict(dimples=t.dimples, tool=t.tool, spindle=t.spindle)
HEIGHTS = dict(safe_height=5.0, clearance_height=6.0)
MASKED = dict(division=t.division, lattice=None, mask=t.mask)
AREA = dict(low=(-2.0, -2.0), high=(2.0, 2.0))
SHOWN = dict(low=0.0, high=1.0)

# tools, paths and texts
call("BallEndMill", radius=1.0, flutes=2, cutting_length=4.0, shank_radius=1.0, stick_out=20.0,
     holder=[(20.0, 60.0, 10.0, 10.0)])
call("Spindle", speed=16.0, sense="M3")
call("ThreadLimit", threads=1)
call("Watch", progress=None)
call("make_path", tool=t.tool, spindle=t.spindle, start=(0.0, 0.0, 5.0), tips=ROWS3, axes=UP, kinds=[0, 1, 2],
     turns=[math.nan, 1.0, 1.0])
call("with_dimples", path=t.path, dimples=[0] * len(t.path))
call("with_turns", path=t.path, turns=[1.0] * len(t.path))
call("with_pacing_of", path=t.path, other=t.path)
call("dimples_at", positions=ROWS3, normals=UP, lattice=np.eye(3)[:, :2], patches=[0, 0, 1], states=[0, 1, 2])
call("joined", paths=[t.path, t.copy_path])
call("freecad_text", path=t.path, feed=core.posted_feed(20.0, 3), decimals=3)
call("freecad_paced_text", path=t.locked_path, model=t.model, decimals=3)
call("freecad_rotary_text", told=t.told, letters="CA", model=t.model, decimals=3)
call("read_gcode", text=t.PROGRAM, tool=t.tool, dialect="linuxcnc", rotary=True)
call("match_plan", read=t.path, plan=t.path, tolerance=0.01)
call("write_program", texts=["G1 X1 Y0 Z0 F10\n"], dialect="linuxcnc", precision=3, header=["x"])
call("posted_feed", feed=20.0, decimals=3)
call("ProgramSection.part", lambda **given: core.read_gcode(
    t.PROGRAM, t.tool, "linuxcnc", rotary=True)[0].part(**given), first=0, end=2, tool=t.tool)
call("Tool.scallop_height", t.tool.scallop_height, cross_feed=0.5)
call("program_lines", text=t.PROGRAM, dialect="linuxcnc")
call("safe_comment", dialect="linuxcnc", text="a label")
call("feeds_of", text="G1 X1 F2")
call("with_feeds", text="G1 X1 F2\n", feeds=[2.0])
call("with_decimal_points", call=dict)

# texture planes, patches, dimples
call("texture_plane", origin=(0.0, 0.0, 10.0), direction=(0.0, 0.0, -1.0), x_hint=(1.0, 0.0, 0.0),
     rotation=0.1)
call("FaceSampler", breps=[t.FACE], plane=t.plane, steepest=1.2)
call("ProjectedSurface.sample", t.sampler.sample, points=ROWS2)
call("ProjectedSurface.place", t.sampler.place, division=t.division, plane=t.plane, surface=t.surface,
     lattice=t.lattice)
call("TriangleMesh", vertices=t.MESH_POINTS, triangles=t.MESH_CORNERS)
call("TriangleMesh.region", t.mesh.region, seed=1, angle=0.5)
call("TriangleMesh.nearest", t.mesh.nearest, point=(1.0, 2.0, 3.0))
call("TriangleMesh.part", t.mesh.part, triangles=np.array([0, 1]))
call("MeshSurface", mesh=t.mesh, crease=0.5)
call("MeshSurface.seen_best", t.mesh_surface.seen_best, preferred=(0.0, 0.0, -1.0))
call("MeshSurface.keep_off_border", on_dimples(t.mesh_surface.keep_off_border), margin=0.1)
call("MeshSampler", surface=t.mesh_surface, plane=t.plane, steepest=1.2)
call("facing", breps=[t.FACE])
call("seen_best", breps=[t.FACE], preferred=(0.0, 0.0, -1.0))
call("lay_on_faces", pattern=t.pattern, breps=[t.FACE], plane=t.plane, sampler=t.sampler, steepest=1.2,
     rotation=0.1)
call("keep_apart", on_dimples(core.keep_apart), least=0.1)
call("nearest_distances", dimples=t.dimples)
call("row_pitch", shape="Square")
call("two_sided", shape="Square")
call("least_patch_side", shape="Square")
call("patch_shapes")
call("PatchPattern", shape="Square", spacing=0.5, size=3, order="Inward", start="Same corner")
call("PatchSurface", lambda **given: t.sampler.place(t.division, t.plane, core.PatchSurface(**given)),
     kind="Pyramid", fit="Best fit", height_factor=1.0, apex_lift=0.1)
call("PatchDivision.places", t.division.places, dimples=t.dimples)
call("cover", pattern=t.pattern, **AREA)
call("cover_lattice", pattern=t.pattern, lattice=t.lattice, **AREA)
call("patch_block", pattern=t.pattern, patches_x=2, patches_y=2)
call("drop_slivers", on_dimples(core.drop_slivers), least=2)
call("keep_off_borders", on_dimples(core.keep_off_borders), breps=[t.FACE], margin=0.2)
call("sink", on_dimples(core.sink), depth=0.1)
call("image_mask", pixels=np.ones((4, 4), np.float32), outside=0.0, **AREA)
call("curve_mask", loops=[np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])])
call("Mask.at", t.mask.at, places=ROWS2)
call("keep_where", on_dimples(core.keep_where), threshold=0.5, **MASKED)
call("thin_out", on_dimples(core.thin_out), **MASKED)
call("set_depth", on_dimples(core.set_depth), depth_at_0=0.0, depth_at_1=0.01, least=0.0, **MASKED)
call("lay_lattice", pattern=t.pattern, sampler=t.sampler, plane=t.plane, start=(0.0, 0.0), **AREA)
call("nearest_start", wanted=(0.0, 0.0), sampler=t.sampler, **AREA)
call("SurfaceLattice.places", t.lattice.places, points=ROWS2)
call("SurfaceLattice.counted_from", t.lattice.counted_from, flat=(0.0, 0.0), pattern=t.pattern)
call("spacing_spread", dimples=t.dimples, pattern=t.pattern)
SIZE = dict(shape="Square", ball_radius=1.0)
call("texture_size depth", kind="Isolated", spacing=0.8, depth=0.01, tilt=0.2, **SIZE)
call("texture_size diameter", kind="Isolated", spacing=0.8, diameter=0.3, **SIZE)
call("texture_size area", kind="Isolated", depth=0.01, area_share=0.3, **SIZE)
call("texture_size ridge", kind="Overlapping", ridge_height=0.01, **SIZE)

# Matsuda's free form
call("FreePatch", shape="Square", side=3.0, cross_feed=0.5, feed_per_tooth=0.5)
call("FreePatch.size", t.free.size, ball_radius=1.0)
call("place_free", patch=t.free, outward=False, stands=t.stands, lattice=None, plane=t.plane,
     sampler=t.sampler,
     corners_fit=False)
call("free_form_path", texture=t.free_texture, dimples=t.free_dimples, tool=t.tool, spindle=t.spindle,
     feed=16.0,
     decimals=3, **HEIGHTS)
call("free_form_phases", path=t.free_path, texture=t.free_texture, dimples=t.free_dimples, patch=0)
WISH = dict(tool=t.tool, spindle_speed=16.0, shape="Square", side=5.0)
call("MarkWish", lambda **given: core.advise(core.MarkWish(**given)), array="Square", feed_per_tooth=0.5,
     cross_feed=0.5, **WISH)
call("MarkWish ridge", lambda **given: core.advise(core.MarkWish(**given)), ridge_height=0.01, **WISH)
call("MarkWish.state", lambda **given: core.MarkWish(**given).state(), feed_per_tooth=0.5, **WISH)
call("advise", wish=core.MarkWish(t.tool, 16.0, "Square", 5.0, feed_per_tooth=0.5))

call("in_rows", dimples=t.dimples, pattern=t.pattern, direction=0, one_way=False, whole_face=True)
call("row_directions", pattern=t.pattern)
call("milled_patches", dimples=t.dimples)
call("from_patch", lambda first: core.from_patch(t.dimples, first), first=1)
call("up_to_patch", lambda last: core.up_to_patch(t.dimples, last), last=1)
call("nearest_row_direction", pattern=t.pattern, direction=(1.0, 0.0))
call("flattest_row_direction", dimples=t.dimples, pattern=t.pattern)

# phase and the strategies
call("PhaseRule", lambda **given: core.constant_feed_path(
    feed=20.0, rule=core.PhaseRule(**given), decimals=3, **PLANNED, **HEIGHTS),
    same_flute=False, extra_turns=5.0, step=0.0)
call("constant_feed_path", feed=20.0, rule=t.rule, decimals=3, **PLANNED, **HEIGHTS)
call("constant_feed_path cutter", with_cutter(lambda tool, spindle: core.constant_feed_path(
    t.dimples, tool, spindle, 20.0, t.rule, 5.0, 6.0, 3)), **CUTTER)
call("PacedRule", lambda **given: core.paced_path(
    t.dimples, t.tool, t.spindle, core.PacedRule(**given), t.model, 3),
    locked=True, phase=t.fewest, lift=0.1, turning=[0.0] * len(t.dimples), **HEIGHTS)
call("paced_path", rule=t.paced, model=t.model, decimals=3, **PLANNED)
call("paced_path cutter", with_cutter(lambda tool, spindle: core.paced_path(
    t.dimples, tool, spindle, t.paced, t.model, 3)), **CUTTER)
call("fit_to_stops", path=t.path, model=t.model, feed=20.0, rule=t.rule, decimals=3)
call("MotionModel", lambda **given: core.path_on_machine(t.path, core.MotionModel(**given)), velocity=100.0,
     acceleration=1000.0, jerk=1e4, period=1e-3, tolerance=0.0, spindle_lock=False)
call("phase_period", flutes=2, rule=t.rule)
call("phase_errors", path=t.path, dimples=t.dimples, rule=t.rule)
call("predicted_phase", path=t.path, model=t.model, dimples=t.dimples, rule=t.rule)
call("judge_plan", plan=lambda spindle: t.path, rule=t.rule, model=t.model, **PLANNED)
call("calibration_side", period=3.14, step=0.02)
call("start_phase", best_dimple=3, step=0.02, period=3.14)
call("own_start_phase", path=t.locked_path, dimples=t.dimples, rule=t.rule, model=t.model, from_index=False)
call("with_start_phase", path=t.locked_path, start_phase=0.1, period=math.pi, decimals=3)
call("mark_tool_tip", on_dimples(core.mark_tool_tip), axis=(0.0, 0.0, 1.0), least_tilt=0.01)
call("mark_tool_tip_along", on_dimples(core.mark_tool_tip_along), axes=t.axes, least_tilt=0.01)
call("tilts", dimples=t.dimples, axis=(0.0, 0.0, 1.0))
