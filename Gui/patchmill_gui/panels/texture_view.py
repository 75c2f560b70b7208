"""View provider of the texture operations: icon, what is displayed, context menu, and the panel's start.

    ViewObject.Show = "Dimples" | "Tool path" | "Tool path and axes" | "Relief" | "FreeCAD's lines"

FreeCAD's own lines are there too; it draws paths with rotary words wrongly (see src/scene/path_nodes.h).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import FreeCADGui
from _patchmill import InputError
from patchmill.textures.plan import place_texture, plan_texture
from PySide import QtCore, QtGui

from patchmill_gui.forms.widgets import translate
from patchmill_gui.panels.operation_base import OperationView
from patchmill_gui.views.path_view import show_native_lines
from patchmill_gui.views.texture_scene import PARTS, TextureScene, placed_displays, planned_displays
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
    RELIEF: ("relief",),
    NATIVE: (),
}


class ViewProvider(OperationView):
    """With dimples, path and relief drawn by us."""

    __module__ = "patchmill_gui.texture_view"  # what documents save

    scene = None
    fresh = False  # just made by a command: its panel looks for values that suit

    def attach(self, vobj):
        """Also when a document is opened: the display is made anew, from the path that was saved."""
        super().attach(vobj)
        self.scene = TextureScene()
        self.drawing = Background()
        self.drawing.finished.connect(self.scene.show)
        self.editing = False
        vobj.RootNode.addChild(self.scene.root)
        if "Show" not in vobj.PropertiesList:
            vobj.addProperty("App::PropertyEnumeration", "Show", "PatchMill", "What is displayed")
            vobj.Show = list(SHOWS)
        self.update(vobj)

    def onChanged(self, vobj, prop):
        if prop in ("Show", "Visibility") and getattr(self, "scene", None):
            self.update(vobj)

    def updateData(self, obj, prop):
        super().updateData(obj, prop)
        if prop == "Path" and getattr(self, "scene", None) and not self.editing:
            self.scene.clear()
            self.update_soon(obj)

    def update_soon(self, obj):
        """As update, when the event loop has its turn."""
        place = (obj.Document.Name, obj.Name)  # it may be gone then
        QtCore.QTimer.singleShot(0, lambda: self._update_if_there(*place))

    def _update_if_there(self, document, name):
        document = FreeCAD.listDocuments().get(document)
        obj = document.getObject(name) if document else None
        if obj is not None and obj.ViewObject is not None:
            self.update(obj.ViewObject)

    def update(self, vobj):
        """Fills, if empty, and shows what `Show` asks for; the dimples, where a relief is asked for and none
        has been simulated yet. For a document just opened the texture is made anew in the background; one
        that cannot be made shows FreeCAD's lines, if it has any."""
        show = vobj.Show
        if show == RELIEF and not self.scene.filled("relief"):
            show = DIMPLES
        parts = PARTS_OF[show] if vobj.Visibility and not self.editing else ()
        if parts and not self._fill(show, vobj.Object):
            show, parts = NATIVE, ()
        for part in PARTS:
            if not self.editing:
                self.scene.switch(part, part in parts)
        show_native_lines(vobj, show == NATIVE and not self.editing)

    def _fill(self, show, obj):
        """Makes what is to be shown in the background, unless it is there. Returns whether there is, or will
        be, something to show."""
        if show == RELIEF or all(self.scene.filled(part) for part in PARTS_OF[show]):
            return True
        planned = getattr(obj.Proxy, "planned", None)
        make = placed_displays if show == DIMPLES else planned_displays
        if planned is not None:
            self.drawing.start(lambda progress: make(planned))
            return True
        if getattr(obj.Proxy, "error", None) is not None or not obj.Path.Size:
            return False
        try:
            given = obj.Proxy.texture_input(obj)
        except InputError:
            return False
        build = place_texture if show == DIMPLES else plan_texture
        self.drawing.start(lambda progress: _made_displays(build(given, progress), make))
        return True

    def make_panel(self, obj, page):
        from patchmill_gui.panels.texture_panel import TexturePanel

        return TexturePanel(obj, False, page, self.getSelectionFactory())

    def setupContextMenu(self, vobj, menu):
        super().setupContextMenu(vobj, menu)
        for text, command in (
            (translate("PatchMill", "Play the path"), "PatchMill_Play"),
            (translate("PatchMill", "Simulate marks"), "PatchMill_Simulate"),
            (translate("PatchMill", "Report"), "PatchMill_Report"),
        ):
            action = QtGui.QAction(text, menu)
            action.triggered.connect(lambda *_, name=command: _run_on(vobj.Object, name))
            menu.addAction(action)


def _made_displays(made, make):
    """Displays of what was made for a display alone; none if it was cancelled."""
    return {} if made is None else make(made)


def _run_on(obj, command):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj)
    FreeCADGui.runCommand(command)
