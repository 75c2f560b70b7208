"""The fold with the rows of a form that few users need, and a line to search them by label and tip. Whether
it is open is remembered.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
from patchmill.freecad import preferences
from patchmill.freecad.translate import QT_TRANSLATE_NOOP
from PySide import QtGui

from patchmill_gui.forms.property_form import Group
from patchmill_gui.forms.widgets import translate


class AdvancedFold(Group):
    """`form`: a PropertyForm; all of its groups but those named in `main` move into the fold."""

    def __init__(self, form, main):
        self._settings = FreeCAD.ParamGet(preferences.PATH)
        super().__init__(
            QT_TRANSLATE_NOOP("PatchMill", "Advanced"), self._settings.GetBool("AdvancedOpen", False)
        )
        self.form = form
        self.search = QtGui.QLineEdit()
        self.search.setObjectName("AdvancedSearch")
        self.search.setPlaceholderText(translate("PatchMill", "Search"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._find)
        self.rows.addRow(self.search)
        self.inner = {name: group for name, group in form.groups.items() if name not in main}
        for group in self.inner.values():
            self.rows.addRow(group)
            group.heading.toggled.connect(self._open_with)
        self.heading.toggled.connect(lambda on: self._settings.SetBool("AdvancedOpen", on))

    def _open_with(self, on):
        """A group that opens, as for an error in it, is to be seen."""
        if on and not self.heading.isChecked():
            self.heading.setChecked(True)

    def _find(self, text):
        """Only the rows that have every word of the text in label or tip, their groups open; all if it is
        empty."""
        words = text.casefold().split()
        found = {
            name
            for name, row in self.form.rows.items()
            if all(word in (row.label.text() + " " + row.label.toolTip()).casefold() for word in words)
        }
        self.form.search_only(found if words else None)
        for group in self.inner.values():
            own = [name for name, row in self.form.rows.items() if row.group is group]
            if words and any(name in found for name in own):
                group.heading.setChecked(True)
