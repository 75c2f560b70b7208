"""As a new user: from an empty FreeCAD with a STEP file to a checked program, through the GUI's commands,
dialogs and widgets only. The steps are those of the README's quick start.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import tempfile
import unittest

import _patchmill as core
import driver
import FreeCAD
import FreeCADGui
import hands
from patchmill_gui.forms import resources
from patchmill_gui.forms.post_dialog import PostDialog
from PySide import QtGui

STEP = resources.path("recipes", "xu2016", "block.step")


class NewUser(unittest.TestCase):
    def test_from_a_step_file_to_a_program(self):
        FreeCADGui.activateWorkbench("PatchMillWorkbench")
        driver.answer_file_dialog(STEP)
        driver.accept_import_options()
        FreeCADGui.runCommand("Std_Open")
        self.assertTrue(driver.wait(lambda: FreeCAD.ActiveDocument is not None))
        document = FreeCAD.ActiveDocument
        (part,) = [o for o in document.Objects if hasattr(o, "Shape")]
        driver.select(part, driver.top_face(part.Shape))
        FreeCADGui.runCommand("PatchMill_CurvedTexture")
        panel = driver.panel_of(document.getObject("CurvedTexture"))
        self.assertTrue(driver.ready(panel))
        panel.page.properties.rows["PatchesX"].editor.setValue(3)
        panel.page.properties.rows["PatchesY"].editor.setValue(2)
        self.assertTrue(driver.ready(panel))
        panel.accept()
        self.assertTrue(driver.wait(lambda: not driver.panel_open()))
        self.choose_post(document.getObject("Job"), "patchmill_linuxcnc")
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "block.ngc")
            self.post(program)
            self.assertTrue(os.path.exists(program))
            self.report(folder)
            with open(program, encoding="utf-8") as file:
                text = file.read()
        operation = document.getObject("CurvedTexture")
        plan = operation.Proxy.planned
        sections = core.read_gcode(text, plan.input.tool)
        matches = [core.match_plan(s.path, plan.path, 0.0005).found for s in sections]
        self.assertEqual(max(matches), operation.DimpleCount)
        FreeCAD.closeDocument(document.Name)

    def choose_post(self, job, name):
        """In FreeCAD's own dialog of the job, with as many decimals as the operation is planned for."""
        FreeCADGui.activeDocument().setEdit(job.Name)
        self.assertTrue(driver.wait(driver.panel_open))
        boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QComboBox, "postProcessor")
        (box,) = [b for b in boxes if b.findText(name) >= 0]
        box.setCurrentIndex(box.findText(name))
        (arguments,) = FreeCADGui.getMainWindow().findChildren(QtGui.QWidget, "postProcessorArguments")
        arguments.setText("--precision=3")
        self.assertTrue(driver.wait(self.pressed_ok))
        self.assertTrue(driver.wait(lambda: not driver.panel_open()))
        self.assertEqual(job.PostProcessor, name)

    def post(self, program):
        """In the window of the Post command."""
        FreeCADGui.runCommand("PatchMill_Post")
        (window,) = FreeCADGui.getMainWindow().findChildren(PostDialog)
        self.assertEqual(window.post.currentText(), "patchmill_linuxcnc")
        hands.enter(window.file, program, None)
        hands.click(window.ok)
        self.assertTrue(driver.wait(lambda: window.message.text()))
        self.assertIn("holds the plan", window.message.text())
        window.reject()

    @staticmethod
    def pressed_ok():
        """Whether the OK button of the panel could be pressed; the panel may be about to be made anew."""
        boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
        try:
            [b for b in boxes if b.isVisible()][-1].button(QtGui.QDialogButtonBox.Ok).click()
        except (IndexError, RuntimeError):  # none there, or one that Qt has just deleted
            return False
        return True

    def report(self, folder):
        """The Report command, into the same folder."""
        driver.answer_file_dialog(folder)
        FreeCADGui.runCommand("PatchMill_Report")
        self.assertTrue(driver.panel_open())
        page = os.path.join(folder, "report.html")
        self.assertTrue(driver.wait(lambda: os.path.exists(page), 200))
        driver.rest(0.5)
        FreeCADGui.Control.closeDialog()
        with open(page, encoding="utf-8") as file:
            self.assertIn("relief", file.read())


def main():
    return driver.run_tests(NewUser)
