"""Faces of which one setup reaches less than half: several textures share them, each from another side, in
operations of one job or in jobs of their own; and no remedy whose tool runs into the part.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import unittest
from dataclasses import replace

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import numpy as np  # noqa: E402
import one_click  # noqa: E402
import other_parts  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from patchmill.advice import apply, companions, remedies, room, sides  # noqa: E402
from patchmill.advice.found import Assessment, PatchQuality  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.machine import machines  # noqa: E402
from patchmill.textures.plan import place_texture  # noqa: E402

V = FreeCAD.Vector
LOCKED = {
    "strategy": "Spindle-locked", "order": "Rows", "row_direction": "Along Y", "same_flute": False,
    "extra_turns": 0.0, "margin": 0.24,
}  # fmt: skip
GOOD = Assessment(100, 1.0, {}, [PatchQuality((0.0, 0.0, 0.0), 20.0, 1.0)])


def shaft(radius=4.0, height=5.0):
    shape = Part.makeCylinder(radius, height)
    return other_parts.where(shape, lambda f: f.Surface.TypeId == "Part::GeomCylinder")


class WithTexture(unittest.TestCase):
    def texture(self, part, machine):
        operation = one_click.texture(*part, machine)
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        return operation

    def shared(self, operation, number=0):
        """(TextureInput, Sides) of the lean of that number."""
        given = replace(operation.Proxy.texture_input(operation), **LOCKED)
        tried = list(sides._tries(given, machines.load(given.machine), True))
        return given, tried[number]


class Sides(WithTexture):
    def test_each_dimple_is_milled_from_one_side(self):
        """Of a shaft, on five axes and on three; the margin leaves out the same from all."""
        for machine in ("table-table-ac", "linuxcnc-mill"):
            given, shared = self.shared(self.texture(shaft(), machine))
            placed = [place_texture(sides.asked(given, side)).dimples for side in shared]
            cut = np.concatenate([one.lattice[one.states == core.DimpleState.CUT] for one in placed])
            self.assertEqual(len(np.unique(cut, axis=0)), len(cut), machine)
            on_face = (placed[0].states != core.DimpleState.OFF_FACE).sum()
            rows = len(np.unique(placed[0].lattice[placed[0].states == core.DimpleState.CUT][:, 1]))
            columns = round(2.0 * math.pi * 4.0 / 0.5)
            self.assertEqual(len(cut), rows * columns)
            self.assertLess(len(cut), on_face)
            inputs = [sides.asked(given, side) for side in shared]
            self.assertEqual(sides.milled_fraction(inputs), 1.0)
            self.assertLess(sides.milled_fraction(inputs[:2]), 0.75)
            self.assertAlmostEqual(sides.milled_fraction(inputs[:1] * 2), sides.milled_fraction(inputs[:1]))

    def test_directions_that_share_are_evenly_around_the_axis(self):
        given, _ = self.shared(self.texture(shaft(), "table-table-ac"))
        for lean, (ups, steepest) in zip(sides.LEANS, sides._directions(given)):
            for up in ups:
                self.assertAlmostEqual(math.degrees(math.acos(up[2])), lean)
            halfway = (ups[0] + ups[1]) * (1.0, 1.0, 0.0)
            cosine = ups[0] @ halfway / np.linalg.norm(halfway)
            self.assertAlmostEqual(math.degrees(math.acos(cosine)), steepest)

    def test_axes_of_faces_whose_normals_are_at_one_angle_to_them(self):
        """Cylinders, cones, one of a spline, and prisms; not of a ball, nor of a plate and its opposite."""
        sine = 1.0 / math.hypot(1.0, 7.0)
        corners = [V(7.0 * math.cos(math.pi / 3 * k), 7.0 * math.sin(math.pi / 3 * k), 0.0) for k in range(7)]
        prism = Part.Face(Part.makePolygon(corners)).extrude(V(0.0, 0.0, 7.0))
        leaning = Part.makeCylinder(4.0, 5.0, V(), V(1.0, 0.0, 1.0))
        up = np.array((0.0, 0.0, 1.0))
        for shape, expected, cosine in (
            (Part.makeCylinder(4.0, 5.0), up, 0.0),
            (leaning, np.array((1.0, 0.0, 1.0)) / math.sqrt(2.0), 0.0),
            (Part.makeCone(6.0, 5.0, 7.0), up, sine),
            (Part.makeCone(5.0, 6.0, 7.0), -up, sine),
            (Part.makeCone(6.0, 5.0, 7.0).toNurbs(), up, sine),
            (prism, up, 0.0),
            (Part.makeSphere(8.0), None, None),
        ):
            given = self.all_but_the_ends(shape, up if expected is None else expected)
            axis, found = sides._common_axis(given)
            if expected is None:
                self.assertIsNone(axis)
                continue
            np.testing.assert_allclose(axis, expected, atol=1e-6)
            self.assertAlmostEqual(found, cosine, places=6)
        plate = [face.exportBrepToString() for face in Part.makeBox(9, 9, 9).Faces[:2]]
        self.assertEqual(sides._common_axis(replace(given, breps=plate)), (None, None))

    def all_but_the_ends(self, shape, axis):
        """TextureInput of the faces of a shape that do not look along an axis."""
        operation = self.texture(shaft(), "linuxcnc-mill")
        texts = []
        for face in shape.Faces:
            u0, u1, v0, v1 = face.ParameterRange
            if abs(np.dot(face.normalAt(0.5 * (u0 + u1), 0.5 * (v0 + v1)), axis)) < 0.99:
                texts.append(face.exportBrepToString())
        return replace(operation.Proxy.texture_input(operation), breps=texts)

    def test_of_a_cone_each_dimple_is_milled_from_one_side(self):
        """Narrower above or below: the next side begins where it is as steep to this one's direction."""
        for low, high in ((5.0, 4.0), (4.0, 5.0)):
            cone = other_parts.where(Part.makeCone(low, high, 5.0), lambda f: "Cone" in f.Surface.TypeId)
            given, shared = self.shared(self.texture(cone, "table-table-ac"), 1)
            placed = [place_texture(sides.asked(given, side)).dimples for side in shared]
            cut = np.concatenate([one.lattice[one.states == core.DimpleState.CUT] for one in placed])
            self.assertEqual(len(np.unique(cut, axis=0)), len(cut))
            part = sides.milled_fraction([sides.asked(given, side) for side in shared])
            self.assertGreater(part, 0.98)  # where it is rolled up again the lattice does not go on

    def test_a_tool_comes_from_above_and_a_part_is_turned_over(self):
        """Of a cone that is narrower below, whose normals look down."""
        cone = other_parts.where(Part.makeCone(4.0, 5.0, 5.0), lambda f: "Cone" in f.Surface.TypeId)
        given, _ = self.shared(self.texture(cone, "table-table-ac"))
        for from_above in (True, False):
            tried = list(sides._directions(given, from_above))
            self.assertTrue(tried)
            for ups, steepest in tried:
                self.assertEqual([up[2] > 0.0 for up in ups], [from_above] * 3)
                self.assertLess(steepest, 88.0)

    def test_a_part_that_may_not_be_turned_and_a_tool_that_cannot_lean(self):
        given, _ = self.shared(self.texture(shaft(), "linuxcnc-mill"))
        self.assertEqual(list(sides._tries(given, machines.load("linuxcnc-mill"), False)), [])
        five = list(sides._tries(given, machines.load("table-table-ac"), False))
        self.assertTrue(five and all(side.axis is None for shared in five for side in shared))

    def test_assessments_add_up(self):
        given, shared = self.shared(self.texture(shaft(), "table-table-ac"))
        inputs = [sides.asked(given, side) for side in shared]
        parts = [
            replace(GOOD, dimples=30, milled_fraction=0.3, seconds=10.0, away_fraction=0.7, whole=0.97),
            replace(GOOD, dimples=10, milled_fraction=0.1, seconds=5.0, away_fraction=0.9),
            replace(GOOD, dimples=60, milled_fraction=0.6, seconds=15.0, away_fraction=0.4),
        ]
        made = sides.together(parts, inputs)
        self.assertEqual((made.dimples, made.seconds, made.whole), (100, 30.0, 0.97))
        self.assertAlmostEqual(made.good_fraction, 1.0)
        self.assertAlmostEqual(made.away_fraction, 0.0)
        self.assertEqual([patch.fraction for patch in made.patches], [0.3, 0.1, 0.6])
        parts[0].patches = [PatchQuality((0.0, 0.0, 0.0), 20.0, 0.5)]
        self.assertAlmostEqual(sides.together(parts, inputs).good_fraction, 0.7)


class Documents(WithTexture):
    def taken(self, operation):
        """(remedy, the other operations) after the first Sides were taken over, whose values are LOCKED."""
        _, shared = self.shared(operation)
        made = [sides.Side({**LOCKED, **side.fields}, side.axis, side.angle) for side in shared]
        remedy = remedies.Remedy("sides", made[0].fields, GOOD, made[0].axis, made[0].angle, made[1:])
        return remedy, apply.take(operation, remedy)

    def test_a_shaft_is_short_and_becomes_good_by_the_fix(self):
        """All of it, of which one setup reaches half; nothing is in the tool's way."""
        operation = self.texture(shaft(), "table-table-ac")
        found = one_click.remedies_of(operation, {"margin": 0.0})
        self.assertEqual(found[0].kind, "sides")
        self.assertTrue(found[0].assessment.good)
        others = apply.take(operation, found[0])
        self.assertEqual(len(others), 2)
        for each in (operation, *others):
            state, seen, _ = one_click.state_of(each)
            self.assertEqual((state, seen.milled_fraction), ("good", 1.0))
            self.assertTrue(patchmill.check(each).clear)

    def test_on_five_axes_the_sides_are_operations_of_one_job(self):
        operation = self.texture(shaft(), "table-table-ac")
        operation.Spacing = 0.6
        _, others = self.taken(operation)
        job = host.PathUtils.findParentJob(operation)
        self.assertEqual(job.Operations.Group, [operation, *others])
        self.assertEqual(len({tuple(each.FixedAxis) for each in job.Operations.Group}), 3)
        for each in others:
            self.assertEqual((each.Spacing.Value, each.Margin.Value), (0.6, 0.24))
            self.assertIs(each.ToolController, operation.ToolController)
        self.assertEqual(len(companions.inputs(operation)), 2)
        others[0].Spacing = 0.5  # another lattice
        self.assertEqual(len(companions.inputs(operation)), 1)
        others[1].Active = False
        self.assertEqual(companions.inputs(operation), [])

    def test_on_three_axes_each_side_has_a_job_in_which_the_part_is_turned(self):
        operation = self.texture(shaft(), "linuxcnc-mill")
        operation.ToolController.SpindleSpeed = 1234
        host.PathUtils.findParentJob(operation).Stock.ExtZpos = 2.5
        _, others = self.taken(operation)
        jobs = [host.PathUtils.findParentJob(each) for each in (operation, *others)]
        self.assertEqual(len(set(job.Name for job in jobs)), 3)
        turns = [job.Model.Group[0].Placement.Rotation for job in jobs]
        up = [turn.inverted().multVec(FreeCAD.Vector(0, 0, 1)) for turn in turns]
        for one, other in ((0, 1), (1, 2), (2, 0)):
            self.assertGreater(math.degrees(up[one].getAngle(up[other])), 70.0)
        for job, each in zip(jobs, (operation, *others)):
            model, stock = job.Model.Group[0].Shape.BoundBox, job.Stock.Shape.BoundBox
            self.assertAlmostEqual(stock.ZMax - model.ZMax, 2.5)
            self.assertAlmostEqual(model.XMin - stock.XMin, 1.0)
            self.assertEqual(each.ToolController.SpindleSpeed, 1234)
            self.assertEqual(each.ToolController.Tool.Diameter.Value, 2.0)
            self.assertEqual(job.PostProcessor, jobs[0].PostProcessor)
        inputs = [each.Proxy.texture_input(each) for each in (operation, *others)]
        self.assertEqual(sides.milled_fraction(inputs), 1.0)

    def test_taken_again_the_same_operations_are_used(self):
        operation = self.texture(shaft(), "table-table-ac")
        _, first = self.taken(operation)
        operation.Spacing = 0.6
        _, second = self.taken(operation)
        self.assertEqual([each.Name for each in second], [each.Name for each in first])
        self.assertEqual(len(companions.inputs(operation)), 2)


class Walls(WithTexture):
    def test_a_tool_that_leans_too_far_for_a_bore_touches_it(self):
        operation = self.texture(other_parts.bore(), "table-table-ac")
        model = apply.model_of(operation)
        touched = []
        for number in (0, 1):  # 50°, 30°
            given, shared = self.shared(operation, number)
            touched.append(room.touches(sides.asked(given, shared[0]), model))
        self.assertEqual(touched, [True, False])
        self.assertFalse(room.touches(sides.asked(given, shared[0]), ()))

    def test_of_a_pocket_no_remedy_cuts_the_walls(self):
        """What a margin leaves out for them is not good."""
        operation = self.texture(other_parts.pocket(0.8), "linuxcnc-mill")
        found = one_click.remedies_of(operation, {"margin": 0.0})
        self.assertTrue(found and found[0].walled)
        self.assertLess(found[0].assessment.good_fraction, 0.8)
        self.assertTrue(found[0].assessment.remains_good)
        apply.take(operation, found[0])
        patchmill.recompute(operation)
        self.assertTrue(patchmill.check(operation).clear)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
