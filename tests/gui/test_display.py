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

    def relief_picture(self):
        """What is seen once the relief of the worst place is there."""
        view = self.document.getObject("CurvedTexture").ViewObject
        scene = view.Proxy.scene
        there = lambda: scene.filled("relief") and scene.filled("dimples") and scene.complete  # noqa: E731
        self.assertTrue(driver.wait(there, 200))
        self.assertEqual(view.Show, "Relief")
        look()
        return eyes.picture()

    def test_the_relief_of_the_panel_is_shown_after_ok_and_that_of_a_simulation_by_itself(self):
        operation, panel = driver.begin_texture(self.part)
        settled = lambda: panel.advising.drawn[1] and panel.ready_now()  # noqa: E731
        self.assertTrue(driver.wait(settled, 200))
        view = operation.ViewObject.Proxy
        self.finish(panel)
        with_relief, (asked, drawn) = self.relief_picture(), panel.advising.drawn
        self.assertEqual(asked, operation.Proxy.planned.asked)
        self.assertIs(view.known_relief[1], drawn)
        operation.ViewObject.Show = "Dimples"
        differing = np.abs(with_relief.astype(int) - eyes.picture()).max(axis=2) > 24
        self.assertGreater(differing.mean(), 0.001)
        view.show_simulated(drawn)
        self.assertEqual(operation.ViewObject.Show, "Relief")
        self.assertEqual(eyes.fraction(eyes.picture(), eyes.DIMPLE), 0.0)

    def test_dimples_are_seen_after_ok_and_after_opening_again(self):
        operation, panel = driver.begin_texture(self.part)
        self.finish(panel)
        after_ok = self.relief_picture()
        self.assertGreater(eyes.fraction(after_ok, eyes.DIMPLE), 0.005)
        operation.ViewObject.Visibility = False
        self.assertEqual(eyes.fraction(eyes.picture(), eyes.DIMPLE), 0.0)
        operation.ViewObject.Visibility = True
        self.reopen()
        opened = self.relief_picture()
        differing = np.abs(after_ok.astype(int) - opened).max(axis=2) > 24
        self.assertLess(differing.mean(), 0.002)


def main():
    return driver.run_tests(Display)
