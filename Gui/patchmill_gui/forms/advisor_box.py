"""The advisor's proposals in the panel of a planar texture in free form: one click takes one over.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError
from patchmill.textures import advisor
from PySide import QtGui

from patchmill_gui.fields.sentences import error_text, in_user_units
from patchmill_gui.forms.widgets import Notice, WrappingButton, translate


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
        self.message = Notice()
        layout.addWidget(self.message)
        self.list = QtGui.QVBoxLayout()
        layout.addLayout(self.list)
        self.buttons = []

    def ask(self):
        """Lists the proposals next to what the properties say now, the least change first."""
        for button in self.buttons:
            button.deleteLater()
        self.buttons = []
        self.message.setText("")
        try:
            proposals = advisor.advise_operation(self.obj, self.array.currentData())
        except InputError as error:
            self.message.setText(error_text(error))
            return
        for proposal in proposals:
            tip = translate(
                "PatchMill", "side {:.4f} mm, cross-feed {:.4f} mm, feed per tooth {:.4f} mm: {}"
            ).format(proposal.side, proposal.cross_feed, proposal.feed_per_tooth, proposal.state)
            button = WrappingButton(in_user_units(proposal.changes))
            button.setToolTip(in_user_units(tip))
            button.clicked.connect(lambda *_, chosen=proposal: self._take(chosen))
            self.buttons.append(button)
            self.list.addWidget(button)

    def _take(self, proposal):
        advisor.take(self.obj, proposal)
        self.taken()
