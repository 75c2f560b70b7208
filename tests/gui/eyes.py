"""What a user sees: the 3-D view as it is on the screen, as numbers, and what is hard to read in a panel.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import driver
import FreeCADGui
import numpy as np
from patchmill_gui.fields.events import below
from PySide import QtCore, QtGui

CONTRAST = 4.5  # WCAG 2.2, success criterion 1.4.3
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


def settled(widget):
    """A widget's picture, once its rows and sentences have come to rest: where the machine is busy that takes
    a while."""
    before = None
    for _ in range(20):
        driver.rest(0.5)
        now = widget.grab().toImage()
        if now == before:
            break
        before = now
    return now


def _luminance(pixels):
    linear = pixels / 255.0
    linear = np.where(linear <= 0.04045, linear / 12.92, ((linear + 0.055) / 1.055) ** 2.4)
    return linear @ np.array([0.2126, 0.7152, 0.0722])


def _pixels(widget):
    image = widget.grab().toImage().convertToFormat(QtGui.QImage.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8, image.bytesPerLine() * image.height())
    rows = rows.reshape(image.height(), -1)[:, : 3 * image.width()]
    return rows.reshape(-1, 3).astype(float)


def _texts(widget):
    """Visible labels and buttons below a widget with their texts."""
    for each in below(widget, (QtGui.QLabel, QtGui.QAbstractButton)):
        if each.isVisible() and each.isEnabled():
            if each.text().strip() and each.width() > 8 and each.height() > 8:
                yield each, each.text()


def faint(widget):
    """(text, contrast) of those below CONTRAST: of the commonest luminance and the one farthest from it."""
    for each, text in _texts(widget):
        light = np.round(_luminance(_pixels(each)), 3)
        values, counts = np.unique(light, return_counts=True)
        ground = values[counts.argmax()]
        ratios = (np.maximum(values, ground) + 0.05) / (np.minimum(values, ground) + 0.05)
        if ratios.max() < CONTRAST:
            yield text, ratios.max()


def clipped(widget):
    """(text, pixels that are missing) of labels of one line and of buttons that are too narrow for it."""
    for each, text in _texts(widget):
        if isinstance(each, QtGui.QAbstractButton):
            text = QtGui.QAbstractButton.text(each)  # a button of ours breaks it
        wraps = isinstance(each, QtGui.QLabel) and (each.wordWrap() or "<" in text)
        lacks = each.fontMetrics().horizontalAdvance(text.replace("&", "")) - each.width()
        if not wraps and lacks > 0 and "\n" not in text:
            yield text, lacks


def without_buddy(widget):
    """Texts of labels whose ampersand is no key: there is no field that it leads to."""
    labels = [each for each in below(widget, QtGui.QLabel) if each.isVisible()]
    return [each.text() for each in labels if "&" in each.text() and each.buddy() is None and plain(each)]


def plain(label):
    return label.textFormat() == QtCore.Qt.PlainText or "<" not in label.text()
