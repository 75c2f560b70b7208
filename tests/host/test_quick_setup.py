"""One call from a selected face to an operation: what is made, and what is left alone.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import sys
import unittest

import FreeCAD
import Part
import patchmill
from patchmill.freecad import host, preferences
from patchmill.operations import quick_setup, texture_operation


class QuickSetup(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument("quick")
        self.block = self.document.addObject("Part::Box", "Block")
        self.block.Length, self.block.Width, self.block.Height = 30, 20, 10
        self.document.recompute()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def texture(self, part):
        return quick_setup.texture(patchmill.CurvedTexture, "Texture", part, ["Face6"])

    def test_a_bare_part_gets_job_stock_and_ball_end_mill(self):
        operation = self.texture(self.block)
        operation.MinimumTilt = 0.0
        (job,) = host.jobs()
        self.assertIsNotNone(job.Stock)
        self.assertEqual(host.tool_kind(operation.ToolController.Tool), "ballend")
        self.assertEqual(len(host.tool_controllers(job)), 1)
        self.assertEqual(operation.Base[0][0], job.Model.Group[0])

    def test_a_face_that_looks_sideways_or_down_is_refused_by_what_helps(self):
        for face in ("Face1", "Face3", "Face5"):
            operation = quick_setup.texture(patchmill.CurvedTexture, "Texture", self.block, [face])
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.recompute(operation)
            self.assertIn("look sideways or down: incline the part", caught.exception.remedy)

    def test_what_exists_is_used_and_left_as_it_was(self):
        job = host.create_job("Job", [self.block])
        end_mill = host.tool_controllers(job)[0]
        end_mill.SpindleSpeed = 5000.0  # the user's own
        kind = host.tool_kind(end_mill.Tool)
        first = self.texture(self.block)
        second = self.texture(job.Model.Group[0])
        self.assertEqual(host.jobs(), [job])
        self.assertEqual(host.tool_kind(end_mill.Tool), kind)
        self.assertEqual(len(host.tool_controllers(job)), 2)
        self.assertEqual(first.ToolController, second.ToolController)
        self.assertNotEqual(first.ToolController, end_mill)
        self.assertNotEqual(first.ToolController.ToolNumber, end_mill.ToolNumber)

    def test_the_machine_is_the_jobs_else_the_users(self):
        group = FreeCAD.ParamGet(preferences.PATH)
        before = group.GetString("Machine", "")
        self.addCleanup(group.SetString, "Machine", before)
        group.SetString("Machine", "haas-mill")
        copy = quick_setup.copy_milling("Copy", self.block)
        self.assertEqual(copy.Machine, "haas-mill")
        self.assertEqual(quick_setup.dcm_modifier("Modifier", copy).Machine, "haas-mill")
        (job,) = host.jobs()
        job.Operations.Group[0].Machine = "linuxcnc-mill"
        self.assertEqual(quick_setup.copy_milling("Copy2", self.block).Machine, "linuxcnc-mill")
        self.assertEqual(self.texture(self.block).Machine, "linuxcnc-mill")

    def test_own_posts_are_in_a_new_jobs_list_once_and_can_be_the_preferred_one(self):
        own = {"patchmill_%s" % name for name in ("fanuc", "heidenhain", "linuxcnc", "siemens")}
        FreeCAD.ParamGet(preferences.PATH).SetString("Post", "patchmill_siemens")
        self.addCleanup(FreeCAD.ParamGet(preferences.PATH).RemString, "Post")
        self.texture(self.block)
        (job,) = host.jobs()
        listed = job.getEnumerationsOfProperty("PostProcessor")
        self.assertLessEqual(own | {"linuxcnc", "fanuc"}, set(listed))
        self.assertEqual(len(listed), len(set(listed)))
        self.assertEqual(job.PostProcessor, "patchmill_siemens")

    def test_an_object_without_faces_is_named(self):
        line = self.document.addObject("Part::Line", "Line")
        self.document.recompute()
        with self.assertRaises(patchmill.InputError) as caught:
            self.texture(line)
        self.assertEqual(caught.exception.property, "Selection")

    def test_a_plan_made_ahead_is_that_of_the_whole_text_and_serves_its_input_only(self):
        surface = self.document.addObject("Part::Feature", "Ball")
        surface.Shape = Part.makeSphere(12.0)
        self.document.recompute()
        operation = quick_setup.texture(patchmill.CurvedTexture, "Ball", surface, ["Face1"])
        operation.Spacing = 0.25
        given = operation.Proxy.texture_input(operation)
        ready = texture_operation.prepare(given)
        whole = host.begin_upright(host.Path.Path(str(ready.planned.pacing.text)).Commands)
        self.assertEqual([c.toGCode() for c in ready.commands], [c.toGCode() for c in whole])
        self.assertGreater(len(ready.planned.pacing.text), 1)  # it was read in parts
        operation.Proxy.ready = ready
        plan = patchmill.recompute(operation)
        self.assertIs(plan, ready.planned)
        operation.Spacing = 0.6
        operation.SafeHeight = 20.0
        operation.Proxy.ready = ready
        self.assertIsNot(patchmill.recompute(operation), ready.planned)

    def test_a_cancelled_plan_is_none(self):
        operation = self.texture(self.block)
        operation.MinimumTilt = 0.0
        given = operation.Proxy.texture_input(operation)
        self.assertIsNone(texture_operation.prepare(given, lambda share: False))


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() else 1)
