"""A document of the version before modules lay in folders, in the GUI: its views are ours, and a double click
opens the panels.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib
import os
import unittest

import driver
import FreeCAD
from patchmill_gui import old_names
from patchmill_gui.panels import copy_panel, dcm_panel, texture_view

SAVED = os.path.join(os.environ["PATCHMILL_GUI_ROOT"], "tests/host/old_documents/before_folders.FCStd")
VIEWS = {
    "PlanarTexture": texture_view.ViewProvider,
    "PyramidTexture": texture_view.ViewProvider,
    "CurvedTexture": texture_view.ViewProvider,
    "CalibrationPatch": texture_view.ViewProvider,
    "CopyMilling": copy_panel.CopyView,
    "DressupDCM": dcm_panel.DcmView,
}


class OldNames(unittest.TestCase):
    def test_a_module_found_under_its_old_name_is_the_same_object(self):
        for old, new in old_names.NEW_NAMES.items():
            module = importlib.import_module("patchmill_gui." + new)
            self.assertIs(importlib.import_module("patchmill_gui." + old), module, old)

    def test_what_documents_save_of_pages_is_their_old_name(self):
        from patchmill_gui.choice_rows import ChoiceRow
        from patchmill_gui.forms import choice_rows

        self.assertIs(ChoiceRow, choice_rows.ChoiceRow)
        for view in set(VIEWS.values()):
            self.assertIn(view.__module__.split(".")[1], old_names.NEW_NAMES)


class SavedBefore(unittest.TestCase):
    def setUp(self):
        before = len(driver.report_text())
        self.document = FreeCAD.openDocument(SAVED)
        driver.rest(0.5)
        self.said = driver.report_text()[before:]

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def test_nothing_fails_on_the_way(self):
        self.assertNotIn("Traceback", self.said)
        self.assertNotIn("has no attribute", self.said)

    def test_views_and_panels(self):
        for name, view in VIEWS.items():
            obj = self.document.getObject(name)
            self.assertIs(type(obj.ViewObject.Proxy), view)
            obj.ViewObject.doubleClicked()
            self.assertTrue(driver.wait(driver.panel_open), name)
            panel = driver.panel_of(obj)
            self.assertIsNone(getattr(panel, "error", None))
            panel.reject()
            self.assertTrue(driver.wait(lambda: not driver.panel_open()), name)


def main():
    return driver.run_tests(OldNames, SavedBefore)
