"""The advisor's proposals in the panel of a planar texture in free form: one click takes one over.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError
from patchmill.textures import advisor
from PySide import QtCore, QtGui

from patchmill_gui.fields.sentences import error_text
from patchmill_gui.forms.widgets import translate


class AdvisorBox(QtGui.QGroupBox):
    """`taken()` is called when a proposal was taken over into the operation's properties."""

    def __init__(self, obj, taken):
        super().__init__(translate("PatchMill", "Marks in rows"))
        self.obj, self.taken = obj, taken
        self.array = QtGui.QComboBox()
        self.array.addItem(translate("PatchMill", "Square"), "Square")
        self.array.addItem(translate("PatchMill", "Staggered"), "Staggered")
        ask = QtGui.QPushButton(translate("PatchMill", "Propose"))
        ask.setObjectName("Propose")
        ask.clicked.connect(self.ask)
        row = QtGui.QHBoxLayout()
        row.addWidget(self.array)
        row.addWidget(ask)
        layout = QtGui.QVBoxLayout(self)
        layout.addLayout(row)
        self.list = QtGui.QVBoxLayout()
        layout.addLayout(self.list)
        self.buttons = []

    def ask(self):
        """Lists the proposals next to what the properties say now, the least change first."""
        for button in self.buttons:
            button.deleteLater()
        self.buttons = []
        try:
            proposals = advisor.advise_operation(self.obj, self.array.currentData())
        except InputError as error:
            label = QtGui.QLabel(error_text(error))
            label.setTextFormat(QtCore.Qt.PlainText)
            self._add(label)
            return
        for proposal in proposals:
            button = QtGui.QPushButton(proposal.changes)
            button.setToolTip(
                translate(
                    "PatchMill", "side {:.4f} mm, cross-feed {:.4f} mm, feed per tooth {:.4f} mm: {}"
                ).format(proposal.side, proposal.cross_feed, proposal.feed_per_tooth, proposal.state)
            )
            button.setMinimumWidth(30)
            button.setStyleSheet("text-align: left")
            button.clicked.connect(lambda *_, chosen=proposal: self._take(chosen))
            self._add(button)

    def _add(self, widget):
        self.buttons.append(widget)
        self.list.addWidget(widget)

    def _take(self, proposal):
        advisor.take(self.obj, proposal)
        self.taken()
