"""What remedies leave out: what is too flat, and under an upright tool what is too steep.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))

from dataclasses import replace  # noqa: E402

import FreeCAD  # noqa: E402
import one_click  # noqa: E402
import quality_parts  # noqa: E402
from patchmill.advice import remedies  # noqa: E402
from patchmill.advice.found import Assessment, PatchQuality, is_better  # noqa: E402
from patchmill_gui.panels import texture_head  # noqa: E402


def patches(*qualities):
    """PatchQuality at tilts of 10°, 20°, and so on, each for the same part of the dimples."""
    return [
        PatchQuality((0.0, 0.0, 0.0), 10.0 * (k + 1), quality, fraction=1.0 / len(qualities))
        for k, quality in enumerate(qualities)
    ]


class LeavingOut(unittest.TestCase):
    def finder(self, *qualities, machine="linuxcnc-mill"):
        """(Finder whose assessment finds patches of these qualities, TextureInput of a dome up to 53°)."""
        shape = quality_parts.dome(5.0, 0.8)
        operation = one_click.texture(shape, quality_parts.top_face(shape), machine)
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        found = Assessment(100, 1.0, {}, patches(*qualities))
        return remedies.Finder(lambda *_, **__: found, None), operation.Proxy.texture_input(operation)

    def test_the_largest_part_that_is_all_good_remains(self):
        for qualities, fields in (
            ((0.5, 1.0, 1.0), {"minimum_tilt": 15.0}),
            ((0.5, 1.0, 1.0, 0.4), {"minimum_tilt": 15.0, "steepest_slope": 35.0}),
            ((1.0, 0.4, 0.4), {"steepest_slope": 15.0}),
            ((1.0, 0.4, 1.0, 1.0), {"minimum_tilt": 25.0}),
            ((1.0, 1.0, 0.4, 1.0), {"steepest_slope": 25.0}),
        ):
            finder, given = self.finder(*qualities)
            self.assertEqual(finder.leave_out(given).fields, fields, qualities)
        for nothing in ((1.0, 1.0), (0.5, 0.5)):
            finder, given = self.finder(*nothing)
            self.assertIsNone(finder.leave_out(given), nothing)

    def test_slopes_are_no_tilts_where_the_tool_leans_or_looks_from_aside(self):
        finder, given = self.finder(0.5, 1.0, 0.4)
        aside = {"tool_axis_mode": "Fixed", "fixed_axis": (0.6, 0.0, 0.8)}
        for other in (aside, {"auto_direction": True}):
            self.assertIsNone(finder.leave_out(replace(given, **other)), other)
        finder, given = self.finder(1.0, 0.4, 1.0, machine="table-table-ac")
        self.assertEqual(finder.leave_out(replace(given, **aside)).fields, {"minimum_tilt": 25.0})

    def test_it_is_offered_where_what_remains_is_good_and_nothing_good_is_lost(self):
        now = Assessment(100, 1.0, {}, patches(1.0, 0.4))
        rest = Assessment(50, 0.5, {}, patches(1.0))
        less = Assessment(40, 0.4, {}, patches(1.0))
        self.assertEqual([one.remains_good for one in (now, rest, less)], [False, True, True])
        self.assertEqual([one.good for one in (now, rest, less)], [False, False, False])
        self.assertTrue(is_better(rest, now))
        self.assertFalse(is_better(less, now))
        self.assertFalse(is_better(rest, rest))
        self.assertFalse(replace(rest, whole=0.9).remains_good)

    def test_the_button_says_how_steep(self):
        found = Assessment(50, 0.5, {}, patches(1.0))

        def text(kind, **fields):
            return texture_head.remedy_text(remedies.Remedy(kind, fields, found)).split(":")[0]

        steep = "eave out what is steeper than 40°"
        self.assertEqual(text("leave out", steepest_slope=40.0), "L" + steep)
        self.assertEqual(
            text("leave out", minimum_tilt=9.0, steepest_slope=40.0), "Leave out what is too flat, l" + steep
        )
        self.assertEqual(text("values", steepest_slope=40.0), "Take the values that suit, l" + steep)
        laid = "Incline the part 0°, dimples laid along the faces"
        self.assertEqual(text("incline", **remedies.LAID), laid)


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() else 1)
