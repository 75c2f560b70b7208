"""View provider of the texture operations: icon, what is displayed, context menu, and the panel's start.

    ViewObject.Show = "Dimples" | "Tool path" | "Tool path and axes" | "Relief" | "FreeCAD's lines"

A new texture shows the relief of its worst place among its dimples, until one is simulated. FreeCAD's own
lines are there too; it draws paths with rotary words wrongly (see src/scene/path_nodes.h).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
from _patchmill import InputError
from patchmill.textures.plan import place_texture, plan_texture
from PySide import QtCore

from patchmill_gui.panels.operation_base import OperationView, offer_commands
from patchmill_gui.views.path_view import show_native_lines
from patchmill_gui.views.texture_scene import PARTS, TextureScene, placed_displays, planned_displays
from patchmill_gui.views.worst_relief import first_relief, relief_displays
from patchmill_gui.work.background import Background

DIMPLES, PATH, AXES, RELIEF, NATIVE = SHOWS = (
    "Dimples",
    "Tool path",
    "Tool path and axes",
    "Relief",
    "FreeCAD's lines",
)
PARTS_OF = {
    DIMPLES: ("dimples", "outlines", "order"),
    PATH: ("path",),
    AXES: ("path", "axes"),
    RELIEF: ("relief", "dimples", "outlines"),
    NATIVE: (),
}


class ViewProvider(OperationView):
    """With dimples, path and relief drawn by us."""

    __module__ = "patchmill_gui.texture_view"  # what documents save

    scene = None
    fresh = False  # just made by a command: its panel looks for values that suit
    simulated = False  # the relief is what the user had simulated: it is shown by itself
    known_relief: tuple = (None, {})  # displays of the relief of a TextureInput's worst place

    def attach(self, vobj):
        """Also when a document is opened: the display is made anew, from the path that was saved."""
        super().attach(vobj)
        self.scene = TextureScene()
        self.drawing, self.looking, self.cutting = (Background() for _ in range(3))
        self.drawing.finished.connect(self.scene.show)
        self.looking.finished.connect(self._looked)
        self.cutting.finished.connect(self._cut)
        self.editing = False
        vobj.RootNode.addChild(self.scene.root)
        if "Show" not in vobj.PropertiesList:
            vobj.addProperty("App::PropertyEnumeration", "Show", "PatchMill", "What is displayed")
            vobj.Show = list(SHOWS)
            vobj.Show = RELIEF
        self.update(vobj)

    def onChanged(self, vobj, prop):
        if prop not in ("Show", "Visibility") or not getattr(self, "scene", None):
            return
        if vobj.Object.Document.Restoring:  # of a file: properties that are newer than it are still to come
            self.update_soon(vobj.Object)
        else:
            self.update(vobj)

    def updateData(self, obj, prop):
        super().updateData(obj, prop)
        if prop == "Path" and getattr(self, "scene", None) and not self.editing:
            self.scene.clear()
            self.cutting.cancel()
            self.simulated = False
            self.update_soon(obj)

    def update_soon(self, obj):
        """As update, when the event loop has its turn."""
        place = (obj.Document.Name, obj.Name)  # it may be gone then
        QtCore.QTimer.singleShot(0, lambda: self._update_if_there(*place))

    def _update_if_there(self, document, name):
        document = FreeCAD.listDocuments().get(document)
        obj = document.getObject(name) if document else None
        if obj is None or obj.ViewObject is None:
            return
        if obj.Document.Restoring:  # FreeCAD lets events in while it opens a file
            self.update_soon(obj)
        else:
            self.update(obj.ViewObject)

    def show_simulated(self, displays):
        """Shows the relief that the user had simulated."""
        self.cutting.cancel()
        self.simulated = True
        self.scene.show(displays)
        self.vobj.Show = RELIEF
        self.update(self.vobj)

    def update(self, vobj):
        """Fills, if empty, and shows what `Show` asks for. For a document just opened the texture is made
        anew in the background; one that cannot be made shows FreeCAD's lines, if it has any."""
        show = vobj.Show
        parts = PARTS_OF[show] if vobj.Visibility and not self.editing else ()
        if show == RELIEF and self.simulated:
            parts = parts[:1]
        if parts and not self._fill(parts, vobj.Object):
            show, parts = NATIVE, ()
        for part in PARTS:
            if not self.editing:
                self.scene.switch(part, part in parts)
        show_native_lines(vobj, show == NATIVE and not self.editing)

    def _fill(self, parts, obj):
        """Makes what is to be shown in the background, unless it is there. Returns whether there is, or will
        be, something to show."""
        lacking = [part for part in parts if not self.scene.filled(part)]
        if not lacking:
            return True
        planned = getattr(obj.Proxy, "planned", None)
        if planned is None and (getattr(obj.Proxy, "error", None) is not None or not obj.Path.Size):
            return False
        try:
            given = planned.asked if planned is not None else obj.Proxy.texture_input(obj)
        except InputError:
            return False
        if lacking[0] == "relief":
            self._cut_relief(given)
            lacking = lacking[1:]
        if lacking:
            placed_only = "dimples" in parts
            make = placed_displays if placed_only else planned_displays
            build = place_texture if placed_only else plan_texture
            self.drawing.start(lambda progress: _made_displays(planned or build(given, progress), make))
        return True

    def _cut_relief(self, given):
        """Shows the relief of the worst place, once it is known; until then of the flattest."""
        asked, displays = self.known_relief
        if asked == given:
            self.scene.show(displays)
        elif not self.cutting.busy:
            self.looking.start(lambda progress: first_relief(given, progress))
            self.cutting.start(lambda progress: (given, relief_displays(given, progress)))

    def _looked(self, displays):
        if not (self.editing or self.simulated or self.scene.filled("relief")):
            self.scene.show(displays)

    def _cut(self, made):
        self.looking.cancel()
        self.known_relief = made
        if not (self.editing or self.simulated):
            self.scene.show(made[1])

    def make_panel(self, obj, page):
        from patchmill_gui.panels.texture_panel import TexturePanel

        return TexturePanel(obj, False, page, self.getSelectionFactory())

    def setupContextMenu(self, vobj, menu):
        super().setupContextMenu(vobj, menu)
        offer_commands(vobj.Object, menu, "PatchMill_Play", "PatchMill_Simulate", "PatchMill_Report")


def _made_displays(made, make):
    """Displays of what was made for a display alone; none if it was cancelled."""
    return {} if made is None else make(made)
