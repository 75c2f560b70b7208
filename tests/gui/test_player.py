"""Playing a path: the tool is where the path says at each moment, and the dimples are met in order.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import driver
import FreeCAD
import FreeCADGui
import hands
import numpy as np
from patchmill.verify.checks import CLEAR, VIOLATED
from patchmill_gui.panels.player import PlayerPanel
from patchmill_gui.views.play_scene import TRAIL
from patchmill_gui.views.timeline import Timeline


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

    def test_places_are_told_in_the_users_unit(self):
        self.addCleanup(FreeCAD.Units.setSchema, 0)
        for schema, unit, millimetres in ((0, "mm", 1.0), (3, "in", 25.4)):
            FreeCAD.Units.setSchema(schema)
            panel = PlayerPanel(self.operation, self.path)
            panel.go_to(0.5 * panel.line.seconds)
            line = panel.place.text().splitlines()[2].split()
            self.assertEqual((line[:6:2], line[6]), (["X", "Y", "Z"], unit))
            told = millimetres * np.array([float(number) for number in line[1:6:2]])
            np.testing.assert_allclose(told, panel.line.at(panel.moment)[0], atol=2e-3)
            panel.reject()

    def test_way_and_dimples_grow_to_the_moment_and_no_further(self):
        scene = self.operation.ViewObject.Proxy.scene
        scene.switch("dimples", True)
        panel = PlayerPanel(self.operation, self.path)
        self.assertFalse(scene.shown("dimples"))
        view, path = panel.view, self.path
        lasting = np.flatnonzero(np.diff(panel.line.ends) > 0.0)
        for move in lasting[[0, 1, 40, len(lasting) // 2, -1]]:
            panel.go_to(0.5 * (panel.line.ends[move] + panel.line.ends[move + 1]))
            self.assertEqual(view._points.numPoints.getValue(), (path.dimples[:move] >= 0).sum())
            shown = view._line.numVertices.getValues()[0]
            self.assertEqual(shown, min(move + 1, TRAIL) + 1)
            last = view._way_points.point[shown - 1].getValue()
            np.testing.assert_allclose(last, panel.line.at(panel.moment)[0], atol=1e-4)
        panel.reject()
        self.assertTrue(scene.shown("dimples"))

    def test_the_time_is_the_operations(self):
        panel = PlayerPanel(self.operation, self.path)
        line = panel.line
        panel.reject()
        self.assertAlmostEqual(line.seconds, self.operation.MachiningTime, delta=1e-6 * line.seconds)

    def played(self):
        """The panel, shown, after its check."""
        panel = PlayerPanel(self.operation, self.path)
        FreeCADGui.Control.showDialog(panel)
        self.assertTrue(driver.wait(lambda: panel.result is not None or panel.error is not None, 60))
        return panel

    def test_what_the_check_finds_is_on_the_time_line(self):
        panel = self.played()  # the tool gouges at the block's edges
        self.assertEqual(panel.result.outcome, VIOLATED)
        moves = sorted({finding.move for finding in panel.result.findings})
        self.assertEqual(len(panel.findings_bar.shares), len(moves))
        for move in [*moves[:3], *moves[3:][-1:]]:
            if move not in moves[:3]:
                panel.go_to(panel.line.ends[move])
            hands.click(panel.next)
            self.assertAlmostEqual(panel.moment, panel.line.ends[move + 1])
        hands.click(panel.next)  # round again
        self.assertAlmostEqual(panel.moment, panel.line.ends[moves[0] + 1])
        panel.reject()

    def test_a_clear_path_has_nothing_on_its_time_line(self):
        tolerance, self.operation.GougeTolerance = self.operation.GougeTolerance, "1 mm"
        try:
            panel = self.played()
        finally:
            self.operation.GougeTolerance = tolerance
        self.assertEqual(panel.result.outcome, CLEAR)
        self.assertTrue(panel.next.isHidden())
        self.assertEqual(panel.findings_bar.shares, [])
        panel.reject()

    def test_what_cannot_be_checked_is_said_and_plays(self):
        tolerance, self.operation.GougeTolerance = self.operation.GougeTolerance, 0.0
        try:
            panel = self.played()
        finally:
            self.operation.GougeTolerance = tolerance
        self.assertIn("GougeTolerance", str(panel.error))
        self.assertIn("zero", panel.text.text())
        panel.go_to(1.0)
        self.assertEqual(panel.moment, 1.0)
        panel.reject()

    def test_every_dimple_is_met_in_order(self):
        numbers = self.path.dimples[self.path.dimples >= 0]
        self.assertEqual(len(numbers), self.operation.DimpleCount)
        self.assertTrue((np.diff(numbers) > 0).all())


def main():
    return driver.run_tests(Player)
