"""Task panel and view of the CopyMilling operation.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
from patchmill.freecad import preferences
from patchmill.machine.machining_time import in_words
from patchmill.operations import copy_milling

from patchmill_gui.fields import unit_text
from patchmill_gui.fields.known_sentences import translated
from patchmill_gui.forms.texture_summary import grouped
from patchmill_gui.forms.widgets import translate
from patchmill_gui.panels.operation_base import OperationPage, OperationPanel, OperationView, offer_commands
from patchmill_gui.views.path_view import PathScene, settle_native_lines
from patchmill_gui.work.computing import Computing, ComputingBox


class CopyPage(OperationPage):
    """The operation's own page."""

    __module__ = "patchmill_gui.copy_panel"  # what documents save

    def getForm(self):
        form, layout = self.begin_form(copy_milling.PROPERTIES)
        for group in self.properties.groups.values():
            layout.addWidget(group)
        self.box = ComputingBox()
        layout.addWidget(self.box)
        layout.addStretch()
        return form


class CopyPanel(Computing, OperationPanel):
    """FreeCAD's panel; OK computes in the background."""

    def __init__(self, obj, delete_on_reject, page, selection):
        super().__init__(obj, delete_on_reject, page, selection)
        self.page, self.box, self.form_rows = page, page.box, page.properties
        self.start_computing()

    def gather(self):
        self.panelGetFields()
        given = copy_milling.input_of(self.obj)

        def work(progress):
            made = copy_milling.mill(given, progress)
            return made and (made, core.path_display(made.path), _summary(made))

        return work

    def show_result(self, result):
        _, display, summary = result
        self.obj.ViewObject.Proxy.scene.show(display)
        self.box.text.setText(summary)

    def accept(self, resetEdit=True):
        self.compute(True)
        return False  # finish closes the dialog

    def finish(self, result):
        preferences.remember_machine(self.obj.Machine)
        self.close_with(result[0])

    def preview(self):
        self.compute(False)

    def stop(self):
        self.give_up()

    def reject(self, resetEdit=True):
        return False if self.stop_waiting() else super().reject(resetEdit)


def _summary(made):
    """What there is to say of a CopiedPath."""
    ridge = core.scallop_height(made.path.tool.radius, made.asked.last_radial)
    text = translate("PatchMill", "{} moves, {} of milling, ridges of {} on a flat").format(
        grouped(len(made.path)), in_words(made.seconds), unit_text.text_of(ridge, "mm")
    )
    return "<br>".join([text, *map(translated, copy_milling.remarks(made))])


class CopyView(OperationView):
    """With the path drawn by us."""

    __module__ = "patchmill_gui.copy_panel"  # what documents save

    def attach(self, vobj):
        super().attach(vobj)
        self.scene = PathScene(vobj)
        settle_native_lines(vobj.Object)

    def onChanged(self, vobj, prop):
        if prop == "Visibility" and getattr(self, "scene", None):
            self.scene.switch(vobj.Visibility)

    def updateData(self, obj, prop):
        super().updateData(obj, prop)
        if prop == "Path" and getattr(self, "scene", None):
            self.scene.follow(getattr(obj.Proxy, "path", None))
            settle_native_lines(obj)

    def setupContextMenu(self, vobj, menu):
        super().setupContextMenu(vobj, menu)
        offer_commands(vobj.Object, menu, "PatchMill_Play", "PatchMill_Simulate", "PatchMill_Check")

    def make_panel(self, obj, page):
        return CopyPanel(obj, False, page, self.getSelectionFactory())
