"""Whether a user is in the middle of a text: fields are not rewritten under the hand that types in them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from functools import partial

from PySide import QtGui

from patchmill_gui.fields.events import unless_deleted


def is_typed_in(editor):
    """Whether the keyboard is in a text of `editor`, a widget, that was begun and not ended."""
    if isinstance(editor, QtGui.QPlainTextEdit):
        return editor.hasFocus() and editor.document().isModified()
    lines = [editor] if isinstance(editor, QtGui.QLineEdit) else editor.findChildren(QtGui.QLineEdit)
    return any(unless_deleted(partial(_is_begun, line), False) for line in lines)


def _is_begun(line):
    return line.hasFocus() and line.isModified() and not _shows_its_value(line)


def _shows_its_value(line):
    """Whether a line is that of a spin box, and says no other number than the box has."""
    box = line.parent()
    if not isinstance(box, (QtGui.QSpinBox, QtGui.QDoubleSpinBox)):
        return False
    return line.text() == box.prefix() + box.textFromValue(box.value()) + box.suffix()
