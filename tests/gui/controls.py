"""Every control of every panel and window, found in them and touched by mouse and keys, lists and file
windows included: nothing is raised, and no value changes that was not edited. It takes as long as a hand:

    tests/gui/run_gui tests/gui/controls.py [WORD ...]    # tests whose names have one of them
    PATCHMILL_GUI_SCREEN=1024x768 PATCHMILL_GUI_SECONDS=3000 tests/gui/run_gui tests/gui/controls.py

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import subprocess
import sys
import traceback

import driver
import FreeCAD
import FreeCADGui
import hands
import Part
from patchmill.freecad import preferences
from patchmill.operations.texture_operation import ObjectTexture
from patchmill_gui.fields.events import below, is_in
from patchmill_gui.forms import machine_editor, post_dialog
from PySide import QtCore, QtGui

FIELDS = (QtGui.QAbstractSpinBox, QtGui.QLineEdit, QtGui.QPlainTextEdit)
KINDS = FIELDS + (QtGui.QComboBox, QtGui.QAbstractButton, QtGui.QSlider, QtGui.QListWidget)
TEXTURE_VALUES = [row[1] for row in ObjectTexture.properties()]
OWNERS = KINDS + (QtGui.QDialogButtonBox,)
CYLINDER = "Part::GeomCylinder"
THREAD = (
    ("Machine", "four-axis-mill"),
    ("Strategy", "Spindle-locked"),
    ("ToolAxisMode", "Normal"),
    ("Order", "Thread"),
)
LEFT = ("Simulate", "SaveRelief", "Preview", "Play")  # buttons that compute or run: other tests press them


def controls(root):
    """What can be touched in a widget, parts of another control left out, from above to below."""
    owners = below(root, OWNERS)
    found = [each for each in owners if isinstance(each, KINDS)]
    found = [each for each in found if not any(is_in(each, owner) for owner in owners)]
    return sorted(found, key=lambda each: _place_in(root, each))


def _place_in(root, widget):
    place = widget.mapTo(root, QtCore.QPoint(0, 0))
    return place.y(), place.x()


class Controls(driver.BlockTest):
    def setUp(self):
        super().setUp()
        self.told = []
        before = sys.excepthook
        self.addCleanup(lambda: setattr(sys, "excepthook", before))
        sys.excepthook = lambda *error: self.told.append("".join(traceback.format_exception(*error)))
        self.touched = []

    def touch(self, control):
        """Touches a control so that its value stays: a list is opened and left, a field is left by Tab."""
        hands.show(control)
        if isinstance(control, QtGui.QComboBox) and control.count():
            hands.open_list(control)
            hands.press("Escape")
            self.assertTrue(driver.wait(lambda: not control.view().isVisible(), 10), control.objectName())
        elif isinstance(control, QtGui.QComboBox):
            hands.click(control)
        elif isinstance(control, FIELDS):
            hands.click(control, hands.middle_left(control, 12))
            hands.press("Tab")
        elif isinstance(control, QtGui.QAbstractButton) and control.isCheckable():
            hands.click(control)
            driver.rest(0.1)
            hands.show(control)
            hands.click(control)
        elif isinstance(control, QtGui.QAbstractButton):
            self.leave_windows = True
            QtCore.QTimer.singleShot(400, self.escape)
            hands.click(control)
            driver.rest(0.2)
            self.leave_windows = False
        else:
            hands.click(control, hands.middle_left(control, 12))

    def escape(self):
        """Leaves the window that a button opened by its key."""
        if QtGui.QApplication.activeModalWidget() is not None:
            subprocess.Popen(["xdotool", "key", "Escape"])
        if self.leave_windows:
            QtCore.QTimer.singleShot(400, self.escape)

    def drive(self, root, values=lambda: None, leave=()):
        """Touches everything in `root`, folds opened first; `values()` is to stay."""
        self.assertTrue(driver.wait(root.isVisible, 60))
        before = values()
        for control in controls(root):
            name = control.objectName() or type(control).__name__
            if not control.isVisible() or not control.isEnabled() or name in LEFT + tuple(leave):
                continue
            self.touch(control)
            self.touched.append(name)
            self.assertEqual(self.told, [], name)
        driver.rest(0.5)
        self.assertEqual(values(), before)
        self.assertEqual(self.told, [])

    def values_of(self, obj, rows):
        def values():
            return {name: str(getattr(obj, name)) for name in rows}

        return values

    def settled(self, panel):
        """Nothing more is said that would move the rows."""
        self.assertTrue(driver.ready(panel))
        driver.wait(lambda: not panel.advising.assessing.busy, 200)
        panel.advising.helping.cancel()
        panel.advising.following = False

    def texture(self, command, groups=None):
        """Drives a texture's page, all of it or only the groups that are named."""
        operation, panel = driver.begin_texture(self.part, command)
        self.settled(panel)
        form = panel.page.properties
        values = self.values_of(operation, form.rows)
        panel.page.advanced.heading.setChecked(True)
        for name, group in form.groups.items():
            group.heading.setChecked(groups is None or name in groups)
        driver.rest(0.3)
        if groups is None:
            self.drive(panel.page.form, values)
        else:
            for name in groups:
                self.drive(form.groups[name], values)
        self.assertTrue(driver.panel_open())
        panel.reject()

    def test_curved_texture(self):
        self.texture("PatchMill_CurvedTexture")
        self.assertGreater(len(self.touched), 40)

    def test_what_the_other_textures_have_besides(self):
        self.texture("PatchMill_PlanarTexture", ["Pattern", "Free form"])
        self.texture("PatchMill_PyramidTexture", ["Pattern"])
        self.texture("PatchMill_CalibrationPatch", ["Phase"])
        self.assertGreater(len(self.touched), 15)

    def test_a_thread(self):
        FreeCAD.closeDocument(self.document.Name)
        roller = Part.makeCylinder(6, 4, FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0))
        self.document, self.part = driver.new_document(roller)
        operation, panel = self.begin_thread()
        form = panel.page.properties
        panel.page.advanced.heading.setChecked(True)
        for group in form.groups.values():
            group.heading.setChecked(True)
        driver.rest(0.3)
        self.drive(panel.page.form, self.values_of(operation, form.rows))
        self.assertIsNone(panel.error)
        self.assertGreater(len(self.touched), 20)
        panel.reject()

    def begin_thread(self):
        """A texture whose order, machine and posture were chosen by mouse; (operation, panel)."""
        face = next(n for n, f in enumerate(self.part.Shape.Faces, 1) if f.Surface.TypeId == CYLINDER)
        driver.select(self.part, "Face%d" % face)
        FreeCADGui.runCommand("PatchMill_CurvedTexture")
        operation = self.document.getObject("CurvedTexture")
        panel = driver.panel_of(operation)
        self.settled(panel)
        rows = panel.page.properties.rows
        panel.page.advanced.heading.setChecked(True)
        rows["Order"].group.heading.setChecked(True)
        for name, choice in THREAD:
            hands.choose(rows[name].editor, choice)
        # without the last of them the machine's one axis does not reach what a texture asks
        self.assertTrue(driver.wait(lambda: panel.ready_now() and panel.error is None, 240), panel.error)
        return operation, panel

    def test_copy_milling_and_its_modifier(self):
        driver.run_on(self.part, "PatchMill_CopyMilling")
        operation = self.document.getObject("CopyMilling")
        panel = driver.panel_of(operation)
        panel.form_rows.rows["AxialDepth"].editor.setProperty("rawValue", 4.0)
        driver.rest(0.2)
        self.drive(panel.page.form, self.values_of(operation, panel.form_rows.rows))
        driver.accept(panel)
        driver.run_on(operation, "PatchMill_DressupDcm")
        dressup = self.document.getObject("DressupDCM")
        panel = dressup.ViewObject.Proxy.panel
        for group in panel.form_rows.groups.values():  # also the load and its limits
            group.heading.setChecked(True)
        driver.rest(0.3)
        self.drive(panel.form, self.values_of(dressup, panel.form_rows.rows))
        panel.reject()
        self.assertGreater(len(self.touched), 20)

    def test_what_is_opened_on_a_texture(self):
        operation, panel = driver.begin_texture(self.part)
        self.settled(panel)
        driver.accept(panel)
        for command in ("PatchMill_Simulate", "PatchMill_Check", "PatchMill_Play"):
            driver.run_on(operation, command)
            task = driver.task_dock()
            self.drive(task, self.values_of(operation, TEXTURE_VALUES), self.outside(task))
            FreeCADGui.Control.closeDialog()
        window = post_dialog.show(operation.Proxy.getJob(operation))
        self.drive(window)
        window.reject()

    @staticmethod
    def outside(task):
        """Names of the controls of FreeCAD's own that are in the same dock."""
        return [w.objectName() for w in below(task, QtGui.QAbstractButton) if "qt_" in w.objectName()]

    def test_the_preferences(self):
        group = FreeCAD.ParamGet(preferences.PATH)
        before, failed = sorted(group.GetContents() or []), []

        def drive():
            dialog = QtGui.QApplication.activeModalWidget()
            if dialog is None:
                return QtCore.QTimer.singleShot(100, drive)
            try:
                hands.give_keyboard(dialog)
                page = next(w for w in dialog.findChildren(QtGui.QWidget, "PatchMillPreferences"))
                self.drive(page, lambda: sorted(group.GetContents() or []))
                hands.click_button("OK", dialog)
            except Exception as error:  # told below: within the dialog's loop nobody would see it
                failed.append(error)
                dialog.reject()

        QtCore.QTimer.singleShot(500, drive)
        FreeCADGui.showPreferences("PatchMill", 0)
        self.assertEqual(failed, [])
        self.assertGreater(len(self.touched), 6)
        self.assertLessEqual(set(before), set(group.GetContents()))  # OK writes the others as they are shown
        self.assertEqual(preferences.tool(), preferences.Tool())
        values = preferences.operation_defaults()
        self.assertEqual(values, {"Spacing": 0.5, "Machine": values["Machine"], "Decimals": 3})
        self.assertEqual((preferences.threads(), preferences.post()), (0, "linuxcnc"))

    def test_the_window_of_machines(self):
        window = machine_editor.show("table-table-ac")

        def close():  # or it would lie over the panels of other tests
            window.changed = False
            window.close()

        self.addCleanup(close)
        self.drive(window, lambda: (window.changed, str(window.data)), ("close",))


def main():
    return driver.run_tests(Controls, words=sys.argv[1:])
