"""One click on a face: values that suit, a head that says what comes out, and a click on what helps.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from unittest import mock

import driver
import FreeCAD
import FreeCADGui
import hands
import Part
from patchmill.advice import remedies
from patchmill.advice.found import Assessment, PatchQuality
from patchmill.advice.remedies import Remedy
from patchmill.freecad import preferences
from patchmill_gui.panels import texture_head
from PySide import QtGui


def plate(angle=0.0):
    """A flat plate, inclined by so many degrees."""
    shape = Part.makeBox(20, 16, 4)
    shape.rotate(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(0, 1, 0), -angle)
    return shape


class OneClick(driver.unittest.TestCase):
    def begin(self, shape, machine="linuxcnc-mill"):
        group = FreeCAD.ParamGet(preferences.PATH)
        group.SetString("Machine", machine)
        self.addCleanup(group.RemString, "Machine")
        self.document, self.part = driver.new_document(shape)
        self.addCleanup(FreeCAD.closeDocument, self.document.Name)
        self.operation, self.panel = driver.begin_texture(self.part)
        self.head = self.panel.advising.head

    def settled(self, state):
        self.assertTrue(driver.wait(lambda: self.head.state == state, 150), self.head.bar.text())

    def test_an_inclined_plate_is_good_as_it_comes(self):
        self.begin(plate(25.0))
        self.settled(texture_head.GREEN)
        self.assertFalse(self.operation.SameFlute)
        self.assertIn("dimples", self.head.text.text())
        boxes = self.panel.form.findChildren(QtGui.QToolBox) or [self.panel.form]
        for number in range(boxes[0].count()):
            boxes[0].setCurrentIndex(number)
            driver.rest(0.3)
            self.assertTrue(self.head.isVisible(), "on every page of the panel")
        driver.accept(self.panel)
        self.assertEqual(self.operation.Proxy.planned.pacing.verdict.holding, "holds")

    def test_a_choice_that_comes_late_leaves_what_the_user_chose_meanwhile(self):
        self.begin(plate(25.0))
        self.settled(texture_head.GREEN)
        late = self.panel.advising._choice
        self.assertIn("strategy", late.fields)
        hands.choose(self.panel.page.properties.rows["Strategy"].editor, "Feed per move")
        self.assertEqual(self.operation.Strategy, "Feed per move")
        self.panel.advising._chosen(late)
        self.assertEqual(self.operation.Strategy, "Feed per move")
        self.assertIsNone(self.panel.advising._choice)

    def test_a_flat_plate_is_red_until_the_fix_is_clicked(self):
        self.begin(plate())
        self.settled(texture_head.RED)
        self.assertTrue(driver.wait(lambda: self.head.buttons, 150))
        before = self.part.Shape.BoundBox.ZLength
        (button,) = [b for b in self.head.buttons if b.objectName() == "FixIncline"]
        hands.click(button)
        self.settled(texture_head.GREEN)
        driver.accept(self.panel)
        self.assertGreater(self.operation.DimpleCount, 500)
        self.assertAlmostEqual(self.part.Shape.BoundBox.ZLength, before)  # the user's part is as it was

    def test_the_tool_is_leant_where_the_machine_can(self):
        self.begin(plate(), "table-table-ac")
        self.assertTrue(driver.wait(lambda: self.head.buttons, 150))
        (button,) = [b for b in self.head.buttons if b.objectName() == "FixLean"]
        hands.click(button)
        self.settled(texture_head.GREEN)
        driver.accept(self.panel)
        self.assertGreater(self.operation.DimpleCount, 500)

    def test_no_values_are_looked_for_on_a_ball_whose_lattice_is_its_own(self):
        """Each trial would relax it anew; they are looked for again when it is no longer asked for."""
        self.begin(Part.makeSphere(4.0, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 0.0, 90.0))
        mapping = self.panel.page.properties.rows["Mapping"].editor
        choosing = self.panel.advising.choosing
        with mock.patch.object(choosing, "start", wraps=choosing.start) as looked_for:
            mapping.setCurrentIndex(mapping.findData("Ball"))
            self.assertTrue(driver.ready(self.panel))
            self.assertIsNone(self.panel.error)
            self.assertIsNotNone(self.panel.ready.planned.ball)
            looked_for.assert_not_called()
            mapping.setCurrentIndex(mapping.findData("On surface"))
            self.assertTrue(driver.wait(lambda: looked_for.called, 60))

    def test_the_head_says_what_looks_away_and_offers_to_lay_the_dimples_along_the_faces(self):
        head, taken = texture_head.Head(), []
        self.addCleanup(head.deleteLater)
        head.taken.connect(taken.append)
        head.show()
        half = Assessment(480, 0.44, {}, [PatchQuality((0.0, 0.0, 0.0), 16.0, 0.86)], away_fraction=0.556)
        head.show_found(half, 60.0, None)
        self.assertIn("56 % of the faces look away or are too steep", head.text.text())
        laid = Assessment(1403, 0.97, {}, [PatchQuality((0.0, 0.0, 0.0), 75.0, 1.0)], away_fraction=0.03)
        offered = [
            Remedy("incline", dict(remedies.LAID), laid, (1.0, 0.0, 0.0), 90.0),
            Remedy("lay", dict(remedies.LAID), laid),
        ]
        head.offer(offered)
        driver.rest(0.3)
        turned, lay = head.buttons
        self.assertIn("Incline the part 90°, dimples laid along the faces: 97 % good", turned.text())
        self.assertIn("Lay the dimples along the faces: 97 % good", lay.text())
        hands.click(lay)
        self.assertEqual(taken, offered[1:])
        head.show_found(laid, 60.0, None)
        self.assertNotIn("look away", head.text.text())

    def test_the_head_stays_at_the_top_and_is_empty_while_values_change(self):
        self.begin(plate(25.0))
        self.settled(texture_head.GREEN)
        place = self.head.geometry()
        hands.show(self.panel.page.properties.rows["Spacing"].editor)
        self.assertEqual(self.head.geometry(), place)
        driver.set_quantity(self.panel, "Spacing", 0.7)
        self.assertEqual((self.head.state, self.head.text.text()), (texture_head.GREY, ""))
        self.assertTrue(driver.wait(lambda: self.head.state != texture_head.GREY, 150))
        self.assertIn("dimples", self.head.text.text())

    def test_the_relief_of_the_worst_place_is_shown_until_a_value_changes(self):
        self.begin(plate(25.0))
        self.settled(texture_head.GREEN)
        scene = self.panel.scene
        self.assertTrue(driver.wait(lambda: scene.filled("relief") and scene.complete, 60))
        self.assertTrue(scene.shown("relief"))
        before, shown = self.panel.advising.drawn, []
        self.panel.placing.finished.connect(lambda _: shown.append(scene.filled("relief")))
        driver.set_quantity(self.panel, "Spacing", 0.7)
        self.assertTrue(driver.wait(lambda: shown, 60))
        self.assertEqual(shown, [False])  # it goes with the dimples of before
        self.assertTrue(driver.wait(lambda: self.panel.advising.drawn is not before, 150))
        self.assertTrue(scene.filled("relief"))
        box = self.panel.page.previews["relief"]
        hands.show(box)
        hands.click(box)
        self.assertFalse(scene.shown("relief"))

    def test_ok_stays_in_sight_whatever_size_the_window_gets(self):
        self.begin(plate(25.0))
        self.settled(texture_head.GREEN)
        window = FreeCADGui.getMainWindow()
        size = window.size()
        self.addCleanup(window.resize, size)
        for width, height in ((1100, 760), (1400, 900), (1024, 740)):
            window.showNormal()
            window.resize(width, height)
            driver.rest(1.0)
            (box,) = [b for b in window.findChildren(QtGui.QDialogButtonBox) if b.isVisible()]
            for kind in (QtGui.QDialogButtonBox.Ok, QtGui.QDialogButtonBox.Cancel):
                self.assertTrue(hands.on_top(box.button(kind)), (width, height))
            self.assertTrue(hands.on_top(self.head.bar))

    def test_the_advanced_fold_is_searched(self):
        self.begin(plate(25.0))
        page = self.panel.page
        rows = page.properties.rows
        for name in ("Spacing", "Machine", "Strategy"):
            self.assertTrue(rows[name].editor.isVisible(), name)
        self.assertFalse(rows["HelixOrder"].editor.isVisible())
        hands.show(page.advanced.heading)
        hands.click(page.advanced.heading)
        hands.show(page.advanced.search)
        hands.click(page.advanced.search)
        hands.write("stick out")
        driver.rest(0.3)
        self.assertTrue(rows["StickOut"].editor.isVisible())
        self.assertFalse(rows["HelixOrder"].editor.isVisible())
        hands.press("ctrl+a", "BackSpace")
        driver.rest(0.3)
        self.assertTrue(rows["HelixOrder"].editor.isVisible())

    def test_paced_strategies_are_reached_by_choosing_them(self):
        self.begin(plate(30.0))
        self.settled(texture_head.GREEN)
        rows = self.panel.page.properties.rows
        rows["Strategy"].group.heading.setChecked(True)
        for strategy in ("Constant feed", "Spindle-locked", "Feed per move"):
            hands.choose(rows["Strategy"].editor, strategy)
            self.assertTrue(driver.ready(self.panel))
            if strategy != "Constant feed":
                # a speed that the axes cannot follow may be told; what the strategy needs is set
                named = getattr(self.panel.error, "property", None)
                self.assertIn(named, (None, "MaxVelocity"))
                self.assertEqual((self.operation.SameFlute, self.operation.ExtraTurns), (False, 0.0))
        hands.choose(rows["Strategy"].editor, "Constant feed")
        self.assertTrue(driver.ready(self.panel))
        self.assertGreater(self.operation.ExtraTurns, 0.0)


def main():
    return driver.run_tests(OneClick)
