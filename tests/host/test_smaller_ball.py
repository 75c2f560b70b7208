"""Where the ball does not fit: in hollows of the faces, or beside walls. A smaller one is tried.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest
from dataclasses import replace

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import FreeCAD  # noqa: E402
import one_click  # noqa: E402
import other_parts  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from patchmill.advice import apply, choice, orientation, remedies, room  # noqa: E402
from patchmill.advice.found import Assessment, PatchQuality  # noqa: E402

LOCKED = {
    "strategy": "Spindle-locked", "order": "Rows", "same_flute": False, "extra_turns": 0.0, "margin": 1.4,
}  # fmt: skip


class SmallerBalls(unittest.TestCase):
    def test_smaller_balls_that_are_tried(self):
        """Of those that catalogues have, in the hollow or beside walls; the ratio to the spacing stays."""
        for name, walls, expected in (
            ("capacitor", False, [(1.5, 0.375), (0.8, 0.2)]),
            ("capacitor", True, [(1.5, 0.375), (0.8, 0.2)]),
            ("flat plate", False, []),
            ("flat plate", True, [(1.0, 0.25)]),
        ):
            operation = one_click.texture(*other_parts.PARTS[name](), "linuxcnc-mill")
            self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
            made = room.smaller_balls(operation.Proxy.texture_input(operation), walls)
            self.assertEqual([(2.0 * one["tool"].radius, one["spacing"]) for one in made], expected, name)

    def test_what_a_ball_reaches_of_the_floor_of_a_pocket(self):
        """Of 20 by 14 mm, all that is no nearer to a wall than its radius."""
        operation = one_click.texture(*other_parts.pocket(1.5), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        given, model = operation.Proxy.texture_input(operation), apply.model_of(operation)
        for radius in (0.1, 0.5, 1.0, 1.5):
            expected = (1.0 - radius / 10.0) * (1.0 - radius / 7.0)
            self.assertAlmostEqual(room.reached_by(given, radius, model), expected, delta=0.015)
        self.assertEqual(room.reached_by(given, 1.0, ()), 1.0)
        said = [(across, round(part, 1)) for across, part in room.short_reach(given, True, model)]
        self.assertEqual(said, [(2.0, 0.8), (1.0, 0.9)])

    def test_what_a_ball_reaches_of_a_bore(self):
        """All or nothing; of an outside all, whatever the ball."""
        for name, radius, expected in (("bore", 7.9, 1.0), ("bore", 8.1, 0.0), ("shaft", 20.0, 1.0)):
            operation = one_click.texture(*other_parts.PARTS[name](), "linuxcnc-mill")
            self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
            given, model = operation.Proxy.texture_input(operation), apply.model_of(operation)
            self.assertEqual(room.reached_by(given, radius, model), expected, name)

    def found_for_a_groove(self, free):
        """(Operation, Remedies) where nothing is good but a ball of less than 0.8 mm."""
        operation = one_click.texture(*other_parts.PARTS["capacitor"](), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)

        def assess(given, *_, **__):
            patch = PatchQuality((0.0, 0.0, 0.0), 20.0, 1.0 if given.tool.radius < 0.8 else 0.5)
            return Assessment(100, 1.0, {}, [patch])

        def chosen(given, _):
            return choice.Choice({"margin": 0.1}, assess(given))

        finder = remedies.Finder(assess, chosen, free, False)
        return operation, finder.find(operation.Proxy.texture_input(operation))

    def test_a_ball_that_fits_is_offered_where_nothing_else_helps(self):
        operation, found = self.found_for_a_groove(True)
        self.assertEqual((found[0].kind, found[0].fields["spacing"]), ("ball", 0.375))
        apply.take(operation, found[0])
        controller = operation.ToolController
        self.assertEqual(controller.Label, "Ball end mill 1.5 mm")
        bit = controller.Tool
        self.assertEqual((bit.Diameter.Value, bit.CuttingEdgeHeight.Value), (1.5, 15.0))
        given = operation.Proxy.texture_input(operation)
        self.assertEqual((given.tool, given.spacing), (found[0].fields["tool"], 0.375))

    def test_no_other_ball_where_others_use_the_tool(self):
        self.assertEqual(self.found_for_a_groove(False)[1], [])


class BesideWalls(unittest.TestCase):
    def test_what_is_tried_beside_walls(self):
        """Wider margins, the least first, each with rows both ways; a helix has no other way."""
        operation = one_click.texture(*other_parts.pocket(1.5), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        given = replace(operation.Proxy.texture_input(operation), margin=1.5, order="Rows")
        tried = room.beside_walls(replace(given, row_direction="Along Y"))
        turned = {"margin": 1.7, "row_direction": "Along X"}
        self.assertEqual(tried[:3], [{"margin": 1.7}, turned, {"margin": 2.0}])
        margins = [one["margin"] for one in tried]
        self.assertEqual(margins, sorted(margins))
        for fields in ({"order": "Helix", "row_direction": "Along Y"}, {"row_direction": "Least time"}):
            tried = room.beside_walls(replace(given, **fields))
            self.assertEqual(tried[:2], [{"margin": 1.7}, {"margin": 2.0}])

    def test_rows_that_run_into_a_wall_are_turned(self):
        """Of a slot that is open at both ends only rows along it have room to run in."""
        slot = Part.makeBox(10, 9, 6).cut(Part.makeBox(10, 5, 2, FreeCAD.Vector(0, 2, 4)))
        part = other_parts.where(slot, lambda f: abs(f.CenterOfMass.z - 4.0) < 1e-6)
        operation = one_click.texture(*part, "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        model, along = apply.model_of(operation), {"Along X": True, "Along Y": False}
        given = replace(operation.Proxy.texture_input(operation), **LOCKED)
        turned = orientation.turned_texts(model, (0.0, 1.0, 0.0), 20.0)
        for direction, clear in along.items():
            asked = replace(given, row_direction=direction)
            asked = orientation.turned(asked, (0.0, 1.0, 0.0), 20.0, model)
            self.assertEqual(room.touches(asked, turned), not clear, direction)

    def test_a_texture_that_runs_into_a_wall_is_not_good_until_its_fix(self):
        """On an inclined plate with a wall along it, all patches are good; posting would refuse it."""
        plate = Part.makeBox(10, 8, 4).fuse(Part.makeBox(10, 2, 8, FreeCAD.Vector(0, -2, 0)))
        plate.rotate(FreeCAD.Vector(), FreeCAD.Vector(0, 1, 0), -25)
        part = other_parts.where(plate, lambda f: f.normalAt(0, 0).z > 0.8 and f.Area > 50)
        operation = one_click.texture(*part, "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        apply.set_fields(operation, {**LOCKED, "margin": 0.24, "row_direction": "Along X"})
        good = Assessment(100, 1.0, {}, [PatchQuality((0.0, 0.0, 0.0), 25.0, 1.0)])
        plan, model = patchmill.recompute(operation), apply.model_of(operation)
        found = room.held_against(good, plan, model)
        said = found.touches, found.good, found.remains_good, found.worth
        self.assertEqual(said, (True, False, False, 0.0))
        self.assertEqual(room.held_against(good, plan, ()), good)
        finder = remedies.Finder(lambda *_, **__: good, None, False, False, {"margin": 0.24}, model=model)
        best = finder.find(plan.asked)[0]
        self.assertEqual((best.kind, best.walled), ("values", True))
        apply.take(operation, best)
        self.assertGreater(operation.Margin.Value, 1.0)
        patchmill.recompute(operation)
        self.assertTrue(patchmill.check(operation).clear)


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
