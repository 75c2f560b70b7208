"""Entry of a quantity: FreeCAD's own spin box, so that expressions work in it, with the text of unit_text.

What was not edited is not stored: text is rounded, and would round the property. A number that is being typed
is taken when the typing rests or ends.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import FreeCAD
from PySide import QtCore, QtGui

from patchmill_gui.fields import unit_text
from patchmill_gui.fields.events import kind_of

REST_MS = 350  # without a key: what was typed so far is meant
_ENDS = (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter, QtCore.Qt.Key_Tab, QtCore.Qt.Key_Backtab)
_STEPS = (QtCore.Qt.Key_Up, QtCore.Qt.Key_Down, QtCore.Qt.Key_PageUp, QtCore.Qt.Key_PageDown)


def host_decimals():
    """Decimals of FreeCAD's own spin boxes."""
    return FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").GetInt("Decimals", 2)


class QuantityEntry(QtCore.QObject):
    """What happens in one spin box `box` of a quantity of `kind` (see unit_text.KINDS) between `show` and
    `taken`. `value` is None before the first. `edited` comes after each change by the user."""

    edited = QtCore.Signal()

    def __init__(self, box, kind, not_negative):
        super().__init__(box)
        self.box, self.kind, self.not_negative = box, kind, not_negative
        self.value = None
        self.is_edited = False
        self._own = self._stepping = self._typing = False
        self.line = box.findChild(QtGui.QLineEdit)
        if kind:
            box.setProperty("unit", kind)
        box.setKeyboardTracking(False)
        box.installEventFilter(self)
        self.line.textEdited.connect(self._typed)
        box.valueChanged.connect(self._changed)
        self._rest = QtCore.QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.timeout.connect(self._take_text)

    def show(self, value):
        """Shows `value`, as not edited. In the field with the keyboard's focus nothing is rewritten: whoever
        types slowly goes on, and what is selected stays so."""
        if self.line.hasFocus() and self.value is not None:
            if abs(value - self.value) <= 1e-9 * max(1.0, abs(value)):
                return
        self.value, self.is_edited, self._typing = value, False, False
        self._rest.stop()
        self._display()

    def _display(self):
        self._own = True
        self.box.setProperty("rawValue", self.value)
        self.line.setText(unit_text.text_of(self.value, self.kind))
        self._own = False

    def take(self):
        """What was typed so far is taken. While the keyboard is in the field its text stays as it is: whoever
        types slowly goes on in it."""
        if not self.line.hasFocus():
            self.commit()
        elif self._typing:
            self._rest.stop()
            self._take_text()

    def commit(self):
        """What was typed is taken, or taken back if it cannot be read, and shown as a value."""
        if self._typing:
            self._rest.stop()
            self._take_text()
            self._typing = False
            self._display()

    def _typed(self, _):
        self._typing = True
        self._rest.start(REST_MS)

    def _take_text(self):
        value = unit_text.value_of(self.line.text(), self.kind)
        if value is not None:
            self._take(value)

    def _take(self, value):
        value = max(0.0, value) if self.not_negative else value
        if value != self.value:
            self.value, self.is_edited = value, True
            self.edited.emit()

    def _changed(self, *_):
        """The spin box has another value: by a step, by its formula, or set by a program; or only because it
        has read the rounded text again."""
        if self._own or self._typing or self.value is None:
            return
        value = float(self.box.property("rawValue"))
        if self._stepping:
            up = value > self.value
            self._take(stepped(self.value, self.kind, up) if value != self.value else value)
        elif not self._is_rounded(value):
            self._take(value)
        self._display()

    def _is_rounded(self, value):
        """Whether `value` is what a text of this one says: ours, or one with FreeCAD's decimals."""
        _, factor = unit_text.user_unit(self.kind)
        ours = 0.51 * factor * 10.0 ** -unit_text.decimals_of(self.value / factor)
        own = factor * round(self.value / factor, host_decimals())
        return abs(value - self.value) <= ours or abs(value - own) <= 1e-9 * factor

    def eventFilter(self, _, event):
        kind = kind_of(event)
        if kind == QtCore.QEvent.FocusOut:
            self.commit()
        elif kind == QtCore.QEvent.KeyPress:
            if event.key() in _ENDS + _STEPS:
                self.commit()
            self._stepping = event.key() in _STEPS
        elif kind == QtCore.QEvent.MouseButtonPress:  # on the arrows; the text is a widget of its own
            self.commit()
            self._stepping = True
        elif kind in (QtCore.QEvent.KeyRelease, QtCore.QEvent.MouseButtonRelease):
            QtCore.QTimer.singleShot(0, self._stepped)
        return False

    def _stepped(self):
        self._stepping = False


def stepped(value, kind, up):
    """`value` one step up or down: a tenth of its leading digit, as the user's unit shows it."""
    _, factor = unit_text.user_unit(kind)
    shown = value / factor
    size = abs(shown) if shown else (1.0 if kind in ("deg", "") else 0.1)
    step = 10.0 ** (math.floor(math.log10(size) + 1e-9) - 1)
    return round(shown / step + (1 if up else -1)) * step * factor
