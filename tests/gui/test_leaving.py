"""A texture's panel is left without OK or Cancel: a command is pressed, another object is edited, what was
made is undone or deleted, the document is closed. Nothing is lost, nothing of a panel stays behind.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import driver
import FreeCAD
import FreeCADGui
import hands
from patchmill.operations import curved_texture, quick_setup
from patchmill_gui.forms import post_dialog
from patchmill_gui.panels.texture_head import Head
from PySide import QtGui


class Leaving(driver.BlockTest):
    def setUp(self):
        super().setUp()
        self.name = self.document.Name
        self.operation, self.panel = driver.begin_texture(self.part)

    def tearDown(self):
        heads = [head for head in FreeCADGui.getMainWindow().findChildren(Head) if head.isVisible()]
        self.assertEqual(len(heads), int(driver.panel_open()))
        if driver.panel_open():
            FreeCADGui.Control.closeDialog()
        if self.name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(self.name)

    def test_no_second_operation_is_made_while_a_panel_is_open(self):
        before = self.names()
        driver.select(self.part, driver.top_face(self.part.Shape))
        FreeCADGui.runCommand("PatchMill_CurvedTexture")
        driver.rest(0.5)
        self.assertEqual(self.names(), before)
        self.assertIs(driver.panel_of(self.operation), self.panel)
        self.assertTrue(driver.panel_open())

    def test_the_texture_stays_when_its_job_is_edited(self):
        FreeCADGui.activeDocument().setEdit(self.document.getObject("Job").Name)
        self.assertTrue(driver.wait(lambda: self.operation.DimpleCount > 0))
        self.assertIsNone(driver.panel_of(self.operation))
        self.assertFalse(self.operation.ViewObject.Proxy.editing)
        buttons = FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
        (box,) = [box for box in buttons if box.isVisible()]
        cancel = box.button(QtGui.QDialogButtonBox.Cancel)
        hands.show(cancel)
        hands.click(cancel)
        self.assertTrue(driver.wait(lambda: not driver.panel_open()))
        self.assertTrue({"CurvedTexture", "Job"} <= self.names())

    def test_undo_takes_back_what_was_made_with_its_panel(self):
        FreeCADGui.runCommand("Std_Undo")
        self.assertTrue(driver.wait(lambda: not driver.panel_open()))
        self.assertEqual(self.names(), {"Part"})

    def test_a_deleted_texture_takes_its_panel_along(self):
        self.document.removeObject(self.operation.Name)
        self.assertTrue(driver.wait(lambda: not driver.panel_open()))
        self.assertNotIn("CurvedTexture", self.names())

    def test_a_field_that_says_too_late_that_it_was_edited_changes_nothing(self):
        """As fields do that lose the keyboard while the panel closes with its operation."""
        page, controller = self.panel.page, self.operation.ToolController
        self.panel.reject()
        self.assertNotIn("CurvedTexture", self.names())
        with self.assertRaises(ReferenceError):
            self.operation.Strategy
        page.pageGetFields()
        page.resetToolController(None, controller)
        self.assertFalse(self.panel.place_timer.isActive() or self.panel.plan_timer.isActive())

    def test_a_tool_controller_that_another_job_gets_is_not_taken(self):
        own, page = self.operation.ToolController, self.panel.page
        other, part = driver.new_document(driver.wavy_block(12.0, 8.0), "Other")
        self.addCleanup(FreeCAD.closeDocument, other.Name)
        texture = quick_setup.texture(
            curved_texture, "CurvedTexture", part, [driver.top_face(part.Shape)]
        )
        page.resetToolController(texture.Proxy.getJob(texture), texture.ToolController)
        self.assertIs(self.operation.ToolController, own)

    def test_what_the_post_window_is_about_takes_it_along(self):
        """Undo takes the job back, with which the command made the texture; or the document is closed."""
        for end in (lambda: FreeCADGui.runCommand("Std_Undo"), lambda: FreeCAD.closeDocument(self.name)):
            if not driver.panel_open():
                self.operation, self.panel = driver.begin_texture(self.part)
            driver.accept(self.panel)
            window = post_dialog.show(self.operation.Proxy.getJob(self.operation))
            self.assertTrue(window.isVisible())
            end()
            self.assertTrue(driver.wait(lambda: not self.post_windows(), 10))

    def test_nothing_is_posted_for_a_job_that_was_just_taken_back(self):
        """By a click that comes before the window has gone."""
        driver.accept(self.panel)
        window = post_dialog.show(self.operation.Proxy.getJob(self.operation))
        FreeCADGui.runCommand("Std_Undo")
        self.assertNotIn("Job", self.names())
        window.write()
        self.assertIsNone(window.posted)
        self.assertTrue(driver.wait(lambda: not self.post_windows(), 10))

    @staticmethod
    def post_windows():
        windows = FreeCADGui.getMainWindow().findChildren(QtGui.QDialog, "PostDialog")
        return [window for window in windows if window.isVisible()]

    def test_a_closed_document_takes_its_panel_along(self):
        FreeCAD.closeDocument(self.name)
        self.assertTrue(driver.wait(lambda: not driver.panel_open()))


def main():
    return driver.run_tests(Leaving)
