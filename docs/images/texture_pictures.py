"""Draws the pictures of textures on parts, each made by the operations themselves:

    tools/freecad docs/images/texture_pictures.py [NAME ...]

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import os
import pathlib
import runpy
import sys
import tempfile
import textwrap

import FreeCAD
import matplotlib
import numpy as np
import Part
import patchmill
from patchmill.freecad import host

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from relief_view import View  # noqa: E402

V = FreeCAD.Vector
DOWN = (0, 0, -1)


def operation_on(shape, faces, kind="CurvedTexture", **properties):
    """A texture operation of a new document on faces of a shape, with a ball end mill of 2 mm."""
    document = FreeCAD.newDocument("picture")
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape
    document.recompute()
    job = host.create_job("Job", [part])
    host.add_ball_end_controller(job, 2.0, 2, 600.0, 1000.0)
    operation = getattr(patchmill, kind).Create("Texture", parentJob=job)
    operation.Base = [(job.Model.Group[0], faces)]
    for name, value in properties.items():
        setattr(operation, name, value)
    return operation


def made(operation):
    """(plan, measured results) of an operation, whose document is closed."""
    plan = patchmill.recompute(operation)
    results = {
        name: getattr(getattr(operation, name), "Value", getattr(operation, name))
        for name in ("SpacingLeast", "SpacingGreatest", "SpacingRms", "LatticeAngleLeast", "LeftOut")
    }
    FreeCAD.closeDocument(operation.Document.Name)
    return plan, results


def save(figure, name):
    figure.tight_layout(h_pad=2.0)
    figure.savefig(str(HERE / (name + ".png")), dpi=100, bbox_inches="tight", pad_inches=0.1)
    plt.close(figure)
    print("%s.png" % name)


def wavy_face():
    """A B-spline face of 13 x 13 mm that rises and waves."""
    points = [
        [
            V(x, y, 0.12 * x + 0.55 * math.sin(0.62 * x + 0.3) * math.cos(0.55 * y))
            for y in np.linspace(-6.5, 6.5, 12)
        ]
        for x in np.linspace(-6.5, 6.5, 12)
    ]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    return surface.toShape()


def nine():
    sizes = {"Square": 8, "Hexagon": 4, "Triangle": 12}
    figure, axes = plt.subplots(3, 3, figsize=(12, 12.6))
    for row, kind in enumerate(("Planar", "Pyramid", "Curved")):
        for column, shape in enumerate(sizes):
            face = wavy_face()
            operation = operation_on(
                face, ["Face1"], kind + "Texture", PatchShape=shape, PatchSide=sizes[shape]
            )
            title = kind.lower()
            if kind == "Pyramid":
                operation.ApexLift = 0.8
                title += " + 0.8 mm"
            plan, _ = made(operation)
            title += ": %d dimples in %ss" % (plan.counts["cut"], shape.lower())
            View(face, DOWN, 0.03).show(axes[row, column], [plan], title)
    save(figure, "texture-nine")


def matsuda():
    recipe = runpy.run_path(str(HERE.parents[1] / "Resources/recipes/matsuda2008/run.py"))
    figure, axes = plt.subplots(2, 3, figsize=(12, 8.6))
    for row, part in enumerate(recipe["PARTS"]):
        for column, array in enumerate(recipe["ARRAYS"]):
            document, job, operation = recipe["make"](part, array)
            plan = patchmill.recompute(operation)
            shape = job.Model.Group[0].Shape.copy()
            direction = tuple(plan.plane.direction)
            title = "%s: %s" % (part, operation.MarkArray.split(",")[0])
            title += "\nmeasured on the path: %+.3f teeth a pass" % operation.MeasuredDrift
            FreeCAD.closeDocument(document.Name)
            middle = np.array(plan.plane.origin)
            view = View(shape, direction, 0.04, _around(shape, direction, middle, 8.5))
            view.show(axes[row, column], [plan], title)
    save(figure, "texture-matsuda")


def _around(shape, direction, middle, half):
    """Corners of a square on the picture around a point of space."""
    import _patchmill as core

    plane = core.texture_plane((0, 0, 0), direction, (1, 0, 0))
    at = np.array([middle @ plane.x_axis, middle @ plane.y_axis])
    return at - half, at + half


def part_with_hole():
    """A block, inclined, with a fillet along one edge and a hole: shape, top and fillet."""
    block = Part.makeBox(26, 20, 8, V(-13, -10, -8))
    edges = [e for e in block.Edges if abs(e.CenterOfMass.y + 10) + abs(e.CenterOfMass.z) < 1e-6]
    block = block.makeFillet(4.0, edges)
    block = block.cut(Part.makeCylinder(3.2, 20, V(3, 2, -15)))
    block.rotate(V(0, 0, 0), V(0, 1, 0), 12.0)
    block.rotate(V(0, 0, 0), V(1, 0, 0), 8.0)
    names = []
    for number, face in enumerate(block.Faces, 1):
        fillet = isinstance(face.Surface, Part.Cylinder) and face.Surface.Radius > 3.9
        if fillet or (isinstance(face.Surface, Part.Plane) and face.normalAt(0, 0).z > 0.9):
            names.append("Face%d" % number)
    return block, names


def part():
    shape, faces = part_with_hole()
    figure, axes = plt.subplots(1, 2, figsize=(13, 6.4))
    common = {"Margin": 0.5, "MinimumDimples": 8, "Mapping": "On surface", "SteepestSlope": 75.0}
    hexagons, found = made(operation_on(shape, faces, PatchShape="Hexagon", PatchSide=4, **common))
    isolated, more = made(
        operation_on(
            shape, faces, PatchSide=6, Spacing=0.8, TextureKind="Isolated", Depth=0.03, **common
        )
    )
    view = View(shape, (0.0, 0.35, -0.8), 0.035)
    for axis, plan, kind, result in (
        (axes[0], hexagons, "overlapping, hexagons", found),
        (axes[1], isolated, "isolated, 0.03 mm deep", more),
    ):
        left = textwrap.fill("left out: " + result["LeftOut"], 60)
        view.show(axis, [plan], "%s: %d dimples\n%s" % (kind, plan.counts["cut"], left))
    save(figure, "texture-part")


def mapping():
    """A ball up to 60° of slope, with the measured spacing."""
    ball = Part.makeSphere(7.0, V(0, 0, 0), V(0, 0, 1), 30.0, 90.0, 360.0)
    cap = [f for f in ball.Faces if isinstance(f.Surface, Part.Sphere)][0]
    figure, axes = plt.subplots(2, 2, figsize=(12.4, 12))
    for row, (shape, side) in enumerate((("Square", 6), ("Hexagon", 3))):
        for column, mapped in enumerate(("Projected", "On surface")):
            operation = operation_on(
                cap, ["Face1"], PatchShape=shape, PatchSide=side, Mapping=mapped
            )
            plan, found = made(operation)
            title = "%s, %s lattice\nspacing %.3f to %.3f mm for 0.5, rms %.1f %%" % (
                mapped.lower(),
                "square" if shape == "Square" else "triangular",
                found["SpacingLeast"],
                found["SpacingGreatest"],
                100.0 * found["SpacingRms"],
            )
            view = View(cap, (0.0, 0.55, -0.83), 0.025)
            view.show(axes[row, column], [plan], title, max(1.0, 2.0 * found["SpacingGreatest"]))
    save(figure, "texture-mapping")


def logo():
    box = Part.makeBox(46, 17, 3, V(-23, -8.5, -3))
    box.rotate(V(0, 0, 0), V(1, 0, 0), 15.0)
    up = [face.normalAt(0, 0).z for face in box.Faces]
    face = "Face%d" % (up.index(max(up)) + 1)
    with tempfile.TemporaryDirectory() as folder:
        letters = os.path.join(folder, "letters.png")
        _letters(letters)
        common = {
            "AutoDirection": True,
            "TextureKind": "Isolated",
            "Depth": 0.02,
            "Spacing": 0.42,
            "PatchSide": 10,
            "MaskImage": letters,
            "MaskInvert": True,
        }
        plans = [
            made(operation_on(box, [face], MaskUse="Leave out", **common))[0],
            made(
                operation_on(
                    box, [face], MaskUse="Depth", DepthAtBlack=0.004, DepthAtWhite=0.021, **common
                )
            )[0],
        ]
    titles = (
        "MaskUse Leave out: %d dimples inside the letters" % plans[0].counts["cut"],
        "MaskUse Depth: 0.021 mm inside the letters, 0.004 mm around",
    )
    figure, axes = plt.subplots(2, 1, figsize=(12, 9.6))
    view = View(box, tuple(plans[0].plane.direction), 0.04)
    for axis, plan, title in zip(axes, plans, titles):
        view.show(axis, [plan], title)
    save(figure, "texture-logo")


def _letters(name):
    figure = plt.figure(figsize=(9, 3), dpi=100)
    figure.text(0.5, 0.46, "PatchMill", size=120, weight="bold", ha="center", va="center")
    figure.savefig(name)
    plt.close(figure)


PICTURES = {"nine": nine, "matsuda": matsuda, "part": part, "mapping": mapping, "logo": logo}

if __name__ == "__main__":
    for name in sys.argv[1:] or PICTURES:
        PICTURES[name]()
