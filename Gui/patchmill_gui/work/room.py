"""Room for a panel: FreeCAD 0.20 leaves its dock as narrow as it is, and cuts off what is wider, such as OK,
Cancel and Apply in a row. Later versions widen the dock to what the panel needs; so does this.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from functools import partial

import FreeCADGui
from PySide import QtCore, QtGui

from patchmill_gui.fields.events import below, unless_deleted

TASK_VIEW = "Gui::TaskView::TaskView"
SHOWN_MS = (100, 600)  # until the widgets of a panel that has just been shown have their sizes


def make_room_soon():
    """make_room() when the panel that is being shown has its widgets."""
    for after in SHOWN_MS:
        QtCore.QTimer.singleShot(after, make_room)


def make_room():
    """Widens the dock with FreeCAD's task panel to the least width that its contents can have, those of
    scroll areas in it as well, the scroll bar beside them; a dock that is as wide stays."""
    window = FreeCADGui.getMainWindow()
    for dock in window.findChildren(QtGui.QDockWidget):
        for area in below(dock, QtGui.QScrollArea):
            if _is_task_view(area):
                needed = needed_width(dock, area)
                if dock.isFloating() and dock.width() < needed:
                    dock.resize(needed, dock.height())
                elif dock.width() < needed:
                    window.resizeDocks([dock], [needed], QtCore.Qt.Horizontal)


def _is_task_view(area):
    """Whether a scroll area is the visible one of FreeCAD's task panel, which is never deleted: one of a page
    may have the Python object of a closed panel's."""
    return unless_deleted(lambda: area.metaObject().className() == TASK_VIEW and area.isVisible(), False)


def needed_width(dock, area):
    """Of a dock [pixels], so that nothing of the scroll area in it is cut off."""
    left = area.mapTo(dock, QtCore.QPoint(0, 0)).x()  # of the tabs around it; as much is at its right
    margins, bar = area.viewportMargins(), area.verticalScrollBar().sizeHint().width()
    contents = area.widget().minimumSizeHint().width()
    outer = contents + bar + margins.left() + margins.right() + 2 * (area.frameWidth() + left)
    inner = [unless_deleted(partial(_hidden_width, each), 0) for each in below(area, QtGui.QScrollArea)]
    return max(outer, dock.width() + max(inner, default=0))


def _hidden_width(area):
    """How much of a scroll area's contents lies past its sides [pixels]."""
    return area.horizontalScrollBar().maximum() if area.isVisible() else 0
