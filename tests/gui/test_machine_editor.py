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
from patchmill_gui.forms import machine_editor
from PySide import QtCore, QtGui

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

    def test_words_are_the_users_and_what_is_saved_the_files(self):
        self.close()
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")
        self.editor = machine_editor.show("table-table-ac")
        boxes = {place: self.editor.tree.itemWidget(item, 1) for place, item in self.editor.items.items()}
        shown = {place: box.currentText() for place, box in boxes.items() if box is not None}
        self.assertEqual(shown["rotary_axes", "0", "side"], "Tisch")
        self.assertEqual(shown["controller", "tcp"], "ja")
        hands.give_keyboard(self.editor)
        hands.choose(boxes["controller", "tcp"], "nein")
        self.assertIs(self.editor.data["controller"]["tcp"], False)
        self.assertTrue(self.editor.changed)

    def test_the_wheel_over_a_choice_changes_nothing(self):
        self.choose("table-table-ac")
        before = self.editor.data
        for box in (self.editor.choice, self.editor.tree.itemWidget(self.editor.items["axes",], 1)):
            hands.show(box)
            hands.wheel(box, 2)
            hands.wheel(box, -1)
        self.assertEqual((self.editor.key, self.editor.data), ("table-table-ac", before))
        self.assertFalse(self.editor.changed)

    def answer(self, key):
        """The next message box gets a key."""

        def press():
            box = QtGui.QApplication.activeModalWidget()
            if box is None:
                return QtCore.QTimer.singleShot(20, press)
            hands.give_keyboard(box)
            self.asked.append(box.text())
            button = box.button(QtGui.QMessageBox.Yes if key == "y" else QtGui.QMessageBox.No)
            hands.click(button)

        QtCore.QTimer.singleShot(20, press)

    def test_what_was_typed_goes_for_another_machine_only_if_the_user_says_so(self):
        self.asked, application = [], QtGui.QApplication.instance()
        application.setProperty("answered", True)
        self.addCleanup(application.setProperty, "answered", False)
        self.choose("linuxcnc-mill")
        self.type(ACCELERATION, "850")
        for key, shown in (("n", "linuxcnc-mill"), ("y", "haas-mill")):
            self.answer(key)
            hands.choose(self.editor.choice, "haas-mill")
            self.assertTrue(driver.wait(lambda: len(self.asked) == ("ny".index(key) + 1), 10))
            driver.rest(0.3)
            self.assertEqual(self.editor.key, shown)
            self.assertEqual(self.editor.choice.currentText(), shown)
            self.assertEqual(self.editor.changed, key == "n")
            if key == "n":
                self.assertEqual(self.editor.items[ACCELERATION].text(1), "850")

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
