"""A photograph as mask: dimples as deep as it is dark, milled by the posted program, look like it from above.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from parts import WithDocuments  # noqa: E402
from photographs import DEEP, SHALLOW, SPACING, cells, correlation, photograph, plate  # noqa: E402
from photographs import seen_from_above  # noqa: E402

SIDE = 40


class Photograph(WithDocuments):
    def test_relief_looks_like_the_photograph(self):
        picture = photograph(160)
        with tempfile.TemporaryDirectory() as folder:
            document, op = plate(picture, SIDE, os.path.join(folder, "photograph.png"))
            plan = patchmill.recompute(op)
            self.assertEqual(plan.counts["cut"], SIDE**2)
            self.assertGreaterEqual(plan.dimples.depths.min(), SHALLOW - 1e-9)
            self.assertLessEqual(plan.dimples.depths.max(), DEEP + 1e-9)
            program = os.path.join(folder, "photograph.ngc")
            patchmill.post(document.getObject("Job"), program)
            result = patchmill.simulate(op, program=program, step=SPACING / 8.0)
        seen = cells(seen_from_above(result), result, SIDE * SPACING, SIDE)
        self.assertGreater(correlation(picture, seen), 0.95)
        for other in (picture[::-1], picture[:, ::-1], np.rot90(picture)):
            self.assertLess(correlation(other, seen), 0.7)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
