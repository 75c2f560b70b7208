"""A tool path in the 3-D view, for operations whose only display it is. Drawn by us: FreeCAD draws paths
with rotary words wrongly (see src/scene/path_nodes.h).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
import FreeCAD
from PySide import QtCore

from patchmill_gui.views.texture_scene import SceneParts
from patchmill_gui.work.background import Background


class PathScene:
    """The display of one document object's path, added to its view."""

    def __init__(self, vobj):
        self.parts = SceneParts(("path", "slice", "arrows"))
        self.parts.switch("path", True)
        vobj.RootNode.addChild(self.parts.root)
        self.drawing = Background()
        self.drawing.finished.connect(self.show)
        self.path = None

    def show(self, display):
        self.parts.show({"path": display})

    def switch(self, on):
        self.parts.switch("path", on)

    def filled(self):
        return self.parts.filled("path")

    def follow(self, path):
        """Draws a ToolPath, in the background; nothing if it is None. Returns whether there is one."""
        if path is self.path:
            return path is not None
        self.path = path
        self.parts.clear()
        if path is not None:
            self.drawing.start(lambda progress: core.path_display(path))
        return path is not None


def settle_native_lines(obj):
    """Shows FreeCAD's lines where there are none of ours. Not at once: FreeCAD's view sets back which lines
    it shows when it has got a new path, and a document being opened gives views the properties that hid
    them."""
    place = (obj.Document.Name, obj.Name)  # it may be gone when its turn comes

    def settle():
        document = FreeCAD.listDocuments().get(place[0])
        found = document.getObject(place[1]) if document else None
        view = getattr(found, "ViewObject", None)
        if view is not None and getattr(view.Proxy, "scene", None) is not None:
            show_native_lines(view, view.Proxy.scene.path is None)

    QtCore.QTimer.singleShot(0, settle)


def show_native_lines(vobj, on):
    """FreeCAD has no switch for its lines: showing one movement from the end on is as good as none."""
    start, count = (0, 0) if on else (max(0, vobj.Object.Path.Size - 1), 1)
    if vobj.StartIndex != start:
        vobj.StartIndex = start
    if vobj.ShowCount != count:
        vobj.ShowCount = count
