"""More parts for judging what one click gives: other kinds and sizes, faces that look aside or down,
and parts of Debian's packages occt-misc and freecad-common. Each function returns (shape, name of the face).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib

import FreeCAD
import Part
import quality_parts

V = FreeCAD.Vector
OCCT = pathlib.Path("/usr/share/opencascade/data")
IDF = pathlib.Path("/usr/share/freecad/Mod/Idf/Idflibs")
INCH = 25.4


def top(shape):
    return shape, quality_parts.top_face(shape)


def where(shape, is_it):
    """(shape, name of the largest face that `is_it`)."""
    found = max((k for k, f in enumerate(shape.Faces) if is_it(f)), key=lambda k: shape.Faces[k].Area)
    return shape, "Face%d" % (found + 1)


def box_side():
    return where(Part.makeBox(20, 16, 14), lambda f: f.normalAt(0, 0).x > 0.9)


def box_bottom():
    return where(Part.makeBox(20, 16, 6), lambda f: f.normalAt(0, 0).z < -0.9)


def upside_down():
    """An inclined plate on its head: its face looks down."""
    shape, name = top(quality_parts.plate(25.0))
    shape.rotate(V(0, 0, 0), V(1, 0, 0), 180)
    return shape, name


def ring():
    return top(Part.makeCylinder(14, 4).cut(Part.makeCylinder(11, 4)))


def plate_with_holes():
    shape = quality_parts.plate(0.0, 24.0, 18.0)
    for x, y in ((4, 4), (12, 9), (20, 14), (20, 4)):
        shape = shape.cut(Part.makeCylinder(1.5, 20, V(x, y, -5)))
    shape.rotate(V(0, 0, 0), V(0, 1, 0), -25)
    return top(shape)


def trough():
    """The inside of a cylinder that lies."""
    shape = Part.makeBox(24, 16, 10).cut(Part.makeCylinder(9, 16, V(12, 0, 13), V(0, 1, 0)))
    return where(shape, lambda f: f.Surface.TypeId == "Part::GeomCylinder")


def bore(radius=8.0, deep=10.0):
    """The inside of a hole."""
    side = 3.0 * radius
    shape = Part.makeBox(side, side, deep).cut(Part.makeCylinder(radius, deep, V(side / 2, side / 2, 0)))
    return where(shape, lambda f: f.Surface.TypeId == "Part::GeomCylinder")


def shaft():
    """The outside of a cylinder that stands."""
    return where(Part.makeCylinder(8, 14), lambda f: f.Surface.TypeId == "Part::GeomCylinder")


def fillet(radius=8.0):
    box = Part.makeBox(22, 16, 12)
    edge = [e for e in box.Edges if e.BoundBox.ZMin > 11.9 and e.BoundBox.XMin > 21.9]
    return where(box.makeFillet(radius, edge), lambda f: f.Surface.TypeId == "Part::GeomCylinder")


def saddle():
    surface = Part.BSplineSurface()
    surface.interpolate(
        [[V(4 * i, 4 * j, 8 + 0.25 * ((i - 2) ** 2 - (j - 2) ** 2)) for j in range(5)] for i in range(5)]
    )
    return where(surface.toShape().extrude(V(0, 0, -6)), lambda f: f.normalAt(0.5, 0.5).z > 0.5)


def loft():
    """From a square to a circle above it."""
    square = Part.makePolygon([V(-10, -10, 0), V(10, -10, 0), V(10, 10, 0), V(-10, 10, 0), V(-10, -10, 0)])
    circle = Part.Wire(Part.Circle(V(0, 0, 9), V(0, 0, 1), 5).toShape())
    shape = Part.makeLoft([square, circle], True)
    return where(shape, lambda f: abs(f.normalAt(*_middle(f)).z) < 0.95)


def torus_segment():
    """The upper side of a quarter of a ring."""
    return where(Part.makeTorus(14, 5, V(), V(0, 0, 1), 30, 150, 90), _is("Toroid"))


def pipe_bend():
    """All around a quarter of a ring: one setup reaches half."""
    return where(Part.makeTorus(16, 4, V(), V(0, 0, 1), -180, 180, 90), _is("Toroid"))


def cap_with_hole():
    cap = quality_parts.dome(20.0, 0.6)
    return where(cap.cut(Part.makeCylinder(2.5, 60, V(0, 0, -30))), _is("Sphere"))


def dish():
    """A shallow hollow of 24 mm."""
    block = Part.makeCylinder(14, 6)
    return where(block.cut(Part.makeSphere(40, V(0, 0, 44))), _is("Sphere"))


def bent_plate():
    """300 mm long, bent to a radius of 800."""
    block = Part.makeBox(300, 60, 20, V(-150, -30, 0))
    return where(block.common(Part.makeCylinder(800, 60, V(0, -30, -785), V(0, 1, 0))), _is("Cylinder"))


def pocket(deep):
    """The floor of a pocket of 20 by 14 mm."""
    box = Part.makeBox(26, 20, 8)
    shape = box.cut(Part.makeBox(20, 14, deep, V(3, 3, 8 - deep)))
    return where(shape, lambda f: abs(f.CenterOfMass.z - 8 + deep) < 1e-6 and f.Area > 200)


def _is(kind):
    """Whether a face lies on a surface of that kind."""
    return lambda face: face.Surface.TypeId == "Part::Geom" + kind


def _middle(face):
    u0, u1, v0, v1 = face.ParameterRange
    return 0.5 * (u0 + u1), 0.5 * (v0 + v1)


def of_file(path):
    """The largest free-form or bent face of a file, and the solid that has it: of a file of several solids
    FreeCAD makes an object of each."""
    from test_real_parts import interesting_face, read

    def make():
        shape = read(path)
        face = interesting_face(shape)
        solid = next((one for one in shape.Solids if _number(one, face)), shape)
        return solid, "Face%d" % _number(solid, face)

    return make


def _number(shape, face):
    """Of a face of a shape, from 1; 0 where it has none such."""
    return next((k + 1 for k, f in enumerate(shape.Faces) if f.isSame(face)), 0)


PARTS = {
    **{name: lambda make=make: top(make()) for name, make in quality_parts.PARTS.items()},
    "plate of 2 mm": lambda: top(quality_parts.plate(25.0, 2.0, 2.0)),
    "flat plate of 4 mm": lambda: top(quality_parts.plate(0.0, 4.0, 3.0)),
    "plate of 200 mm": lambda: top(quality_parts.plate(25.0, 200.0, 100.0)),
    "flat plate of 500 mm": lambda: top(quality_parts.plate(0.0, 500.0, 300.0)),
    "plate of an inch": lambda: top(quality_parts.plate(0.0, INCH, 0.5 * INCH)),
    "side of a box": box_side,
    "bottom of a box": box_bottom,
    "upside down": upside_down,
    "ring": ring,
    "plate with holes": plate_with_holes,
    "trough": trough,
    "bore": bore,
    "shaft": shaft,
    "fillet": fillet,
    "saddle": saddle,
    "loft": loft,
    "torus segment": torus_segment,
    "pipe bend": pipe_bend,
    "cap with a hole": cap_with_hole,
    "dish": dish,
    "bent plate of 300 mm": bent_plate,
    "plate of two inches": lambda: top(quality_parts.plate(0.0, 2.0 * INCH, INCH)),
    "rim of 1.5 mm": lambda: top(Part.makeCylinder(15, 4).cut(Part.makeCylinder(13.5, 4))),
    "floor of a pocket": lambda: pocket(1.5),
    "torus": lambda: where(Part.makeTorus(14, 5), lambda f: True),
    "ball": lambda: where(Part.makeSphere(8), lambda f: True),
    "wing": of_file(OCCT / "occ/wing.brep"),
    "hammer": of_file(OCCT / "iges/hammer.iges"),
    "bottle": of_file(OCCT / "occ/bottle.brep"),
    "crank arm": of_file(OCCT / "occ/CrankArm.brep"),
    "top of a case": of_file(OCCT / "occ/Top.brep"),
    "link rods": of_file(OCCT / "step/linkrods.step"),
    "screw": of_file(OCCT / "step/screw.step"),
    "pump cover": of_file(OCCT / "occ/Pump_TopCover.brep"),
    "piston": of_file(OCCT / "occ/Piston.rle"),
    "coil": of_file(IDF / "RLF_12545.stp"),
    "capacitor": of_file(IDF / "CAP_50SGV_8_10.stp"),
}
# The table of docs/advice.md: those of the task, and 20 others
TABLE = (
    "demo", "flat plate", "knob", "dome", "telephone shell",
    "plate 10", "plate 30", "cone 27", "wave", "high wave on a slope", "plate of 2 mm", "plate of an inch",
    "plate with holes", "ring", "side of a box", "bottom of a box", "upside down", "trough", "bore", "shaft",
    "fillet", "saddle", "loft", "coil", "capacitor",
)  # fmt: skip
