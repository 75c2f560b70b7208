"""What copy milling leaves is shown from its context menu and by the command, of a modifier on it as well; it
goes when the panel closes, and the path comes back.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import driver
import eyes
import FreeCAD
import FreeCADGui
import hands
import numpy as np
from patchmill.path.milled_surface import milled_surface
from patchmill.verify import checks
from patchmill_gui.views import milled_panel
from PySide import QtGui


class Milled(driver.unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.document, part = driver.new_document(driver.wavy_block(12.0, 8.0))
        cls.part = part
        driver.run_on(part, "PatchMill_CopyMilling")
        cls.operation = cls.document.getObject("CopyMilling")
        driver.accept(driver.panel_of(cls.operation))

    @classmethod
    def tearDownClass(cls):
        FreeCAD.closeDocument(cls.document.Name)

    def setUp(self):
        self.opened = []
        before = milled_panel.MilledPanel.__init__

        def kept(panel, operation):
            before(panel, operation)
            self.opened.append(panel)

        milled_panel.MilledPanel.__init__ = kept
        self.addCleanup(setattr, milled_panel.MilledPanel, "__init__", before)
        self.addCleanup(FreeCADGui.Control.closeDialog)

    def shown(self):
        """The panel that was opened, with its result."""
        (panel,) = self.opened
        self.assertTrue(driver.wait(lambda: panel.result is not None or panel.error is not None, 200))
        self.assertIsNone(panel.error)
        return panel

    def test_it_is_shown_until_the_panel_closes(self):
        root = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()
        before, scene = root.getNumChildren(), self.operation.ViewObject.Proxy.scene.parts
        driver.run_on(self.operation, "PatchMill_Simulate")
        path = eyes.picture()
        panel = self.shown()
        self.assertTrue(driver.wait(lambda: panel.parts.complete))
        self.assertTrue(panel.parts.shown("relief"))
        self.assertFalse(scene.shown("path"))
        self.assertGreater((eyes.picture() != path).any(axis=2).mean(), 0.01)
        given = checks.check_input(self.operation)
        direct = milled_surface(given.path, given.breps)
        np.testing.assert_array_equal(direct.left, panel.result.left)
        for _, value in direct.rows():
            self.assertIn(value, panel.text.text())
        (box,) = [
            b for b in FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox) if b.isVisible()
        ]
        hands.click(box.button(QtGui.QDialogButtonBox.Close))
        self.assertFalse(driver.panel_open())
        self.assertEqual(root.getNumChildren(), before)
        self.assertTrue(scene.shown("path"))

    def test_it_goes_when_something_else_is_edited(self):
        root = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()
        before, scene = root.getNumChildren(), self.operation.ViewObject.Proxy.scene.parts
        for command in ("PatchMill_Simulate", "PatchMill_Check", "PatchMill_Play"):
            driver.run_on(self.operation, command)
            driver.rest(1.0)
            view = self.operation.ViewObject
            view.Document.setEdit(view, 0)
            driver.rest(0.5)
            self.assertEqual(root.getNumChildren(), before, command)
            self.assertTrue(scene.shown("path"), command)
            driver.panel_of(self.operation).reject()
            driver.rest(0.5)

    def test_the_context_menu_has_it(self):
        menu = QtGui.QMenu()
        self.operation.ViewObject.Proxy.setupContextMenu(self.operation.ViewObject, menu)
        (entry,) = [action for action in menu.actions() if action.text() == "Simulate marks"]
        entry.trigger()
        self.shown()

    def test_of_the_modifier_too(self):
        driver.run_on(self.operation, "PatchMill_DressupDcm")
        dressup = self.document.getObject("DressupDCM")
        panel = dressup.ViewObject.Proxy.panel
        panel.accept()
        self.assertTrue(driver.wait(lambda: not driver.panel_open(), 300), panel.error)
        driver.run_on(dressup, "PatchMill_Simulate")
        self.assertGreater(self.shown().result.milled, 0.9)

    def test_in_inches_heights_are_in_inches(self):
        self.addCleanup(FreeCAD.Units.setSchema, 0)
        FreeCAD.Units.setSchema(3)
        driver.run_on(self.operation, "PatchMill_Simulate")
        said = self.shown().text.text()
        self.assertRegex(said, r"0\.\d+ in")
        self.assertNotIn("µm", said)


def main():
    return driver.run_tests(Milled)
