"""No control of any panel lies past what its dock shows, or is lower than its sentence or number takes,
nothing scrolls sideways, no label shows its key's ampersand: at 1024 by 768, in a dock that was made narrow
before, in every language, all folds open.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import tempfile

import driver
import FreeCADGui
from patchmill.advice import remedies
from patchmill.advice.found import Assessment, PatchQuality
from patchmill_gui.app.core_window import CoreWindow
from patchmill_gui.fields.events import unless_deleted
from patchmill_gui.forms import machine_editor, post_dialog
from patchmill_gui.fields.deleted_widgets import forget_closed_panels
from patchmill_gui.forms.widgets import WrappingLabel
from patchmill_gui.panels.report_panel import ReportPanel
from PySide import QtCore, QtGui

SHOWN = (
    QtGui.QLabel, QtGui.QAbstractButton, QtGui.QLineEdit, QtGui.QComboBox, QtGui.QAbstractSpinBox,
    QtGui.QAbstractItemView, QtGui.QPlainTextEdit, QtGui.QAbstractSlider, QtGui.QProgressBar, QtGui.QGroupBox,
)  # fmt: skip
NARROW = 180  # pixels
MOST_BETWEEN = 8
MOST_TAKEN = 5  # widgets of a dock that PySide may take for deleted ones
OTHERS = ("PlanarTexture", "PyramidTexture", "CalibrationPatch")
WIDEST = 400  # that a panel may ask for, of a screen of 1024


def dock():
    return driver.task_dock()


def seen(widgets):
    """Those of some widgets that are visible. Of one that PySide takes for a deleted one nobody can say:
    there may be a few."""
    told = [(each, unless_deleted(each.isVisible, None)) for each in widgets]
    assert sum(visible is None for _, visible in told) <= MOST_TAKEN, "too many are taken for deleted ones"
    return [each for each, visible in told if visible]


def across(widget, around):
    """(left, right) of a widget in one that it is in [pixels]."""
    left = widget.mapTo(around, QtCore.QPoint(0, 0)).x()
    return left, left + widget.width()


def cut_off(around):
    """(what, its left, its right, what is seen to) of all that a dock shows in part: of a control in a scroll
    area past its viewport, of a scroll area past the dock."""
    forget_closed_panels()  # PySide gives a new widget the Python object of a deleted one
    found, kept = [], []  # it takes a widget for deleted when the last name of its parent goes
    for area in seen(around.findChildren(QtGui.QScrollArea)):
        contents, viewport = area.widget(), area.viewport()
        kept += [contents, viewport]
        inside = [(each, viewport) for each in seen(contents.findChildren(QtGui.QWidget))]
        for each, limit in [(area, around)] + inside:
            if (each is area or isinstance(each, SHOWN)) and not each.isWindow():
                left, right = across(each, limit)
                if left < 0 or right > limit.width():
                    text = each.text() if hasattr(each, "text") else ""
                    name = each.objectName() or each.metaObject().className()
                    found.append((name, text, left, right, limit.width()))
    return found


def scrolling_sideways(around):
    """How far what is in each scroll area of a dock is wider than it [pixels]."""
    areas = seen(around.findChildren(QtGui.QScrollArea))
    bars = [each.horizontalScrollBar().maximum() for each in areas]
    return [most for most in bars if most > 0]


def ampersands(around):
    """Texts of labels that show an ampersand, for want of a field that its key would lead to."""
    labels = seen(around.findChildren(QtGui.QLabel))
    return [each.text() for each in labels if each.text().startswith("&") and each.buddy() is None]


def too_low(around):
    """(text or name, height, what it takes) of labels and fields that are cut off at their lower side."""
    found = []
    for each in seen(around.findChildren(QtGui.QWidget)):
        if isinstance(each, (QtGui.QLabel, QtGui.QAbstractSpinBox, QtGui.QComboBox)):
            label = isinstance(each, QtGui.QLabel)
            wraps = label and each.wordWrap() and each.text()
            takes = each.heightForWidth(each.width()) if wraps else each.minimumSizeHint().height()
            if each.height() < takes:
                found.append((each.text() if label else each.objectName(), each.height(), takes))
    return found


def gaps(form):
    """(name of the row below, its distance from the row above [pixels]) where a PropertyForm leaves more room
    between two rows of a group than MOST_BETWEEN, as if something were missing there."""
    found = []
    for group in form.groups.values():
        lowest = None
        for name, row in form.rows.items():
            parts = [part for part in (row.label, row.editor, row.error) if part.isVisible()]
            if row.group is group and parts:
                top = min(part.y() for part in parts)
                if lowest is not None and top - lowest > MOST_BETWEEN:
                    found.append((name, top - lowest))
                lowest = max(part.y() + part.height() for part in parts)
    return found


class Room(driver.BlockTest):
    def setUp(self):
        window = FreeCADGui.getMainWindow()
        window.showNormal()
        window.resize(1024, 768)
        self.document, self.part = driver.new_document(driver.wavy_block(8.0, 6.0))

    def tearDown(self):
        super().tearDown()
        FreeCADGui.setLocale("English")

    def narrow(self):
        """As a user who leaves more room to the view, before a panel is opened."""
        FreeCADGui.getMainWindow().resizeDocks([dock()], [NARROW], QtCore.Qt.Horizontal)
        driver.rest(0.2)

    def check(self, what):
        driver.rest(0.6)
        # where the machine is busy
        driver.wait(lambda: not (cut_off(dock()) or scrolling_sideways(dock()) or too_low(dock())), 20)
        self.assertEqual(cut_off(dock()), [], what)
        self.assertEqual(scrolling_sideways(dock()), [], what)
        self.assertEqual(ampersands(dock()), [], what)
        self.assertEqual(too_low(dock()), [], what)
        self.assertLess(dock().width(), WIDEST, what)

    def other_textures(self, language):
        for name in OTHERS:
            self.narrow()
            _, panel = driver.begin_texture(self.part, "PatchMill_" + name)
            panel.page.advanced.heading.setChecked(True)
            for group in panel.page.properties.groups.values():
                group.heading.setChecked(True)
            self.check("%s, %s" % (language, name))
            panel.reject()

    def without_command(self, language, operation):
        """A panel that asks for a file first, and the windows; one of them is shown without a core."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.narrow()
        FreeCADGui.Control.showDialog(ReportPanel(operation, folder.name))
        self.check("%s, report" % language)
        FreeCADGui.Control.closeDialog()
        core = CoreWindow()
        core.show()
        for window in (
            core,
            post_dialog.show(operation.Proxy.getJob(operation)),
            machine_editor.show("table-table-ac"),
        ):
            driver.rest(0.3)
            self.assertEqual(ampersands(window), [], language)
            window.close()

    def panels(self, language):
        FreeCADGui.setLocale(language)
        self.other_textures(language)
        self.narrow()
        operation, panel = driver.begin_texture(self.part)
        self.check(language + ", texture")
        panel.page.advanced.heading.setChecked(True)
        for group in panel.page.properties.groups.values():
            group.heading.setChecked(True)
        self.check(language + ", texture, all")
        self.assertEqual(gaps(panel.page.properties), [], language)
        panel.page.advanced.heading.setChecked(False)
        driver.set_quantity(panel, "Spacing", 4.0)
        self.assertTrue(driver.wait(lambda: panel.error is not None, 60))
        self.check(language + ", texture, refused")
        driver.set_quantity(panel, "Spacing", 0.5)
        self.assertTrue(driver.wait(lambda: panel.error is None, 60))
        self.assertTrue(driver.ready(panel))
        driver.accept(panel)
        for command in ("PatchMill_Simulate", "PatchMill_Check", "PatchMill_Play"):
            self.narrow()
            driver.run_on(operation, command)
            self.check("%s, %s" % (language, command))
            FreeCADGui.Control.closeDialog()
        self.without_command(language, operation)
        self.narrow()
        driver.run_on(self.part, "PatchMill_CopyMilling")
        milling = self.document.getObject("CopyMilling")
        panel = driver.panel_of(milling)
        panel.form_rows.rows["AxialDepth"].editor.setProperty("rawValue", 4.0)
        self.check(language + ", copy milling")
        rows = panel.form_rows.rows.values()
        self.assertTrue(all(row.editor.isVisible() for row in rows if row.group.heading.isChecked()))
        driver.accept(panel)
        self.narrow()
        driver.run_on(milling, "PatchMill_Simulate")
        self.check(language + ", simulated milling")
        FreeCADGui.Control.closeDialog()
        self.narrow()
        driver.run_on(milling, "PatchMill_DressupDcm")
        self.check(language + ", DCM")
        self.document.getObject("DressupDCM").ViewObject.Proxy.panel.reject()

    def test_english(self):
        self.panels("English")

    def test_german(self):
        self.panels("German")

    def test_japanese(self):
        self.panels("Japanese")

    def test_sentences_in_a_scroll_area_are_as_high_as_their_lines(self):
        area, page = QtGui.QScrollArea(), QtGui.QWidget()
        label = WrappingLabel("as many words as it takes " * 6)
        self.addCleanup(area.deleteLater)
        layout = QtGui.QVBoxLayout(page)
        for each in (label, QtGui.QPushButton("1"), QtGui.QPushButton("2")):
            layout.addWidget(each)
        area.setWidgetResizable(True)
        area.setWidget(page)
        area.show()
        line = label.fontMetrics().height()
        for width in (180, 600, 180):
            area.resize(width, 60)
            driver.rest(0.3)
            around = QtCore.QRect(0, 0, label.width(), 10000)
            lines = label.fontMetrics().boundingRect(around, QtCore.Qt.TextWordWrap, label.text()).height()
            self.assertLess(abs(label.height() - lines), line, width)

    def test_what_helps_is_read_whole(self):
        fields = dict(remedies.LAID, minimum_tilt=10.0, mapping="On surface")
        given = (fields, Assessment(1403, 0.97, {}, [PatchQuality((0.0, 0.0, 0.0), 75.0, 1.0)]))
        for language in ("English", "German", "Japanese"):
            FreeCADGui.setLocale(language)
            self.narrow()
            _, panel = driver.begin_texture(self.part)
            head = panel.advising.head
            for work in (panel.advising.assessing, panel.advising.helping):
                work.cancel()  # or what they find would take the place of what is offered here
            axis = (1.0, 0.0, 0.0)
            head.offer([remedies.Remedy(kind, *given, axis, 30.0) for kind in ("along", "incline")])
            driver.rest(0.6)
            for button in head.buttons:
                lines = QtGui.QPushButton.text(button).split("\n")
                self.assertGreater(len(lines), 1)
                self.assertEqual("".join(lines).replace(" ", ""), button.text().replace(" ", ""))
                wide = max(button.fontMetrics().horizontalAdvance(line) for line in lines)
                self.assertLess(wide, button.width())
                self.assertLess(button.geometry().bottom(), head.height())
                self.assertGreaterEqual(button.height(), len(lines) * button.fontMetrics().height())
            panel.reject()

    def test_a_dock_that_is_wide_enough_stays_as_it_is(self):
        FreeCADGui.getMainWindow().resizeDocks([dock()], [450], QtCore.Qt.Horizontal)
        driver.rest(0.2)
        before = dock().width()
        driver.begin_texture(self.part)
        driver.rest(0.6)
        self.assertEqual(dock().width(), before)


def main():
    return driver.run_tests(Room)
