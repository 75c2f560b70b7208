"""Task panel and view of the CopyMilling operation.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
from patchmill import copy_milling
from PySide import QtGui

from patchmill_gui.computing import Computing, ComputingBox, translate
from patchmill_gui.operation_base import OperationPage, OperationView
from patchmill_gui.path_view import PathScene, show_native_lines
from patchmill_gui.resources import native
from patchmill_gui.texture_summary import duration, grouped


class CopyPage(OperationPage):
    """The operation's own page."""

    def getForm(self):
        form, layout = self.begin_form(copy_milling.PROPERTIES)
        for group in self.properties.groups.values():
            layout.addWidget(group)
        self.box = ComputingBox()
        layout.addWidget(self.box)
        layout.addStretch()
        return form


class CopyPanel(Computing, native("operation").TaskPanel):
    """FreeCAD's panel; OK computes in the background."""

    def __init__(self, obj, delete_on_reject, page, selection):
        super().__init__(obj, delete_on_reject, page, selection)
        self.page, self.box, self.form_rows = page, page.box, page.properties
        self.start_computing()

    def gather(self):
        self.panelGetFields()
        given = copy_milling.input_of(self.obj)

        def work(progress):
            path = copy_milling.mill(given)
            return path, core.path_display(path)

        return work

    def show_result(self, result):
        path, display = result
        self.obj.ViewObject.Proxy.scene.show(display)
        statistics = path.statistics()
        self.box.text.setText(
            translate("{} moves, {} of milling").format(
                grouped(len(path)), duration(statistics["timed_seconds"])
            )
        )

    def accept(self, resetEdit=True):
        self.compute(True)
        return False  # finish closes the dialog

    def finish(self, result):
        self.obj.Proxy.ready = result[0]
        self.obj.Document.recompute()  # inside the transaction
        super().accept()

    def clicked(self, button):
        if button == QtGui.QDialogButtonBox.Apply:
            self.panelGetFields()
            self.setClean()
            self.compute(False)

    def reject(self, resetEdit=True):
        if self.closing and self.cancel():
            return False
        self.work.cancel()
        return super().reject(resetEdit)


class CopyView(OperationView):
    """With the path drawn by us."""

    def attach(self, vobj):
        super().attach(vobj)
        self.scene = PathScene(vobj)

    def onChanged(self, vobj, prop):
        if prop == "Visibility" and getattr(self, "scene", None):
            self.scene.switch(vobj.Visibility)

    def updateData(self, obj, prop):
        super().updateData(obj, prop)
        if prop == "Path" and getattr(self, "scene", None):
            shown = self.scene.follow(getattr(obj.Proxy, "path", None))
            show_native_lines(obj.ViewObject, not shown)

    def make_panel(self, obj, page):
        return CopyPanel(obj, False, page, self.getSelectionFactory())
