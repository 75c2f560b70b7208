"""Values that look bad and are taken without a word: what they mean there, for test_contracts. A row is
(why, faults as spoilt_values.fault_of calls them, places); a place is a function and an argument, or
"* argument" in any function.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

TAKEN = [
    ("a position, of which any is good, or a corner of an area that has a size", "zero negative",
     "* low, * high, make_path start, texture_plane origin, lay_lattice start, nearest_start wanted, "
     "SurfaceLattice.counted_from flat, Kinematics lowest, Kinematics highest, Kinematics work_zero, "
     "Kinematics.add_rotary point, Kinematics.in_work_frame linear, Kinematics.pivot_referred point, "
     "VoxelGrid.section place, TriangleMesh.nearest point"),
    ("a corner that is cut off at the faces', or a limit that is never reached", "huge", "* high"),
    ("a direction counts, not its length", "negative huge",
     "seen_best preferred, MeshSurface.seen_best preferred, nearest_row_direction direction, "
     "mark_tool_tip axis, tilts axis, "
     "Kinematics.contact_azimuth normal, Kinematics.solve_axis axis, tool_axes axis, tool_axes towards, "
     "VoxelGrid.section direction, feed_at direction"),
    ("likewise; too long a one is refused", "negative",
     "texture_plane direction, texture_plane x_hint, Kinematics.add_rotary direction, "
     "classify_alignment feed"),
    ("no dimple: what takes a path and dimples looks", "negative", "with_dimples dimples"),
    ("no direction: the feed's, or the one that there is", "zero", "tool_axes towards"),
    ("an angle to either side", "zero negative",
     "texture_plane rotation, lay_on_faces rotation, Kinematics.contact_azimuth joints, "
     "Kinematics.in_work_frame joints, Kinematics.pivot_referred joints, Kinematics.tool_axis joints, "
     "Kinematics.add_rotary lowest, Kinematics.add_rotary highest, tool_axes lead, tool_axes tilt, "
     "motion_of_path start_phase"),
    ("an angle counts by its turn: beyond 1e15 none is left, but it is a unit vector's still", "huge",
     "Kinematics.contact_azimuth joints, Kinematics.in_work_frame joints, Kinematics.pivot_referred joints, "
     "Kinematics.tool_axis joints, motion_of_path start_phase"),
    ("a factor, or a lift, that turns the pyramid over", "zero negative",
     "PatchSurface height_factor, PatchSurface apex_lift"),
    ("the widest tilt: upright all over", "zero", "tool_axes widest"),
    ("no posture", "zero", "estimate_voxels posture_fields, voxelise posture_fields"),
    ("whole units are posted", "zero", "* decimals, write_program precision"),
    ("exactly, or nothing at all is allowed or blended", "zero",
     "match_plan tolerance, MotionModel tolerance, axes_by_row tolerance, check_clearance tolerance, "
     "check_clearance clearance, * pole_tolerance, ProgramForm chord_clear, steady_posture crease, "
     "TriangleMesh.region angle, MeshSurface crease"),
    ("nothing is left out by it", "zero",
     "keep_apart least, drop_slivers least, keep_off_borders margin, MeshSurface.keep_off_border margin, "
     "keep_where threshold, set_depth least, "
     "tool_axes least_lead, simulate_texture least_depth, simulate_texture halo, dales least_depth"),
    ("a depth, allowance, overlap, step, shift, time, length or ridge of nothing", "zero",
     "sink depth, set_depth depth_at_0, set_depth depth_at_1, image_mask outside, CopyOptions allowance, "
     "CopyOptions overlap, PhaseRule step, with_start_phase start_phase, tool_axes smoothing, "
     "simulate_texture helix, simulate_texture runout, PacedRule turning, with_tool tool_length, "
     "make_path turns, with_feeds feeds, Tool.scallop_height cross_feed, scallop_height cross_feed"),
    ("a force that thin chips do not change, or without one normal to the surface", "zero",
     "load_along exponent, load_along normal, limit_load exponent, limit_load normal"),
    ("the uncut surface may be the base, or below it: there the tool meets air", "zero negative",
     "simulate_texture stock"),
    ("the first of things that are counted from 0, or none of them", "zero",
     "ProgramSection.part first, ProgramSection.part end, free_form_phases patch, in_rows direction, "
     "start_phase best_dimple, * axis, TriangleMesh.region seed, "
     "TextureMarks.surface row, TextureMarks.surface column, "
     "check_clearance most_findings, check_clearance first_move, path_axis_display most, "
     "Display.chunk number"),
    ("as many as there are, or modulo the period; first_move beyond the path: the outcome is unknown", "huge",
     "ThreadLimit threads, start_phase best_dimple, VoxelGrid.arrows stride, TextureMarks.surface stride, "
     "check_clearance most_findings, check_clearance first_move, path_axis_display most"),
    ("so large that it limits, rounds or divides nothing", "huge",
     "MotionModel velocity, MotionModel acceleration, MotionModel jerk, MotionModel period, "
     "Kinematics highest, Kinematics.add_rotary lowest, Kinematics.add_rotary highest, "
     "Kinematics.add_rotary rate, "
     "Kinematics.add_rotary acceleration, ProgramForm chord, voxelise memory_limit, "
     "simulate_texture memory_limit, apply_dcm feed_tolerance, apply_dcm axis_tolerance, "
     "apply_dcm axis_rate, apply_dcm acceleration, limit_load chip, limit_load force, limit_load power, "
     "limit_load acceleration, with_plunge_feed vertical, LiveSession.next seconds, "
     "solid_of_brep deflection, tessellate deflection, part_model deflection, diffuse_feed step"),
    ("a size whose results are finite; what it is used with sets the limit, by name", "huge",
     "BallEndMill radius, Spindle speed, make_path turns, with_turns turns, posted_feed feed, "
     "Tool.scallop_height cross_feed, "
     "PatchPattern spacing, keep_off_borders margin, MeshSurface.keep_off_border margin, "
     "nearest_start wanted, "
     "TriangleMesh.nearest point, "
     "SurfaceLattice.counted_from flat, texture_size spacing, texture_size ball_radius, "
     "FreePatch cross_feed, FreePatch feed_per_tooth, FreePatch.size ball_radius, * clearance_height, "
     "MarkWish spindle_speed, MarkWish.state spindle_speed, constant_feed_path feed, fit_to_stops feed, "
     "Kinematics work_zero, Kinematics.add_rotary point, Kinematics.in_work_frame linear, "
     "Kinematics.pivot_referred point, scale_feed factors, hurry_in_air feed, CopyOptions feed, "
     "CopyOptions radial_depth, CopyOptions axial_depth, CopyOptions clearance, "
     "copy_mill speed, scallop_height radius, LiveSession.change radial_depth, "
     "LiveSession.change axial_depth, motion_of_samples radius, simulate_texture step, * reach, "
     "compare_window spacing, classify_alignment feed_per_tooth, classify_alignment cross_feed"),
    ("a display shows what it is given, at the nearest end of its scale", "zero negative huge",
     "* values, arrow_display scale, scale_colour share"),
    ("a display may be small or large", "huge",
     "dimple_display radius, order_display spacing, path_axis_display length, slice_display side, "
     "grid_display low, slice_display low, arrow_display low"),
    ("any text is a comment, a key, a name, or has no words; a file of no such name is no model", "word",
     "safe_comment text, feeds_of text, with_feeds text, solid_of_brep property, save_voxels path, "
     "save_voxels key, load_voxels path, load_voxels key"),
    ("nothing in, nothing out", "empty",
     "* text, write_program texts, write_program header, with_feeds feeds, * points, Mask.at places, "
     "housing_x joints, save_voxels key, load_voxels path, load_voxels key, outline_display outlines, "
     "classify_alignment places"),
    ("none: no loop to be inside of, no other materials, no holder, upright, no part (unknown)", "empty",
     "curve_mask loops, materials_of bodies, * holder, motion_of_path housing, part_model breps"),
    ("not known, as Tool says of all three", "zero",
     "BallEndMill cutting_length, BallEndMill shank_radius, BallEndMill stick_out"),
    ("not given: flat in the plane, or without that field, part or base", "none",
     "Watch progress, * lattice, save_voxels posture, save_voxels materials, VoxelGrid.section feed, "
     "VoxelGrid.section posture, apply_dcm feed, apply_dcm posture, apply_dcm part, "
     "simulate_texture base, TextureMarks.surface base"),
]
