"""What Python's event filters ask first.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from PySide import QtCore


def kind_of(event):
    """Type of a QEvent; None where PySide takes it for a widget that FreeCAD deleted at its address, whose
    Python object is still there."""
    return event.type() if isinstance(event, QtCore.QEvent) else None
