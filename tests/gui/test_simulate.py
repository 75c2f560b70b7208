"""Simulating and checking a texture from its panels: what is shown is what the functions say.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import tempfile
from unittest import mock

import FreeCAD
import FreeCADGui
import driver
import hands
import numpy as np
import patchmill
from patchmill.verify import checks
from patchmill_gui.panels.check_panel import CheckPanel
from patchmill_gui.panels.report_panel import ReportPanel
from patchmill_gui.panels.simulate_panel import SimulatePanel


class Simulate(driver.TexturedTest):
    def setUp(self):
        self.root = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()
        self.before = self.root.getNumChildren()

    def test_the_relief_is_shown_with_a_legend_and_a_table(self):
        panel = SimulatePanel(self.operation)
        FreeCADGui.Control.showDialog(panel)
        panel.size.setValue(4.0)
        panel.simulate()
        self.assertTrue(driver.wait(lambda: panel.result is not None or panel.error is not None))
        self.assertIsNone(panel.error)
        scene = self.operation.ViewObject.Proxy.scene
        self.assertTrue(scene.filled("relief") and scene.shown("relief"))
        self.assertFalse(scene.shown("dimples"))
        self.assertEqual(self.root.getNumChildren(), self.before + 1)
        direct = patchmill.simulate(self.operation, window=panel.window())
        np.testing.assert_array_equal(direct.heights, panel.result.heights)
        for name, value in direct.rows():
            self.assertIn(value, panel.text.text(), name)
        panel.reject()
        self.assertEqual(self.root.getNumChildren(), self.before)
        self.operation.ViewObject.Show = "Dimples"
        self.assertFalse(scene.shown("relief"))

    def test_window_and_runout_are_typed_in_inches_by_those_who_use_them(self):
        FreeCAD.Units.setSchema(3)
        self.addCleanup(FreeCAD.Units.setSchema, 0)
        panel = SimulatePanel(self.operation)
        FreeCADGui.Control.showDialog(panel)
        self.addCleanup(panel.reject)
        self.assertIn(" in", panel.size.text())
        hands.enter(panel.size, "0.1")
        hands.enter(panel.runout, "0.0002")
        (low, high), asked = panel.window(), []
        np.testing.assert_allclose(np.subtract(high, low), 2.54, rtol=1e-12)
        with mock.patch.object(patchmill, "simulate", lambda *_, **given: asked.append(given)):
            hands.click(panel.button)
            self.assertTrue(driver.wait(lambda: asked and not panel.work.busy, 20))
        self.assertAlmostEqual(asked[0]["runout"][0], 0.00508)
        hands.enter(panel.size, "0")
        self.assertIsNone(panel.window())

    def test_the_relief_is_saved_by_a_click(self):
        panel = SimulatePanel(self.operation)
        FreeCADGui.Control.showDialog(panel)
        panel.size.setValue(2.0)
        self.assertFalse(panel.saving.isEnabled())
        hands.click(panel.button)
        self.assertTrue(driver.wait(lambda: panel.result is not None or panel.error is not None))
        lines = panel.text.heightForWidth  # all of the table is seen
        self.assertTrue(driver.wait(lambda: panel.text.height() >= lines(panel.text.width()), 10))
        with tempfile.TemporaryDirectory() as folder:
            for name in ("relief.x3p", "relief.stl", "relief.dimples.csv"):
                driver.answer_file_dialog(os.path.join(folder, name))
                hands.click(panel.saving)
                self.assertTrue(driver.wait(lambda: os.path.exists(os.path.join(folder, name)), 60), name)
            read = patchmill.measured(os.path.join(folder, "relief.x3p"))
            np.testing.assert_allclose(read.heights, panel.result.heights, atol=1e-12)
            driver.answer_file_dialog(os.path.join(folder, "relief.doc"))
            hands.click(panel.saving)
            self.assertTrue(driver.wait(lambda: panel.error is not None))
            self.assertIn(".x3p", panel.text.text())
            self.assertNotIn("relief.doc", os.listdir(folder))
        panel.reject()

    def test_the_commands_open_their_panels(self):
        for command in ("PatchMill_Simulate", "PatchMill_Check", "PatchMill_Play"):
            driver.run_on(self.operation, command)
            self.assertTrue(driver.panel_open(), command)
            FreeCADGui.Control.closeDialog()
            driver.rest(0.1)
            self.assertFalse(driver.panel_open(), command)

    def test_a_simulation_can_be_cancelled(self):
        panel = SimulatePanel(self.operation)
        FreeCADGui.Control.showDialog(panel)
        panel.size.setValue(0.0)
        panel.simulate()
        self.assertTrue(panel.work.busy)
        panel.simulate()
        self.assertFalse(panel.work.busy)
        driver.rest(1.0)
        self.assertIsNone(panel.result)
        panel.reject()

    def report(self, folder):
        """(panel that has tried to write the report, and is closed; what it said)."""
        panel = ReportPanel(self.operation, folder)
        FreeCADGui.Control.showDialog(panel)
        self.assertTrue(driver.wait(lambda: panel.result is not None or panel.error is not None, 300))
        said = panel.text.text()
        panel.reject()
        self.assertFalse(driver.panel_open())
        return panel, said

    def test_the_report_is_written_and_linked_or_the_reason_told(self):
        with tempfile.TemporaryDirectory() as folder:
            _, said = self.report(folder)  # the tool gouges at the block's edges
            self.assertIn("PostGouging", said)
            self.assertEqual(os.listdir(folder), [])
            self.operation.PostGouging = True
            panel, said = self.report(folder)
            self.operation.PostGouging = False
            self.assertIsNone(panel.error)
            self.assertEqual(sorted(map(os.path.basename, panel.result)), sorted(os.listdir(folder)))
            (page,) = [name for name in panel.result if name.endswith(".html")]
            self.assertIn(page, said)

    def test_the_check_says_what_it_found_and_marks_it(self):
        panel = CheckPanel(self.operation)
        FreeCADGui.Control.showDialog(panel)
        self.assertTrue(driver.wait(lambda: panel.result is not None or panel.error is not None, 120))
        self.assertIsNone(panel.error)
        self.assertEqual(panel.result.sentence, checks.check(self.operation).sentence)
        self.assertIn(panel.result.sentence, panel.text.text())
        self.assertEqual(panel.marks.getNumChildren(), min(200, len(panel.result.findings)))
        panel.reject()
        self.assertEqual(self.root.getNumChildren(), self.before)


def main():
    return driver.run_tests(Simulate)
