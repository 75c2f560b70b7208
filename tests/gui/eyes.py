"""What a user sees: the 3-D view as it is on the screen, as numbers.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import driver
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

DIMPLE = (0x00, 0x72, 0xB2)  # of a dimple that is cut; see src/scene/colours.cpp


def picture():
    """(rows, columns, 3) of the active 3-D view, once it has come to rest."""
    before = None
    for _ in range(40):
        driver.rest(0.25)
        now = _grab()
        if before is not None and np.array_equal(now, before):
            return now
        before = now
    raise AssertionError("the view does not come to rest")


def _grab():
    area = FreeCADGui.getMainWindow().findChild(QtGui.QMdiArea)
    view = area.currentSubWindow().widget()
    place = QtCore.QRect(view.mapToGlobal(QtCore.QPoint(0, 0)), view.size())
    shot = QtGui.QApplication.primaryScreen().grabWindow(0).copy(place)
    image = shot.toImage().convertToFormat(QtGui.QImage.Format_RGB888)
    bits = image.constBits()
    rows = np.frombuffer(bits, np.uint8, image.bytesPerLine() * image.height())
    return rows.reshape(image.height(), -1)[:, : 3 * image.width()].reshape(image.height(), -1, 3).copy()


def near(seen, colour, within=12):
    """Where a picture has a colour, but for so much in each channel."""
    return (np.abs(seen.astype(int) - colour) <= within).all(axis=2)


def fraction(seen, colour):
    """How much of a picture has a colour."""
    return float(near(seen, colour).mean())
