"""Parts for judging what one click gives, by name; the face to be textured is the highest that looks up.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib

import FreeCAD
import Part

V = FreeCAD.Vector
ROOT = pathlib.Path(__file__).resolve().parents[2]


def plate(angle=0.0, length=20.0, width=16.0):
    """A flat plate inclined by so many degrees."""
    shape = Part.makeBox(length, width, 4)
    shape.rotate(V(0, 0, 0), V(0, 1, 0), -angle)
    return shape


def demo():
    return Part.read(str(ROOT / "Resources" / "recipes" / "xu2016" / "block.step"))


def knob(radius=10.0, height=12.0):
    """A cylinder that lies: its bent face is textured."""
    return Part.makeCylinder(radius, height, V(0, 0, 0), V(1, 0, 0), 180)


def dome(radius=14.0, part=0.6):
    """The upper part of a ball."""
    return Part.makeSphere(radius, V(0, 0, 0), V(0, 0, 1), math.degrees(math.asin(part)), 90, 360)


def cone(low=12.0, high=6.0, height=8.0):
    return Part.makeCone(low, high, height)


def wave(amplitude, slope=0.0, length=20.0, width=16.0):
    """A block with waves on top, its mean plane inclined by `slope`."""
    rows = [
        [
            V(
                length * i / 6,
                width * j / 4,
                8 + slope * length * i / 6 + amplitude * math.cos(1.1 * i) * math.cos(0.9 * j),
            )
            for j in range(5)
        ]
        for i in range(7)
    ]
    surface = Part.BSplineSurface()
    surface.interpolate(rows)
    return surface.toShape().extrude(V(0, 0, -6))


def shell(radius=3.0):
    """A case like a telephone's, its long edges rounded, with two holes through the top."""
    box = Part.makeBox(30, 20, 8)
    edges = [e for e in box.Edges if e.BoundBox.ZMin > 7.9]
    rounded = box.makeFillet(radius, edges)
    for x in (9, 21):
        rounded = rounded.cut(Part.makeCylinder(2.5, 20, V(x, 10, -5)))
    return rounded


PARTS = {
    "demo": demo,
    "flat plate": plate,
    "knob": knob,
    "dome": dome,
    "telephone shell": shell,
    "plate 10": lambda: plate(10.0),
    "plate 20": lambda: plate(20.0),
    "plate 30": lambda: plate(30.0),
    "plate 40": lambda: plate(40.0),
    "plate 50": lambda: plate(50.0),
    "cone 53": cone,
    "cone 27": lambda: cone(12.0, 4.0, 4.0),
    "thin knob": lambda: knob(6.0),
    "thick knob": lambda: knob(25.0),
    "flat dome": lambda: dome(30.0, 0.9),
    "small dome": lambda: dome(9.0),
    "wave": lambda: wave(0.5),
    "high wave": lambda: wave(1.2),
    "wave on a slope": lambda: wave(0.5, 0.5),
    "high wave on a slope": lambda: wave(1.0, 0.6),
    "wave on a gentle slope": lambda: wave(0.3, 0.25),
    "small plate 25": lambda: plate(25.0, 8.0, 6.0),
    "long plate 25": lambda: plate(25.0, 40.0, 5.0),
    "shell of large fillets": lambda: shell(6.0),
    "plate 5": lambda: plate(5.0),
}


def top_face(shape):
    """Name of the highest face that looks upwards anywhere."""
    numbers = range(len(shape.Faces))
    best = max(numbers, key=lambda n: (_looks_up(shape.Faces[n]), shape.Faces[n].CenterOfMass.z))
    return "Face%d" % (best + 1)


def _looks_up(face):
    u0, u1, v0, v1 = face.ParameterRange
    places = (u0 + share * (u1 - u0) for share in (0.25, 0.5, 0.75))
    return max(face.normalAt(u, 0.5 * (v0 + v1)).z for u in places) > 0.5
