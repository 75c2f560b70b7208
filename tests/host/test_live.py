"""Live sessions of a CopyMilling operation: G-code in batches, conditions that change on the way, materials.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parents[1] / "Resources" / "recipes" / "kobayashi2014"))

import make_parts  # noqa: E402
import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import CopyMilling, InputError  # noqa: E402
from test_copy_milling import RADIUS, TOLERANCE, ball_centres, deepest_at, job_with_stock  # noqa: E402


class LiveSessions(WithDocuments):
    def setUp(self):
        _, self.job = job_with_stock(make_parts.convex_part(), 1.0)
        self.operation = CopyMilling.Create("Copy", parentJob=self.job)
        self.operation.RadialDepth, self.operation.AxialDepth = 5.0, 8.0
        CopyMilling.recompute(self.operation)

    def test_batches_and_a_change(self):
        session = patchmill.live.start(self.operation, 2.0, 400 / 60, 800 / 60)
        words, batches, centres = [], 0, []
        while not session.done:
            batch = session.next(5.0)
            words.extend(patchmill.live.lines(batch))
            centres.append(ball_centres(batch, 0.3))
            batches += 1
            if batches == 20:
                session.change(axial_depth=4.0, high=1200 / 60)
        self.assertEqual(session.conditions["axial_depth"], 4.0)
        shape = self.job.Model.Group[0].Shape
        self.assertLessEqual(deepest_at(shape, np.vstack(centres), RADIUS), TOLERANCE)
        self.assertGreater(len(words), 500)
        feeds = [float(line.split("F")[1]) for line in words if "F" in line]
        self.assertGreaterEqual(min(feeds), 399.9)
        self.assertLessEqual(max(feeds), 1200.1)
        self.assertGreater(max(feeds), 800.1)

    def test_materials(self):
        feeds = []
        for materials in ([], ["skin 0.25 4"]):
            session = patchmill.live.start(self.operation, 2.0, 10.0, 10.0, materials=materials)
            words = list(patchmill.live.lines(session.next(60.0)))
            feeds.append([float(line.split("F")[1]) / 60.0 for line in words if "F" in line])
        self.assertAlmostEqual(min(feeds[0]), 10.0, 3)
        self.assertAlmostEqual(min(feeds[1]), 2.5, 3)
        with self.assertRaises(InputError) as caught:
            patchmill.live.start(self.operation, 2.0, 10.0, 10.0, materials=["skin 0.25"])
        self.assertEqual(caught.exception.property, "Materials")


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
