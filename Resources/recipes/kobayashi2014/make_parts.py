"""The two parts of Kobayashi & Shirase 2014: a smooth convex one for the feed experiment, an overhanging one
for the posture experiment. The paper gives no dimensions; these fit its figures.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import FreeCAD
import Part

NODES = 25  # of the interpolated top face, each way


def convex_top(u, v):
    """A rounded hill on a block 50 x 50 mm; u, v in [0, 1]."""
    return 50 * u, 50 * v, 8 + 20 * math.sin(math.pi * u) * math.sin(math.pi * v)


def overhanging_top(u, v):
    """A wave on a block 60 x 50 mm that leans over towards +X, the more the greater Y is."""
    bump = math.sin(math.pi * u) ** 2
    lean = (20 + 10 * v) * bump
    return 60 * u + lean * math.sin(math.pi * u), 50 * v, 8 + 22 * bump


def block_with_top(top):
    """A closed solid from Z = 0 up to the surface `top`, whose border is over a rectangle's."""
    surface = Part.BSplineSurface()
    steps = [i / (NODES - 1) for i in range(NODES)]
    surface.interpolate([[FreeCAD.Vector(*top(u, v)) for v in steps] for u in steps])
    face = surface.toShape()
    corners = [top(0, 0), top(1, 0), top(1, 1), top(0, 1)]
    low = [FreeCAD.Vector(x, y, 0) for x, y, _ in corners]
    faces = [face, Part.Face(Part.makePolygon(low + low[:1]))]
    for edge in face.Edges:
        a, b = edge.valueAt(edge.FirstParameter), edge.valueAt(edge.LastParameter)
        a0, b0 = FreeCAD.Vector(a.x, a.y, 0), FreeCAD.Vector(b.x, b.y, 0)
        side = [edge] + [Part.makeLine(p, q) for p, q in ((b, b0), (b0, a0), (a0, a))]
        faces.append(Part.Face(Part.Wire(Part.__sortEdges__(side))))
    shell = Part.makeShell(faces)
    shell.sewShape()
    solid = Part.makeSolid(shell)
    if solid.Volume < 0:
        solid.reverse()
    if not (solid.isValid() and solid.isClosed()):
        raise RuntimeError("the block is not a valid solid")
    return solid


def convex_part():
    return block_with_top(convex_top)


def overhanging_part():
    return block_with_top(overhanging_top)
