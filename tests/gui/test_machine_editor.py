"""The window of machine files: a value typed, saved in the user's folder, refused by its row, taken away.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import tempfile
import unittest
from unittest import mock

import driver
import FreeCAD
import FreeCADGui
import hands
from patchmill.machine import machines
from PySide import QtGui

AXIS = "[AXIS_%s]\nMAX_VELOCITY = 50\nMAX_ACCELERATION = 750\nMIN_LIMIT = -100\nMAX_LIMIT = 100\n"
CONFIGURATION = "[KINS]\nKINEMATICS = trivkins\n[HAL]\nHALFILE = mill.hal\n"
CONFIGURATION += "".join(AXIS % letter for letter in "XYZ")
HAL = "net turns encoder.0.position => spindle.0.revs\nnet index spindle.0.index-enable encoder.0.index\n"
ACCELERATION = ("linear_axes", "acceleration_mm_s2")


class EditsMachines(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        patch = mock.patch.dict(os.environ, PATCHMILL_MACHINES=folder.name)
        patch.start()
        self.addCleanup(patch.stop)
        FreeCADGui.activateWorkbench("PatchMillWorkbench")
        FreeCADGui.runCommand("PatchMill_Machines")
        FreeCADGui.runCommand("PatchMill_Machines")  # a second click brings the same window to the front
        driver.rest(0.1)
        dialogs = FreeCADGui.getMainWindow().findChildren(QtGui.QDialog)
        (self.editor,) = [d for d in dialogs if hasattr(d, "show_machine") and d.isVisible()]
        self.addCleanup(self.close)

    def close(self):
        self.editor.changed = False
        self.editor.close()
        driver.rest(0.1)

    def choose(self, key):
        self.editor.choice.setCurrentText(key)
        self.editor.choice.activated.emit(self.editor.choice.currentIndex())

    def type(self, place, text):
        self.editor.items[place].setText(1, text)

    def test_a_value_is_saved_in_the_users_folder(self):
        self.choose("linuxcnc-mill")
        self.assertFalse(self.editor.buttons["save"].isEnabled())
        self.type(ACCELERATION, "850")
        self.editor.buttons["save"].click()
        self.assertEqual(machines.load("linuxcnc-mill").model.acceleration, 850.0)
        self.assertEqual(self.editor.message.text(), "")
        self.assertTrue(self.editor.buttons["remove"].isEnabled())
        self.editor.buttons["remove"].click()
        self.assertEqual(machines.load("linuxcnc-mill").model.acceleration, 2000.0)

    def test_a_wrong_value_is_refused_at_its_row(self):
        self.choose("table-table-ac")
        place = ("rotary_axes", "1", "direction")
        self.type(place, "1 0 0")
        self.editor.buttons["save"].click()
        self.assertIn("/rotary_axes/1/direction", self.editor.message.text())
        self.assertIs(self.editor.tree.currentItem(), self.editor.items[place])
        self.assertFalse(machines.own("table-table-ac"))

    def test_a_choice_and_a_copy(self):
        self.choose("table-table-ac")
        item = self.editor.items[("controller", "dialect")]
        self.editor.tree.itemWidget(item, 1).setCurrentText("fanuc")
        self.assertTrue(self.editor.save("ours"))
        self.assertEqual(self.editor.choice.currentText(), "ours")
        self.assertEqual(machines.load("ours").controller["dialect"], "fanuc")
        self.assertEqual(machines.load("table-table-ac").controller["dialect"], "linuxcnc")

    def test_a_name_that_is_no_file_name_is_refused(self):
        self.choose("linuxcnc-mill")
        self.assertFalse(self.editor.save("../ours"))
        self.assertIn("letters", self.editor.message.text())

    def test_a_linuxcnc_configuration_is_imported_by_clicks(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("shop mill.ini", CONFIGURATION), ("mill.hal", HAL), ("bad.ini", "[EMC]\n")):
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(text)
            self.choose("linuxcnc-mill")
            driver.answer_file_dialog(os.path.join(folder, "bad.ini"))
            hands.click(self.editor.buttons["import"])
            self.assertTrue(driver.wait(lambda: self.editor.message.text() != "", 20))
            self.assertIn("bad.ini", self.editor.message.text())
            self.assertEqual(self.editor.key, "linuxcnc-mill")
            driver.answer_file_dialog(os.path.join(folder, "shop mill.ini"))
            hands.click(self.editor.buttons["import"])
            self.assertTrue(driver.wait(lambda: self.editor.key == "shop-mill", 20))
        self.assertIn("start phase", self.editor.where.text())
        self.assertFalse(machines.own("shop-mill"))
        hands.click(self.editor.buttons["save"])
        self.assertTrue(driver.wait(lambda: machines.own("shop-mill"), 20), self.editor.message.text())
        self.assertEqual(self.editor.choice.currentText(), "shop-mill")
        self.assertEqual(machines.load("shop-mill").model.acceleration, 750.0)
        self.assertTrue(machines.load("shop-mill").model.spindle_lock)

    def test_a_machine_of_freecad_is_imported_by_clicks(self):
        axis = {"limits": {"min": 0, "max": 400}, "max_velocity": 6000}
        content = {"machine": {"name": "Shop", "axes": dict.fromkeys("XYZ", axis)}}
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "shop.fcm")
            with open(name, "w", encoding="utf-8") as file:
                json.dump(content, file)
            driver.answer_file_dialog(name)
            hands.click(self.editor.buttons["import"])
            self.assertTrue(driver.wait(lambda: self.editor.key == "shop", 20), self.editor.message.text())
        self.assertIn("Accelerations are not in the file", self.editor.where.text())
        hands.click(self.editor.buttons["save"])
        self.assertTrue(driver.wait(lambda: machines.own("shop"), 20), self.editor.message.text())
        self.assertEqual(machines.load("shop").model.velocity, 100.0)

    def test_an_open_panel_lists_a_machine_that_is_saved_meanwhile(self):
        document, part = driver.new_document(driver.wavy_block())
        self.addCleanup(lambda: FreeCAD.closeDocument(document.Name))
        driver.select(part, driver.top_face(part.Shape))
        FreeCADGui.runCommand("PatchMill_CurvedTexture")
        operation = document.getObject("CurvedTexture")
        panel = driver.panel_of(operation)
        self.addCleanup(panel.reject)
        self.assertTrue(driver.ready(panel))
        box = panel.page.properties.rows["Machine"].editor
        box.setCurrentIndex(box.findData("linuxcnc-mill"))
        told = []
        box.currentIndexChanged.connect(told.append)
        self.choose("table-table-ac")
        self.assertTrue(self.editor.save("ours"))
        self.assertLess(box.findData("ours"), 0)
        box.showPopup()
        box.hidePopup()
        self.assertGreater(box.findData("ours"), 0)
        self.assertEqual(box.currentData(), "linuxcnc-mill")
        self.assertEqual(told, [])
        box.setCurrentIndex(box.findData("ours"))
        self.assertTrue(driver.ready(panel))
        self.assertEqual(operation.Machine, "ours")
        self.choose("ours")
        self.editor.remove()
        box.showPopup()
        box.hidePopup()
        self.assertEqual(box.currentData(), "ours")  # gone, and still named


def main():
    return driver.run_tests(EditsMachines)
