"""From an empty FreeCAD with a STEP file to a verified program by the mouse alone: nine clicks, ten on five
axes; no key but the file's name and the Return that ends it.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import tempfile

import driver
import FreeCAD
import FreeCADGui
import hands
import Part
from patchmill.freecad import preferences
from patchmill_gui.forms.post_dialog import PostDialog
from patchmill_gui.panels import texture_head
from PySide import QtCore, QtGui


class NineClicks(driver.unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        FreeCADGui.activateWorkbench("PartWorkbench")
        self.clicks = 0

    def click(self, widget, at=None):
        self.clicks += 1
        hands.click(widget, at)

    def step_file(self, angle):
        """A flat plate inclined by `angle` degrees."""
        shape = Part.makeBox(20, 16, 4)
        shape.rotate(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(0, 1, 0), -angle)
        name = os.path.join(self.folder.name, "plate.step")
        shape.exportStep(name)
        return name

    def remembered(self, machine):
        """What was said once, in the panel of an earlier texture or in the preferences."""
        preferences.remember(Machine=machine, ProgramFolder=self.folder.name)
        for name in ("Machine", "ProgramFolder"):
            self.addCleanup(FreeCAD.ParamGet(preferences.PATH).RemString, name)

    def tool_button(self, name):
        """The visible button of a command in a toolbar."""
        buttons = FreeCADGui.getMainWindow().findChildren(QtGui.QToolButton)
        found = [b for b in buttons if b.isVisible() and b.defaultAction()]
        (button,) = [b for b in found if b.defaultAction().objectName() == name]
        return button

    def open(self, name):
        done = []

        def answer():
            dialog = QtGui.QApplication.activeModalWidget()
            if not isinstance(dialog, QtGui.QFileDialog) or not dialog.isVisible():
                return QtCore.QTimer.singleShot(100, answer)
            driver.rest(0.3)
            hands.give_keyboard(dialog)
            hands.write(name)
            hands.press("Return")  # a click on Open would only close the list of names that fit
            done.append(name)

        QtCore.QTimer.singleShot(100, answer)
        driver.accept_import_options()
        self.click(self.tool_button("Std_Open"))
        self.assertTrue(driver.wait(lambda: done and FreeCAD.ActiveDocument is not None))
        self.addCleanup(FreeCAD.closeDocument, FreeCAD.ActiveDocument.Name)
        driver.rest(1.0)

    def choose_workbench(self):
        boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QComboBox)
        (box,) = [b for b in boxes if b.isVisible() and b.findText("PatchMill") >= 0]
        hands.choose(box, "PatchMill")
        self.clicks += 2  # on the box, and on the list
        self.assertTrue(driver.wait(lambda: FreeCADGui.activeWorkbench().name() == "PatchMillWorkbench"))

    def click_face(self, point):
        view = FreeCADGui.activeDocument().activeView()
        area = FreeCADGui.getMainWindow().findChild(QtGui.QMdiArea).currentSubWindow().widget()
        canvas = max(area.findChildren(QtGui.QWidget), key=lambda w: w.width() * w.height())
        x, y = view.getPointOnScreen(point)
        self.click(canvas, QtCore.QPoint(x, canvas.height() - y))
        self.assertTrue(driver.wait(lambda: FreeCADGui.Selection.getSelectionEx(), 5), "no face is selected")

    def finish(self, operation):
        (box,) = [
            b for b in FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox) if b.isVisible()
        ]
        self.click(box.button(QtGui.QDialogButtonBox.Ok))
        panel = driver.panel_of(operation)
        self.assertTrue(driver.wait(lambda: not driver.panel_open(), 500), panel and panel.error)

    def post(self):
        self.click(self.tool_button("PatchMill_Post"))
        window = FreeCADGui.getMainWindow()
        shown = lambda: [d for d in window.findChildren(PostDialog) if d.isVisible()]  # noqa: E731
        self.assertTrue(driver.wait(shown))
        (dialog,) = shown()
        self.addCleanup(dialog.reject)
        self.click(dialog.ok)
        self.assertTrue(driver.wait(lambda: dialog.message.text() != ""))
        said = dialog.message.text()
        self.assertIn("holds the plan", said)
        self.assertTrue(os.path.exists(dialog.file.text()))

    def mill(self, machine, angle, point, fix=None):
        self.remembered(machine)
        self.open(self.step_file(angle))
        self.choose_workbench()
        self.click_face(FreeCAD.Vector(*point))
        self.click(self.tool_button("PatchMill_CurvedTexture"))
        operation = FreeCAD.ActiveDocument.getObject("CurvedTexture")
        head = driver.panel_of(operation).advising.head
        if fix:
            self.assertTrue(driver.wait(lambda: head.buttons, 500), head.bar.text())
            (button,) = [b for b in head.buttons if b.objectName() == fix]
            self.click(button)
        self.assertTrue(driver.wait(lambda: head.state == texture_head.GREEN, 500), head.bar.text())
        self.finish(operation)
        self.assertGreater(operation.DimpleCount, 500)
        self.post()
        print("clicks:", self.clicks, flush=True)

    def test_three_axes(self):
        self.mill("linuxcnc-mill", 25.0, (7.4, 8.0, 7.85))
        self.assertLessEqual(self.clicks, 9)

    def test_five_axes(self):
        self.mill("table-table-ac", 0.0, (10.0, 8.0, 4.0), "FixLean")
        self.assertLessEqual(self.clicks, 10)


def main():
    return driver.run_tests(NineClicks)
