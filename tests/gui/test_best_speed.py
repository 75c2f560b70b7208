"""Two clicks in a texture's panel: the speed that is done first and holds, and taking it over.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import driver
import FreeCAD
import hands
import Part
from PySide import QtGui


class BestSpeed(driver.unittest.TestCase):
    def setUp(self):
        shape = Part.makeBox(20, 16, 4)
        shape.rotate(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(0, 1, 0), -25.0)
        self.document, self.part = driver.new_document(shape)
        self.addCleanup(FreeCAD.closeDocument, self.document.Name)
        self.operation, self.panel = driver.begin_texture(self.part)
        self.panel.advising.following = False

    def button(self, name):
        (found,) = [b for b in self.panel.page.form.findChildren(QtGui.QPushButton) if b.objectName() == name]
        return found

    def click(self, button):
        """Scrolls again where sentences that came meanwhile took the button out of sight, as a user does."""
        for _ in range(5):
            hands.show(button)
            hands.point_at(button)
            if hands.on_top(button):
                break
        hands.click(button)

    def test_one_click_finds_it_and_one_takes_it(self):
        operation = self.operation
        operation.Strategy, operation.Machine = "Spindle-locked", "linuxcnc-mill"
        operation.SameFlute, operation.ExtraTurns, operation.Spacing = False, 0.0, 1.0
        operation.ToolController.SpindleSpeed = 400  # slower than need be
        self.panel.page.advised()
        self.assertTrue(driver.wait(self.panel.ready_now))
        before = operation.ToolController.SpindleSpeed
        find = self.button("FindSpeed")
        box = find.parent()
        self.click(find)
        self.assertTrue(driver.wait(lambda: box.said.text(), 10), "the click was not taken")
        self.assertTrue(driver.wait(lambda: not box.work.busy, 120))
        self.assertIsNotNone(box.best, [p.trouble for p in box.curve.found.curve])
        self.assertEqual(operation.ToolController.SpindleSpeed, before)  # nothing behind the user's back
        self.assertIn("S%d" % box.best.rpm, box.said.text())
        self.assertGreater(len(box.curve.places()), 5)
        self.assertNotEqual(box.best.rpm, round(before))
        self.click(self.button("TakeSpeed"))
        self.assertEqual(round(operation.ToolController.SpindleSpeed), box.best.rpm)
        self.assertTrue(driver.wait(self.panel.ready_now))
        driver.accept(self.panel)
        self.assertEqual(operation.Proxy.planned.pacing.verdict.holding, "holds")

    def test_without_a_machine_it_says_what_is_missing(self):
        operation = self.operation
        operation.Strategy, operation.Machine = "Constant feed", ""
        operation.SameFlute, operation.ExtraTurns = True, 5.0
        find = self.button("FindSpeed")
        box = find.parent()
        self.click(find)
        self.assertTrue(driver.wait(lambda: not box.work.busy and "Trying" not in box.said.text(), 120))
        self.assertIn("machine", box.wrong.text())
        self.assertTrue(box.wrong.isVisible())
        self.assertFalse(self.button("TakeSpeed").isVisible())

    def test_what_is_given_up_for_another_page_is_not_said_to_go_on(self):
        self.operation.Machine, self.operation.Strategy = "linuxcnc-mill", "Spindle-locked"
        self.operation.SameFlute, self.operation.ExtraTurns = False, 0.0
        self.panel.page.advised()
        self.assertTrue(driver.wait(self.panel.ready_now))
        find = self.button("FindSpeed")
        box = find.parent()
        self.click(find)
        self.assertTrue(driver.wait(lambda: box.work.busy, 10))
        self.assertIn("Trying", box.said.text())
        box.hide()  # as with the page of another tab
        box.show()
        self.assertFalse(box.work.busy)
        self.assertEqual(box.said.text(), "")


def main():
    return driver.run_tests(BestSpeed)
