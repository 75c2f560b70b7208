"""Preferences change while our displays are shown: FreeCAD's actions for highlight, selection and the like go
over every node of ours, and none of them may end the program.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import driver
import FreeCAD
import FreeCADGui
import hands
import patchmill
from patchmill_gui.panels import simulate_panel, texture_view
from PySide import QtCore, QtGui

VIEW = "User parameter:BaseApp/Preferences/View"
MAIN = "User parameter:BaseApp/Preferences/MainWindow"


def change_everything():
    """As Preferences' pages write their values when OK is pressed."""
    view, window = FreeCAD.ParamGet(VIEW), FreeCAD.ParamGet(MAIN)
    for name in ("EnablePreselection", "EnableSelection", "UseAutoRotation", "CornerCoordSystem"):
        for _ in range(2):
            view.SetBool(name, not view.GetBool(name, True))
    for name in ("HighlightColor", "SelectionColor", "BackgroundColor", "BoundingBoxColor"):
        view.SetUnsigned(name, 0x12AB34FF)
    for style in ("Gui::BlenderNavigationStyle", "Gui::TouchpadNavigationStyle", "Gui::CADNavigationStyle"):
        view.SetString("NavigationStyle", style)
    for units in (3, 0):
        FreeCAD.Units.setSchema(units)
    for sheet in ("Dark-blue.qss", ""):
        window.SetString("StyleSheet", sheet)
    driver.rest(0.2)


class Preferences(driver.TexturedTest):
    def shown(self, show, part):
        """Whether the display of that name is there, drawn."""
        view = self.operation.ViewObject
        view.Show = show
        driver.wait(lambda: view.Proxy.scene.filled(part) and view.Proxy.scene.complete, 20)
        FreeCADGui.SendMsgToActiveView("ViewFit")
        driver.rest(0.2)
        return view.Proxy.scene.filled(part) and view.Proxy.scene.shown(part)

    def test_with_every_display_shown(self):
        parts = {texture_view.DIMPLES: "dimples", texture_view.PATH: "path", texture_view.AXES: "axes"}
        for show, part in parts.items():
            self.assertTrue(self.shown(show, part))
            change_everything()
        relief = simulate_panel.relief_of(patchmill.simulate(self.operation, window=((-3, -3), (3, 3))))[0]
        self.operation.ViewObject.Proxy.scene.show(relief)
        self.assertTrue(self.shown(texture_view.RELIEF, "relief"))
        change_everything()

    def test_ok_of_the_preferences_dialog(self):
        self.assertTrue(self.shown(texture_view.DIMPLES, "dimples"))
        pressed = []

        def press():
            dialog = QtGui.QApplication.activeModalWidget()
            if dialog is None:
                return QtCore.QTimer.singleShot(100, press)
            boxes = dialog.findChildren(QtGui.QDialogButtonBox)
            for kind in (QtGui.QDialogButtonBox.Apply, QtGui.QDialogButtonBox.Ok):
                (button,) = [b for b in (box.button(kind) for box in boxes) if b is not None]
                hands.click(button)
                pressed.append(kind)

        QtCore.QTimer.singleShot(100, press)
        FreeCADGui.runCommand("Std_DlgPreferences")
        self.assertEqual(len(pressed), 2)
        self.assertTrue(self.operation.ViewObject.Proxy.scene.shown("dimples"))


def main():
    return driver.run_tests(Preferences)
