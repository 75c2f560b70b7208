"""Panel that shows what copy milling, or a modifier on it, leaves over the part: a surface in colours, with a
legend and a table.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.path.milled_surface import milled_surface
from patchmill.verify import checks
from PySide import QtCore

from patchmill_gui.fields import unit_text
from patchmill_gui.forms.texture_summary import table_of
from patchmill_gui.forms.widgets import translate
from patchmill_gui.views.legend import LegendPlace
from patchmill_gui.views.own_view import scene_of
from patchmill_gui.views.texture_scene import SceneParts, relief_display
from patchmill_gui.work.work_panel import WorkPanel


class MilledPanel(WorkPanel):
    """Task panel for an operation or modifier; it starts at once. What it shows goes when it closes, and what
    the operation itself shows comes back."""

    ICON = "PatchMill_Simulate"

    def __init__(self, operation):
        given = checks.check_input(operation)
        super().__init__(translate("PatchMill", "What {} leaves").format(operation.Label), operation)
        self.root, self.parts = scene_of(operation), SceneParts(("relief",))
        self.root.addChild(self.parts.root)
        self.legend = LegendPlace(operation)
        self.bring_back = None
        self.scene = operation.ViewObject.Proxy.scene.parts
        self.text.setTextFormat(QtCore.Qt.RichText)
        self.add_progress()
        self.text.setText(translate("PatchMill", "Simulating …"))
        self.bar.begin()
        self.work.start(lambda progress: _milled(given, progress))

    def show_result(self, made):
        if made is None:
            return
        self.result, (displays, low, high) = made
        self.bar.hide()
        self.bring_back = self.scene.set_aside()
        self.parts.show(displays)
        self.parts.switch("relief", True)
        unit, *scale = unit_text.of_micrometres(low, high)
        self.legend.show(translate("PatchMill", "left over the part [{}]").format(unit), *scale)
        self.text.setText(table_of(self.result.rows()))

    def leave(self):
        super().leave()
        self.legend.hide()
        self.root.removeChild(self.parts.root)
        if self.bring_back is not None:
            self.bring_back()


def _milled(given, progress):
    """(MilledSurface, its display) of a CheckInput, or None if cancelled; for any thread."""
    made = milled_surface(given.path, given.breps, progress=progress)
    return made and (made, relief_display(made.points, 1e3 * made.left))
