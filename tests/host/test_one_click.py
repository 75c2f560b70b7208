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
import one_click  # noqa: E402
import quality_parts  # noqa: E402
from patchmill.advice import assessment, choice, remedies  # noqa: E402
from patchmill.machine import machines  # noqa: E402


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

    def test_a_flat_plate_is_short_and_becomes_good_by_the_fix(self):
        for machine, kinds in (("linuxcnc-mill", {"incline"}), ("table-table-ac", {"incline", "lean"})):
            operation, state, _, _ = self.one("flat plate", machine)
            self.assertEqual(state, "short")
            self.assertIn(one_click.fix(operation), kinds)
            self.assertEqual(one_click.state_of(operation)[0], "good", machine)

    def test_without_a_remedy_nothing_is_offered_that_does_not_help(self):
        operation, state, found, _ = self.one("plate 20", "linuxcnc-mill")
        finder = remedies.Finder(one_click.assess, one_click.choose)
        offered = finder.find(operation.Proxy.texture_input(operation))
        self.assertEqual([r.kind for r in offered], [])

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
        found = assessment._middles(np.arange(9)[::-1], neighbours, 3)
        self.assertEqual(found, [7, 5, 1])
        self.assertEqual(len(assessment._middles(np.arange(2), neighbours, 3)), 3)

    def test_the_leaning_turns_flat_normals_to_the_middle_of_good_tilts(self):
        up = np.tile([0.0, 0.0, 1.0], (5, 1))
        good, angle, _ = remedies.leanings(up)[0]
        self.assertEqual((good, angle), (1.0, 20.0))


if __name__ == "__main__":
    outcome = unittest.main(exit=False, argv=sys.argv[:1]).result
    sys.exit(0 if outcome.wasSuccessful() else 1)
