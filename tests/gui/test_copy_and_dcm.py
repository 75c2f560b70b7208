"""Copy milling and the DCM modifier from their commands: panels, background, undo, reopening.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import gc
import re

import FreeCAD
import FreeCADGui
import driver
import numpy as np
from patchmill.freecad import preferences
from patchmill.machine import machining_time
from patchmill_gui.app import tool_paths
from patchmill_gui.work.work_panel import WorkPanel


class CopyAndDcm(driver.BlockTest):
    def begin_copy(self):
        driver.select(self.part, driver.top_face(self.part.Shape))
        FreeCADGui.runCommand("PatchMill_CopyMilling")
        operation = self.document.getObject("CopyMilling")
        return operation, driver.panel_of(operation)

    def copy_milled(self):
        operation, panel = self.begin_copy()
        driver.accept(panel)
        return operation

    def begin_dcm(self, operation):
        driver.run_on(operation, "PatchMill_DressupDcm")
        dressup = self.document.getObject("DressupDCM")
        return dressup, dressup.ViewObject.Proxy.panel

    def test_copy_milling_of_a_face_in_one_step_of_undo(self):
        before = self.names()
        operation, panel = self.begin_copy()
        panel.form_rows.rows["RadialDepth"].editor.setProperty("rawValue", 3.0)
        panel.box.button.click()
        self.assertTrue(driver.wait(lambda: panel.result is not None))
        self.assertTrue(operation.ViewObject.Proxy.scene.filled())
        driver.accept(panel)
        self.assertEqual(operation.State, ["Up-to-date"])
        self.assertAlmostEqual(operation.RadialDepth.Value, 3.0)
        self.assertGreater(operation.Moves, 20)
        self.assertEqual(len(tool_paths.path_of(operation)), operation.Moves)
        self.document.undo()
        self.assertEqual(self.names(), before)

    def said_and_accepted(self, panel):
        """What a panel's preview says, before OK."""
        panel.box.button.click()
        self.assertTrue(driver.wait(lambda: panel.result is not None))
        said = panel.box.text.text()
        driver.accept(panel)
        return said

    def test_a_machine_is_chosen_and_taken_by_what_comes_next(self):
        group = FreeCAD.ParamGet(preferences.PATH)
        self.addCleanup(group.SetString, "Machine", group.GetString("Machine", ""))
        group.RemString("Machine")
        operation, panel = self.begin_copy()
        self.assertEqual(operation.Machine, "")
        panel.form_rows.rows["Machine"].editor.setCurrentText("linuxcnc-mill")
        said = self.said_and_accepted(panel)
        self.assertEqual(operation.Machine, "linuxcnc-mill")
        self.assertIn(machining_time.in_words(operation.MachiningTime), said)  # one time
        self.assertEqual(operation.CycleTime, machining_time.clock(operation.MachiningTime))
        self.assertEqual(preferences.operation_defaults()["Machine"], "linuxcnc-mill")
        dressup, panel = self.begin_dcm(operation)
        self.assertEqual(dressup.Machine, "linuxcnc-mill")
        said = self.said_and_accepted(panel)
        self.assertEqual(dressup.CycleTime, machining_time.clock(dressup.MachiningTime))
        self.assertIn(machining_time.in_words(dressup.MachiningTime), said)

    def test_copy_milling_and_a_modifier_are_checked_and_played(self):
        operation = self.copy_milled()
        dressup, _ = self.begin_dcm(operation)
        driver.accept(dressup.ViewObject.Proxy.panel)
        for obj in (operation, dressup):
            for command in ("PatchMill_Check", "PatchMill_Play"):
                driver.run_on(obj, command)
                self.assertTrue(driver.panel_open(), command)
                (panel,) = [o for o in gc.get_objects() if isinstance(o, WorkPanel) and o._is_open()]
                self.assertTrue(driver.wait(lambda: panel.result is not None or panel.error is not None, 120))
                self.assertIsNone(panel.error)
                self.assertNotEqual(panel.result.outcome, "unknown", panel.result.sentence)
                panel.reject()
                driver.rest(0.1)

    def test_cancel_leaves_nothing(self):
        before = self.names()
        _, panel = self.begin_copy()
        panel.reject()
        self.assertTrue(driver.wait(lambda: not driver.panel_open()))
        self.assertEqual(self.names(), before)

    def test_ridges_are_told_with_their_digits_in_inches(self):
        FreeCAD.Units.setSchema(3)
        self.addCleanup(FreeCAD.Units.setSchema, 0)
        operation, panel = self.begin_copy()
        said = self.said_and_accepted(panel)
        radius = 0.5 * operation.ToolController.Tool.Diameter.Value
        spacing = operation.FinishingRadialDepth.Value
        ridge = radius - (radius**2 - 0.25 * spacing**2) ** 0.5
        (told,) = re.findall(r"ridges of (\S+) in on a flat", said)
        self.assertAlmostEqual(25.4 * float(told), ridge, delta=1e-3 * ridge)

    def test_a_panel_closed_by_a_macro_is_left_like_one_that_is_cancelled(self):
        _, panel = self.begin_copy()
        FreeCADGui.Control.closeDialog()
        driver.rest(0.1)  # its widgets are deleted
        FreeCADGui.activeDocument().resetEdit()
        self.assertTrue(driver.wait(lambda: panel.left, 10))
        self.assertFalse(driver.panel_open())

    def test_bad_values_are_told_at_their_field(self):
        _, panel = self.begin_copy()
        panel.form_rows.rows["AxialDepth"].editor.setProperty("rawValue", 0.0)
        panel.accept()
        self.assertTrue(driver.wait(lambda: panel.error is not None))
        self.assertIn("more than zero", panel.form_rows.rows["AxialDepth"].error.text())
        self.assertTrue(driver.panel_open())
        panel.reject()

    def test_dcm_on_copy_milling_with_its_slice(self):
        operation = self.copy_milled()
        dressup, panel = self.begin_dcm(operation)
        panel.form_rows.rows["VoxelSize"].editor.setProperty("rawValue", 1.0)
        panel.box.button.click()
        self.assertTrue(driver.wait(lambda: panel.result is not None or panel.error is not None))
        self.assertIsNone(panel.error)
        scene = dressup.ViewObject.Proxy.scene.parts
        self.assertTrue(scene.filled("slice") and scene.shown("slice"))
        for choice, shown in (("Distance to the product", True), ("Material", True), ("None", False)):
            panel.what.setCurrentText(choice)
            self.assertEqual(scene.shown("slice"), shown, choice)
        panel.what.setCurrentText("Feed")
        driver.accept(panel)
        self.assertFalse(scene.shown("slice"))
        path = tool_paths.path_of(dressup)
        lengths = np.linalg.norm(np.diff(np.vstack([[path.start], path.tips]), axis=0), axis=1)
        timed = np.isfinite(path.turns) & (lengths > 1e-9)
        feeds = 60.0 * lengths[timed] / (path.turns[timed] / path.spindle.speed)
        self.assertGreater(feeds.max(), feeds.min() + 50.0)  # mm/min: not one feed for all
        self.assertLessEqual(feeds.max(), 800.0 * 1.001)

    def test_a_texture_takes_its_axes_from_the_voxels(self):
        operation = self.copy_milled()
        self.document.getObject("Job").Stock.ExtZpos = 20  # room for long polygons
        operation.ToolController.SpindleSpeed = 200  # rpm: time for C to turn
        dressup, panel = self.begin_dcm(operation)
        driver.accept(panel)
        texture, panel = driver.begin_texture(self.part)
        rows = panel.page.properties.rows
        self.assertTrue(rows["PostureField"].editor.isHidden())
        rows["Machine"].editor.setCurrentText("table-table-ac")
        rows["ToolAxisMode"].editor.setCurrentText("Field")
        self.assertFalse(rows["PostureField"].editor.isHidden())
        self.assertFalse(rows["FieldVoxelSize"].editor.isHidden())
        choices = rows["PostureField"].editor
        self.assertEqual([choices.itemText(i) for i in range(choices.count())], ["(none)", dressup.Label])
        choices.setCurrentText(dressup.Label)
        self.assertTrue(rows["FieldVoxelSize"].editor.isHidden())
        self.assertTrue(driver.ready(panel))
        self.assertIsNone(panel.error)
        driver.accept(panel)
        self.assertEqual(texture.PostureField, dressup)
        self.assertEqual(texture.State, ["Up-to-date"])
        self.assertIsNotNone(texture.Proxy.planned.posture)
        self.assertIsNotNone(texture.Proxy.planned.input.posture_field.model)

    def test_the_load_is_shown_along_the_path_and_limited(self):
        operation = self.copy_milled()
        dressup, panel = self.begin_dcm(operation)
        scene = dressup.ViewObject.Proxy.scene.parts
        panel.box.button.click()
        self.assertTrue(driver.wait(lambda: panel.result is not None or panel.error is not None))
        self.assertNotIn(" N ", panel.box.text.text())  # nobody asked
        for choice in ("Force along the path", "Power along the path", "Chip thickness along the path"):
            panel.what.setCurrentText(choice)
            self.assertTrue(driver.wait(lambda: panel.result is not None or panel.error is not None))
            self.assertIsNone(panel.error)
            self.assertTrue(scene.filled("slice") and scene.shown("slice"), choice)
        free = float(re.search(r"Largest force (\d+) N", panel.box.text.text()).group(1))
        limit = round(0.5 * free)
        panel.form_rows.rows["ForceLimit"].editor.setProperty("rawValue", float(limit))
        said = self.said_and_accepted(panel)
        kept = float(re.search(r"Largest force (\d+) N", said).group(1))
        self.assertLess(kept, 1.1 * limit)
        self.assertEqual(dressup.ForceLimit, limit)
        self.assertAlmostEqual(dressup.LargestForce, kept, delta=0.51)
        self.assertEqual(dressup.State, ["Up-to-date"])

    def test_cancelled_dcm_gives_the_operation_back_to_its_job(self):
        operation = self.copy_milled()
        before = self.names()
        _, panel = self.begin_dcm(operation)
        panel.reject()
        driver.wait(lambda: not driver.panel_open())
        self.assertEqual(self.names(), before)
        self.assertIn(operation, self.document.getObject("Job").Operations.Group)

    def test_defaults_fit_the_tool(self):
        operation, panel = self.begin_copy()
        diameter = float(operation.ToolController.Tool.Diameter)
        self.assertLessEqual(operation.RadialDepth.Value, 0.5 * diameter)
        self.assertGreater(operation.SafeHeight.Value, self.document.getObject("Stock").Shape.BoundBox.ZMax)
        panel.reject()

    def test_a_panel_rounds_nothing_that_was_not_edited(self):
        dressup, panel = self.begin_dcm(self.copy_milled())
        high, low = dressup.FeedAtSkin.Value, dressup.FeedAtProduct.Value
        panel.form_rows.rows["FeedAtProduct"].editor.setProperty("rawValue", 5.0)
        driver.accept(panel)
        self.assertEqual(dressup.FeedAtSkin.Value, high)
        self.assertAlmostEqual(high, 800.0 / 60.0, 12)  # 13.33 as it is shown
        self.assertNotEqual(dressup.FeedAtProduct.Value, low)
        dressup.VoxelSize = 1.2345678
        dressup.ViewObject.Document.setEdit(dressup.ViewObject, 0)
        driver.accept(dressup.ViewObject.Proxy.panel)
        self.assertEqual(dressup.VoxelSize.Value, 1.2345678)

    def test_only_what_means_something_is_shown(self):
        _, panel = self.begin_dcm(self.copy_milled())
        rows = panel.form_rows.rows
        for controls, diffusion, shown, hidden in (
            ("Feed", "Steady", "FeedAtSkin", "TiltLimit"),
            ("Feed", "Transient", "TimeStep", "PostureForm"),
            ("Posture", "Transient", "TiltLimit", "TimeStep"),
            ("Feed and posture", "Steady", "PostureForm", "Diffusivity"),
        ):
            rows["Controls"].editor.setCurrentText(controls)
            rows["Diffusion"].editor.setCurrentText(diffusion)
            self.assertFalse(rows[shown].editor.isHidden(), shown)
            self.assertTrue(rows[hidden].editor.isHidden(), hidden)
        panel.reject()

    def test_views_are_restored_on_reopening(self):
        dressup, panel = self.begin_dcm(self.copy_milled())
        driver.accept(panel)
        self.reopen()
        for name in ("CopyMilling", "DressupDCM"):  # nothing of ours is drawn yet: FreeCAD's lines, all
            view = self.document.getObject(name).ViewObject
            self.assertEqual((view.StartIndex, view.ShowCount), (0, 0), name)
            view.Object.touch()
        self.document.recompute()
        driver.rest(0.2)
        for name in ("CopyMilling", "DressupDCM"):
            self.assertGreater(self.document.getObject(name).ViewObject.StartIndex, 100, name)
        for name, module in (("CopyMilling", "copy_panel"), ("DressupDCM", "dcm_panel")):
            view = self.document.getObject(name).ViewObject.Proxy
            self.assertEqual(type(view).__module__, "patchmill_gui." + module)
            self.assertIsNotNone(view.scene)


def main():
    return driver.run_tests(CopyAndDcm)
