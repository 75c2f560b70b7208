"""What Python asks where PySide may take an event or a widget for a deleted one of its address, whose Python
object is still there.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from PySide import QtCore

from patchmill_gui.fields.deleted_widgets import DELETED


def kind_of(event):
    """Type of a QEvent; None where PySide takes it for a widget that FreeCAD deleted at its address, whose
    Python object is still there."""
    return event.type() if isinstance(event, QtCore.QEvent) else None


def unless_deleted(ask, otherwise):
    """What `ask()` gives; `otherwise` where a widget that it asks is taken for a deleted one."""
    try:
        return ask()
    except RuntimeError as gone:
        if DELETED not in str(gone):
            raise
        return otherwise
