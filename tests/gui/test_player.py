"""Playing a path: the tool is where the path says at each moment, and the dimples are met in order.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCADGui
import driver
import numpy as np
from patchmill_gui.panels.player import PlayerPanel, Timeline


class Player(driver.TexturedTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.path = cls.operation.Proxy.planned.path

    def test_at_the_end_of_each_timed_move_the_tool_is_there_with_its_turns(self):
        line = Timeline(self.path)
        tips, turns = self.path.tips, self.path.turns
        for move in range(1, len(tips), 97):
            tip, axis, _, _ = line.at(line.ends[move + 1])
            np.testing.assert_allclose(tip, tips[move], atol=1e-9)
            self.assertAlmostEqual(float(np.linalg.norm(axis)), 1.0)
            if np.isfinite(turns[move]):
                self.assertAlmostEqual(line.turned[move + 1] - line.turned[move], turns[move])

    def test_the_panel_plays_and_leaves_the_view_as_it_was(self):
        root = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()
        before = root.getNumChildren()
        driver.run_on(self.operation, "PatchMill_Play")
        self.assertTrue(driver.panel_open())
        self.assertEqual(root.getNumChildren(), before + 1)
        FreeCADGui.Control.closeDialog()
        panel = PlayerPanel(self.operation, self.path)
        panel.speed.setValue(4)
        panel.play.setChecked(True)
        self.assertTrue(driver.wait(lambda: panel.moment > 20.0, 30))
        panel.play.setChecked(False)
        panel.slider.setValue(50000)
        self.assertAlmostEqual(panel.moment, 0.5 * panel.line.seconds, places=6)
        at = panel.tool.pose.translation.getValue().getValue()
        tip, axis, _, _ = panel.line.at(panel.moment)
        np.testing.assert_allclose(at, tip + self.path.tool.radius * axis, atol=1e-4)
        panel.reject()

    def test_every_dimple_is_met_in_order(self):
        numbers = self.path.dimples[self.path.dimples >= 0]
        self.assertEqual(len(numbers), self.operation.DimpleCount)
        self.assertTrue((np.diff(numbers) > 0).all())


def main():
    return driver.run_tests(Player)
