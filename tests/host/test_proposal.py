"""How a job is posted if nobody says otherwise: the post-processor of its machine's control, or one that
keeps what the strategy needs; the decimals of the plan; a file beside the document.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import FreeCAD  # noqa: E402
import one_click  # noqa: E402
import patchmill  # noqa: E402
import quality_parts  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.posting import proposal  # noqa: E402


class Proposed(unittest.TestCase):
    def setUp(self):
        self.operation = one_click.texture(quality_parts.plate(25.0, 8.0, 6.0), "Face6", "")
        self.document = self.operation.Document
        self.addCleanup(FreeCAD.closeDocument, self.document.Name)
        self.job = host.PathUtils.findParentJob(self.operation)

    def proposed(self, machine="", strategy="Constant feed"):
        self.operation.Machine, self.operation.Strategy = machine, strategy
        paced = strategy != "Constant feed"
        self.operation.SameFlute, self.operation.ExtraTurns = not paced, 0.0 if paced else 5.0
        patchmill.recompute(self.operation)
        return proposal.of(self.job)

    def test_the_post_is_that_of_the_machine_or_of_what_the_strategy_needs(self):
        self.job.PostProcessor = "linuxcnc"
        self.assertEqual(self.proposed().post, "linuxcnc")
        self.assertEqual(self.proposed("table-table-ac").post, "patchmill_linuxcnc")
        self.assertEqual(self.proposed("linuxcnc-mill").post, "linuxcnc")
        self.assertEqual(self.proposed("linuxcnc-mill", "Spindle-locked").post, "patchmill_linuxcnc")
        self.assertEqual(self.proposed("head-table-bc").post, "patchmill_siemens")

    def test_what_is_proposed_is_posted(self):
        found = self.proposed("linuxcnc-mill", "Spindle-locked")
        self.assertEqual(found.machine.key, "linuxcnc-mill")
        self.operation.PostGouging = True  # the ball goes over the plate's edges
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, os.path.basename(found.filename))
            posted = patchmill.post(self.job, name, found.post, found.arguments)
            self.assertTrue(os.path.exists(name))
        self.assertEqual([one.operation for one in posted], [self.operation])

    def test_decimals_are_those_of_the_plan_whatever_the_job_says(self):
        self.job.PostProcessorArgs = "--no-header --precision=6 --no-show-editor"
        self.assertEqual(self.proposed().arguments, "--no-header --no-show-editor --precision=3")
        self.operation.Decimals = 4
        self.assertIn("--precision=4", self.proposed().arguments)

    def test_the_file_is_beside_the_document(self):
        with tempfile.TemporaryDirectory() as folder:
            self.document.saveAs(os.path.join(folder, "part.FCStd"))
            found = self.proposed("head-table-bc")
            self.assertEqual(found.filename, os.path.join(folder, "Job.mpf"))


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() else 1)
