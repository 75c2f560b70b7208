"""Small things that panels are made of: translated texts, labels that wrap, editors that fit FreeCAD's narrow
panel, a progress bar, a pointer that says wait.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib
import html

import FreeCAD
from FreeCAD import Qt
from PySide import QtCore, QtGui

from patchmill_gui.fields.deleted_widgets import DELETED, forget_closed_panels
from patchmill_gui.fields.events import kind_of
from patchmill_gui.fields.quantity_entry import QuantityEntry

# under white text, so that sentences are read as well in a dark theme as in a light one (contrast above 5)
GOOD_COLOUR, DOUBT_COLOUR, ERROR_COLOUR = "#2e7d32", "#8a5a00", "#b71c1c"


def translate(context, text):
    """`text` in the language of FreeCAD's interface. Both are literals, or marked by QT_TRANSLATE_NOOP where
    they are written: Qt's lupdate finds them so (tools/translations)."""
    return Qt.translate(context, text)


def let_shrink(editor):
    """FreeCAD's panel is narrow: a combo box must not be as wide as its longest choice."""
    for widget in [editor] + editor.findChildren(QtGui.QWidget):
        widget.setMinimumWidth(30)
        if isinstance(widget, QtGui.QComboBox):
            widget.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)


class _EditorGuard(QtCore.QObject):
    """Lets the wheel scroll the panel, so that it never edits what the pointer passes, and lets Return end a
    number, not the panel: FreeCAD would press OK."""

    def eventFilter(self, editor, event):
        if kind_of(event) == QtCore.QEvent.Wheel:
            event.ignore()  # then it goes to the widget around the editor
            return True
        if kind_of(event) == QtCore.QEvent.KeyPress and isinstance(editor, QtGui.QAbstractSpinBox):
            if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter):
                entry = editor.findChild(QuantityEntry)
                if entry is not None:
                    entry.commit()
                editor.interpretText()
                editor.selectAll()
                return True
        return False


def guard_editors(widget):
    """The wheel edits nothing in `widget`, itself included, and Return in a number is no OK. Where Python
    still knows a deleted editor of the same address, that is forgotten first; what cannot be told from a
    deleted one even then stays without a guard."""
    if not _guard_living(widget):
        forget_closed_panels()
        _guard_living(widget)


def _guard_living(widget):
    """Guards the editors that Python can use; whether those are all."""
    kinds = (QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QAbstractSlider)
    all_alive = True
    for each in [widget] + widget.findChildren(QtGui.QWidget):
        if isinstance(each, kinds) and not isinstance(each, QtGui.QScrollBar):
            try:
                if each.findChild(_EditorGuard) is None:
                    each.installEventFilter(_EditorGuard(each))
            except RuntimeError as gone:
                if DELETED not in str(gone):
                    raise
                all_alive = False
    return all_alive


def button_number(buttons):
    """Standard buttons as the number that a task panel gives FreeCAD: PySide6 has enumerations instead."""
    return int(getattr(buttons, "value", buttons))


class WrappingLabel(QtGui.QLabel):
    """A label that breaks its text at the width that it gets, and is as high as that takes: scroll areas do
    not ask what they hold how high it is at a width, and give rows of two lines and sentences too little."""

    def __init__(self, text=""):
        super().__init__(text)
        self.setWordWrap(True)

    def setText(self, text):
        super().setText(text)
        if self.isVisible():
            self._take_height()

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self._take_height()

    def _take_height(self):
        self.setMinimumHeight(0)  # or it would not be asked for less than that
        self.setMinimumHeight(max(0, self.heightForWidth(self.width())) if self.text() else 0)


def wrapping_label(text=""):
    """A label that breaks its text at whatever width the panel has, and asks for none itself."""
    label = QtGui.QLabel(text)
    label.setWordWrap(True)
    label.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Preferred)
    return label


def plain_label(text=""):
    """A wrapping_label for sentences with names of others in them, of a document's objects or of a machine
    file: those are no markup."""
    label = wrapping_label(text)
    label.setTextFormat(QtCore.Qt.PlainText)
    return label


class Notice(WrappingLabel):
    """A sentence in white on a colour, hidden while there is none. Names of a document's objects are no
    markup in it."""

    def __init__(self, colour=ERROR_COLOUR):
        super().__init__()
        self.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Preferred)
        self.setTextFormat(QtCore.Qt.PlainText)
        self.setStyleSheet("color: white; background: %s; padding: 3px; border-radius: 3px" % colour)
        self.hide()

    def setText(self, text):
        super().setText(text)
        self.setVisible(bool(text))


class WrappingButton(QtGui.QPushButton):
    """A button whose text, which text() gives as it was set, breaks at the button's width. `broken`: it has
    other lines than before."""

    broken = QtCore.Signal()
    PADDING = 6  # pixels

    def __init__(self, text):
        super().__init__(text)
        self._text = text
        self.setStyleSheet("text-align: left; padding: %dpx" % self.PADDING)
        self.setMinimumWidth(30)

    def text(self):
        return self._text

    def resizeEvent(self, event):
        super().resizeEvent(event)
        lines = "\n".join(self._lines(self.width() - 2 * self.PADDING - 2))
        if lines != super().text():
            self.setText(lines)
            self.broken.emit()

    def _lines(self, width):
        """Parts of the text that fit in a width, broken between words, or anywhere as Japanese is."""
        layout = QtGui.QTextLayout(self._text, self.font())
        option = QtGui.QTextOption()
        option.setWrapMode(QtGui.QTextOption.WrapAtWordBoundaryOrAnywhere)
        layout.setTextOption(option)
        layout.beginLayout()
        line = layout.createLine()
        while line.isValid():
            line.setLineWidth(max(20, width))
            yield self._text[line.textStart() : line.textStart() + line.textLength()].strip()
            line = layout.createLine()
        layout.endLayout()


def noticed(text, colour):
    """Rich text of a sentence in white on a colour."""
    style = "color:white; background-color:" + colour
    return '<span style="%s">&nbsp;%s&nbsp;</span>' % (style, html.escape(text))


@contextlib.contextmanager
def busy_cursor():
    """The pointer says that the window does not answer meanwhile."""
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        yield
    finally:
        QtGui.QApplication.restoreOverrideCursor()


class ProgressBar(QtGui.QProgressBar):
    """Shows a share of the work and the time left; hidden until there is something to show."""

    def __init__(self):
        super().__init__()
        self.setRange(0, 1000)
        self.hide()

    def begin(self, known=True):
        """At nothing done; `known`: false until the first share is known."""
        self.setRange(0, 1000 if known else 0)
        self.setValue(0)
        self.resetFormat()
        self.show()

    def show_share(self, share, seconds):
        """`share` of the work is done, 0 to 1; about so many seconds are left: at first nobody knows."""
        self.setRange(0, 1000)
        self.setValue(int(1000 * share))
        if self.value():
            self.setFormat(translate("PatchMill", "%p % · {:.0f} s left").format(seconds))
        else:
            self.resetFormat()
        self.show()


def one_shot(call):
    """A timer that calls once after each start."""
    timer = QtCore.QTimer()
    timer.setSingleShot(True)
    timer.timeout.connect(call)
    return timer


def user_unit(unit):
    """(unit, factor) in which the user's FreeCAD shows what is in `unit`, such as "mm/s"."""
    _, factor, shown = FreeCAD.Units.Quantity(1.0, unit).getUserPreferred()
    return shown, 1.0 / factor
