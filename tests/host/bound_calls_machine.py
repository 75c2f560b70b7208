"""Good calls, second half: rotary axes, voxels, copy milling, marks, checks and displays. See bound_calls.py.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
import bound_things as t
import numpy as np
from bound_calls import CUTTER, FILE, ROWS2, ROWS3, SHOWN, UP, bare, call, copied, rotary, with_cutter

NORMAL = (0.0, 0.6, 0.8)
STAND = [0.1, 0.2]

# rotary axes
call("Kinematics", bare, lowest=(-5.0,) * 3, highest=(5.0,) * 3, work_zero=(0.0,) * 3)
call("Kinematics.add_rotary", rotary, **t.ROTARY)
call("Kinematics.contact_azimuth", t.machine.contact_azimuth, joints=STAND, normal=NORMAL)
call("Kinematics.in_work_frame", t.machine.in_work_frame, linear=(0.0, 0.0, 1.0), joints=STAND)
call("Kinematics.pivot_referred", t.machine.pivot_referred, point=(0.0, 0.0, 1.0), joints=STAND)
call("Kinematics.solve_axis", t.machine.solve_axis, axis=NORMAL)
call("Kinematics.tool_axis", t.machine.tool_axis, joints=STAND)
call("ProgramForm", lambda **given: core.programmed(t.posed, t.tooled, core.ProgramForm(**given), 3),
     tcp=False,
     reference="tip", chord=0.001, chord_clear=0.01)
call("with_tool", machine=t.machine, tool_length=100.0, form=t.form, tool=t.tool)
call("plan_joints", machine=t.machine, axes=np.tile(NORMAL, (3, 1)), clear=np.zeros(3, bool),
     pole_tolerance=1e-9)
call("plan_path_joints", machine=t.machine, path=t.path, pole_tolerance=1e-9, decimals=3)
call("programmed", posture=t.posed, machine=t.tooled, form=t.form, decimals=3)
call("axis_load", machine=t.tooled, posture=t.posed)
call("section_in_work", section=t.section, machine=t.tooled, form=t.form)
call("tool_axes", dimples=t.dimples, mode="Normal", axis=(0.0, 0.0, 1.0), lead=0.1, tilt=0.1, least_lead=0.1,
     towards=(0.0, 1.0, 0.0), smoothing=0.1, widest=1.0)
call("tool_axes lead", dimples=t.dimples, mode="Minimum lead", axis=(0.0, 0.1, 1.0), least_lead=0.1,
     towards=(0.0, 1.0, 0.0))
call("tool_axes field", dimples=t.dimples, mode="Field", field=t.axes, least_lead=0.1)
call("axes_by_row", dimples=t.dimples, axes=t.axes, tolerance=0.01)
call("plan_postures", machine=t.machine, dimples=t.dimples, axes=t.axes, decimals=3)
call("with_azimuths", rule=t.rule, postures=t.postures)
call("turning_seconds", machine=t.tooled, dimples=t.dimples, postures=t.postures, tool=t.tool, model=t.model,
     form=t.form)
call("with_postures", vertical=t.path, postures=t.postures, machine=t.machine, decimals=3)
call("housing_x", machine=t.machine, joints=ROWS2)

# solids, voxels, fields
call("Solid", vertices=np.array(t.stock.vertices), triangles=np.array(t.stock.triangles))
call("Solid.box", low=(0.0, 0.0, 0.0), high=(1.0, 1.0, 1.0))
call("Solid.signed_distances", t.stock.signed_distances, points=ROWS3)
call("solid_of_brep", brep=t.BLOCK, deflection=0.1, property="Part", closed=True)
call("tessellate", brep=t.BLOCK, deflection=0.1, angle=0.35)
call("estimate_voxels", stock=t.stock, part=t.part, pitch=0.5, posture_fields=2)
call("voxelise", stock=t.stock, part=t.part, pitch=0.5, memory_limit=1e9, posture_fields=2)
call("save_voxels", path=FILE, key="k", grid=t.grid, posture=t.posture, materials=t.materials)
call("load_voxels", path=FILE + ".none", key="k")
call("VoxelGrid.section", t.grid.section, axis=2, place=1.0, feed=t.feed, direction=(1.0, 0.0, 0.0),
     posture=t.posture)
call("VoxelGrid.arrows", t.grid.arrows, posture=t.posture, stride=2)
call("steady_feed", grid=t.grid, low=5.0, high=10.0, exterior="Held")
DIFFUSED = dict(grid=t.grid, low=5.0, high=10.0, time=1.0, step=0.01, diffusivity=1.0)
call("diffuse_feed", substep=False, **DIFFUSED)
call("diffuse_feed divided", substep=True, **DIFFUSED)
call("steady_posture", grid=t.grid, part=t.part, form="Angles", exterior="Held", limit=1.2, crease=0.5)
call("materials_of", grid=t.grid, bodies=[(t.part, 1.0)])
call("scale_feed", feed=t.feed, materials=t.materials, factors=[1.0, 0.5])
call("axes_at", grid=t.grid, posture=t.posture, points=ROWS3)
call("feed_at", grid=t.grid, feed=t.feed, points=ROWS3, direction=(1.0, 0.0, 0.0))
call("kinds_at", grid=t.grid, points=ROWS3)
call("materials_at", grid=t.grid, materials=t.materials, points=ROWS3)

# paths by the voxel model, copy milling
call("apply_dcm", path=t.copy_path, grid=t.grid, feed=t.feed, posture=t.posture, part=t.part, holder=t.HOLDER,
     clearance=1.0, lowest=1.5, reading="Smooth", read_at="Ball centre", feed_tolerance=0.1,
     axis_tolerance=0.01,
     axis_rate=1.0, acceleration=100.0)
call("hurry_in_air", path=t.copy_path, grid=t.grid, feed=50.0)
call("load_along", path=t.copy_path, grid=t.grid, specific=2000.0, exponent=0.25, normal=0.3)
call("limit_load", path=t.copy_path, grid=t.grid, specific=2000.0, exponent=0.25, normal=0.3, chip=0.05,
     force=300.0, power=200.0, acceleration=100.0)
call("path_steps", path=t.copy_path)
call("holder_clearance", part=t.part, holder=t.HOLDER, path=t.copy_path, clearance=1.0, step=0.5)
call("CopyOptions", copied, **t.COPY)
call("copy_mill", part=t.part, options=core.CopyOptions(**t.COPY))
call("over_faces", path=t.copy_path, part=t.part, faces=t.part, options=core.CopyOptions(**t.COPY))
call("with_plunge_feed", path=t.copy_path, vertical=5.0)
call("copy_mill cutter", with_cutter(lambda tool, spindle: copied(**dict(t.COPY, tool=tool,
     spindle=spindle))),
     **CUTTER)
call("scallop_height", radius=1.0, cross_feed=0.5)
call("LiveSession", lambda **given: core.LiveSession(t.part, t.grid, core.CopyOptions(**t.COPY), **given),
     low=5.0, high=10.0)
call("LiveSession.next", lambda **given: t.live_session().next(**given), seconds=0.5)
call("LiveSession.change", lambda **given: t.live_session().change(**given), radial_depth=1.0,
     axial_depth=1.0,
     low=5.0, high=10.0)

# marks and checks
PATH_OF = dict(path=t.path, dimples=t.dimples, rule=t.rule)
call("motion_of_path", start_phase=0.1, housing=np.tile([1.0, 0.0, 0.0], (len(t.path) + 1, 1)), **PATH_OF)
call("motion_of_samples", time=t.TIMES, tips=t.TIPS, spindle_angle=t.ANGLES, spindle=t.spindle, radius=1.0,
     axes=np.tile(UP[:1], (50, 1)))
call("path_on_machine", path=t.path, model=t.model)
call("best_start_phase", **dict(PATH_OF, path=core.path_on_machine(t.locked_path, t.model)[2]))
SEEN = dict(motion=t.motion, tool=t.tool, plane=t.plane, low=(-1.0, -1.0), high=(1.0, 1.0), step=0.05,
            stock=0.05)
call("simulate_texture", base=t.sampler, helix=0.0, runout=[0.0, 0.001], least_depth=0.002, halo=1.0,
     memory_limit=1e9, **SEEN)
call("simulate_texture planes", base=t.dimples, reach=1.0, **SEEN)
call("TextureMarks.surface", t.marks.surface, base=t.dimples, reach=1.0, row=0, rows=4, column=0, columns=4,
     stride=2)
call("compare_window", marks=t.marks, dimples=t.dimples, low=(-1.0, -1.0), high=(1.0, 1.0), spacing=0.5)
call("classify_alignment", places=np.random.default_rng(1).random((30, 2)), feed=(1.0, 0.0),
     feed_per_tooth=0.5,
     cross_feed=0.5)
call("dales", heights=np.random.default_rng(2).random((9, 12)), step=(0.1, 0.1), least_depth=0.2)
call("part_model", breps=[t.BLOCK], deflection=0.1)
call("part_model_of_mesh", mesh=t.mesh)
call("PartModel.distances", t.part_model.distances, points=ROWS3)
call("check_clearance", path=t.path, part=t.part_model, tolerance=0.01, clearance=0.5, resolution=0.01,
     most_findings=100, first_move=0, cutting=True)

# displays
call("dimple_display", dimples=t.dimples, radius=0.2)
call("order_display", dimples=t.dimples, spacing=0.5)
call("outline_display", outlines=[ROWS3])
call("path_display", path=t.path)
call("path_axis_display", path=t.path, length=1.0, most=100)
call("grid_display", points=np.zeros((3, 4, 3)), values=np.zeros((3, 4)), **SHOWN)
call("slice_display", centres=ROWS3, values=[0.0, 0.5, 1.0], side=1.0, axis=0, **SHOWN)
call("arrow_display", places=ROWS3, vectors=UP, scale=1.0, values=[0.0, 0.5, 1.0], **SHOWN)
call("scale_colour", share=0.5)
call("Display.chunk", core.path_display(t.path).chunk, number=0)
