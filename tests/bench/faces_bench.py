"""Seconds that a texture on 2684 faces takes, from the chosen faces to its path, beside what FreeCAD takes to
look each of those faces up once, in the same run.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import time

import FreeCAD
import Part
import patchmill
from patchmill.freecad import host

ROWS, COLUMNS = 22, 61  # of cells of 1 mm, two triangles each


def point(i, j):
    return FreeCAD.Vector(i, j, 0.12 * i + 0.25 * math.sin(0.9 * i) * math.cos(0.7 * j))


def shell():
    faces = []
    for i in range(ROWS):
        for j in range(COLUMNS):
            a, b, c, d = point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)
            for corners in ((a, b, c), (a, c, d)):
                faces.append(Part.Face(Part.makePolygon([*corners, corners[0]])))
    return Part.makeShell(faces)


def seconds(call):
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def main():
    document = FreeCAD.newDocument("bench")
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shell()
    document.recompute()
    job = host.create_job("Job", [part])
    host.add_ball_end_controller(job, 2.0, 2, 600.0, 1000.0)
    operation = patchmill.CurvedTexture.Create("Texture", parentJob=job)
    model = job.Model.Group[0]
    names = ["Face%d" % (i + 1) for i in range(2 * ROWS * COLUMNS)]
    operation.Base = [(model, names)]
    whole = seconds(lambda: patchmill.recompute(operation))
    looked_up = seconds(lambda: [model.Shape.getElement(name) for name in names])
    print("texture on %d faces, %d dimples: %.2f s" % (len(names), operation.DimpleCount, whole))
    print("FreeCAD looks each face up once:     %.2f s" % looked_up)


main()
