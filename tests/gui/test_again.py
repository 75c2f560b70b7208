"""Panels that are opened again and again, and left behind meanwhile: each opens, and nothing is raised.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import sys
import traceback

import driver
import FreeCAD
import FreeCADGui
from patchmill_gui.app import tool_paths


class Again(driver.TexturedTest):
    def setUp(self):
        self.told = []
        before = sys.excepthook
        self.addCleanup(lambda: setattr(sys, "excepthook", before))
        sys.excepthook = lambda *error: self.told.append("".join(traceback.format_exception(*error)))

    def test_a_panel_opens_every_time(self):
        kept = []  # as something may keep them: what is left of one must not be in the way of the next
        for _ in range(6):
            for command in ("PatchMill_Simulate", "PatchMill_Play"):
                driver.run_on(self.operation, command)
                self.assertTrue(driver.panel_open(), command)
                FreeCADGui.Control.closeDialog()
            self.operation.ViewObject.Document.setEdit(self.operation.ViewObject, 0)
            self.assertTrue(driver.panel_open())
            self.assertEqual([panel.buttonBox for panel in kept], [None] * len(kept))
            kept.append(driver.panel_of(self.operation))
            kept[-1].reject()
            self.assertFalse(driver.panel_open())
        self.assertEqual(self.told, [])

    def test_a_panel_closes_with_its_document(self):
        document, part = driver.new_document(driver.wavy_block(12.0, 8.0), "Other")
        operation, panel = driver.begin_texture(part)
        driver.accept(panel)
        driver.run_on(operation, "PatchMill_Simulate")
        self.assertTrue(driver.panel_open())
        FreeCAD.closeDocument(document.Name)
        self.assertTrue(driver.wait(lambda: not driver.panel_open(), 20))
        self.assertEqual(self.told, [])

    def test_cancel_takes_back_in_its_own_document(self):
        document, part = driver.new_document(driver.wavy_block(12.0, 8.0), "Other")
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        _, panel = driver.begin_texture(part)
        FreeCAD.setActiveDocument(self.document.Name)
        panel.reject()
        self.assertTrue(driver.wait(lambda: not driver.panel_open(), 20))
        self.assertIsNone(document.getObject("CurvedTexture"))
        self.assertTrue(tool_paths.is_ours(self.operation))
        self.assertEqual(self.told, [])


def main():
    return driver.run_tests(Again)
