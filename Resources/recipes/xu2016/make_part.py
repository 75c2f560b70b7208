"""Makes block.step: the block of Xu & Sasahara 2016, whose top is the Bezier surface of their Table 1.

Run in FreeCAD:  freecadcmd -c "exec(open('make_part.py').read())"

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import Part

# Control points [mm], a row per line of the table, from the side of greatest Y on.
TABLE_1 = [
    [(-30, 30, 24), (-14, 32, 32), (16, 29, 20), (30, 29, 30)],
    [(-31, 14, 15), (-15, 13, 20), (15, 16, 30), (29, 14, 19)],
    [(-32, -10, 24), (-16, -12, 35), (16, -15, 21), (32, -14, 32)],
    [(-30, -30, 14), (-14, -29, 23), (14, -30, 18), (30, -30, 21)],
]


def bezier_face():
    """The face of Table 1, a bicubic Bezier surface."""
    surface = Part.BezierSurface()
    surface.increase(3, 3)
    for row, points in enumerate(TABLE_1):
        for column, point in enumerate(points):
            surface.setPole(row + 1, column + 1, FreeCAD.Vector(*point))
    return surface.toShape()


def block():
    """A solid between Z = 0 and the Bezier face."""
    column = bezier_face().extrude(FreeCAD.Vector(0, 0, -60))
    half_space = Part.makeBox(200, 200, 100, FreeCAD.Vector(-100, -100, 0))
    solid = column.common(half_space).Solids[0]
    if not solid.isValid():
        raise RuntimeError("the block is not a valid solid")
    return solid


def top_face_name(shape):
    """Name of the face that holds the middle of the Bezier surface."""
    middle = Part.Vertex(0, 0.546875, 24.875)
    distances = [face.distToShape(middle)[0] for face in shape.Faces]
    return "Face%d" % (distances.index(min(distances)) + 1)


def write_step(filename):
    """Writes the block as STEP."""
    block().exportStep(filename)
