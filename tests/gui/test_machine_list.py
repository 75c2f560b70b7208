"""A machine is chosen from the open list by mouse and by keys, in the panel and in Simulate; files that come
and go meanwhile are seen.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import tempfile

import driver
import FreeCADGui
import hands
from patchmill.machine import machines
from patchmill_gui.panels.simulate_panel import SimulatePanel


class MachineList(driver.BlockTest):
    def setUp(self):
        self.document, self.part = driver.new_document(driver.wavy_block(12.0, 8.0))
        self.operation, self.panel = driver.begin_texture(self.part)
        rows = self.panel.page.properties.rows
        rows["Machine"].group.heading.setChecked(True)
        self.box = rows["Machine"].editor

    def machine(self):
        """What the operation would be planned for."""
        self.panel.page.properties.store()
        return self.operation.Machine

    def test_by_mouse(self):
        for name in ("table-table-ac", "linuxcnc-mill", "open-loop-mill"):
            hands.choose(self.box, name)
            self.assertTrue(driver.ready(self.panel))
            self.assertEqual((self.box.currentText(), self.machine()), (name, name))

    def test_by_keys(self):
        hands.choose(self.box, "linuxcnc-mill")
        hands.press("space", "Down", "Return")
        chosen = machines.names()[machines.names().index("linuxcnc-mill") + 1]
        self.assertEqual((self.box.currentText(), self.machine()), (chosen, chosen))

    def test_escape_leaves_what_was_chosen(self):
        hands.choose(self.box, "linuxcnc-mill")
        hands.click(self.box)
        hands.press("Down", "Down", "Escape")
        self.assertEqual(self.machine(), "linuxcnc-mill")

    def test_a_file_made_meanwhile_is_listed_and_one_taken_away_is_not(self):
        before = os.environ.get("PATCHMILL_MACHINES")
        with tempfile.TemporaryDirectory() as folder:
            os.environ["PATCHMILL_MACHINES"] = folder
            machines.save("a-new-one", machines.load("linuxcnc-mill").data)
            hands.choose(self.box, "linuxcnc-mill")
            hands.choose(self.box, "a-new-one")
            self.assertEqual(self.machine(), "a-new-one")
            hands.choose(self.box, "linuxcnc-mill")
            machines.remove("a-new-one")
            self.box.refresh()
            self.assertLess(self.box.findData("a-new-one"), 0)
            self.assertEqual(self.machine(), "linuxcnc-mill")
        os.environ.pop("PATCHMILL_MACHINES")
        if before is not None:
            os.environ["PATCHMILL_MACHINES"] = before


class InSimulate(driver.TexturedTest):
    def test_by_mouse(self):
        panel = SimulatePanel(self.operation)
        FreeCADGui.Control.showDialog(panel)
        driver.rest(0.3)
        hands.choose(panel.machine, "as linuxcnc-mill would run it")
        self.assertEqual(panel.machine.currentData(), "linuxcnc-mill")
        hands.choose(panel.machine, "as planned")
        self.assertIsNone(panel.machine.currentData())
        panel.reject()


def main():
    return driver.run_tests(MachineList, InSimulate)
