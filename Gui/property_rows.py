"""Editors for FreeCAD properties, one class to a kind: what a row of a property form is made of.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from patchmill import axis_field, machines

from patchmill_gui.resources import native

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


class ChoiceRow(Row):
    def __init__(self, name, obj):
        editor = QtGui.QComboBox()
        editor.addItems(obj.getEnumerationsOfProperty(name))
        self.name = name
        super().__init__(editor, editor.currentIndexChanged)

    def show(self, obj):
        self.editor.setCurrentText(getattr(obj, self.name))

    def store(self, obj):
        _assign(obj, self.name, self.editor.currentText())


class MachineRow(Row):
    """The machine files at hand; the empty name is 'none'."""

    def __init__(self, name, obj):
        editor = QtGui.QComboBox()
        timed = hasattr(obj, "Strategy")  # a texture
        editor.addItem("(none: phase not judged)" if timed else "(none: no limits)", "")
        for key in machines.names():
            editor.addItem(key, key)
        self.name = name
        super().__init__(editor, editor.currentIndexChanged)

    def show(self, obj):
        key = getattr(obj, self.name)
        if self.editor.findData(key) < 0:
            self.editor.addItem(key, key)
        self.editor.setCurrentIndex(self.editor.findData(key))

    def store(self, obj):
        _assign(obj, self.name, self.editor.currentData())


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
        _assign(obj, self.name, self.editor.value())


class FlagRow(Row):
    def __init__(self, name, obj):
        editor = QtGui.QCheckBox()
        self.name = name
        super().__init__(editor, editor.stateChanged)

    def show(self, obj):
        self.editor.setChecked(getattr(obj, self.name))

    def store(self, obj):
        _assign(obj, self.name, self.editor.isChecked())


class TextRow(Row):
    def __init__(self, name, obj):
        editor = QtGui.QLineEdit()
        self.name = name
        super().__init__(editor, editor.editingFinished)

    def show(self, obj):
        self.editor.setText(str(getattr(obj, self.name)))

    def store(self, obj):
        _assign(obj, self.name, self.editor.text())


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
        _assign(obj, self.name, lines)


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
        _assign(obj, self.name, self.line.text())


class ObjectRow(Row):
    """One of the document's objects that fit, with a shape if nothing else is asked, or none."""

    def __init__(self, name, obj, fits=lambda other: hasattr(other, "Shape")):
        editor = QtGui.QComboBox()
        editor.addItem("(none)", "")
        for other in obj.Document.Objects:
            if fits(other) and other is not obj and obj not in other.OutListRecursive:
                editor.addItem(other.Label, other.Name)
        self.name = name
        super().__init__(editor, editor.currentIndexChanged)

    def show(self, obj):
        linked = getattr(obj, self.name)
        self.editor.setCurrentIndex(max(0, self.editor.findData(linked.Name if linked else "")))

    def store(self, obj):
        name = self.editor.currentData()
        _assign(obj, self.name, obj.Document.getObject(name) if name else None)


class ObjectListRow(Row):
    """Any of the document's sketches and wires, ticked in a list."""

    def __init__(self, name, obj):
        editor = QtGui.QListWidget()
        editor.setMaximumHeight(80)
        for other in obj.Document.Objects:
            shape = getattr(other, "Shape", None)
            if shape is not None and shape.Edges and not shape.Faces:
                item = QtGui.QListWidgetItem(other.Label, editor)
                item.setData(QtCore.Qt.UserRole, other.Name)
                item.setCheckState(QtCore.Qt.Unchecked)
        self.name = name
        super().__init__(editor, editor.itemChanged)

    def _items(self):
        return [self.editor.item(i) for i in range(self.editor.count())]

    def show(self, obj):
        linked = {other.Name for other in getattr(obj, self.name)}
        for item in self._items():
            on = item.data(QtCore.Qt.UserRole) in linked
            item.setCheckState(QtCore.Qt.Checked if on else QtCore.Qt.Unchecked)

    def store(self, obj):
        names = [
            item.data(QtCore.Qt.UserRole)
            for item in self._items()
            if item.checkState() == QtCore.Qt.Checked
        ]
        if names != [other.Name for other in getattr(obj, self.name)]:
            setattr(obj, self.name, [obj.Document.getObject(name) for name in names])


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


def _assign(obj, name, value):
    if getattr(obj, name) != value:
        setattr(obj, name, value)


def row_for(kind, name, obj):
    """The Row for a property of FreeCAD type `kind`."""
    if name == "Machine":
        return MachineRow(name, obj)
    if name == "PostureField":
        return ObjectRow(name, obj, axis_field.gives_field)
    if kind in QUANTITIES:
        return QuantityRow(name, obj)
    if kind in ("App::PropertyInteger", "App::PropertyIntegerConstraint"):
        return NumberRow(name, obj, True)
    simple = {
        "App::PropertyEnumeration": ChoiceRow,
        "App::PropertyBool": FlagRow,
        "App::PropertyVector": VectorRow,
        "App::PropertyFile": FileRow,
        "App::PropertyFileIncluded": FileRow,
        "App::PropertyLink": ObjectRow,
        "App::PropertyLinkListGlobal": ObjectListRow,
        "App::PropertyStringList": LinesRow,
    }
    if kind in simple:
        return simple[kind](name, obj)
    if kind == "App::PropertyFloat":
        return NumberRow(name, obj, False)
    return TextRow(name, obj)
