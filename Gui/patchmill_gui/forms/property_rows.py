"""Editors for FreeCAD properties that hold a number, a text or a vector, one class to a kind: what a row of a
property form is made of. Those that choose among what there is: choice_rows.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import FreeCADGui
from patchmill.properties.property_table import UNITS
from PySide import QtGui

from patchmill_gui.fields import unit_text
from patchmill_gui.fields.number_box import NumberBox
from patchmill_gui.fields.quantity_entry import QuantityEntry
from patchmill_gui.fields.deleted_widgets import living


PLACES = ("Origin", "MaskCentre")  # vectors that are lengths


class Row:
    """A property and its editor. `changed` is the editor's signal."""

    unit = ""  # of a number that does not say it itself
    on = True  # it is shown

    def __init__(self, editor, changed):
        self.editor = editor
        self.changed = changed
        self.error = None

    def show(self, obj):
        """Property to editor."""
        raise NotImplementedError

    def store(self, obj):
        """Editor to property, if they differ."""
        raise NotImplementedError


def assign(obj, name, value):
    """Sets a property of `obj`, if it has another value: given its own, too, an object counts as changed."""
    if getattr(obj, name) != value:
        setattr(obj, name, value)


class QuantityRow(Row):
    def __init__(self, name, obj, type_name):
        editor = living(lambda: FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox"))
        self.entry = QuantityEntry(editor, UNITS[type_name], type_name == "App::PropertyLength")
        editor.setProperty("binding", "%s.%s" % (obj.Name, name))
        self.name = name
        super().__init__(editor, self.entry.edited)

    def show(self, obj):
        formula = dict(obj.ExpressionEngine).get(self.name)
        self.entry.line.setReadOnly(formula is not None)
        value = obj.evalExpression(formula) if formula else getattr(obj, self.name)
        self.entry.show(float(getattr(value, "Value", value)))

    def store(self, obj):
        """Only what was edited."""
        self.entry.take()
        if self.entry.is_edited:
            setattr(obj, self.name, self.entry.value)
            self.entry.is_edited = False


class WholeRow(Row):
    """A whole number."""

    def __init__(self, name, obj):
        editor = QtGui.QSpinBox()
        editor.setRange(0, 10**6)
        editor.setKeyboardTracking(False)
        self.name = name
        super().__init__(editor, editor.valueChanged)

    def show(self, obj):
        self.editor.setValue(getattr(obj, self.name))

    def store(self, obj):
        assign(obj, self.name, self.editor.value())


class FlagRow(Row):
    def __init__(self, name, obj):
        editor = QtGui.QCheckBox()
        self.name = name
        super().__init__(editor, editor.stateChanged)

    def show(self, obj):
        self.editor.setChecked(getattr(obj, self.name))

    def store(self, obj):
        assign(obj, self.name, self.editor.isChecked())


class TextRow(Row):
    def __init__(self, name, obj):
        editor = QtGui.QLineEdit()
        self.name = name
        super().__init__(editor, editor.editingFinished)

    def show(self, obj):
        self.editor.setText(str(getattr(obj, self.name)))

    def store(self, obj):
        assign(obj, self.name, self.editor.text())
        self.editor.setModified(False)  # what was typed is taken: the next value may be shown


class LinesRow(Row):
    """A list of texts, one to a line."""

    def __init__(self, name, obj):
        editor = QtGui.QPlainTextEdit()
        editor.setMaximumHeight(60)
        self.name = name
        super().__init__(editor, editor.textChanged)

    def _lines(self):
        return [line.strip() for line in self.editor.toPlainText().splitlines() if line.strip()]

    def show(self, obj):
        if self._lines() != list(getattr(obj, self.name)):  # a new text puts the cursor at its beginning
            self.editor.setPlainText("\n".join(getattr(obj, self.name)))

    def store(self, obj):
        assign(obj, self.name, self._lines())
        self.editor.document().setModified(False)


class FileRow(TextRow):
    """A file name with a button that opens a dialog."""

    def __init__(self, name, obj):
        super().__init__(name, obj)
        self.line = self.editor
        self.editor = QtGui.QWidget()
        layout = QtGui.QHBoxLayout(self.editor)
        layout.setContentsMargins(0, 0, 0, 0)
        button = QtGui.QToolButton()
        button.setText("…")
        layout.addWidget(self.line)
        layout.addWidget(button)
        button.clicked.connect(self._choose)

    def _choose(self):
        name, _ = QtGui.QFileDialog.getOpenFileName(self.editor)
        if name:
            self.line.setText(name)
            self.line.editingFinished.emit()

    def show(self, obj):
        self.line.setText(getattr(obj, self.name))

    def store(self, obj):
        assign(obj, self.name, self.line.text())
        self.line.setModified(False)


class VectorRow(Row):
    """A direction, or a place in the user's unit of length."""

    def __init__(self, name, obj):
        editor = QtGui.QWidget()
        layout = QtGui.QHBoxLayout(editor)
        layout.setContentsMargins(0, 0, 0, 0)
        self.boxes = [NumberBox() for _ in range(3)]
        self.name = name
        self.unit, self.factor = unit_text.user_unit("mm" if name in PLACES else "")
        for box in self.boxes:
            box.setRange(-1e6, 1e6)
            box.setDecimals(6)
            box.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
            layout.addWidget(box)
        self.shown = None
        super().__init__(editor, [box.valueChanged for box in self.boxes])

    def _values(self):
        return [box.value() for box in self.boxes]

    def show(self, obj):
        for box, value in zip(self.boxes, getattr(obj, self.name)):
            box.setValue(value / self.factor)
        self.shown = self._values()

    def store(self, obj):
        """Only what was edited: the boxes' values are rounded."""
        if self._values() != self.shown:
            pairs = zip(self.boxes, self.shown, getattr(obj, self.name))
            kept = (own if box.value() == shown else self.factor * box.value() for box, shown, own in pairs)
            setattr(obj, self.name, FreeCAD.Vector(*kept))
            self.shown = self._values()
