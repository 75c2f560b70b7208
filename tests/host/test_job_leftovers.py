"""What FreeCAD puts into a new job of its own accord: nothing of it is left that nobody sees, and nothing is
taken for said that nobody said.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest

import FreeCAD
import Part
import patchmill
from patchmill.freecad import host, tool_bits

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from parts import WithDocuments, job_on, tilted_box  # noqa: E402


class NewJob(WithDocuments):
    def test_the_default_tool_leaves_nothing(self):
        document = FreeCAD.newDocument("job")
        part = document.addObject("Part::Feature", "Part")
        part.Shape = Part.makeBox(20, 20, 10)
        document.recompute()
        job = host.create_job("Job", [part])
        host.add_ball_end_controller(job, 4.0, 2, 600.0, 1000.0)
        document.recompute()
        kept = {part, job, *job.OutListRecursive}
        lost = [o.Name for o in document.Objects if o not in kept]
        self.assertEqual(lost, [])


class Flutes(WithDocuments):
    @unittest.skipIf(host.VERSION < (1, 1), "older FreeCADs leave Flutes at 0, which is refused")
    def test_a_number_that_nobody_said_is_told(self):
        from Path.Tool.camassets import cam_assets

        cam_assets.setup()
        document, operation = job_on(*tilted_box())
        bit = cam_assets.get("toolbit://6mm_Ball_End").attach_to_doc(doc=document)
        self.assertFalse(tool_bits.flutes_said(bit))
        bit.Flutes = 3
        self.assertTrue(tool_bits.flutes_said(bit))
        self.assertTrue(tool_bits.flutes_said(operation.ToolController.Tool))

    def test_zero_is_refused(self):
        _, operation = job_on(*tilted_box())
        operation.ToolController.Tool.Flutes = 0
        with self.assertRaises(patchmill.InputError) as caught:
            patchmill.recompute(operation)
        self.assertEqual(caught.exception.property, "Flutes")
        self.assertIn("proposed: 2", str(caught.exception))
        self.assertIn(operation.ToolController.Tool.Label, str(caught.exception))


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
