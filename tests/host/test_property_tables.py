"""The property tables and what is made from them, or says the same in another place: docs/properties.md, the
fields of TextureInput, names of panels and errors.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import dataclasses
import pathlib
import sys
import unittest

import FreeCAD

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import properties  # noqa: E402
from patchmill.modifiers import dressup_dcm  # noqa: E402
from patchmill.operations.copy_milling import ObjectCopyMilling  # noqa: E402
from patchmill.operations.planar_texture import ObjectPlanarTexture  # noqa: E402
from patchmill.operations.pyramid_texture import ObjectPyramidTexture  # noqa: E402
from patchmill.properties import property_table  # noqa: E402
from patchmill.properties.property_table import ENUMERATION, field_of, label_of, property_of  # noqa: E402
from patchmill.textures.input import TextureInput  # noqa: E402

SETTINGS = {
    "texture": ObjectPlanarTexture.properties() + ObjectPyramidTexture.OWN_PROPERTIES,
    "copy": ObjectCopyMilling.properties(),
    "dcm": dressup_dcm.PROPERTIES,
}


class Tables(unittest.TestCase):
    def test_the_page_is_current(self):
        self.assertEqual(properties.PAGE.read_text(), properties.page(), "tools/freecad tools/properties.py")

    def test_the_page_has_every_property(self):
        text = properties.page()
        for rows in SETTINGS.values():
            for kind, name, group, tip, _ in rows:
                self.assertIn("| %s | %s: %s |" % (name, group, label_of(name)), text)
                self.assertIn(tip, text)

    def test_no_property_is_in_a_table_twice(self):
        for rows in SETTINGS.values():
            names = [row[1] for row in rows]
            self.assertEqual(sorted(set(names)), sorted(names))

    def test_a_texture_without_a_document_begins_as_one_with_it(self):
        """Defaults of TextureInput, which macros make by hand, are those of the table."""
        rows = {field_of(row[1]): row for row in SETTINGS["texture"]}
        compared = 0
        for field in dataclasses.fields(TextureInput):
            default = field.default
            if field.name not in rows or default is dataclasses.MISSING or default is None:
                continue
            kind, name, _, _, given = rows[field.name]
            given = given[0] if kind == ENUMERATION else given
            given = tuple(given) if isinstance(given, FreeCAD.Vector) else given
            compared += 1
            with self.subTest(name):
                self.assertEqual(default, given)
        self.assertGreater(compared, 40)

    def test_choices_that_an_older_document_lacks(self):
        """They are added, the value stays; one that there is no more is left as it is."""
        row = (ENUMERATION, "Order", "Texture", "in what order", ["Helix", "Rows", "Thread"])
        document = FreeCAD.newDocument("Choices")
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        for choices, value, found in (
            (["Helix", "Rows"], "Rows", row[4]),
            (["Rows", "Helix"], "Helix", row[4]),
            (["Helix", "Spiral"], "Spiral", ["Helix", "Spiral"]),
        ):
            with self.subTest(value):
                obj = document.addObject("App::FeaturePython", "Older")
                obj.addProperty(ENUMERATION, "Order")
                obj.Order = choices
                obj.Order = value
                property_table.add(obj, [row])
                self.assertEqual((obj.getEnumerationsOfProperty("Order"), obj.Order), (found, value))

    def test_names_of_fields_and_properties(self):
        for rows in SETTINGS.values():
            for row in rows:
                self.assertEqual(property_of(field_of(row[1])), row[1])
        self.assertEqual(field_of("PatchSideAcross"), "patch_side_across")
        self.assertEqual(label_of("PatchSideAcross"), "Patch side across")
        self.assertEqual(label_of("PatchesX"), "Patches X")


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
