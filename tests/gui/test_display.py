"""What is seen of a texture after OK and after the document is opened again: pictures of the screen,
compared.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import driver
import eyes
import FreeCADGui
import hands
import numpy as np
from PySide import QtGui


def look():
    """The camera as on any view of the same part."""
    FreeCADGui.activeDocument().activeView().viewAxonometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")


class Display(driver.BlockTest):
    def finish(self, panel):
        """A click on the panel's OK, and what is seen then."""
        (box,) = [
            b for b in FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox) if b.isVisible()
        ]
        button = box.button(QtGui.QDialogButtonBox.Ok)
        self.assertTrue(hands.on_top(button), "OK is out of sight")
        hands.click(button)
        self.assertTrue(driver.wait(lambda: not driver.panel_open(), 200), panel.error)
        look()
        return eyes.picture()

    def test_dimples_are_seen_after_ok_and_after_opening_again(self):
        operation, panel = driver.begin_texture(self.part)
        after_ok = self.finish(panel)
        self.assertGreater(eyes.fraction(after_ok, eyes.DIMPLE), 0.005)
        operation.ViewObject.Visibility = False
        self.assertEqual(eyes.fraction(eyes.picture(), eyes.DIMPLE), 0.0)
        operation.ViewObject.Visibility = True
        self.reopen()
        scene = self.document.getObject("CurvedTexture").ViewObject.Proxy.scene
        self.assertTrue(driver.wait(lambda: scene.filled("dimples")))
        look()
        opened = eyes.picture()
        differing = np.abs(after_ok.astype(int) - opened).max(axis=2) > 24
        self.assertLess(differing.mean(), 0.002)


def main():
    return driver.run_tests(Display)
