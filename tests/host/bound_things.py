"""Small things of every kind that _patchmill's functions take, each of them good: what test_contracts.py
calls
them with before it spoils one argument after the other.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import _patchmill as core
import FreeCAD
import numpy as np
import Part

V = FreeCAD.Vector
PROGRAM = "G21 G90 G94\nM3 S960\nG0 X0 Y0 Z5\nG1 X1 Y0 Z0 F600\nG1 X2 Y0 Z0 A1\n"


def sloping_face():
    surface = Part.BSplineSurface()
    places = (-4, -1, 1, 4)
    surface.interpolate([[V(x, y, 0.02 * x * y + 0.3 * x) for y in places] for x in places])
    return surface.toShape().exportBrepToString()


FACE = sloping_face()
BLOCK = Part.makeBox(10, 10, 5, V(-5, -5, -20)).exportBrepToString()
tool, spindle = core.BallEndMill(1.0, 2), core.Spindle(16.0, "M3")
model = core.MotionModel(100.0, 1000.0, spindle_lock=True)

# a texture: 36 dimples in four patches, and paths over it
plane = core.texture_plane((0, 0, 10), (0, 0, -1), (1, 0, 0))
sampler = core.FaceSampler([FACE], plane, 1.2)
MESH_POINTS = np.array([[0.0, 0.0, 10.0], [9.0, 0.0, 10.0], [9.0, 9.0, 10.0], [0.0, 9.0, 11.0]])
MESH_CORNERS = np.array([[0, 1, 2], [0, 2, 3]])
mesh = core.TriangleMesh(MESH_POINTS, MESH_CORNERS)
mesh_surface = core.MeshSurface(mesh, 0.5)
pattern = core.PatchPattern("Square", 0.5, 3)
division = core.patch_block(pattern, 2, 2)
surface = core.PatchSurface("Curved")


def fresh_dimples():
    made = sampler.place(division, plane, surface)
    core.mark_tool_tip(made, (0, 0, 1), 0.001)
    return made


dimples = fresh_dimples()
rule, fewest = core.PhaseRule(False, 5.0), core.PhaseRule(False, 0.0)
path = core.constant_feed_path(dimples, tool, spindle, 20.0, rule, 5.0, 6.0, 3)
paced = core.PacedRule(True, fewest, 0.1, 5.0, 6.0)
locked_path = core.paced_path(dimples, tool, spindle, paced, model, 3)[0]
low, high = sampler.extent()
lattice = core.lay_lattice(pattern, sampler, plane, (0, 0), low, high)
mask = core.image_mask(np.full((4, 4), 0.7, np.float32), (-4, -4), (4, 4))

# Matsuda's free form
free = core.FreePatch("Square", 3.0, 0.5, 0.5)
stands = core.patch_block(free.stands(), 1, 1)
free_texture, free_dimples = core.place_free(free, False, stands, None, plane, sampler, False)
core.mark_tool_tip(free_dimples, (0, 0, 1), 0.001)
free_path = core.free_form_path(free_texture, free_dimples, tool, spindle, 16.0, 5.0, 6.0, 3)

# a voxel model, its fields, and copy milling
stock = core.Solid.box((0, 0, -1), (10, 10, 5))
part = core.Solid.box((2, 2, -1), (8, 8, 3))
grid = core.voxelise(stock, part, 0.5)
feed = core.steady_feed(grid, 5.0, 10.0)
posture = core.steady_posture(grid, part)
materials = core.materials_of(grid, [(part, 1.0)])
HOLDER = [(10.0, 20.0, 5.0, 5.0)]
COPY = dict(
    mode="Scanning", tool=tool, spindle=spindle, feed=10.0, radial_depth=2.0, axial_depth=2.0,
    tolerance=0.05, allowance=0.0, low=(0, 0, -1), high=(10, 10, 5), clearance=3.0, overlap=0.0,
)
copy_path = core.copy_mill(part, core.CopyOptions(**COPY))[0]

# other ones of the same kind, that do not belong to the first
other_grid = core.voxelise(stock, part, 1.0)
other_dimples = sampler.place(core.patch_block(pattern, 3, 3), plane, surface)
core.mark_tool_tip(other_dimples, (0, 0, 1), 0.001)


def live_session():
    return core.LiveSession(part, grid, core.CopyOptions(**COPY), 5.0, 10.0)


# a machine with a table that turns and tilts
def bare_machine(**given):
    limits = dict(lowest=(-500,) * 3, highest=(500,) * 3, work_zero=(0, 0, 0))
    return core.Kinematics(**dict(limits, **given))


ROTARY = dict(letter="A", side="table", direction=(1, 0, 0), point=(0, 0, 0), lowest=-2.0, highest=2.0,
              rate=1.0, acceleration=10.0)
machine = bare_machine()
machine.add_rotary("C", "table", (0, 0, 1), (0, 0, 0), -50.0, 50.0, 1.0, 10.0)
machine.add_rotary(**ROTARY)
form = core.ProgramForm()
tooled = core.with_tool(machine, 100.0, form, tool)
axes = core.tool_axes(dimples, "Normal", lead=0.2)
postures = core.plan_postures(machine, dimples, axes, 3)
posed = core.with_postures(path, postures, machine, 3)
told = core.programmed(posed, tooled, form, 3)
section = core.read_gcode(PROGRAM, tool, "linuxcnc", True)[0]

# what it looks like
motion = core.motion_of_path(path, dimples, rule)
marks = core.simulate_texture(motion, tool, plane, (-1, -1), (1, 1), 0.05, 0.05, base=sampler)
part_model = core.part_model([BLOCK], 0.1)
TIMES = np.linspace(0, 1, 50)
TIPS = np.column_stack([5 * TIMES, 0 * TIMES, 0 * TIMES])
ANGLES = -2 * math.pi * 16 * TIMES
