"""Editors for FreeCAD properties that hold a number, a text or a vector, one class to a kind: what a row of a
property form is made of. Those that choose among what there is: choice_rows.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import FreeCADGui
from PySide import QtGui

from patchmill_gui.forms.resources import native

QUANTITIES = {"App::Property" + kind for kind in ("Length", "Distance", "Angle", "Speed")}


class Row:
    """A property and its editor. `changed` is the editor's signal."""

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
    def __init__(self, name, obj):
        editor = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        self.box = native("widgets").QuantitySpinBox(editor, obj, name)
        self.shown = None
        super().__init__(editor, editor.valueChanged)

    def show(self, obj):
        update = getattr(self.box, "updateSpinBox", None) or self.box.updateWidget
        update()
        self.shown = self.editor.property("text")

    def store(self, obj):
        """Only what was edited: the text is rounded, and would round the property."""
        if self.editor.property("text") != self.shown:
            self.box.updateProperty()
            self.shown = self.editor.property("text")


class NumberRow(Row):
    def __init__(self, name, obj, whole):
        editor = QtGui.QSpinBox() if whole else QtGui.QDoubleSpinBox()
        editor.setRange(-(10**6) if not whole else 0, 10**6)
        if not whole:
            editor.setDecimals(4)
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


class LinesRow(Row):
    """A list of texts, one to a line."""

    def __init__(self, name, obj):
        editor = QtGui.QPlainTextEdit()
        editor.setMaximumHeight(60)
        self.name = name
        super().__init__(editor, editor.textChanged)

    def show(self, obj):
        self.editor.setPlainText("\n".join(getattr(obj, self.name)))

    def store(self, obj):
        lines = [line.strip() for line in self.editor.toPlainText().splitlines() if line.strip()]
        assign(obj, self.name, lines)


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


class VectorRow(Row):
    def __init__(self, name, obj):
        editor = QtGui.QWidget()
        layout = QtGui.QHBoxLayout(editor)
        layout.setContentsMargins(0, 0, 0, 0)
        self.boxes = [QtGui.QDoubleSpinBox() for _ in range(3)]
        self.name = name
        for box in self.boxes:
            box.setRange(-1e6, 1e6)
            box.setDecimals(3)
            box.setKeyboardTracking(False)
            box.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
            layout.addWidget(box)
        super().__init__(editor, [box.valueChanged for box in self.boxes])

    def show(self, obj):
        for box, value in zip(self.boxes, getattr(obj, self.name)):
            box.setValue(value)

    def store(self, obj):
        value = FreeCAD.Vector(*(box.value() for box in self.boxes))
        if (getattr(obj, self.name) - value).Length > 1e-3:
            setattr(obj, self.name, value)
