"""The patch whose relief is seen at once: that of the flattest place, as the assessment has it too.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import FreeCAD  # noqa: E402
import one_click  # noqa: E402
import patchmill  # noqa: E402
import quality_parts  # noqa: E402
from patchmill import InputError  # noqa: E402
from patchmill.advice import assessment  # noqa: E402
from patchmill.textures.plan import place_texture  # noqa: E402


class FirstPatch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shape = quality_parts.PARTS["dome"]()
        operation = one_click.texture(shape, quality_parts.top_face(shape), "linuxcnc-mill")
        cls.document = operation.Document.Name
        cls.given = operation.Proxy.texture_input(operation)
        cls.placed = place_texture(cls.given)

    @classmethod
    def tearDownClass(cls):
        FreeCAD.closeDocument(cls.document)

    def test_it_is_the_flattest_of_those_that_are_assessed(self):
        found = one_click.assess(self.given, 2)
        made = assessment.first_patch(patchmill.simulate, self.given, self.placed)
        flattest = min(found.patches, key=lambda patch: patch.tilt)
        self.assertGreater(len(found.patches), 2)
        self.assertEqual(made.quality, flattest.quality)
        self.assertEqual(tuple(made.plan.asked.origin), flattest.position)

    def test_where_it_cannot_be_made_the_next_one_is_taken(self):
        tried = []

        def failing(plan, **options):
            tried.append(plan.asked.origin)
            if len(tried) == 1:
                raise InputError("Window", "no dimples", "the texture has nothing to look at.")
            return patchmill.simulate(plan, **options)

        made = assessment.first_patch(failing, self.given, self.placed)
        self.assertEqual(len(set(tried)), 2)
        self.assertEqual(made.plan.asked.origin, tried[1])

    def test_there_may_be_none(self):
        def never(*_, **__):
            raise AssertionError("simulated")

        self.assertIsNone(assessment.first_patch(never, self.given, self.placed, lambda share: False))
        with mock.patch.object(self.placed, "free", object()):
            self.assertIsNone(assessment.first_patch(never, self.given, self.placed))


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
