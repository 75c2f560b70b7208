"""What is not looked at while good values are searched: other speeds of a way to go that is far from good,
fine cells where coarse ones are clear, plans that were simulated before, and remedies that mill less than
several sides together.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import types
import unittest
from dataclasses import replace

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import one_click  # noqa: E402
import other_parts  # noqa: E402
import quality_parts  # noqa: E402
from _patchmill import InputError  # noqa: E402
from patchmill.advice import assessment, cells, choice, remedies, room  # noqa: E402
from patchmill.advice.found import Assessment, PatchQuality  # noqa: E402
from patchmill.machine import machines  # noqa: E402
from patchmill.textures.plan import plan_texture  # noqa: E402

X, Y = ({"strategy": "Spindle-locked", "order": "Rows", "row_direction": "Along " + name} for name in "XY")
GOOD = Assessment(100, 1.0, {}, [PatchQuality((0.0, 0.0, 0.0), 20.0, 1.0)])


class SearchEffort(unittest.TestCase):
    def given(self, part):
        operation = one_click.texture(*part, "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        return operation.Proxy.texture_input(operation)

    def whole_ones(self, of_x):
        """[(row direction, rpm)] whose wholes are looked at, where along X they have quality `of_x`, and
        along Y, which takes longer at every speed, 1."""
        given, asked = self.given((quality_parts.plate(20.0), "Face6")), []

        def assess(texture, *_, whole=False, **__):
            if not whole:
                return GOOD
            asked.append((texture.row_direction, round(60.0 * texture.spindle.speed)))
            return replace(GOOD, whole=of_x if texture.row_direction == X["row_direction"] else 1.0)

        def seconds(texture):
            return (1.0 if texture.row_direction == X["row_direction"] else 9.0) / texture.spindle.speed

        before, choice._seconds = choice._seconds, seconds
        self.addCleanup(setattr, choice, "_seconds", before)
        choices = [choice.Choice(fields, GOOD) for fields in (X, Y)]
        found = choice._fastest(assess, given, choices, [1200, 1500], bool)
        self.assertEqual((found.fields["row_direction"], found.assessment.whole), asked[-1][:1] + (1.0,))
        return asked

    def test_of_a_way_that_is_far_from_good_one_speed_is_looked_at(self):
        self.assertEqual(self.whole_ones(0.6), [("Along X", 1500), ("Along Y", 1500)])
        near = [("Along X", 1500), ("Along X", 1200), ("Along X", 1000), ("Along Y", 1500)]
        self.assertEqual(self.whole_ones(0.9), near)

    def test_cells_are_fine_where_coarse_ones_are_not_clear(self):
        """And wherever values are not compared: what the head says is by fine ones alone."""
        given = self.given((quality_parts.plate(20.0, 8.0, 6.0), "Face6"))
        for coarse, expected in ((1.0, 1), (0.5, 1), (0.95, 2), (0.88, 2)):
            steps = []

            def simulate(plan, machine=None, window=None, step=None):
                steps.append(step and step / plan.input.spacing)
                return types.SimpleNamespace(
                    quality=0.97 if step is None else coarse, alignment={"state": ""}  # noqa: B023
                )

            found = assessment.assess(simulate, given, 3, middle_first=True)
            self.assertEqual(steps, [assessment.COARSE, None][:expected])
            self.assertEqual(found.quality, coarse if expected == 1 else 0.97)
            steps.clear()
            self.assertEqual(assessment.assess(simulate, given, 3).quality, 0.97)
            self.assertEqual(steps, [None])

    def test_a_plan_that_comes_out_equal_is_simulated_once(self):
        """Whatever margin it has; other dimples, another speed, window, step or machine are another plan."""
        given, made = self.given((quality_parts.plate(20.0, 8.0, 6.0), "Face6")), []
        given = replace(given, same_flute=False, extra_turns=0.0, **X)

        def simulate(plan, **options):
            made.append(plan)
            return types.SimpleNamespace(quality=0.9, alignment={"state": "square"}, found={})

        once = cells.Once(simulate)
        faster = core.Spindle(1.5 * given.spindle.speed, given.spindle.sense)
        tried = {"margin": 0.001}, {"margin": 1.0}, {"spindle": faster}, {"strategy": "Feed per move"}
        plans = [plan_texture(replace(given, **fields), slower=False) for fields in ({}, *tried)]
        machine, other = machines.load("linuxcnc-mill"), machines.load("table-table-ac")
        looks = {"machine": machine}, {"machine": other}, {"step": 0.05}, {"window": ((0, 0), (1, 1))}
        seen = [(plan, {}) for plan in plans] + [(plans[0], options) for options in looks]
        for plan, options in seen:
            result = once(plan, **options)
            self.assertEqual((result.quality, result.alignment), (0.9, {"state": "square"}))
        self.assertEqual(len(made), len(seen) - 1)
        self.assertIs(once(plans[1]).plan, plans[1])
        self.assertEqual(len(made), len(seen) - 1)
        self.assertEqual(once.afresh(plans[1]).quality, 0.9)
        self.assertEqual(len(made), len(seen))

    def test_what_is_cancelled_is_simulated_again(self):
        given, made = self.given((quality_parts.plate(20.0, 8.0, 6.0), "Face6")), []
        once = cells.Once(lambda plan, **_: made.append(plan))
        plan = plan_texture(given, slower=False)
        self.assertEqual([once(plan), once(plan)], [None, None])
        self.assertEqual(len(made), 2)

    def test_a_margin_that_leaves_nothing_takes_no_narrower_one_away(self):
        """Of the margins beside walls the first that is clear stays, though none is good."""
        given = self.given((quality_parts.plate(20.0), "Face6"))

        def touches(asked, _):
            if asked.margin > 1.3:
                raise InputError("Dimples", 0, "none are left.")
            return asked.margin < 1.0

        before, room.touches = room.touches, touches
        self.addCleanup(setattr, room, "touches", before)
        bad = [PatchQuality((0.0, 0.0, 0.0), 20.0, 0.5)]
        finder = remedies.Finder(lambda *_, **__: replace(GOOD, patches=bad), one_click.choose)
        made = finder._beside_walls(given, remedies.Remedy("values", {}, GOOD))
        self.assertEqual(made.fields["margin"], 1.15)

    def test_sides_are_tried_before_what_mills_less(self):
        """Of a shaft; a face that one setup reaches is not shared."""
        for part, expected in ((other_parts.shaft(), ["sides"]), (other_parts.box_side(), [])):
            tried = []

            class Finder(remedies.Finder):
                def _tries(self, *_):
                    return [lambda: tried.append("incline")], []  # noqa: B023

                def _by_sides(self, _):
                    tried.append("sides")  # noqa: B023

                def _assessed(self, _):
                    return None

            Finder(one_click.assess, one_click.choose).find(self.given(part))
            self.assertEqual(tried, [*expected, "incline"])


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
