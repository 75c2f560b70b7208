"""A box for a plain number that takes either decimal sign, whatever the user's language, and shows no more
zeros than it needs.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from PySide import QtGui

from patchmill_gui.fields import unit_text


class NumberBox(QtGui.QDoubleSpinBox):
    """As QDoubleSpinBox, but a comma and a point both are the decimal sign."""

    def __init__(self):
        super().__init__()
        self.setKeyboardTracking(False)

    def _number(self, text):
        text = text.strip()
        for fixed in (self.prefix(), self.suffix()):
            text = text.replace(fixed.strip(), "") if fixed.strip() else text
        return unit_text.value_of(text, "")

    def validate(self, text, position):
        if text.strip() == self.specialValueText() and text.strip():
            return QtGui.QValidator.Acceptable, text, position
        number = self._number(text)
        if number is None:
            partial = not text.strip(" +-.,eE0123456789" + self.suffix() + self.prefix())
            return (
                QtGui.QValidator.Intermediate if partial else QtGui.QValidator.Invalid,
                text,
                position,
            )
        inside = self.minimum() <= number <= self.maximum()
        return QtGui.QValidator.Acceptable if inside else QtGui.QValidator.Intermediate, text, position

    def valueFromText(self, text):
        if text.strip() == self.specialValueText() and text.strip():
            return self.minimum()
        number = self._number(text)
        return self.value() if number is None else number

    def textFromValue(self, value):
        return unit_text.plain(value, self.decimals())
