"""A document that was made without a GUI, opened in a FreeCAD that has not shown the PatchMill workbench yet:
its operation and its job get their views, and the operation can be edited.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import subprocess
import tempfile
import unittest

import driver
import FreeCAD
import FreeCADGui


MAKE = """
import sys
sys.path.insert(0, %r)
import FreeCAD, Part, patchmill
from patchmill.operations import quick_setup
document = FreeCAD.newDocument("Made")
part = document.addObject("Part::Feature", "Part")
part.Shape = Part.makeSphere(12.0)
document.recompute()
operation = quick_setup.texture(patchmill.CurvedTexture, "CurvedTexture", part, ["Face1"])
patchmill.recompute(operation)
document.saveAs(%r)
"""


def saved_headless(folder):
    """A file with a texture operation, made by another FreeCAD without a GUI."""
    name, script = os.path.join(folder, "made.FCStd"), os.path.join(folder, "make.py")
    with open(script, "w", encoding="utf-8") as file:
        file.write(MAKE % (folder, name))
    root = os.environ["PATCHMILL_GUI_ROOT"]
    subprocess.run([os.path.join(root, "tools", "freecad"), script], check=True, timeout=300)
    return name


class ColdStart(unittest.TestCase):
    def test_a_saved_texture_is_edited_without_the_workbench_in_front(self):
        self.assertNotEqual(FreeCADGui.activeWorkbench().name(), "PatchMillWorkbench")
        with tempfile.TemporaryDirectory() as folder:
            document = FreeCAD.openDocument(saved_headless(folder))
        driver.rest(0.3)
        operation = document.getObject("CurvedTexture")
        self.assertEqual(type(operation.ViewObject.Proxy).__module__, "patchmill_gui.texture_view")
        operation.ViewObject.Document.setEdit(operation.ViewObject, 0)
        panel = driver.panel_of(operation)
        self.assertTrue(driver.ready(panel))
        self.assertIsNone(panel.error)
        panel.accept()
        self.assertTrue(driver.wait(lambda: not driver.panel_open()))
        self.assertGreater(operation.DimpleCount, 500)


def main():
    return driver.run_tests(ColdStart)
