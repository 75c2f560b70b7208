"""Editors for FreeCAD properties that choose among what there is: words, machine files, a document's objects.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from PySide import QtCore, QtGui

from patchmill.machine import machines

from patchmill_gui.forms.property_rows import Row, assign
from patchmill_gui.forms.widgets import translate


class ChoiceRow(Row):
    def __init__(self, name, obj):
        editor = QtGui.QComboBox()
        for choice in obj.getEnumerationsOfProperty(name):
            editor.addItem(translate("PatchMill", choice), choice)
        self.name = name
        super().__init__(editor, editor.currentIndexChanged)

    def show(self, obj):
        self.editor.setCurrentIndex(self.editor.findData(getattr(obj, self.name)))

    def store(self, obj):
        assign(obj, self.name, self.editor.currentData())


class MachineBox(QtGui.QComboBox):
    """The machine files at hand, as `text_of` says each, below an entry that is none of them: `first`, a text
    and its data. It looks for files again whenever it is opened or gets the keyboard, for they are made in a
    window beside it. A chosen one that is gone stays, so that its name can be seen."""

    def __init__(self, first, text_of=str):
        super().__init__()
        self.first, self.text_of = first, text_of
        self.addItem(*first)
        self.refresh()

    def choose(self, key):
        """Chooses a machine, also one that there is no file of."""
        if self.findData(key) < 0:
            self.addItem(self.text_of(key), key)
        self.setCurrentIndex(self.findData(key))

    def refresh(self):
        """Lists the files that there are now. What is chosen stays chosen, and nothing is told as changed.
        Entries that stay are left in their places: a list that closes over a click holds on to one."""
        chosen = self.currentData()
        blocked = self.blockSignals(True)
        wanted = [self.first[1]] + machines.names()
        if chosen not in wanted:
            wanted.append(chosen)
        for row in reversed(range(self.count())):
            if self.itemData(row) not in wanted:
                self.removeItem(row)
        for row, key in enumerate(wanted):
            if row >= self.count() or self.itemData(row) != key:
                self.insertItem(row, self.text_of(key), key)
        self.setCurrentIndex(wanted.index(chosen))
        self.blockSignals(blocked)

    def showPopup(self):
        self.refresh()
        super().showPopup()

    def focusInEvent(self, event):
        if event.reason() != QtCore.Qt.PopupFocusReason:  # it comes back from its own list
            self.refresh()
        super().focusInEvent(event)


class MachineRow(Row):
    """The machine files at hand; the empty name is 'none'."""

    def __init__(self, name, obj):
        editor = MachineBox((translate("PatchMill", "(none)"), ""))
        self.name = name
        super().__init__(editor, editor.currentIndexChanged)

    def show(self, obj):
        self.editor.choose(getattr(obj, self.name))

    def store(self, obj):
        assign(obj, self.name, self.editor.currentData())


class ObjectRow(Row):
    """One of the document's objects that fit, with a shape if nothing else is asked, or none."""

    def __init__(self, name, obj, fits=lambda other: hasattr(other, "Shape")):
        editor = QtGui.QComboBox()
        editor.addItem(translate("PatchMill", "(none)"), "")
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
        assign(obj, self.name, obj.Document.getObject(name) if name else None)


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
