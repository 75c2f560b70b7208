"""What one click gives on a few parts: good, or the head says that it is short and its first button makes it
so. tools/survey-one-click does the same for many more.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import FreeCAD  # noqa: E402
import numpy as np  # noqa: E402
import Part  # noqa: E402
import one_click  # noqa: E402
import other_parts  # noqa: E402
import patchmill  # noqa: E402
import quality_parts  # noqa: E402
from patchmill.advice import apply, assessment, cells, choice, orientation, remedies  # noqa: E402
from patchmill.advice.found import Assessment, PatchQuality, _helps  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.machine import machines  # noqa: E402
from patchmill.textures import strategies  # noqa: E402


class OneClick(unittest.TestCase):
    def one(self, name, machine):
        """(operation, state, Assessment, minutes) after one click."""
        shape = quality_parts.PARTS[name]()
        operation = one_click.texture(shape, quality_parts.top_face(shape), machine)
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        one_click.choose_for(operation)
        return (operation, *one_click.state_of(operation))

    def test_an_inclined_plate_is_good_at_once(self):
        for name in ("plate 20", "plate 30"):
            operation, state, found, _ = self.one(name, "linuxcnc-mill")
            self.assertEqual(state, "good", name)
            self.assertGreaterEqual(found.quality, 0.95)
            self.assertEqual(found.milled_fraction, 1.0)
            self.assertEqual((operation.Strategy, operation.Order), ("Spindle-locked", "Rows"))

    def test_a_face_that_looks_sideways_is_short_and_becomes_good_by_the_fix(self):
        """On three axes the part is turned; that was tried."""
        shape, face = other_parts.box_side()
        operation = one_click.texture(shape, face, "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        one_click.choose_for(operation)
        self.assertEqual(one_click.state_of(operation)[0], "short")
        self.assertEqual(one_click.fix(operation), "incline")
        self.assertEqual(one_click.state_of(operation)[0], "good")

    def test_a_lying_half_cylinder_is_short_and_becomes_good_by_the_fix(self):
        """However it lies, much of it is steep, where a projected lattice is stretched: it is laid on."""
        operation = one_click.texture(quality_parts.knob(5.0, 6.0), "Face1", "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        one_click.choose_for(operation)
        _, found, _ = one_click.state_of(operation)
        self.assertLess(found.milled_fraction, 0.5)  # the other half looks down
        self.assertEqual(one_click.fix(operation), "incline")
        self.assertEqual(operation.Mapping, "On surface")
        self.assertEqual(one_click.state_of(operation)[0], "good")

    def test_what_looks_away_counts_as_left_out(self):
        """Of a lying cylinder all sides but those of up to 80° to the projection."""
        shape = Part.makeCylinder(6.0, 8.0, FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0))
        operation = one_click.texture(shape, "Face1", "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        given = operation.Proxy.texture_input(operation)
        seen = orientation.seen_fraction(given, (0.0, 0.0, -1.0))
        self.assertAlmostEqual(seen, 160.0 / 360.0, delta=0.03)  # by triangles
        self.assertEqual(orientation.seen_fraction(given, (-1.0, 0.0, 0.0)), 0.0)
        found = one_click.assess(given, 1)
        self.assertAlmostEqual(found.milled_fraction, seen, delta=0.06)
        self.assertAlmostEqual(found.away_fraction, 1.0 - seen)

    def test_bad_borders_count_for_what_they_leave(self):
        inside = [PatchQuality((0.0, 0.0, 0.0), 20.0, 1.0)]
        short, good = (Assessment(100, part, {}, inside) for part in (0.6, 1.0))
        open_border = Assessment(100, 1.0, {}, inside, whole=0.9)
        self.assertEqual([found.worth for found in (short, open_border, good)], [0.6, 0.9, 1.0])
        self.assertTrue(_helps(open_border, short.worth))
        self.assertTrue(_helps(good, open_border.worth))
        self.assertFalse(_helps(open_border, good.worth))

    def test_an_inclined_part_keeps_its_stock_and_its_heights_are_foreseen(self):
        """The top of a part with one edge rounded is not that of the rounded face."""
        operation = one_click.texture(*other_parts.fillet(), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        job = host.PathUtils.findParentJob(operation)
        for axis, angle in (((1.0, 0.0, 0.0), 40.0), ((0.0, 1.0, 0.0), 110.0), ((-0.6, 0.8, 0.0), -70.0)):
            given, model = operation.Proxy.texture_input(operation), apply.model_of(operation)
            foreseen = orientation.turned(given, axis, angle, model)
            apply.incline(job, axis, angle)
            operation.Proxy.refresh_heights(operation)
            part, stock = (shape.BoundBox for shape in (job.Model.Group[0].Shape, job.Stock.Shape))
            for name in ("XMin", "YMin", "ZMin"):
                self.assertAlmostEqual(getattr(part, name) - getattr(stock, name), 1.0)
            self.assertAlmostEqual(stock.ZMax - part.ZMax, 1.0)
            now = operation.Proxy.texture_input(operation)
            above = [one.safe_height - orientation._top(one.breps[0]) for one in (foreseen, now)]
            self.assertAlmostEqual(*above, places=6)

    def test_remedies_choose_their_own_speed_from_the_one_before(self):
        """A face that holds 1520 rpm as it lies may need less when it is inclined."""
        shape = quality_parts.PARTS["flat plate"]()
        operation = one_click.texture(shape, quality_parts.top_face(shape), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        before = one_click.cutting(operation)
        operation.ToolController.SpindleSpeed = 1520
        given = operation.Proxy.texture_input(operation)
        good = Assessment(1000, 1.0, {}, [PatchQuality((0.0, 0.0, 0.0), 20.0, 1.0)])
        asked = []

        def choose(given, _):
            asked.append(round(60.0 * given.spindle.speed))
            return choice.Choice({"strategy": strategies.LOCKED}, good)

        finder = remedies.Finder(one_click.assess, choose, True, True, {"spindle": given.spindle}, before)
        found = finder.find(given)
        self.assertEqual(set(asked), {1000})
        apply.take(operation, found[0])
        self.assertEqual(operation.ToolController.SpindleSpeed, 1000.0)

    def test_borders_of_a_large_texture_are_in_what_is_said_of_it(self):
        """Of squares spread over it: along both circles of a cone the ends of rows leave marks."""
        cone = other_parts.where(Part.makeCone(14, 8, 12), lambda f: f.Surface.TypeId == "Part::GeomCone")
        operation = one_click.texture(*cone, "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        operation.Strategy, operation.Order, operation.RowDirection = "Spindle-locked", "Rows", "Along Y"
        operation.SameFlute, operation.ExtraTurns, operation.Margin = False, 0.0, 0.24
        state, found, _ = one_click.state_of(operation)
        self.assertGreater(found.dimples, assessment.SMALL)
        self.assertGreater(found.quality, 0.99)
        plan = operation.Proxy.planned
        whole = patchmill.simulate(plan, machine=plan.machine).quality
        self.assertAlmostEqual(found.whole, whole, delta=0.04)
        self.assertLess(found.whole, 0.95)
        self.assertEqual(state, "short")

    def test_squares_cover_a_texture_once(self):
        operation = one_click.texture(quality_parts.plate(25.0), "Face6", "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        plan = patchmill.recompute(operation)
        places = plan.places()[plan.dimples.states == 0]
        windows = cells.squares(plan, 1000)
        within = sum(((places >= low) & (places < high)).all(axis=1) for low, high in windows)
        self.assertEqual(set(within), {1})
        self.assertEqual(len(cells.squares(plan, 3)), 3)

    def test_a_flat_plate_is_short_and_becomes_good_by_the_fix(self):
        for machine, kinds in (("linuxcnc-mill", {"incline"}), ("table-table-ac", {"incline", "lean"})):
            operation, state, _, _ = self.one("flat plate", machine)
            self.assertEqual(state, "short")
            self.assertIn(one_click.fix(operation), kinds)
            self.assertEqual(one_click.state_of(operation)[0], "good", machine)

    def test_a_small_flat_disc_is_good_with_its_border_at_a_lower_speed(self):
        """Of 168 dimples a tenth lie along the border, where rows end: the faster, the more marks."""
        shape = quality_parts.PARTS["cone 27"]()
        operation = one_click.texture(shape, quality_parts.top_face(shape), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        self.assertIsNone(one_click.state_of(operation)[1])
        self.assertEqual(one_click.fix(operation), "incline")
        state, found, _ = one_click.state_of(operation)
        self.assertEqual(state, "good")
        self.assertGreaterEqual(found.whole, 0.95)

    def test_where_the_machine_locks_polygons_are_no_end_of_the_search(self):
        shape = quality_parts.PARTS["flat plate"]()
        operation = one_click.texture(shape, quality_parts.top_face(shape), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        given = operation.Proxy.texture_input(operation)
        good = Assessment(1000, 1.0, {}, [PatchQuality((0.0, 0.0, 0.0), 20.0, 1.0)])
        slow, fast = ({"strategy": strategies.FITTED}, {"strategy": strategies.LOCKED})
        tried = []

        class Finder(remedies.Finder):
            def _tries(self, *_):
                def attempt(fields):
                    tried.append(fields)
                    return remedies.Remedy("incline", fields, good)

                return [], [lambda fields=fields: attempt(fields) for fields in (slow, fast, fast)]

        found = Finder(one_click.assess, one_click.choose).find(given)
        self.assertEqual(tried, [slow, fast])
        self.assertEqual([remedy.fields for remedy in found], [fast, slow])

    def test_without_a_remedy_nothing_is_offered_that_does_not_help(self):
        operation, state, found, _ = self.one("plate 20", "linuxcnc-mill")
        finder = remedies.Finder(one_click.assess, one_click.choose)
        offered = finder.find(operation.Proxy.texture_input(operation))
        self.assertEqual([r.kind for r in offered], [])

    def test_a_macro_without_values_gets_those_of_one_click(self):
        operation = one_click.texture(quality_parts.plate(25.0, 8.0, 6.0), "Face6", "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        fields = one_click.choose_for(operation).fields
        part = operation.Document.addObject("Part::Feature", "Other")
        part.Shape = quality_parts.plate(25.0, 8.0, 6.0)
        job = patchmill.job(part, machine="linuxcnc-mill")
        same = patchmill.texture(job, ["Face6"])
        for name in ("Strategy", "Order", "RowDirection", "SameFlute", "ExtraTurns", "Margin"):
            self.assertEqual(getattr(same, name), getattr(operation, name), name)
        self.assertEqual(same.ToolController.SpindleSpeed, operation.ToolController.SpindleSpeed)
        self.assertEqual(fields["margin"], same.Margin.Value)
        own = patchmill.texture(job, ["Face6"], Spacing=0.5)
        self.assertEqual((own.Strategy, own.Margin.Value), ("Constant feed", 0.0))

    def test_outermost_rows_are_whole(self):
        """The ball that mills the row along the lower border has its centre beyond it."""
        for angle in (20.0, 30.0, 45.0):
            operation = one_click.texture(quality_parts.plate(angle, 8.0, 6.0), "Face6", "linuxcnc-mill")
            self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
            one_click.choose_for(operation)
            self.assertGreaterEqual(operation.Margin.Value, 0.48 * operation.Spacing.Value - 1e-9)
            for margin in (operation.Margin.Value, 0.0):
                operation.Margin = margin
                plan = patchmill.recompute(operation)
                result = patchmill.simulate(plan, machine=plan.machine)
                self.assertGreaterEqual(result.quality, 0.99, (angle, margin))
                self.assertEqual(result.found["missing"], 0)

    def test_a_plate_of_two_millimetres_is_good(self):
        """Of its eight dimples all are outermost."""
        operation = one_click.texture(quality_parts.plate(25.0, 2.0, 2.0), "Face6", "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        one_click.choose_for(operation)
        self.assertEqual(one_click.state_of(operation)[0], "good")

    def test_speeds_rise_to_what_a_lock_can_follow(self):
        operation = one_click.texture(quality_parts.plate(20.0), "Face6", "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        given = operation.Proxy.texture_input(operation)
        tried = choice.speeds(given, machines.load("linuxcnc-mill"))
        self.assertEqual(tried[-1], int(60.0 / (11 * 2 * 0.001)))
        steps = np.array(tried) / np.array([1000, *tried[:-1]])
        self.assertTrue(((steps > 1.0) & (steps < 1.16)).all())
        self.assertEqual(choice.speeds(given, machines.load("open-loop-mill"))[-1], 4000)
        self.assertEqual(choice.speeds(given, None), [])

    def test_patches_are_looked_at_away_from_borders(self):
        neighbours = np.array([9, 81, 9, 9, 9, 80, 40, 40, 40])
        parts = np.array_split(np.arange(9)[::-1], 3)
        self.assertEqual([assessment._middle(part, neighbours) for part in parts], [7, 5, 1])

    def test_the_flattest_dimples_have_a_patch_of_their_own(self):
        order, tilts = np.arange(200)[::-1], np.linspace(0.0, 0.5, 200)
        parts = assessment._parts(order, tilts, 3)
        self.assertEqual([len(part) for part in parts], [10, 64, 63, 63])
        self.assertEqual(np.concatenate(parts).tolist(), order.tolist())
        self.assertEqual(len(assessment._parts(order, np.full(200, 0.3), 3)), 1)
        self.assertEqual([len(part) for part in assessment._parts(order[:2], tilts[:2] * 99, 3)], [1, 1])

    def test_the_leaning_turns_flat_normals_to_the_middle_of_good_tilts(self):
        up = np.tile([0.0, 0.0, 1.0], (5, 1))
        good, angle, _ = orientation.leanings(up)[0]
        self.assertEqual((good, angle), (1.0, 20.0))

    def test_faces_that_look_sideways_or_down_are_turned_up(self):
        for normal, least in (((1, 0, 0), 70.0), ((0, -1, 0), 70.0), ((0, 0, -1), 160.0)):
            good, angle, axis = orientation.leanings(np.tile(np.array(normal, float), (3, 1)))[0]
            self.assertEqual((good, angle), (1.0, least))
            tilt = np.degrees(np.arccos(np.dot(orientation.up_of(axis, angle), normal)))
            self.assertTrue(14.0 < tilt < 28.0, tilt)

    def test_normals_are_outward_and_weigh_as_much_as_their_triangles(self):
        given = one_click.texture(quality_parts.knob(5.0, 7.0), "Face1", "").Proxy.texture_input
        operation = FreeCAD.ActiveDocument.getObject("Texture")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        normals, areas = orientation.face_normals(given(operation))
        self.assertAlmostEqual(areas.sum(), np.pi * 5.0 * 7.0, delta=1.0)
        np.testing.assert_allclose(np.abs(normals[:, 0]), 0.0, atol=1e-9)
        shape = quality_parts.knob(5.0, 7.0).Face1
        mean = (normals * areas[:, None]).sum(axis=0) / areas.sum()
        self.assertGreater(np.dot(mean, np.array(shape.normalAt(*[0.5 * (a + b) for a, b in (
            shape.ParameterRange[:2], shape.ParameterRange[2:])]))), 0.5)


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() else 1)
