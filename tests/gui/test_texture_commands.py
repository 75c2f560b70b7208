"""The texture commands as a user has them: select a face, one click, the panel, OK; and all the ways back.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import unittest

import FreeCAD
import FreeCADGui
import driver
from patchmill.freecad import host
from patchmill_gui.app import examples

COMMANDS = (
    "PatchMill_PlanarTexture",
    "PatchMill_PyramidTexture",
    "PatchMill_CurvedTexture",
    "PatchMill_CalibrationPatch",
)


class TextureCommands(driver.BlockTest):
    def begin(self, command="PatchMill_CurvedTexture"):
        """(operation, panel) of a texture on the top face, once planned."""
        return driver.begin_texture(self.part, command)

    def test_each_command_makes_a_texture_from_a_bare_part(self):
        for command in COMMANDS:
            with self.subTest(command):
                operation, panel = self.begin(command)
                self.assertIsNone(panel.error)
                driver.set_quantity(panel, "Spacing", 0.8)
                driver.accept(panel)
                self.assertEqual(operation.State, ["Up-to-date"])
                self.assertAlmostEqual(operation.Spacing.Value, 0.8)
                self.assertGreater(operation.DimpleCount, 50)
                self.assertGreater(operation.Path.Size, operation.DimpleCount)
                self.assertTrue(os.path.exists(operation.ViewObject.Proxy.getIcon()))
        self.assertEqual(len(host.jobs()), 1)

    def test_ok_takes_the_plan_of_the_preview_when_sizes_are_worked_out(self):
        operation, panel = self.begin()
        driver.set_quantity(panel, "RidgeHeight", 0.05)
        driver.set_quantity(panel, "Spacing", 0.0)  # from the ridge height
        self.assertTrue(driver.ready(panel))
        self.assertIsNone(panel.error)
        ready = panel.ready
        self.assertNotEqual(ready.planned.input, ready.planned.asked)
        driver.accept(panel)
        self.assertIs(operation.Proxy.planned, ready.planned)

    def test_cancel_leaves_nothing(self):
        before = self.names()
        _, panel = self.begin()
        panel.reject()
        self.assertTrue(driver.wait(lambda: not driver.panel_open()))
        self.assertEqual(self.names(), before)

    def test_undo_is_one_step_and_redo_brings_it_back(self):
        before = self.names()
        operation, panel = self.begin()
        driver.accept(panel)
        size, after = operation.Path.Size, self.names()
        self.assertEqual(len(self.document.UndoNames), 1)
        self.document.undo()
        self.assertEqual(self.names(), before)
        self.document.redo()
        self.document.recompute()
        self.assertEqual(self.names(), after)
        self.assertEqual(self.document.getObject("CurvedTexture").Path.Size, size)

    def test_edit_again_after_saving_and_reopening(self):
        operation, panel = self.begin()
        driver.accept(panel)
        count = operation.DimpleCount
        self.reopen()
        operation = self.document.getObject("CurvedTexture")
        view = operation.ViewObject.Proxy
        self.assertEqual(type(view).__module__, "patchmill_gui.texture_view")
        operation.ViewObject.Document.setEdit(operation.ViewObject, 0)
        panel = driver.panel_of(operation)
        self.assertTrue(driver.ready(panel))
        driver.set_quantity(panel, "Spacing", 1.0)
        driver.accept(panel)
        self.assertLess(operation.DimpleCount, count / 2)
        self.document.undo()
        self.document.recompute()
        self.assertEqual(operation.DimpleCount, count)

    def test_cancelled_edit_leaves_the_properties(self):
        operation, panel = self.begin()
        driver.accept(panel)
        operation.ViewObject.Document.setEdit(operation.ViewObject, 0)
        panel = driver.panel_of(operation)
        driver.set_quantity(panel, "Spacing", 1.3)
        driver.rest(0.3)
        panel.reject()
        self.assertAlmostEqual(operation.Spacing.Value, 0.5)

    def test_the_display_follows_what_is_asked(self):
        operation, panel = self.begin()
        scene = operation.ViewObject.Proxy.scene
        self.assertTrue(scene.filled("dimples") and scene.shown("dimples"))
        panel.page.previews["dimples"].setChecked(False)
        self.assertFalse(scene.shown("dimples"))
        panel.page.previews["order"].setChecked(True)
        self.assertTrue(scene.shown("order"))
        driver.accept(panel)
        driver.rest(0.2)
        for show, part in (("Dimples", "dimples"), ("Tool path", "path"), ("Dimples", "outlines")):
            operation.ViewObject.Show = show
            self.assertTrue(driver.wait(lambda: scene.filled(part)), (show, part))
            self.assertTrue(scene.shown(part), (show, part))
        operation.ViewObject.Visibility = False
        self.assertFalse(scene.shown("dimples"))

    def test_an_error_is_a_sentence_at_its_field_and_goes_when_mended(self):
        _, panel = self.begin()
        rows = panel.page.properties.rows
        rows["PatchSide"].editor.setValue(20000)
        self.assertTrue(driver.wait(lambda: panel.error is not None))
        self.assertIn("10000", rows["PatchSide"].error.text())
        panel.accept()
        driver.rest(0.5)
        self.assertTrue(driver.panel_open(), "OK must not close a panel whose texture cannot be made")
        rows["PatchSide"].editor.setValue(8)
        self.assertTrue(driver.wait(lambda: panel.error is None and panel.ready_now()))
        self.assertEqual(rows["PatchSide"].error.text(), "")
        driver.accept(panel)

    def test_a_proposal_of_the_advisor_is_taken_over_by_one_click(self):
        operation, panel = self.begin("PatchMill_PlanarTexture")
        rows, advice = panel.page.properties.rows, panel.page.advice
        self.assertFalse(advice.isVisibleTo(panel.page.form))
        rows["Form"].editor.setCurrentText("Free")
        driver.set_quantity(panel, "FreeSide", 5.0)
        driver.set_quantity(panel, "CrossFeed", 0.47)
        driver.set_quantity(panel, "FeedPerTooth", 0.41)
        self.assertTrue(driver.wait(panel.ready_now))
        self.assertTrue(advice.isVisibleTo(panel.page.form))
        self.assertFalse(rows["PatchSide"].editor.isVisibleTo(panel.page.form))
        advice.ask()
        self.assertGreater(len(advice.buttons), 1)
        advice.buttons[0].click()
        self.assertTrue(driver.ready(panel))
        self.assertIsNone(panel.error)
        driver.accept(panel)
        # to the decimals of the posted feed
        self.assertAlmostEqual(operation.PhaseDrift, 0.0, delta=1e-3)
        self.assertNotIn("drift", operation.MarkArray.lower())

    def test_without_a_face_a_sentence_and_an_unchanged_document(self):
        before = self.names()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.runCommand("PatchMill_CurvedTexture")
        self.assertEqual(self.names(), before)
        self.assertFalse(driver.panel_open())

    def test_what_a_macro_makes_has_its_view_too(self):
        import patchmill

        job = host.create_job("Job", [self.part])
        host.add_ball_end_controller(job, 2.0, 2, 450.0, 1000.0)
        operation = patchmill.PlanarTexture.Create("FromMacro", parentJob=job)
        self.assertEqual(type(operation.ViewObject.Proxy).__module__, "patchmill_gui.texture_view")


class ExamplesMenu(unittest.TestCase):
    def test_every_example_opens_a_part_with_faces(self):
        FreeCADGui.activateWorkbench("PatchMillWorkbench")
        for name in examples.COMMANDS:
            FreeCADGui.runCommand(name)
            (part,) = FreeCAD.ActiveDocument.Objects
            self.assertTrue(part.Shape.isValid() and part.Shape.Faces, name)
            FreeCAD.closeDocument(FreeCAD.ActiveDocument.Name)


class NativeMenu(unittest.TestCase):
    def test_the_commands_are_in_freecads_cam_menu_too(self):
        FreeCADGui.activateWorkbench(host.NATIVE_WORKBENCH)
        driver.rest(1.0)
        bar = FreeCADGui.getMainWindow().menuBar()
        titles = [action.text().replace("&", "") for action in bar.actions()]
        self.assertIn("PatchMill", titles)


def main():
    return driver.run_tests(TextureCommands, ExamplesMenu, NativeMenu)
