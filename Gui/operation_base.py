"""What the views and panel pages of our operations share, over FreeCAD's own.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from FreeCAD import Qt
from PySide import QtGui

from patchmill_gui.property_form import PropertyForm, let_shrink
from patchmill_gui.resources import native


class OperationView(native("operation").ViewProvider):
    """FreeCAD's view provider with our selection gate, icon and panel. A subclass gives `make_panel`."""

    def __init__(self, vobj, resources):
        super().__init__(vobj, resources)
        self.OpIcon = resources.pixmap
        self.deleteOnReject = False  # what Cancel takes back is the transaction that made it, if that is open
        vobj.Proxy = self

    def __setstate__(self, state):
        super().__setstate__(state)
        self.deleteOnReject = False

    loads = __setstate__

    def getSelectionFactory(self):
        return native("selection").fselect

    def make_panel(self, obj, page):
        """The task panel for `obj` with its own page."""
        raise NotImplementedError

    def setEdit(self, vobj=None, mode=0):
        if mode != 0:
            return False
        vobj = vobj if vobj is not None and hasattr(vobj, "Object") else self.vobj
        page = self.getTaskPanelOpPage(vobj.Object)
        page.setTitle(self.OpName)
        page.setIcon(self.OpIcon)
        self.setupTaskPanel(self.make_panel(vobj.Object, page))
        return True


class OperationPage(native("operation").TaskPanelPage):
    """A page with tool controller, coolant and a form of the operation's properties. A subclass builds its
    form with `begin_form` and adds to it."""

    def begin_form(self, table, closed=()):
        """(form, layout): tool controller and coolant in it; `self.properties` is made, its groups are not
        in it yet."""
        form = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(form)
        layout.setContentsMargins(2, 2, 2, 2)
        form.toolController, form.coolantController = QtGui.QComboBox(), QtGui.QComboBox()
        rows = QtGui.QFormLayout()
        for text, combo in (
            ("Tool controller", form.toolController),
            ("Coolant", form.coolantController),
        ):
            let_shrink(combo)
            rows.addRow(Qt.translate("PatchMill", text), combo)
        layout.addLayout(rows)
        self.properties = PropertyForm(table, self.obj, closed)
        return form, layout

    def getFields(self, obj):
        self.properties.store()
        self.updateToolController(obj, self.form.toolController)
        self.updateCoolant(obj, self.form.coolantController)

    def setFields(self, obj):
        self.properties.show()
        self.setupToolController(obj, self.form.toolController)
        self.setupCoolant(obj, self.form.coolantController)

    def getSignalsForUpdate(self, obj):
        return [
            self.properties.changed,
            self.form.toolController.currentIndexChanged,
            self.form.coolantController.currentIndexChanged,
        ]
