"""Parts that others made: for each its largest free-form or curved face is textured, every point lies on
the face, and the counts by reason add up to the lattice points tried.

The parts are those of Debian packages occt-misc and freecad-common (its Idf library).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import unittest

import _patchmill as core
import FreeCAD
import numpy as np
import Part

from patchmill.textures.plan import TextureInput, plan_texture

OCCT = pathlib.Path("/usr/share/opencascade/data")
IDF = pathlib.Path("/usr/share/freecad/Mod/Idf/Idflibs")
NAMES = [
    "occ/Axis_of_bearing.brep", "occ/Ball.brep", "occ/Bottom.brep", "occ/CrankArm.brep",
    "occ/MODERN_Sink_1.brep", "occ/Motor-c.brep", "occ/Pump_Nut.brep", "occ/Pump_TopCover.brep",
    "occ/Top.brep", "occ/bottle.brep", "occ/face1.brep", "occ/face2.brep", "occ/hammer.brep",
    "occ/shell1.brep", "occ/terrain.brep", "occ/wing.brep", "occ/CylinderHead.rle", "occ/Piston.rle",
    "occ/Propeller.rle", "iges/bearing.iges", "iges/hammer.iges", "step/linkrods.step",
    "step/screw.step",
]  # fmt: skip
IDF_NAMES = [
    "CAP_50SGV_8_10.stp", "EPL22_6_16.stp", "RLF_12545.igs", "RLF_12545.stp", "SOD_323.igs", "SOT404.igs",
    "SOT_96.stp", "TCMT1107_4.stp",
]  # fmt: skip
DIMPLES = 400.0  # of a face, about
# Of a face whose points take half a second each to be found on it; tools/parts_of_others.py makes 400
FEW = {"terrain.brep": 50.0}
FREE_FORM = ("BSplineSurface", "BezierSurface", "OffsetSurface", "SurfaceOfRevolution", "SurfaceOfExtrusion")
LEANING = FreeCAD.Vector(math.sin(math.radians(20)), 0, math.cos(math.radians(20)))


def read(path):
    if path.suffix == ".rle":  # occt's name for BREP text
        shape = Part.Shape()
        shape.importBrepFromString(path.read_text(errors="replace"))
        return shape
    return Part.read(str(path))


def interesting_face(shape):
    """The largest free-form face whose middle can be seen from where its normal points; if there is none,
    the largest curved one; None if there is neither. The inside of a bore hides its own far wall."""

    def kind(face):
        name = face.Surface.__class__.__name__
        return 0 if name in FREE_FORM else 2 if name == "Plane" else 1

    faces = sorted((f for f in shape.Faces if kind(f) < 2), key=lambda f: (kind(f), -f.Area))
    return next((f for f in faces if middle_is_seen(f)), None)


def middle_is_seen(face):
    u0, u1, v0, v1 = face.ParameterRange
    u, v = 0.5 * (u0 + u1), 0.5 * (v0 + v1)
    if not face.isPartOfDomain(u, v):
        return True  # a face around a hole: whatever it hides, it does not hide its middle
    away = 2.0 * face.BoundBox.DiagonalLength
    near = face.valueAt(u, v) + 1e-3 * away * face.normalAt(u, v)
    sight = Part.makeLine(near, near + away * face.normalAt(u, v))
    return face.distToShape(sight)[0] > 1e-6


def facing_up(face):
    """A copy of the face turned so that its normal at the middle of its parameters leans 20 degrees from
    the vertical: a flat face turned straight up would be milled with the tool's tip."""
    u0, u1, v0, v1 = face.ParameterRange
    normal = face.normalAt(0.5 * (u0 + u1), 0.5 * (v0 + v1))
    turned = face.copy()
    turned.Placement = FreeCAD.Placement(
        FreeCAD.Vector(0, 0, 0), FreeCAD.Rotation(normal, LEANING)
    ).multiply(face.Placement)
    return turned


def distance(face, point):
    """Distance of a point to the face [mm]: to its surface if the foot is inside the trimming. (Only where
    it is not is distToShape asked: it is slow, and on parts of this list it overlooks feet in the face.)"""
    u, v = face.Surface.parameter(point)
    if face.isPartOfDomain(u, v):
        return face.Surface.value(u, v).distanceToPoint(point)
    return face.distToShape(Part.Vertex(point))[0]


def texture(face, dimples=DIMPLES):
    """A texture of about so many dimples with a tool to match."""
    low, high = core.FaceSampler(
        [face.exportBrepToString()], core.texture_plane((0, 0, 0), (0, 0, -1), (1, 0, 0)), 1.0
    ).extent()
    width, height = high - low
    spacing = min((face.Area / dimples) ** 0.5, min(width, height) / 4.0)
    height = face.BoundBox.ZMax + 100.0 * spacing + 1.0
    given = TextureInput(
        breps=[face.exportBrepToString()],
        tool=core.BallEndMill(spacing, 2),
        spindle=core.Spindle(1000 / 60, "M3"),
        feed=30.0 * spacing,
        safe_height=height,
        clearance_height=height + 1.0,
        spacing=spacing,
        patch_side=3,
        steepest_slope=60.0,
        minimum_tilt=0.01,
        decimals=6,
    )
    return plan_texture(given)


class RealParts(unittest.TestCase):
    def test_every_part_is_textured(self):
        done, points = [], 0
        for path in [OCCT / n for n in NAMES] + [IDF / n for n in IDF_NAMES]:
            with self.subTest(path.name):
                face = interesting_face(read(path))
                if face is None:
                    continue
                face = facing_up(face)
                plan = texture(face, FEW.get(path.name, DIMPLES))
                self.check(face, plan)
                done.append(path.name)
                points += plan.counts["cut"]
                print("%-24s %-20s %s" % (path.name, type(face.Surface).__name__, used(plan.counts)))
        self.assertGreaterEqual(len(done), 20)
        print("%d parts, %d dimples" % (len(done), points))

    def check(self, face, plan):
        self.assertEqual(sum(plan.counts.values()), len(plan.dimples))
        cut = plan.dimples.states == 0
        self.assertGreater(int(cut.sum()), 20)
        positions, normals = plan.dimples.positions[cut], plan.dimples.normals[cut]
        self.assertTrue(np.isfinite(positions).all())
        self.assertLess(np.abs(np.linalg.norm(normals, axis=1) - 1.0).max(), 1e-9)
        self.assertLess(max(distance(face, FreeCAD.Vector(*p)) for p in positions), 1e-6)
        self.assertLess(math.degrees(plan.phase_errors()["largest"]), 1.0)


def used(counts):
    return ", ".join("%s %d" % (k, v) for k, v in counts.items() if v)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
