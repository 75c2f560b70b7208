"""What a texture decides for the user instead of refusing, and says: smaller patches where one is larger than
the face, heights over the part where they are not the user's own.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import patchmill  # noqa: E402
from parts import WithDocuments, job_on, tilted_box  # noqa: E402
from recipe import small_job  # noqa: E402


class Spared(WithDocuments):
    def test_a_patch_larger_than_the_face_becomes_as_large_as_it(self):
        for shape in ("Square", "Hexagon", "Triangle"):
            document, operation = job_on(*tilted_box(25.0))
            operation.PatchShape, operation.PatchSide = shape, 200
            plan = patchmill.recompute(operation)
            size, low, high = plan.division.pattern.size, *plan.extent
            self.assertIn("A patch of side 200 is larger than the faces", operation.Remarks)
            outline = plan.division.outlines()[0]
            self.assertTrue((outline.max(axis=0) - outline.min(axis=0) <= high - low).all())
            operation.PatchSide = size  # it is the greatest that fits
            patchmill.recompute(operation)
            self.assertEqual(operation.Remarks, "")
            operation.PatchSide = size + 1
            patchmill.recompute(operation)
            self.assertIn("is larger than the faces", operation.Remarks)
            self.tearDown()

    def test_heights_of_the_setup_sheet_are_raised_over_the_part(self):
        document, job, operation = small_job()
        self.document = document
        patchmill.recompute(operation)
        self.assertEqual(operation.Remarks, "")
        for name, lower in (("SafeHeight", 30), ("ClearanceHeight", 29)):
            operation.setExpression(name, "OpStockZMax + SetupSheet.%sOffset - %d mm" % (name, lower))
        plan = patchmill.recompute(operation)
        self.assertIn("The safe height was raised to Z", operation.Remarks)
        top = plan.dimples.positions[plan.dimples.states == 0][:, 2].max()
        self.assertGreater(plan.path.tips[:, 2].max(), top)

    def test_a_height_of_the_users_own_is_kept_and_refused(self):
        document, job, operation = small_job()
        self.document = document
        operation.setExpression("SafeHeight", None)
        operation.SafeHeight = 5.0
        self.assert_refused(operation, "SafeHeight")


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
