"""What the GUI tests and the pictures' script share: a part, its face selected, and waiting for events.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import tempfile
import time
import unittest

import FreeCAD
import FreeCADGui
import Part
from PySide import QtCore, QtGui


def wait(condition, seconds=60.0):
    """Runs the event loop until `condition()` is true; returns whether it became so. Between events it
    sleeps, as the program's own loop does: a loop that asks again and again would take a core."""
    look = QtCore.QTimer()
    look.start(10)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents | QtCore.QEventLoop.WaitForMoreEvents)
        if condition():
            return True
    return False


def rest(seconds):
    """Runs the event loop for so long."""
    wait(lambda: False, seconds)


def panel_open():
    return bool(FreeCADGui.Control.activeDialog())


def new_document(shape, name="Part"):
    """A document with `shape` as its one object; the PatchMill workbench in front."""
    FreeCADGui.activateWorkbench("PatchMillWorkbench")
    document = FreeCAD.newDocument(name)
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape
    document.recompute()
    FreeCADGui.activeDocument().activeView().viewAxonometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return document, part


def wavy_block(length=30.0, width=20.0):
    """A solid with a wavy top, steep enough everywhere for an upright tool."""
    rows = [
        [FreeCAD.Vector(length * i / 6, width * j / 4, 8.0 + 0.6 * length * i / 6 + ((i + j) % 2) * 0.8)
         for j in range(5)]
        for i in range(7)
    ]
    surface = Part.BSplineSurface()
    surface.interpolate(rows)
    top = surface.toShape()
    return top.extrude(FreeCAD.Vector(0, 0, -6))


def top_face(shape):
    """Name of the highest face that looks upwards."""
    up = [(face.CenterOfMass.z, n) for n, face in enumerate(shape.Faces, 1) if _normal(face).z > 0.5]
    return "Face%d" % max(up)[1]


def _normal(face):
    u0, u1, v0, v1 = face.ParameterRange
    return face.normalAt(0.5 * (u0 + u1), 0.5 * (v0 + v1))


def select(part, face):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(part, face)


def task_dock():
    """The dock of FreeCAD's task panel: "Combo View", from 1.1 on "Tasks"."""
    docks = FreeCADGui.getMainWindow().findChildren(QtGui.QDockWidget)
    return next(dock for name in ("Combo View", "Tasks") for dock in docks if dock.objectName() == name)


def report_text():
    """What the report view says."""
    edits = FreeCADGui.getMainWindow().findChildren(QtGui.QTextEdit)
    (view,) = [edit for edit in edits if edit.metaObject().className() == "Gui::DockWnd::ReportOutput"]
    return view.toPlainText()


def panel_of(operation):
    return operation.ViewObject.Proxy.panel


def begin_texture(part, command="PatchMill_CurvedTexture"):
    """Selects the part's top face and runs a texture command; (operation, its open panel) once the plan or
    an error is there."""
    select(part, top_face(part.Shape))
    FreeCADGui.runCommand(command)
    operation = part.Document.getObject(command.replace("PatchMill_", ""))
    assert ready(panel_of(operation)), "the plan did not come"
    return operation, panel_of(operation)


def accept(panel):
    """OK, and waits until the panel is closed."""
    panel.accept()
    closed = wait(lambda: not panel_open() or panel.error is not None, 240)
    assert panel.error is None, panel.error
    assert closed and not panel_open(), "the panel did not close"


def run_on(obj, command):
    """Selects an object and runs a command."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj)
    FreeCADGui.runCommand(command)


class BlockTest(unittest.TestCase):
    """With a wavy block in a document of its own for each test; closes what is left open."""

    def setUp(self):
        self.document, self.part = new_document(wavy_block())

    def tearDown(self):
        if panel_open():
            FreeCADGui.Control.closeDialog()
        FreeCAD.closeDocument(self.document.Name)

    def names(self):
        return {o.Name for o in self.document.Objects}

    def reopen(self):
        """Saves the document, closes it and opens it again."""
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "saved.FCStd")
            self.document.saveAs(name)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(name)
        rest(0.5)


class TexturedTest(unittest.TestCase):
    """With one document, in which a curved texture is planned, for all tests of the class."""

    @classmethod
    def setUpClass(cls):
        cls.document, part = new_document(wavy_block())
        cls.operation, panel = begin_texture(part)
        accept(panel)

    @classmethod
    def tearDownClass(cls):
        FreeCAD.closeDocument(cls.document.Name)


def set_quantity(panel, name, value):
    """As a user who types a value and leaves the field."""
    panel.page.properties.rows[name].editor.setProperty("rawValue", value)


def ready(panel):
    """Waits until the panel's plan is there for its input, or an error is shown."""
    return wait(lambda: panel.ready_now() or panel.error is not None, 240)


def run_tests(*cases, words=()):
    """Runs TestCase classes, or only their tests whose names have one of `words`; the exit status."""
    loader = unittest.TestLoader()
    loader.testNamePatterns = ["*%s*" % word for word in words] or None
    suite = unittest.TestSuite()
    for case in cases:
        suite.addTests(loader.loadTestsFromTestCase(case))
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    return 0 if result.wasSuccessful() and result.testsRun else 1


def accept_import_options():
    """FreeCAD 1.0 and later ask how to read a STEP file: OK, as a user says, until a document is there."""

    def look():
        if FreeCAD.ActiveDocument is not None:
            return
        dialog = QtGui.QApplication.activeModalWidget()
        if isinstance(dialog, QtGui.QDialog) and not isinstance(dialog, QtGui.QFileDialog):
            dialog.accept()
        QtCore.QTimer.singleShot(50, look)

    QtCore.QTimer.singleShot(50, look)


def answer_file_dialog(name):
    """The next file dialog gets `name`, as if typed, and OK."""

    def answer():
        dialog = QtGui.QApplication.activeModalWidget()
        if not isinstance(dialog, QtGui.QFileDialog) or not dialog.isVisible():
            QtCore.QTimer.singleShot(50, answer)
            return
        edit = dialog.findChild(QtGui.QLineEdit)
        edit.setText(name)
        QtCore.QTimer.singleShot(20, dialog.accept)

    QtCore.QTimer.singleShot(50, answer)
