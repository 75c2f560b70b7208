"""Which spindle speeds a search for good values plans: each plan of a large texture takes seconds of a user
who waits.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest

import FreeCAD
from patchmill.advice import choice
from patchmill.advice.found import Assessment, PatchQuality
from patchmill.textures import strategies

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import one_click  # noqa: E402
import quality_parts  # noqa: E402

OWN, HIGHER = 1000, [1100, 1200, 1300, 1400, 1500, 1600, 1700, 1800]


class SpeedsTried(unittest.TestCase):
    def setUp(self):
        operation = one_click.texture(quality_parts.plate(10.0), "Face6", "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        self.given = operation.Proxy.texture_input(operation)
        self.planned = []
        before, choice._seconds = choice._seconds, self.seconds
        self.addCleanup(setattr, choice, "_seconds", before)
        self.holds, self.lost = True, set()

    def seconds(self, asked):
        self.planned.append(round(60.0 * asked.spindle.speed))
        return 1.0 if self.holds and self.planned[-1] not in self.lost else None

    def tried(self, strategy, quality):
        self.planned.clear()
        patch = PatchQuality((0.0, 0.0, 0.0), 20.0, quality, fraction=1.0)
        made = choice.Choice({"strategy": strategy}, Assessment(100, 1.0, {}, [patch]))
        list(choice._by_time(lambda *_, **__: made.assessment, self.given, [made], HIGHER, bool))
        return self.planned

    def test_all_where_a_lock_holds(self):
        self.assertEqual(self.tried(strategies.LOCKED, 1.0), [OWN, *HIGHER])

    def test_none_above_one_at_which_it_does_not(self):
        self.holds = False
        self.assertEqual(self.tried(strategies.FITTED, 1.0), [OWN])

    def test_a_lock_may_hold_at_one_speed_and_not_at_a_slower_one(self):
        self.holds = False
        self.assertEqual(self.tried(strategies.LOCKED, 1.0), [OWN, HIGHER[0]])
        self.lost = {OWN, HIGHER[3]}
        self.holds = True
        self.assertEqual(self.tried(strategies.LOCKED, 1.0), [OWN, *HIGHER])

    def test_few_of_good_polygons_and_none_of_bad_ones(self):
        self.assertEqual(self.tried(strategies.FITTED, 1.0), [OWN, 1400, 1800])
        self.assertEqual(self.tried(strategies.FITTED, 0.4), [OWN])


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() else 1)
