"""What is seen of a texture after OK, after the document is opened again, and of a simulated relief:
pictures of the screen, compared.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import driver
import eyes
import FreeCADGui
import hands
import numpy as np
from PySide import QtCore, QtGui

LEFT_OUT = "undercut"


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
        _, panel = driver.begin_texture(self.part)
        after_ok = self.finish(panel)
        self.assertGreater(eyes.fraction(after_ok, eyes.DIMPLE), 0.01)
        self.reopen()
        scene = self.document.getObject("CurvedTexture").ViewObject.Proxy.scene
        self.assertTrue(driver.wait(lambda: scene.filled("dimples")))
        look()
        opened = eyes.picture()
        differing = np.abs(after_ok.astype(int) - opened).max(axis=2) > 24
        self.assertLess(differing.mean(), 0.002)

    def test_a_relief_hides_the_face_that_it_lies_on(self):
        operation, panel = driver.begin_texture(self.part)
        self.finish(panel)
        driver.run_on(operation, "PatchMill_Simulate")
        hands.click_button("Simulate")
        scene = operation.ViewObject.Proxy.scene
        self.assertTrue(driver.wait(lambda: scene.filled("relief") and scene.complete, 120))
        look()
        QtGui.QCursor.setPos(QtCore.QPoint(5, 5))
        with_part = eyes.picture()
        models = [self.part, *self.document.getObject("Job").Model.Group]
        shown = [model for model in models if model.ViewObject.Visibility]
        for model in shown:
            model.ViewObject.Visibility = False
        alone = eyes.picture()
        operation.ViewObject.Visibility = False
        nothing = eyes.picture()
        relief = (alone != nothing).any(axis=2)
        self.assertGreater(relief.sum(), 2000)
        self.assertTrue(shown)
        differing = (np.abs(with_part.astype(int) - alone).max(axis=2) > 24) & relief
        self.assertLess(differing.sum() / relief.sum(), 0.02)

    def test_faces_that_look_away_from_the_tool_are_said_to(self):
        _, panel = driver.begin_texture(self.part)
        rows = panel.page.properties.rows
        hands.choose(rows["Machine"].editor, "table-table-ac")
        hands.choose(rows["ToolAxisMode"].editor, "Fixed")
        panel.page.advanced.heading.setChecked(True)
        rows["FixedAxis"].group.heading.setChecked(True)
        hands.enter(rows["FixedAxis"].boxes[0], "20", "Tab")
        self.assertTrue(driver.wait(lambda: panel.error is not None and panel.ready_now(), 200))
        self.assertIn(LEFT_OUT, str(panel.error))
        self.assertIn("lean the tool", str(panel.error))
        self.assertNotIn("tool tip", str(panel.error))


def main():
    return driver.run_tests(Display)
