"""A form made from an operation's table of properties: a row for each, grouped as the table groups them,
with its unit, its tip, and room for a sentence below it that says what is wrong.

The table's rows are (type, name, group, tip, default); see patchmill.property_table.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from PySide import QtCore, QtGui

from patchmill.properties.property_table import UNITS, label_of
from patchmill.voxels import axis_field

from patchmill_gui.fields.known_sentences import translated
from patchmill_gui.fields.sentences import error_text, in_user_units
from patchmill_gui.fields.typing_hand import is_typed_in
from patchmill_gui.forms.choice_rows import ChoiceRow, MachineRow, ObjectListRow, ObjectRow
from patchmill_gui.forms.property_rows import (
    FileRow,
    FlagRow,
    LinesRow,
    QuantityRow,
    TextRow,
    VectorRow,
    WholeRow,
)
from patchmill_gui.forms.widgets import Notice, WrappingLabel, guard_editors, let_shrink, translate


class Group(QtGui.QWidget):
    """A heading that opens and closes the rows below it. `title` is marked for translation."""

    def __init__(self, title, is_open):
        super().__init__()
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        self.heading = QtGui.QToolButton()
        self.heading.setText(translate("PatchMill", title))
        self.heading.setObjectName("Group" + title)
        self.heading.setCheckable(True)
        self.heading.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        self.heading.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
        self.heading.setStyleSheet("font-weight: bold; border: none; text-align: left")
        self._parts = []
        self.body = QtGui.QWidget()
        self.rows = QtGui.QFormLayout(self.body)
        self.rows.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        self.rows.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        self.rows.setContentsMargins(8, 0, 2, 4)
        self.rows.setHorizontalSpacing(4)
        self.rows.setVerticalSpacing(3)
        layout.addWidget(self.heading)
        layout.addWidget(self.body)
        self.heading.toggled.connect(self._toggle)
        self.heading.setChecked(is_open)
        self._toggle(is_open)

    def lay_out(self, parts):
        """Puts these into the layout and no others: hidden ones would leave their spacing behind. Pairs of
        a label and an editor, and sentences across both."""
        if parts == self._parts:
            return
        self._parts = parts
        while self.rows.count():
            self.rows.takeAt(0)
        while self.rows.rowCount():
            self.rows.removeRow(0)
        for part in parts:
            self.rows.addRow(*part)

    def _toggle(self, on):
        self.heading.setArrowType(QtCore.Qt.DownArrow if on else QtCore.Qt.RightArrow)
        self.body.setVisible(on)


class PropertyForm(QtCore.QObject):
    """Groups with rows for `table`, to be added to a layout; those named in `closed` start closed.
    `changed` comes after any edit."""

    changed = QtCore.Signal()

    def __init__(self, table, obj, closed=()):
        super().__init__()
        self.closed = closed
        self.obj = obj
        self.rows = {}
        self.groups = {}
        self._showing = False
        self._relevant = self._found = None  # names of the rows that may be shown; None: all
        for kind, name, group, tip, _ in table:
            self._add(row_for(kind, name, obj), name, group, tip)
        self._lay_out()

    def _add(self, row, name, group, tip):
        if group not in self.groups:
            self.groups[group] = Group(group, group not in self.closed)
        text = translate("PatchMill", label_of(name))
        label = WrappingLabel("%s [%s]" % (text, row.unit) if row.unit else text)
        for widget in (label, row.editor):
            widget.setToolTip(translate("App::Property", tip))
        row.editor.setObjectName(name)
        let_shrink(row.editor)
        guard_editors(row.editor)
        row.label = label
        row.error = Notice()
        row.group = self.groups[group]
        row.error.setParent(row.group.body)  # it gets into the layout when it says something
        for signal in row.changed if isinstance(row.changed, list) else [row.changed]:
            signal.connect(self._edited)
        self.rows[name] = row

    def _edited(self, *_):
        if not self._showing:
            self.changed.emit()

    def show(self):
        """Properties to editors, without `changed`; what is being typed stays."""
        self._showing = True
        for row in self.rows.values():
            if not is_typed_in(row.editor):
                row.show(self.obj)
        self._showing = False

    def store(self):
        """Editors to properties."""
        for row in self.rows.values():
            row.store(self.obj)

    def show_only(self, names):
        """Hides the rows of all other properties: these mean something now."""
        self._relevant = set(names)
        self._show_rows()

    def search_only(self, names):
        """Hides the rows of all properties that were not searched for; None: there is no search."""
        self._found = names
        self._show_rows()

    def _show_rows(self):
        for name, row in self.rows.items():
            on = all(names is None or name in names for names in (self._relevant, self._found))
            if row.on != on:
                row.on = on
                row.editor.setVisible(on)
                row.label.setVisible(on)
        self._lay_out()
        for group in self.groups.values():  # a heading with nothing below it says nothing
            empty = not any(row.on for row in self.rows.values() if row.group is group)
            if empty != group.isHidden():
                group.setHidden(empty)

    def _lay_out(self):
        """Each group has the rows that are on and the sentences that say something."""
        parts: dict = {group: [] for group in self.groups.values()}
        for row in self.rows.values():
            if row.on:
                parts[row.group].append((row.label, row.editor))
            if row.error.text():
                parts[row.group].append((row.error,))
        for group, own in parts.items():
            group.lay_out(own)

    def show_error(self, error):
        """Puts the sentence of an InputError below its field; None clears all, and so does an exception that
        names no property. Returns the sentence to be shown elsewhere, which is "" where a field has it."""
        named = getattr(error, "property", None)
        for name, row in self.rows.items():
            mine = named == name
            said = [translated(str(text)) for text in (error.value, error.remedy)] if mine else []
            row.error.setText(in_user_units(": ".join(said)))
            if mine:
                row.group.heading.setChecked(True)
        self._lay_out()
        return "" if error is None or named in self.rows else error_text(error)


def row_for(kind, name, obj):
    """The Row for a property of FreeCAD type `kind`."""
    if name == "Machine":
        return MachineRow(name, obj)
    if name == "PostureField":
        return ObjectRow(name, obj, axis_field.gives_field)
    if kind in UNITS:
        return QuantityRow(name, obj, kind)
    if kind in ("App::PropertyInteger", "App::PropertyIntegerConstraint"):
        return WholeRow(name, obj)
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
    return TextRow(name, obj)
