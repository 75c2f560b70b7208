"""How much of a face is too flat: the flattest twentieth is looked at in its middle, and if that is bad at
its steepest places as well.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import types
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import FreeCAD  # noqa: E402
import one_click  # noqa: E402
import quality_parts  # noqa: E402
from patchmill.advice import assessment  # noqa: E402

RADIUS = 14.0  # of a dome up to 53°: its flattest twentieth has its middle at 7.3°, its third quarter at 8.9°


class Flattest(unittest.TestCase):
    def fractions(self, limit):
        """[(fraction, whether it is good)] of the patches of a dome whose patches are good from `limit` on
        [degrees]."""

        def simulate(plan, machine=None, window=None):
            tilt = math.degrees(math.asin(math.hypot(*plan.input.origin[:2]) / RADIUS))
            return types.SimpleNamespace(quality=1.0 if tilt > limit else 0.5, alignment={"state": ""})

        shape = quality_parts.dome(RADIUS)
        operation = one_click.texture(shape, quality_parts.top_face(shape), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        found = assessment.assess(simulate, operation.Proxy.texture_input(operation), 3)
        tilts = [patch.tilt for patch in found.patches]
        self.assertEqual(tilts, sorted(tilts))
        self.assertAlmostEqual(sum(patch.fraction for patch in found.patches), 1.0)
        return [(round(patch.fraction, 4), patch.quality > 0.9) for patch in found.patches]

    def test_what_of_the_flattest_is_good_counts(self):
        twentieth, rest = 0.05, (0.3167, True)
        for limit, expected in (
            (5.0, [(twentieth, True)]),
            (8.0, [(0.5 * twentieth, False), (0.5 * twentieth, True)]),
            (9.5, [(0.85 * twentieth, False), (0.15 * twentieth, True)]),
            (12.0, [(twentieth, False)]),
        ):
            made = self.fractions(limit)
            for one, other in zip(made, [*expected, rest, rest, rest]):
                self.assertAlmostEqual(one[0], other[0], delta=1e-3, msg=limit)
                self.assertEqual(one[1], other[1], limit)
            self.assertEqual(len(made), len(expected) + 3)

    def test_where_more_is_bad_the_flattest_are_looked_at_once(self):
        self.assertEqual([good for _, good in self.fractions(30.0)], [False, False, True, True])


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
