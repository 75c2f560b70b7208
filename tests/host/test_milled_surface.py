"""What copy milling leaves: ridges of the height that the geometry gives, on flats and slopes, of every end;
the tilted ball; what is not milled.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import unittest

import _patchmill as core
import numpy as np
import Part
from _patchmill import InputError, MoveKind
from patchmill.path import milled_surface as milled

LINES, STEP = 1.0, 0.05  # mm
R = 2.0
LONG, WIDE = 3.0, 4.0  # mm, of the plate along x and y


def plate(slope=0.0):
    """BREP of a face that rises by `slope` along x."""
    high = LONG * slope
    corners = [(0, 0, 0), (LONG, 0, high), (LONG, WIDE, high), (0, WIDE, 0), (0, 0, 0)]
    return Part.Face(Part.makePolygon(corners)).exportBrepToString()


def lines(tool, slope=0.0, lift=0.0, axis=None, apart=LINES):
    """Passes along x over all of the plate and beyond, `apart` from each other; the tip is `lift` over it."""
    tips, kinds = [], []
    for number, y in enumerate(np.arange(-3.0, 8.0, apart)):
        ends = [(-2.0, y, -2.0 * slope + lift), (LONG + 2.0, y, (LONG + 2.0) * slope + lift)]
        for end in ends if number % 2 == 0 else ends[::-1]:
            kinds.append(MoveKind.LINK if len(tips) == 0 else MoveKind.CUT)
            tips.append(end)
    axes = None if axis is None else [axis] * len(tips)
    spindle = core.Spindle(100.0, "M3")
    turns = [math.nan] * len(tips)
    return core.make_path(tool, spindle, tips[0], tips, axes, [int(k) for k in kinds], turns)


class MilledSurface(unittest.TestCase):
    def over(self, path, slope=0.0, step=STEP):
        return milled.milled_surface(path, [plate(slope)], step)

    def test_ridges_of_a_ball_on_a_flat_are_as_high_as_geometry_says(self):
        tool = core.Tool(R, 2)
        left = self.over(lines(tool)).left
        self.assertAlmostEqual(np.nanmin(left), 0.0, delta=2e-4)
        ridge = R - math.sqrt(R**2 - 0.25 * LINES**2)
        self.assertAlmostEqual(np.nanmax(left), ridge, delta=0.5 * STEP * 0.5 * LINES / R)
        self.assertAlmostEqual(tool.scallop_height(LINES), ridge, delta=1e-9)

    def test_ridges_beside_the_path_are_below_what_is_said(self):
        """Along the middle of a pass the places that are looked at leave less than ALONG."""
        left = self.over(lines(core.Tool(R, 2)), step=0.03).left
        beside = abs((np.arange(len(left)) + 0.5) * 0.03 - 1.0).min() ** 2 / (2.0 * R)
        row = left[np.abs((np.arange(len(left)) + 0.5) * 0.03 - 1.0).argmin()]
        self.assertGreater(np.nanmax(row), beside)
        self.assertLess(np.nanmax(row), beside + 1.01 * milled.ALONG)

    def test_on_a_slope_heights_count_along_the_normal(self):
        slope = math.tan(math.radians(30.0))
        lift = R / math.cos(math.radians(30.0)) - R  # of the tip of a ball that touches the slope
        left = self.over(lines(core.Tool(R, 2), slope, lift), slope).left
        self.assertAlmostEqual(np.nanmin(left), 0.0, delta=5e-4)
        low = self.over(lines(core.Tool(R, 2), slope, lift - 0.1), slope).left
        self.assertAlmostEqual(np.nanmin(low), -0.1 * math.cos(math.radians(30.0)), delta=5e-4)

    def test_a_flat_bottom_leaves_nothing_and_a_corner_its_ridges(self):
        bull = core.Tool(R, 2, 1.0)
        self.assertAlmostEqual(np.nanmax(self.over(lines(bull, apart=1.9)).left), 0.0, delta=1e-9)
        heights = milled.end_heights(bull, np.array([0.0, 1.0, 1.5, 2.0, 2.1]))
        np.testing.assert_allclose(heights, [0.0, 0.0, 1.0 - math.sqrt(0.75), 1.0, np.inf])

    def test_a_tapered_end_goes_on_as_its_flank(self):
        angle, cutting = math.radians(10.0), 12.0
        tool = core.Tool(1.0, 2, taper=angle, cutting_length=cutting)
        (_, low, high, inner, outer) = tool.sections[0]
        heights = milled.end_heights(tool, np.array([0.0, inner, 0.5 * (inner + outer), outer, outer + 0.1]))
        np.testing.assert_allclose(heights, [0.0, low, 0.5 * (low + high), high, np.inf], atol=1e-9)

    def test_a_tilted_ball_leaves_what_an_upright_one_with_its_centre_does(self):
        tool, axis = core.Tool(R, 2), np.array([math.sin(0.3), 0.0, math.cos(0.3)])
        upright = self.over(lines(tool))
        moved = lines(tool, axis=axis)
        tips = moved.tips - R * (axis - (0.0, 0.0, 1.0))
        moved = core.make_path(
            tool, moved.spindle, tips[0], tips, moved.axes, moved.kinds, [math.nan] * len(tips)
        )
        np.testing.assert_allclose(self.over(moved).left, upright.left, atol=1e-6)
        with self.assertRaisesRegex(InputError, "ToolAxis"):
            self.over(lines(core.Tool(R, 2, 1.0), axis=axis))

    def test_where_the_tool_has_not_been_is_not_known(self):
        path = lines(core.Tool(R, 2))
        half = core.make_path(
            path.tool, path.spindle, path.start, path.tips[:8], None, path.kinds[:8], [math.nan] * 8
        )
        surface = self.over(half)
        reached = 0.0 + R  # of y: four passes, from -3 to 0 mm, and the ball's radius
        self.assertAlmostEqual(surface.milled, reached / WIDE, delta=0.02)
        self.assertTrue(np.isnan(surface.left[-1]).all() and np.isfinite(surface.left[0]).all())
        self.assertIn("%.1f %%" % (100.0 * surface.milled), surface.text())

    def test_what_cannot_be_is_refused_and_progress_stops_it(self):
        path = lines(core.Tool(R, 2))
        for step in (0.0, -1.0, math.nan, 11.0):
            with self.assertRaisesRegex(InputError, "GridStep"):
                self.over(path, step=step)
        aside = Part.Face(Part.makePolygon([(50, 50, 0), (60, 50, 0), (60, 60, 0), (50, 50, 0)]))
        with self.assertRaisesRegex(InputError, "Path"):
            milled.milled_surface(path, [aside.exportBrepToString()], 0.1)
        self.assertIsNone(milled.milled_surface(path, [plate()], STEP, lambda share: False))


if __name__ == "__main__":
    unittest.main()
