"""Nothing is left of a panel that was closed, however it was, and an undo while it computes raises nothing:
what Python keeps of deleted widgets is taken for new ones at their addresses.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib
import gc
import sys
import traceback
from unittest import mock

import driver
import FreeCAD
import FreeCADGui
from patchmill_gui.fields import deleted_widgets, events, typing_hand
from patchmill_gui.forms import widgets
from patchmill_gui.forms.machine_editor import MachineEditor
from patchmill_gui.forms.post_dialog import PostDialog
from patchmill_gui.panels import texture_head
from patchmill_gui.panels.check_panel import CheckPanel
from patchmill_gui.panels.dcm_panel import DcmPanel
from patchmill_gui.panels.player import PlayerPanel
from patchmill_gui.panels.simulate_panel import SimulatePanel
from patchmill_gui.panels.texture_panel import TexturePanel
from patchmill_gui.work import room
from PySide import QtGui

try:
    import shiboken2 as shiboken
except ImportError:
    import shiboken6 as shiboken

DELETED = "Internal C++ object (PySide2.QtWidgets.QAbstractSpinBox) already deleted."
KINDS = ("TexturePanel", "CopyPanel", "DcmPanel", "PropertyForm", "Advising")


class ClosedPanels(driver.unittest.TestCase):
    def setUp(self):
        self.told = []
        before = sys.excepthook
        self.addCleanup(lambda: setattr(sys, "excepthook", before))
        sys.excepthook = lambda *error: self.told.append("".join(traceback.format_exception(*error)))
        self.document, self.part = driver.new_document(driver.wavy_block(12.0, 8.0))
        self.document.UndoMode = 1
        self.addCleanup(self.close_documents)

    def close_documents(self):
        if driver.panel_open():
            FreeCADGui.Control.closeDialog()
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

    def assertNothingLeft(self):
        driver.rest(2.0)
        gc.collect()
        left = sorted(type(one).__name__ for one in gc.get_objects() if type(one).__name__ in KINDS)
        self.assertEqual(left, [])
        ours = [text for text in self.told if "patchmill" in text.lower()]
        self.assertEqual(ours, [])
        self.assertFalse(driver.panel_open())

    def test_of_a_texture(self):
        _, panel = driver.begin_texture(self.part)
        panel.reject()
        del panel
        self.assertNothingLeft()
        _, panel = driver.begin_texture(self.part, "PatchMill_PlanarTexture")
        driver.accept(panel)
        del panel
        self.assertNothingLeft()

    def test_what_lasts_holds_no_widget_of_a_closed_panel(self):
        """PySide would keep what is found below docks and FreeCAD's task panel, with these as parents."""
        _, panel = driver.begin_texture(self.part)
        driver.rest(1.0)  # room was made for it
        panel.reject()
        del panel
        self.assertNothingLeft()
        lasting = [one for one in gc.get_objects() if is_widget(one) and shiboken.isValid(one)]
        held = [each for one in lasting for each in gc.get_referents(one) if is_widget(each)]
        self.assertEqual([type(each).__name__ for each in held if not shiboken.isValid(each)], [])

    def test_of_a_texture_undone_while_it_computes(self):
        _, panel = driver.begin_texture(self.part)
        panel.accept()
        del panel
        FreeCADGui.runCommand("Std_Undo")
        self.assertNothingLeft()

    def test_an_editor_that_python_takes_for_a_deleted_one_stops_no_panel(self):
        """The others are guarded, and it as well where forgetting what is deleted helps."""

        class Taken(QtGui.QSpinBox):
            times = 0

            def findChild(self, *wanted):
                self.times -= 1
                if self.times >= 0:
                    raise RuntimeError(DELETED)
                return super().findChild(*wanted)

        for times, guarded in ((0, 3), (1, 3), (9, 2)):
            form = QtGui.QWidget()
            editors = [QtGui.QSpinBox(form), Taken(form), QtGui.QComboBox(form)]
            editors[1].times = times
            widgets.guard_editors(form)
            self.assertEqual(len(form.findChildren(widgets._EditorGuard)), guarded)

    def test_a_widget_that_python_takes_for_a_deleted_one_has_no_hand_on_it(self):
        """Neither the keyboard nor the pointer: what asks where those are goes on."""

        class Taken(QtGui.QLineEdit):
            def hasFocus(self):
                raise RuntimeError(DELETED)

        form, area, dock = QtGui.QWidget(), QtGui.QScrollArea(), QtGui.QDockWidget()
        taken = Taken(form)
        self.assertFalse(typing_hand.is_typed_in(form))
        gone = mock.Mock(isAncestorOf=mock.Mock(side_effect=RuntimeError(DELETED)))
        with mock.patch.object(QtGui.QApplication, "focusWidget", lambda: taken):
            self.assertFalse(texture_head._is_at_work_in(gone, form))
        with mock.patch.object(QtGui.QApplication, "widgetAt", lambda _: QtGui.QPushButton(form)):
            self.assertFalse(texture_head._is_at_work_in(area, gone))
        hidden = mock.Mock(isVisible=mock.Mock(side_effect=RuntimeError(DELETED)))
        area.setWidget(QtGui.QWidget())
        dock.setWidget(area)
        with mock.patch.object(room, "below", lambda *_: [hidden]):
            self.assertGreater(room.needed_width(dock, area), 0)
        self.assertRaises(RuntimeError, events.unless_deleted, mock.Mock(side_effect=RuntimeError("else")), 0)

    def test_a_panel_is_made_again_where_python_takes_a_widget_of_it_for_a_deleted_one(self):
        made = []

        def make():
            made.append(QtGui.QWidget())
            if len(made) < 3:
                raise RuntimeError(DELETED)
            return made[-1]

        before = len(deleted_widgets._taken)
        self.assertIs(deleted_widgets.made_alive(make), made[2])
        self.assertEqual(len(deleted_widgets._taken), before + 2)

        def fail():
            raise RuntimeError("something else")

        self.assertRaises(RuntimeError, deleted_widgets.made_alive, fail)
        del deleted_widgets._taken[before:]

    def test_a_part_that_python_takes_for_a_deleted_widget_is_found_wherever_it_is_named(self):
        class Taken(QtGui.QSpinBox):
            def metaObject(self):
                return QtGui.QPushButton.staticMetaObject

        form = QtGui.QWidget()
        form.part, form.other = QtGui.QLineEdit(form), QtGui.QComboBox()
        deleted_widgets.require_alive(form)
        form.other = Taken()
        self.assertRaisesRegex(RuntimeError, DELETED[-17:], deleted_widgets.require_alive, form)
        form.other = QtGui.QComboBox()
        part = form.part
        form.part.setParent(None)
        shiboken.delete(part)
        self.assertRaisesRegex(RuntimeError, DELETED[-17:], deleted_widgets.require_alive, form)

    def test_a_panel_that_cannot_be_shown_is_told_of_no_selection(self):
        operation, panel = driver.begin_texture(self.part)
        driver.accept(panel)
        del panel
        told = []

        class Refused(TexturePanel):
            def setupUi(self):
                raise RuntimeError("refused")

            def updateSelection(self):
                told.append(1)

        view = operation.ViewObject.Proxy
        view.make_panel = lambda obj, page: Refused(obj, False, page, view.getSelectionFactory())
        self.assertRaisesRegex(RuntimeError, "refused", view.setEdit)
        del view.make_panel
        FreeCADGui.Control.closeDialog()
        driver.select(self.part, "Face1")
        self.assertEqual(told, [])

    def test_of_a_texture_whose_document_is_closed(self):
        driver.begin_texture(self.part)
        FreeCAD.closeDocument(self.document.Name)
        self.assertNothingLeft()

    def test_of_copy_milling_and_its_modifier(self):
        driver.run_on(self.part, "PatchMill_CopyMilling")
        operation = self.document.getObject("CopyMilling")
        driver.accept(driver.panel_of(operation))
        self.assertNothingLeft()
        driver.run_on(operation, "PatchMill_DressupDcm")
        self.document.getObject("DressupDCM").ViewObject.Proxy.panel.accept()
        FreeCADGui.runCommand("Std_Undo")
        self.assertNothingLeft()

    def test_every_panel_and_window_is_made_again_where_a_widget_is_taken_for_a_deleted_one(self):
        operation, panel = driver.begin_texture(self.part)
        driver.accept(panel)
        del panel
        before = len(deleted_widgets._taken)
        for made, command in (
            (SimulatePanel, "PatchMill_Simulate"),
            (CheckPanel, "PatchMill_Check"),
            (PlayerPanel, "PatchMill_Play"),
            (PostDialog, "PatchMill_Post"),
            (MachineEditor, "PatchMill_Machines"),
            (DcmPanel, "PatchMill_DressupDcm"),
        ):
            with self.subTest(command), taken_once(made) as failed:
                driver.run_on(operation, command)
                self.assertEqual(len(failed), 1)
                if made in (PostDialog, MachineEditor):
                    (window,) = FreeCADGui.getMainWindow().findChildren(made)
                    window.reject()
                else:
                    self.assertTrue(driver.panel_open())
                    FreeCADGui.Control.closeDialog()
                driver.rest(0.2)
        self.assertEqual(len(deleted_widgets._taken), before + 6)
        del deleted_widgets._taken[before:]


def is_widget(thing):
    return issubclass(type(thing), QtGui.QWidget)  # which asks nothing of what may be deleted


@contextlib.contextmanager
def taken_once(made):
    """The first object of the class `made` fails as where PySide takes one of its widgets for a deleted one;
    gives the list that tells how many did."""
    failed = []
    begin = made.__init__

    def fail_once(self, *arguments, **named):
        if not failed:
            failed.append(made)
            raise RuntimeError(DELETED)
        begin(self, *arguments, **named)

    made.__init__ = fail_once
    try:
        yield failed
    finally:
        made.__init__ = begin


def main():
    return driver.run_tests(ClosedPanels)
