"""The small parts of panels: widgets that Python takes for deleted ones, events that it takes for widgets,
and labels that show a document's names as they are, whatever markup is in them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import types
from unittest import mock

import driver
import FreeCADGui
from patchmill import InputError
from patchmill.operations import copy_milling
from patchmill.posting.proposal import Proposal
from patchmill_gui.fields import deleted_widgets, events
from patchmill_gui.forms import post_dialog, texture_summary, widgets
from patchmill_gui.panels.texture_head import RED, Head
from PySide import QtCore, QtGui

MARKUP = '<b>bold</b> <a href="https://a.b/c">here</a>'
DELETED = "Internal C++ object (PySide2.QtWidgets.QWidget) already deleted."


class Taken(QtGui.QWidget):
    """A widget that PySide takes for a deleted one."""

    def metaObject(self):
        raise RuntimeError(DELETED)


class TakenForALabel(QtGui.QWidget):
    """A widget that PySide takes for one of another class, which had its address."""

    def metaObject(self):
        return QtGui.QLabel.staticMetaObject


class OfATakenClass(QtGui.QWidget):
    """A widget whose class itself is taken for something else."""

    def metaObject(self):
        raise AttributeError("no metaObject")


class Living(driver.unittest.TestCase):
    def setUp(self):
        self.before = len(deleted_widgets._taken)
        self.addCleanup(lambda: deleted_widgets._taken.__delitem__(slice(self.before, None)))

    def makes(self, *made):
        """A function that gives these, one after the other."""
        left = list(made)
        return lambda: left.pop(0)

    def test_the_first_that_can_be_used(self):
        whole, other = QtGui.QWidget(), QtGui.QWidget()
        self.assertIs(deleted_widgets.living(self.makes(whole, other)), whole)
        self.assertEqual(len(deleted_widgets._taken), self.before)

    def test_the_address_of_one_that_cannot_is_left_taken(self):
        one, two, whole = Taken(), Taken(), QtGui.QWidget()
        self.assertIs(deleted_widgets.living(self.makes(one, two, whole)), whole)
        self.assertEqual(deleted_widgets._taken[self.before :], [one, two])

    def test_one_of_another_class_is_left_taken(self):
        one, two, whole = TakenForALabel(), OfATakenClass(), QtGui.QWidget()
        self.assertIs(deleted_widgets.living(self.makes(one, two, whole)), whole)
        self.assertEqual(deleted_widgets._taken[self.before :], [one, two])

    def test_one_with_a_part_that_only_an_attribute_names(self):
        form, whole = QtGui.QWidget(), QtGui.QWidget()
        form.spacing = Taken()
        self.assertIs(deleted_widgets.living(self.makes(form, whole)), whole)

    def test_one_with_such_a_part(self):
        outer, whole = QtGui.QWidget(), QtGui.QWidget()
        middle = QtGui.QWidget(outer)
        inner = Taken(middle)
        self.assertIs(deleted_widgets.living(self.makes(outer, whole)), whole)
        self.assertEqual(deleted_widgets._taken[self.before :], [outer])
        inner.setParent(None)
        self.assertIs(deleted_widgets.living(self.makes(outer)), outer)

    def test_ends_where_none_can(self):
        made = []

        def make():
            made.append(Taken())
            return made[-1]

        self.assertRaisesRegex(RuntimeError, "50 new widgets", deleted_widgets.living, make)
        self.assertEqual(len(made), deleted_widgets.MOST_TAKEN)

    def test_what_fails_otherwise_comes_out(self):
        def make():
            raise ZeroDivisionError

        self.assertRaises(ZeroDivisionError, deleted_widgets.living, make)


class Kinds(driver.unittest.TestCase):
    def test_of_events(self):
        none = QtCore.Qt.NoModifier
        for event in (
            QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_A, none, "a"),
            QtGui.QFocusEvent(QtCore.QEvent.FocusIn),
            QtCore.QEvent(QtCore.QEvent.FocusOut),
        ):
            self.assertEqual(events.kind_of(event), event.type())

    def test_of_what_is_no_event(self):
        for thing in (QtGui.QWidget(), QtCore.QObject(), None):
            self.assertIsNone(events.kind_of(thing))

    def test_filters_let_it_pass(self):
        guarded, taken = QtGui.QSpinBox(), QtGui.QWidget()
        widgets.guard_editors(guarded)
        (guard,) = guarded.findChildren(widgets._EditorGuard)
        for one in (guard, Head()):
            self.assertFalse(one.eventFilter(guarded, taken))


class Found(driver.unittest.TestCase):
    def test_what_is_in_a_widget_and_around_it(self):
        outer, inner, box = QtGui.QScrollArea(), QtGui.QScrollArea(), QtGui.QSpinBox()
        self.addCleanup(outer.deleteLater)
        outer.setWidget(inner)
        inner.setWidget(box)
        self.assertEqual(events.around(box, QtGui.QScrollArea), [outer, inner])
        self.assertEqual(events.below(outer, (QtGui.QSpinBox, QtGui.QDial)), [box])
        self.assertEqual(events.below(box, QtGui.QSpinBox) + events.around(outer, QtGui.QScrollArea), [])

    def test_what_is_taken_for_a_deleted_one_is_in_nothing(self):
        holder = mock.Mock(isAncestorOf=mock.Mock(side_effect=RuntimeError(DELETED)))
        with mock.patch.object(QtGui.QApplication, "allWidgets", lambda: [QtGui.QLabel()]):
            self.assertEqual(events.below(holder, QtGui.QLabel), [])


class Names(driver.BlockTest):
    """Of a document's objects, with markup in them."""

    def assertPlain(self, label):
        self.assertEqual(label.textFormat(), QtCore.Qt.PlainText, label.objectName() or label.text())
        self.assertEqual(label.text(), MARKUP)

    def test_in_labels_of_sentences(self):
        head, notice = Head(), widgets.Notice()
        head.show_error(MARKUP)
        self.assertEqual(head.state, RED)
        head.note(MARKUP)
        notice.setText(MARKUP)
        for label in (head.bar, head.hint, notice):
            self.assertPlain(label)

    def labels(self):
        return [one for one in FreeCADGui.getMainWindow().findChildren(QtGui.QLabel) if not one.isHidden()]

    def shown(self, rich):
        """What a reader sees of rich text."""
        document = QtGui.QTextDocument()
        document.setHtml(rich)
        return document.toPlainText()

    def test_in_rich_text(self):
        found = types.SimpleNamespace(
            dimples=5, patches=[], away_fraction=0.0, good_fraction=1.0, milled_fraction=1.0,
            whole=1.0, quality=1.0, whole_area=1.0, simulated=True,
        )  # fmt: skip
        head = Head()
        head._say = lambda *_: None
        head_verdict = "patchmill_gui.panels.texture_head.verdict_of"
        with mock.patch(head_verdict, return_value=(RED, "")):
            head.show_found(found, 10.0, None, [MARKUP])
        self.assertIn(MARKUP, self.shown(head.text.text()))
        self.assertIn(MARKUP, self.shown(widgets.noticed(MARKUP, RED)))
        planned = types.SimpleNamespace(
            path=types.SimpleNamespace(statistics=lambda: {"cut_turns": 1.0}), counts={"cut": 1},
            seconds=1.0, pacing=types.SimpleNamespace(verdict=types.SimpleNamespace(sentence=MARKUP)),
            dimples=types.SimpleNamespace(counts=lambda: {"cut": 1}), remarks=[MARKUP], free=[1],
        )  # fmt: skip
        self.assertEqual(self.shown(texture_summary.planned_summary(planned)).count(MARKUP), 2)

    def test_in_a_panel_that_refuses(self):
        driver.run_on(self.part, "PatchMill_CopyMilling")
        operation = self.document.getObject("CopyMilling")
        panel = driver.panel_of(operation)
        for name in ("RadialDepth", "Stock"):  # one with a row of the panel's own, one without
            error = InputError(name, MARKUP, "choose another one.")
            with mock.patch.object(copy_milling, "input_of", side_effect=error):
                panel.compute(False)
            labels = [one for one in self.labels() if MARKUP in one.text()]
            self.assertTrue(labels, name)
            for label in labels:
                self.assertEqual(label.textFormat(), QtCore.Qt.PlainText, name)
        panel.reject()

    def test_in_the_window_that_posts(self):
        driver.run_on(self.part, "PatchMill_CopyMilling")
        driver.accept(driver.panel_of(self.document.getObject("CopyMilling")))
        job = next(one for one in self.document.Objects if hasattr(one, "Fixtures"))
        machine = types.SimpleNamespace(data={"name": MARKUP}, key="own")
        pacing = types.SimpleNamespace(verdict=types.SimpleNamespace(sentence=MARKUP))
        plan = types.SimpleNamespace(pacing=pacing)
        window = post_dialog.PostDialog(job, Proposal("linuxcnc", "", "x.ngc", [plan], 1.0, machine))
        self.addCleanup(window.reject)
        window._say(MARKUP, widgets.ERROR_COLOUR)
        labels = [each for each in window.findChildren(QtGui.QLabel) if MARKUP in each.text()]
        self.assertEqual(len(labels), 3)
        for label in labels:
            self.assertEqual(label.textFormat(), QtCore.Qt.PlainText, label.text())


def main():
    return driver.run_tests(Living, Kinds, Found, Names)
