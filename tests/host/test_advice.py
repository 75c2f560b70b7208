"""What the head of the panel is told: how good a texture is in one word, which part of its area is as
planned, and where faces are too narrow for the ball.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import types
import unittest
from dataclasses import replace

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import FreeCAD  # noqa: E402
import numpy as np  # noqa: E402
import Part  # noqa: E402
import one_click  # noqa: E402
import other_parts  # noqa: E402
import patchmill  # noqa: E402
import quality_parts  # noqa: E402
from patchmill.advice import apply, cells, choice, orientation, remedies, room, verdict  # noqa: E402
from patchmill.advice.found import Assessment, PatchQuality, is_enough  # noqa: E402

HOLDS, LOST = types.SimpleNamespace(holding="holds"), types.SimpleNamespace(holding="lost")


def patches(*qualities):
    return [PatchQuality((0.0, 0.0, 0.0), 20.0, q, fraction=1.0 / len(qualities)) for q in qualities]


class Verdicts(unittest.TestCase):
    def said(self, found, phase=HOLDS):
        return verdict.judge(found, phase)

    def test_in_one_word(self):
        good = Assessment(100, 1.0, {}, patches(1.0))
        self.assertEqual(self.said(good), (verdict.GOOD, verdict.ALL))
        self.assertEqual(self.said(good, None), (verdict.DOUBTFUL, verdict.PHASE_UNKNOWN))
        self.assertEqual(self.said(good, LOST), (verdict.BAD, verdict.LOST))
        self.assertEqual(self.said(Assessment(100, 1.0, {})), (verdict.DOUBTFUL, verdict.NOT_SIMULATED))
        self.assertEqual(self.said(replace(good, whole=0.9)), (verdict.DOUBTFUL, verdict.BORDERS))
        area = replace(good, whole=0.96, whole_area=0.94)
        self.assertEqual(self.said(area), (verdict.DOUBTFUL, verdict.BORDERS))
        self.assertEqual(self.said(replace(area, whole_area=0.95)), (verdict.GOOD, verdict.ALL))
        self.assertAlmostEqual(area.worth, 0.94)
        self.assertEqual(self.said(replace(good, milled_fraction=0.95))[0], verdict.GOOD)
        self.assertEqual(self.said(replace(good, milled_fraction=0.94)), (verdict.DOUBTFUL, verdict.SHORT))
        self.assertEqual(self.said(replace(good, milled_fraction=0.5)), (verdict.BAD, verdict.SHORT))

    def test_half_of_a_shaft_is_all_that_one_setup_reaches(self):
        half = Assessment(100, 0.47, {}, patches(1.0), away_fraction=0.53)
        self.assertEqual(self.said(half), (verdict.DOUBTFUL, verdict.AWAY))
        self.assertEqual(self.said(replace(half, patches=patches(1.0, 0.5))), (verdict.BAD, verdict.SHORT))
        self.assertEqual(self.said(replace(half, milled_fraction=0.3)), (verdict.BAD, verdict.SHORT))
        self.assertEqual(self.said(replace(half, whole=0.9)), (verdict.BAD, verdict.SHORT))

    def test_every_verdict_has_a_sentence_and_a_colour_of_its_own_level(self):
        """judge() and what it may answer: no other reason comes out of any combination."""
        whys = {value for name, value in vars(verdict).items() if name.isupper() and isinstance(value, str)}
        whys -= {verdict.GOOD, verdict.DOUBTFUL, verdict.BAD}
        seen = set()
        for milled in (0.3, 0.6, 1.0):
            for whole in (None, 0.9):
                for away in (0.0, 0.7):
                    for phase in (None, HOLDS, LOST):
                        for quality in ((), (1.0,), (0.5,)):
                            found = Assessment(9, milled, {}, patches(*quality) if quality else [])
                            found = replace(found, whole=whole, away_fraction=away)
                            level, why = self.said(found, phase)
                            seen.add(why)
                            self.assertIn(level, (verdict.GOOD, verdict.DOUBTFUL, verdict.BAD))
                            said = self.said(replace(found, touches=True), phase)
                            lost = phase is LOST
                            self.assertEqual(said, (verdict.BAD, verdict.LOST if lost else verdict.TOUCHES))
                            seen.add(said[1])
        self.assertEqual(seen, whys)


class Cells(unittest.TestCase):
    def result(self, plan, found, places, moved, extra=()):
        numbers = np.arange(len(found))
        return types.SimpleNamespace(
            plan=plan,
            found={
                "dimple": numbers, "found": np.array(found), "moved": np.array(moved),
                "extra": np.array(extra, int), "places": np.array(places),
            },
        )  # fmt: skip

    def plan(self, tilts, mapping="Projected"):
        """Dimples in a row of spacing 1, each on a face of its own tilt [rad]."""
        normals = np.array([[0.0, math.sin(t), math.cos(t)] for t in tilts])
        return types.SimpleNamespace(
            input=types.SimpleNamespace(spacing=1.0, mapping=mapping),
            places=lambda: np.array([[float(k), 0.0] for k in range(len(tilts))]),
            dimples=types.SimpleNamespace(normals=normals),
            plane=types.SimpleNamespace(direction=(0.0, 0.0, -1.0)),
        )

    def test_missing_moved_and_crowded_cells_are_not_good(self):
        """1 - (4 · 0.05)² is 0.96, 1 - (4 · 0.06)² is 0.942; the mark at 3.4 is nearest to dimple 3."""
        plan = self.plan([0.0] * 6)
        moved = [(0.0, 0.05), (0.06, 0.0), (0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (0.0, 0.0)]
        places = [(k, 0.0) for k in range(6)] + [(3.4, 0.1)]
        result = self.result(plan, [0, 1, -1, 3, 4, 5], places, moved, extra=[6])
        self.assertEqual(cells.good_cells(result).tolist(), [True, False, False, False, True, True])
        self.assertAlmostEqual(cells.good_share([result]), 0.5)
        self.assertTrue(math.isnan(cells.good_share([])))

    def test_steep_cells_weigh_as_much_as_their_area(self):
        """At 60° a cell of a projected lattice has twice the area."""
        for mapping, expected in (("Projected", 2.0 / 3.0), ("On surface", 0.5)):
            plan = self.plan([0.0, math.radians(60.0)], mapping)
            result = self.result(plan, [-1, 0], [(1.0, 0.0)], [(0.0, 0.0), (0.0, 0.0)])
            self.assertAlmostEqual(cells.good_share([result]), expected)

    def test_the_marks_at_ends_of_rows_spoil_the_outermost_row_only(self):
        """Of a plate, inclined and run by the machine: no cell inside is bad."""
        shape = quality_parts.PARTS["flat plate"]()
        operation = one_click.texture(shape, quality_parts.top_face(shape), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        one_click.choose_for(operation)
        self.assertEqual(one_click.fix(operation), "incline")
        plan = patchmill.recompute(operation)
        result = patchmill.simulate(plan, machine=plan.machine)
        good = cells.good_cells(result)
        places = plan.places()[result.found["dimple"]]
        low, high = places.min(axis=0), places.max(axis=0)
        inside = ((places > low + 0.1) & (places < high - 0.1)).all(axis=1)
        self.assertTrue(good[inside].all())
        self.assertGreaterEqual(cells.good_share([result]), 0.95)
        self.assertGreater(len(result.found["extra"]), 20)
        self.assertGreater((~good).sum(), 20)
        self.assertLessEqual((~good).sum(), len(result.found["extra"]))


class Hollows(unittest.TestCase):
    def radius(self, name, tool_radius=1.0):
        operation = one_click.texture(*other_parts.PARTS[name](), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        given = operation.Proxy.texture_input(operation)
        return room.least_radius(given), room.ball_too_large(given)

    def test_known_radii(self):
        """A bore of 8 mm, a trough of 9; the torus' inside bends in along it with what is left of its hole;
        spheres, shafts and fillets nowhere."""
        self.assertAlmostEqual(self.radius("bore")[0], 8.0, places=6)
        self.assertAlmostEqual(self.radius("trough")[0], 9.0, places=6)
        self.assertAlmostEqual(self.radius("torus")[0], 14.0 - 5.0, delta=0.1)
        for name in ("ball", "shaft", "fillet", "flat plate"):
            self.assertEqual(self.radius(name), (None, None), name)

    def test_the_groove_of_a_capacitor_is_too_narrow_for_the_ball(self):
        radius, narrow = self.radius("capacitor")
        self.assertLess(radius, 1.0)
        self.assertEqual(narrow, radius)
        self.assertIsNone(self.radius("bore")[1])


class Narrow(unittest.TestCase):
    def texture(self, shape, face):
        operation = one_click.texture(shape, face, "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        return operation

    def rim(self, wide, radius=15.0):
        return other_parts.top(Part.makeCylinder(radius, 4).cut(Part.makeCylinder(radius - wide, 4)))

    def test_known_widths(self):
        """Of rectangles, a ring and a shaft; a disc is no narrower than its radius."""
        for sides in ((20.0, 1.5), (1.5, 20.0), (6.0, 6.0)):
            face = Part.makePlane(*sides)
            self.assertAlmostEqual(room.width(face), min(sides), places=9)
        shape, name = self.rim(1.5)
        self.assertAlmostEqual(room.width(shape.getElement(name)), 1.5, places=9)
        shaft = max(Part.makeCylinder(3.0, 2.0).Faces, key=lambda face: face.Area)
        self.assertAlmostEqual(room.width(shaft), 2.0, places=9)
        disc = Part.Face(Part.Wire(Part.makeCircle(8.0)))
        self.assertGreater(room.width(disc), 8.0)

    def test_few_dimples_side_by_side(self):
        """Of a rim with 3, not of a ring with 6, nor of a plate; nor where little of the area is narrow."""
        for wide, expected in ((1.5, (1.5, 3.0)), (3.0, None)):
            operation = self.texture(*self.rim(wide))
            given = operation.Proxy.texture_input(operation)
            found = room.too_narrow(given)
            self.assertEqual(found and tuple(round(each, 6) for each in found), expected)
            finer = replace(given, spacing=0.25)
            self.assertIsNone(room.too_narrow(finer))
        plate = Part.makePlane(20.0, 16.0).exportBrepToString()
        rim = Part.makePlane(8.0, 1.5).exportBrepToString()
        self.assertIsNone(room.too_narrow(replace(given, breps=(plate, rim))))
        self.assertIsNotNone(room.too_narrow(replace(given, breps=(plate, rim, rim))))

    def test_a_narrow_rim_gets_a_smaller_spacing(self):
        operation = self.texture(*self.rim(1.5, radius=6.0))
        found = one_click.remedies_of(operation, {"margin": 0.0})
        self.assertTrue(found[0].assessment.good)
        self.assertEqual(found[0].kind, "incline")
        self.assertLess(found[0].fields["spacing"], 0.35)


class ClosedFaces(unittest.TestCase):
    def test_what_one_setup_reaches(self):
        """All of a plate and a fillet; 176° of 360° of a shaft."""
        for name, expected in (("flat plate", 1.0), ("fillet", 1.0), ("shaft", 176.0 / 360.0)):
            shape, face = other_parts.PARTS[name]()
            operation = one_click.texture(shape, face, "linuxcnc-mill")
            self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
            normals, areas = orientation.face_normals(operation.Proxy.texture_input(operation))
            self.assertAlmostEqual(orientation.reached_fraction(normals, areas), expected, delta=0.03)

    def test_a_patch_in_a_bore_is_seen_from_where_it_can_be(self):
        """Along its own normal the opposite wall is met first."""
        operation = one_click.texture(*other_parts.bore(), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        given = replace(operation.Proxy.texture_input(operation), **remedies.LAID, margin=0.24)
        given = orientation.turned(given, (1.0, 0.0, 0.0), 50.0)
        fields = {"strategy": "Spindle-locked", "order": "Rows", "same_flute": False, "extra_turns": 0.0}
        found = one_click.assess(replace(given, **fields), 3)
        self.assertEqual([patch.problem for patch in found.patches], [""] * len(found.patches))

    def test_of_a_bore_only_good_dimples_are_left(self):
        """By several sides."""
        operation = one_click.texture(*other_parts.bore(5.0, 5.0), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        given = operation.Proxy.texture_input(operation)
        finder = remedies.Finder(one_click.assess, one_click.choose, True, model=apply.model_of(operation))
        found = finder._by_sides(given).assessment
        self.assertTrue(found.remains_good)
        self.assertGreater(found.good_fraction, 0.35)

    def test_what_leaves_nothing_to_be_wished_for(self):
        """94 % of a dome is not, 47 of the 49 % that are reached of a shaft are."""
        dome, shaft = (Assessment(100, part, {}, patches(1.0)) for part in (0.94, 0.47))
        self.assertFalse(is_enough(dome, 1.0))
        self.assertTrue(is_enough(shaft, 0.49))
        self.assertFalse(is_enough(replace(shaft, patches=patches(1.0, 0.5)), 0.49))

    def test_inclinations_on_both_sides_of_the_best_are_tried(self):
        leanings = [(0.5, 40.0, "a"), (0.4, 50.0, "b"), (0.39, 20.0, "c"), (0.3, 60.0, "d"), (0.2, 10.0, "e")]
        self.assertEqual([lean[2] for lean in orientation.apart(leanings)], ["c", "d"])


class Fastest(unittest.TestCase):
    def test_of_orders_that_are_good_enough_the_fastest_is_looked_for(self):
        """One that is good everywhere may take four times as long as one that is on 96 %."""
        asked = []

        def fastest(_assess, _given, choices, *_):
            asked.extend(each.assessment.milled_fraction for each in choices)
            return choices[0]

        before, choice._fastest = choice._fastest, fastest
        self.addCleanup(setattr, choice, "_fastest", before)
        shares = (0.93, 0.95, 0.96, 1.0)
        choices = [choice.Choice({}, Assessment(100, part, {}, patches(1.0))) for part in shares]
        choice._of_locked(None, None, choices, [], None)
        self.assertEqual(asked, [0.95, 0.96, 1.0])
        asked.clear()
        choice._of_locked(None, None, choices[:1], [], None)
        self.assertEqual(asked, [0.93])

    def test_a_higher_speed_that_is_good_enough_is_taken(self):
        """Though the first is good on more; not one that is good on too little."""
        operation = one_click.texture(quality_parts.plate(20.0), "Face6", "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        given = operation.Proxy.texture_input(operation)
        before, choice._seconds = choice._seconds, lambda asked: 1.0 / asked.spindle.speed
        self.addCleanup(setattr, choice, "_seconds", before)
        first = choice.Choice({"strategy": "Spindle-locked"}, Assessment(100, 1.0, {}, patches(1.0)))
        for part, expected in ((0.96, [1500, 1200, 1000]), (0.94, [1000])):
            made = choice._by_time(
                lambda *_, **__: Assessment(100, part, {}, patches(1.0)), given, [first], [1200, 1500], bool
            )
            speeds = [one.fields.get("spindle", given.spindle).speed for one in made]
            self.assertEqual([round(60.0 * speed) for speed in speeds], expected)


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() else 1)
