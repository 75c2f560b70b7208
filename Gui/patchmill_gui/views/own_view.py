"""The 3-D view that an object is seen in, whichever document or window is in front.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCADGui
from pivy import coin


def view_of(obj):
    """The view of a document object's own document, or None: it may show a table, or be closed."""
    views = FreeCADGui.getDocument(obj.Document.Name).mdiViewsOfType("Gui::View3DInventor")
    return views[0] if views else None


def scene_of(obj):
    """The root that is drawn there; one that nobody sees where there is no view."""
    view = view_of(obj)
    return view.getSceneGraph() if view is not None else coin.SoSeparator()
