"""Clicks *Install* in the window of a workbench without its core, as tools/release-click does for a user who
has a clone in FreeCAD's folder Mod and a wheel in the downloads: ends with 0 if the window says that it is
installed.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import driver
import FreeCADGui
from PySide import QtGui


def labels(form):
    return " ".join(label.text() for label in form.findChildren(QtGui.QLabel))


def open_form():
    forms = FreeCADGui.getMainWindow().findChildren(QtGui.QDialog, "PatchMillCoreWindow")
    return next((form for form in forms if form.isVisible()), None)


def main():
    FreeCADGui.activateWorkbench("PatchMillWorkbench")
    if not driver.wait(open_form, 60):
        print("no window came up")
        return 1
    form = open_form()
    print(labels(form))
    (button,) = [b for b in form.findChildren(QtGui.QPushButton) if b.text() == "Install"]
    button.click()
    print(labels(form))
    return 0 if "Installed. Start FreeCAD again" in labels(form) else 1
