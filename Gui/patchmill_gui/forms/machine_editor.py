"""Window in which machine files are looked at, copied and changed: a row to everything that a file may say.

Shipped files are not touched: a changed one is saved in the user's folder, and stands before the shipped one.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os

import FreeCADGui
from _patchmill import InputError
from patchmill.machine import freecad_file, machine_table, machines
from patchmill.machine.linuxcnc import machine_of
from PySide import QtCore, QtGui

from patchmill_gui.fields.known_sentences import translated
from patchmill_gui.fields.sentences import error_text
from patchmill_gui.fields.deleted_widgets import made_for_user
from patchmill_gui.forms.widgets import Notice, guard_editors, translate

PLACE = QtCore.Qt.UserRole
VALUE = 1  # column


def show(key=None):
    """Shows the window, the one that is open if there is one; returns it."""
    for window in FreeCADGui.getMainWindow().findChildren(MachineEditor):
        if window.isVisible():
            break
    else:
        window = made_for_user(lambda: MachineEditor(key))
        window.show()
    window.raise_()
    window.activateWindow()
    return window


class MachineEditor(QtGui.QDialog):
    """`key`: the machine that is shown first, or None."""

    def __init__(self, key=None, parent=None):
        super().__init__(parent or FreeCADGui.getMainWindow())
        self.setWindowTitle(translate("PatchMill", "Machines"))
        self.setObjectName("MachineEditor")
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.resize(620, 720)
        self.data = self.key = None
        self.changed = False
        self._build()
        self._list(key)

    def _build(self):
        self.choice, self.tree = QtGui.QComboBox(), QtGui.QTreeWidget()
        self.tree.setHeaderLabels(
            [translate("PatchMill", "What"), translate("PatchMill", "Value"), translate("PatchMill", "Unit")]
        )
        self.tree.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.tree.setAlternatingRowColors(True)
        self.where, self.message = QtGui.QLabel(), Notice()
        self.where.setTextFormat(QtCore.Qt.PlainText)
        self.where.setWordWrap(True)
        self.buttons = {}
        row = QtGui.QHBoxLayout()
        for name, text, call in [
            ("save", translate("PatchMill", "Save"), self.save),
            ("copy", translate("PatchMill", "Save as …"), self._ask_copy),
            ("import", translate("PatchMill", "Import …"), self._ask_import),
            ("remove", translate("PatchMill", "Remove my file"), self.remove),
            ("close", translate("PatchMill", "Close"), self.reject),
        ]:
            button = self.buttons[name] = QtGui.QPushButton(text)
            button.setObjectName(name)
            button.setAutoDefault(False)
            button.clicked.connect(lambda checked=False, call=call: call())
            row.addWidget(button)
        self.buttons["import"].setToolTip(
            translate("PatchMill", "Reads the configuration of a LinuxCNC machine")
        )
        layout = QtGui.QVBoxLayout(self)
        for widget in (self.choice, self.where, self.tree, self.message):
            layout.addWidget(widget)
        layout.addLayout(row)
        guard_editors(self.choice)
        self.choice.activated.connect(self._chosen)
        self.tree.itemChanged.connect(self._typed)
        self.tree.itemClicked.connect(self._edit)
        self.tree.itemActivated.connect(self._edit)

    def _chosen(self, _):
        """Another machine, if what was typed for this one may go."""
        if self._may_go(translate("PatchMill", "Go on without saving what was changed?")):
            self.show_machine(self.choice.currentText())
        else:
            self.choice.setCurrentIndex(self.choice.findText(self.key))

    def _list(self, key):
        names = machines.names()
        self.choice.clear()
        self.choice.addItems(names)
        key = key if key in names else names[0]
        self.choice.setCurrentText(key)
        self.show_machine(key)

    def show_machine(self, key):
        """Shows a machine file; what was typed for the one before is gone."""
        self.key = key
        try:
            self.data = machines.load(key).data
        except InputError as error:
            self.tree.clear()
            self._say(error)
            return
        own = machines.own(key)
        self.where.setText(
            translate("PatchMill", "Your own file.")
            if own
            else translate("PatchMill", "Comes with PatchMill.")
        )
        self.buttons["remove"].setEnabled(own)
        self._fill()
        self._say(None)
        self._mark(False)

    def _fill(self):
        self.tree.blockSignals(True)
        self.tree.clear()
        self.items, parents = {}, {(): self.tree.invisibleRootItem()}
        for row in machine_table.rows(self.data):
            item = QtGui.QTreeWidgetItem(parents[row.place[: _depth(row.place, parents)]])
            item.setData(0, PLACE, row.place)
            item.setText(0, translate("PatchMill", row.label))
            item.setText(2, "" if row.heading else row.unit)
            if row.heading:
                parents[row.place] = item
            else:
                self._fill_value(item, row)
                self.items[row.place] = item
        self.tree.expandAll()
        for column in (0, 2):
            self.tree.resizeColumnToContents(column)
        self.tree.setColumnWidth(VALUE, 280)
        self.tree.blockSignals(False)

    def _fill_value(self, item, row):
        if row.words:
            self.tree.setItemWidget(item, VALUE, self._choices(row))
        else:
            item.setText(VALUE, row.text)
            item.setFlags(item.flags() | QtCore.Qt.ItemIsEditable)

    def _choices(self, row):
        """A box with the row's words as the user says them. The wheel passes over it."""
        box = QtGui.QComboBox()
        for word in row.words:
            box.addItem(translate("PatchMill", word), word)
        box.setCurrentIndex(box.findData(row.text))
        box.currentIndexChanged.connect(lambda index: self.set_text(row.place, box.itemData(index)))
        guard_editors(box)
        return box

    def _edit(self, item, column):
        if item.flags() & QtCore.Qt.ItemIsEditable:
            self.tree.editItem(item, VALUE)

    def _typed(self, item, column):
        if column == VALUE:
            self.set_text(item.data(0, PLACE), item.text(VALUE))

    def set_text(self, place, text):
        """What the row at `place` says now."""
        self.data = machine_table.with_text(self.data, tuple(place), text)
        self._mark(True)

    def _mark(self, changed):
        self.changed = changed
        self.buttons["save"].setEnabled(changed)

    def save(self, key=None):
        """Saves what is shown, as `key` if given; returns whether it was sound. What is wrong is said below
        the rows, and its row chosen."""
        key = key or self.key
        try:
            machines.save(key, self.data)
        except InputError as error:
            self._say(error)
            self._choose(error.property)
            return False
        self._list(key)
        return True

    def _ask_copy(self):
        name, good = QtGui.QInputDialog.getText(
            self,
            translate("PatchMill", "Save as"),
            translate("PatchMill", "Name of the new machine file:"),
            text=self.key + "-mine",
        )
        if good:
            self.save(name.strip())

    def _ask_import(self):
        if not self._may_go(translate("PatchMill", "Go on without saving what was changed?")):
            return
        name, _ = QtGui.QFileDialog.getOpenFileName(
            self,
            translate("PatchMill", "Machine of LinuxCNC or FreeCAD"),
            "",
            translate("PatchMill", "Machine of LinuxCNC or FreeCAD") + " (*.ini *.fcm)",
        )
        if name:
            self.import_from(name)

    def import_from(self, filename):
        """Shows the machine of a LinuxCNC .ini or FreeCAD .fcm file, with what that does not say; nothing is
        saved yet."""
        try:
            read = freecad_file.read if filename.lower().endswith(".fcm") else machine_of.read
            found = read(filename)
        except InputError as error:
            self._say(error)
            return
        self.key, self.data = machines.free_key(os.path.splitext(os.path.basename(filename))[0]), found.data
        self.choice.setCurrentIndex(-1)
        begin = translate("PatchMill", "From {}; to be saved as {}.").format(
            os.path.basename(filename), self.key
        )
        self.where.setText("\n".join([begin, *map(translated, found.remarks)]))
        self.buttons["remove"].setEnabled(False)
        self._fill()
        self._say(None)
        self._mark(True)

    def remove(self):
        """Takes the user's own file away; a shipped one of the same name shows again."""
        machines.remove(self.key)
        self._list(self.key)

    def _may_go(self, question):
        """Whether nothing was changed, or the user gives it up."""
        if not self.changed:
            return True
        answer = QtGui.QMessageBox.question(self, translate("PatchMill", "Machines"), question)
        return answer == QtGui.QMessageBox.Yes

    def reject(self):
        if self._may_go(translate("PatchMill", "Close without saving what was changed?")):
            super().reject()

    def _say(self, error):
        self.message.setText(error_text(error) if error else "")

    def _choose(self, property):
        place = tuple(property.partition(": /")[2].split("/"))
        if place in self.items:
            self.tree.setCurrentItem(self.items[place], VALUE)


def _depth(place, parents):
    """How many of a place's words lead to the heading that it is below."""
    return max(count for count in range(len(place)) if place[:count] in parents)
