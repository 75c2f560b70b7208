"""Values typed, stepped and passed over by the wheel: what is typed is what is stored, in every unit system
and with either decimal sign; what is not edited stays as it was.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import driver
import FreeCAD
import FreeCADGui
import hands
from patchmill.advice.found import Assessment
from patchmill.advice.remedies import Remedy
from patchmill_gui.fields import quantity_entry
from patchmill_gui.fields.sentences import in_user_units
from patchmill_gui.panels import texture_head
from PySide import QtCore, QtGui

UNITS = "User parameter:BaseApp/Preferences/Units"
MM, INCHES = 0, 3  # FreeCAD's schemes


class Values(driver.BlockTest):
    def setUp(self):
        super().setUp()
        self.addCleanup(FreeCAD.ParamGet(UNITS).RemInt, "UserSchema")
        self.addCleanup(QtCore.QLocale.setDefault, QtCore.QLocale())
        self.addCleanup(FreeCAD.Units.setSchema, MM)

    def begin(self, scheme=MM, language="en_US"):
        FreeCAD.Units.setSchema(scheme)
        QtCore.QLocale.setDefault(QtCore.QLocale(language))
        self.operation, self.panel = driver.begin_texture(self.part)
        self.panel.page.advanced.heading.setChecked(True)
        self.rows = self.panel.page.properties.rows
        return self.rows

    def typed(self, name, text, end="Return", pause=40):
        """What a property is after `text` was typed in its field."""
        hands.enter(self.rows[name].editor, text, end, pause)
        if not end:
            driver.rest(0.6)
        self.panel.page.properties.store()
        value = getattr(self.operation, name)
        return float(getattr(value, "Value", value))

    def formula(self):
        return dict(self.operation.ExpressionEngine)["Spacing"]

    def text(self, name):
        return self.rows[name].entry.line.text()

    def test_a_number_without_a_unit_counts_in_millimetres_however_small_the_last_was(self):
        self.begin()
        self.assertAlmostEqual(self.typed("RidgeHeight", "0.05 mm"), 0.05)
        self.assertEqual(self.text("RidgeHeight"), "0.05 mm")
        self.assertAlmostEqual(self.typed("RidgeHeight", "0.5"), 0.5)
        self.assertAlmostEqual(self.typed("RidgeHeight", "3 um", "Tab"), 0.003)
        self.assertAlmostEqual(self.typed("RidgeHeight", "0.004", None), 0.004)
        self.assertAlmostEqual(self.typed("RidgeHeight", "2*0.3"), 0.6)
        self.assertAlmostEqual(self.typed("RidgeHeight", "nonsense"), 0.6)
        self.assertEqual(self.text("RidgeHeight"), "0.60 mm")

    def test_comma_and_point_are_both_the_decimal_sign(self):
        for language in ("de_DE", "en_US"):
            self.begin(language=language)
            for text in ("0,6", "0.6", "0,6 mm", "0.6 mm"):
                self.assertAlmostEqual(self.typed("Spacing", text), 0.6, msg="%s %s" % (language, text))
            self.assertAlmostEqual(self.typed("Spacing", "0,7", None), 0.7)
            self.rows["ExtraTurns"].group.heading.setChecked(True)
            for text in ("0,25", "0.25"):
                self.assertAlmostEqual(self.typed("ExtraTurns", text), 0.25)
            self.assertEqual(self.text("Spacing"), "0,70 mm" if language == "de_DE" else "0.70 mm")
            self.panel.reject()

    def test_whoever_types_slowly_is_not_written_over(self):
        for language in ("de_DE", "en_US"):
            self.begin(language=language)
            for text, end in (("0,6 mm", "Return"), ("0.7 mm", "Tab"), ("2*0.4", "Return")):
                wanted = {"0,6 mm": 0.6, "0.7 mm": 0.7, "2*0.4": 0.8}[text]
                self.assertAlmostEqual(self.typed("Spacing", text, end, 2 * quantity_entry.REST_MS), wanted)
            self.panel.reject()

    def test_what_comes_in_while_one_types_does_not_write_over_it(self):
        self.begin()
        self.rows["ExtraTurns"].group.heading.setChecked(True)
        for name, first, rest, value in (("Spacing", "0.", "6", 0.6), ("PatchSide", "1", "2", 12),
                                         ("ExtraTurns", "0.", "25", 0.25)):  # fmt: skip
            hands.enter(self.rows[name].editor, first, None)
            self.panel.page.properties.store()
            self.panel.page.properties.show()
            hands.write(rest)
            hands.press("Return")
            self.panel.page.properties.store()
            found = getattr(self.operation, name)
            self.assertAlmostEqual(float(getattr(found, "Value", found)), value, msg=name)
            setattr(self.operation, name, 2 * value)  # the typing has ended: the next value is shown
            self.panel.page.properties.show()
            self.panel.page.properties.store()
            found = getattr(self.operation, name)
            self.assertAlmostEqual(float(getattr(found, "Value", found)), 2 * value, msg=name)

    def test_places_are_typed_in_inches_and_directions_are_not(self):
        rows = self.begin(INCHES)
        self.assertEqual(rows["Origin"].label.text(), "Origin [in]")
        self.operation.AutoOrigin, self.operation.AutoDirection = False, False
        self.operation.Origin = FreeCAD.Vector(25.4, 1.0, 3.0)
        self.panel.page.setFields(self.operation)
        self.assertAlmostEqual(rows["Origin"].boxes[0].value(), 1.0)
        hands.enter(rows["Origin"].boxes[2], "0.2")
        self.assertTrue(driver.wait(lambda: self.operation.Origin.z != 3.0, 10))
        self.assertEqual(tuple(self.operation.Origin), (25.4, 1.0, 0.2 * 25.4))
        hands.enter(rows["Direction"].boxes[0], "0.5")
        self.assertTrue(driver.wait(lambda: self.operation.Direction.x == 0.5, 10))

    def test_inches_are_shown_with_the_digits_that_small_depths_need(self):
        rows = self.begin(INCHES)
        self.operation.Depth = 0.02
        rows["Depth"].show(self.operation)
        self.assertEqual(self.text("Depth").split()[0], "0.0007874")
        rows["Depth"].store(self.operation)
        self.assertEqual(self.operation.Depth.Value, 0.02)
        self.assertAlmostEqual(self.typed("Depth", "0.001"), 0.0254)
        self.assertAlmostEqual(self.typed("Depth", "0.05 mm"), 0.05)

    def test_sentences_are_in_the_users_units(self):
        FreeCAD.Units.setSchema(INCHES)
        for said, shown in (
            ("give a value from 0.254 to 25.4 mm.", "give a value from 0.01 to 1.00 in."),
            ("2 x 5.08 mm² and 3 mm, F12.7 mm/s", "2 x 5.08 mm² and 0.1181 in, F12.7 mm/s"),
            ("423.333333333 mm/min at 1.5.3 mm", "16.67 in/min at 1.5.3 mm"),
        ):
            self.assertEqual(in_user_units(said), shown)
        FreeCAD.Units.setSchema(MM)
        self.assertEqual(in_user_units("2.8284271247461903 mm from 0.5 mm"), "2.828 mm from 0.5 mm")
        self.assertEqual(in_user_units("eine Kugel von 12,5 mm"), "eine Kugel von 12,5 mm")

    def test_small_lengths_in_sentences_have_their_digits(self):
        FreeCAD.Units.setSchema(INCHES)
        found = Assessment(100, 1.0, {})
        said = texture_head.remedy_text(Remedy("finer", {"spacing": 0.12}, found))
        self.assertIn("spacing 0.004724 in", said)
        _, panel = driver.begin_texture(self.part)
        panel.advising._helped(([], (0.05, 0.11), None, False, []))
        self.assertIn("radius of 0.001969 in; the ball of 0.004331 in", panel.advising.head.hint.text())
        panel.advising._helped(([], None, (0.15, 3.0), False, []))
        self.assertIn("about 0.005906 in wide", panel.advising.head.hint.text())
        panel.advising._helped(([], None, None, True, [(2.0, 0.64), (0.2, 0.9)]))
        said = panel.advising.head.hint.text()
        self.assertIn("Walls of the part", said)
        self.assertIn("0.07874 in reaches 64 % of the faces", said)
        self.assertIn("A ball of diameter 0.007874 in reaches 90 %", said)

    def test_an_error_at_its_field_is_in_the_users_units(self):
        rows = self.begin(INCHES)
        self.typed("Spacing", "9 mm")
        driver.wait(lambda: rows["Spacing"].error.text())
        self.assertRegex(rows["Spacing"].error.text(), r"^0\.2505 in .* of radius 0\.03937 in ")
        self.assertNotIn("mm", rows["Spacing"].error.text())

    def test_an_error_is_said_in_the_users_language(self):
        self.addCleanup(FreeCADGui.setLocale, "English")
        FreeCADGui.setLocale("German")
        rows = self.begin()
        self.typed("Spacing", "4")
        self.assertTrue(driver.wait(lambda: rows["Spacing"].error.text()))
        said = "2.828 mm von der nächsten Mulde: Eine Kugel vom Radius 1 mm lässt zwischen den Mulden"
        self.assertIn(said, rows["Spacing"].error.text())
        head = self.panel.advising.head.bar
        self.assertTrue(driver.wait(lambda: "Abstand = 2.828 mm von der" in head.text(), 20), head.text())

    def test_what_was_not_edited_keeps_every_digit(self):
        rows = self.begin()
        self.operation.Spacing = 0.512345678
        self.operation.Direction = FreeCAD.Vector(0.123456789, 0.2, -0.9)
        self.panel.page.properties.show()
        hands.show(rows["Spacing"].editor)
        hands.click(rows["Spacing"].editor)
        hands.press("Tab", "Tab")
        hands.click(rows["Depth"].editor)
        rows["Spacing"].store(self.operation)
        rows["Direction"].store(self.operation)
        self.assertEqual(self.operation.Spacing.Value, 0.512345678)
        self.assertEqual(self.operation.Direction.x, 0.123456789)

    def test_the_arrows_step_in_the_shown_unit(self):
        self.begin()
        self.typed("Spacing", "0.5")
        hands.press("Up", "Up")
        self.rows["Spacing"].store(self.operation)
        self.assertAlmostEqual(self.operation.Spacing.Value, 0.52)
        hands.press("Down")
        self.rows["Spacing"].store(self.operation)
        self.assertAlmostEqual(self.operation.Spacing.Value, 0.51)

    def test_an_expression_is_followed_and_not_overwritten(self):
        rows = self.begin()
        self.operation.setExpression("Spacing", "2 * 0.35 mm")
        before = self.formula()
        rows["Spacing"].show(self.operation)
        self.assertEqual(self.text("Spacing"), "0.70 mm")
        rows["Spacing"].store(self.operation)
        self.assertEqual(self.formula(), before)

    def test_return_ends_a_number_and_not_the_panel(self):
        self.begin()
        self.typed("Spacing", "0.6")
        self.typed("PatchSide", "9")
        driver.rest(1.0)
        self.assertTrue(driver.panel_open())
        self.assertEqual((self.operation.Spacing.Value, self.operation.PatchSide), (0.6, 9))

    def test_fields_stay_under_the_hand_while_the_head_comes_and_goes(self):
        self.begin()
        field, head = self.rows["Spacing"].editor, self.panel.advising.head
        driver.rest(0.5)
        hands.show(field)
        hands.click(field)
        place, height = field.mapToGlobal(QtCore.QPoint(0, 0)), head.height()
        for sentence in ("A sentence of the head that takes a line or two of it. " * 4, "", "Short", ""):
            head.note(sentence)
            driver.rest(0.3)
            self.assertEqual(field.mapToGlobal(QtCore.QPoint(0, 0)), place)
            self.assertTrue(not sentence or head.hint.isVisible())
        head.note("A sentence. " * 30)
        self.assertGreater(head.height(), height)

    def test_a_button_stays_under_the_pointer_while_the_head_comes_and_goes(self):
        self.begin()
        (button,) = [b for b in self.panel.page.form.findChildren(QtGui.QPushButton)
                     if b.objectName() == "FindSpeed"]
        head = self.panel.advising.head
        driver.rest(0.5)
        hands.show(button)
        hands.point_at(button)
        place = button.mapToGlobal(QtCore.QPoint(0, 0))
        for sentence in ("A sentence of the head that takes a line or two of it. " * 4, "", "Short", ""):
            head.note(sentence)
            driver.rest(0.3)
            self.assertEqual(button.mapToGlobal(QtCore.QPoint(0, 0)), place)

    def test_the_wheel_over_the_panel_edits_nothing(self):
        self.begin()
        for group in self.panel.page.properties.groups.values():
            group.heading.setChecked(True)
        driver.rest(0.3)
        before = {name: str(getattr(self.operation, name)) for name in self.rows}
        for name in ("Spacing", "PatchSide", "PatchShape", "Machine", "Strategy", "ExtraTurns"):
            editor = self.rows[name].editor
            hands.show(editor)
            hands.wheel(editor, 3)
            hands.wheel(editor, -3)
            hands.show(editor)
            hands.click(editor.findChild(QtGui.QLineEdit) or self.rows[name].label)
            hands.wheel(editor, 2)
        self.panel.page.properties.store()
        self.assertEqual({name: str(getattr(self.operation, name)) for name in self.rows}, before)
        self.assertTrue(driver.panel_open())


def main():
    return driver.run_tests(Values)
