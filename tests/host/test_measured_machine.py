"""What a measured texture says of the machine that cut it: deviations that were put into the motion are
found in the relief, within the uncertainty that is told.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import unittest

import FreeCAD
import numpy as np
import patchmill
from patchmill.areal.late_marks import late_marks
from patchmill.areal.machine_deviations import samples_with
from patchmill.areal.measured_texture import marks_of
from patchmill.areal.planned_marks import planned_marks
from patchmill.surface.height_map import HeightMap

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from recipe import small_job  # noqa: E402

STEP, SPACING = 0.02, 0.5


def locked_texture(name):
    """One spindle-locked patch of 10 x 10 dimples on the steepest corner."""
    document, _, op = small_job(name=name)
    op.PatchSide, op.PatchesX, op.PatchesY = 10, 1, 1
    op.Origin, op.Strategy, op.Machine = (-25, -25, 0), "Spindle-locked", "linuxcnc-mill"
    op.SameFlute, op.ExtraTurns = False, 0.0
    return document, patchmill.recompute(op)


class MeasuredMachine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.document, cls.plan = locked_texture("machine")
        cls.marks = planned_marks(cls.plan)
        cls.reference = marks_of(cls.plan, STEP)

    @classmethod
    def tearDownClass(cls):
        FreeCAD.closeDocument(cls.document.Name)

    def test_marks_of_the_plan(self):
        marks = self.marks
        self.assertEqual(len(marks.numbers), 100)
        self.assertTrue(marks.straight.all())
        self.assertEqual(set(marks.flutes.tolist()), {0, 1})
        np.testing.assert_allclose(marks.pitch, SPACING, rtol=0.05)
        inner = marks.rows[1:] == marks.rows[:-1]
        way = np.diff(marks.places, axis=0)[inner]
        np.testing.assert_allclose(way / SPACING, marks.travel[1:][inner], atol=0.01)
        bends = (marks.travel[1:] * marks.travel[:-1]).sum(axis=1) < 0.5
        self.assertEqual(len(np.unique(marks.rows)), bends.sum() + 1)

    def test_places_that_are_late_are_told_exactly(self):
        """Marks moved by the equation itself: turn, shift, start phase, spindle error and play come back."""
        marks, chance = self.marks, np.random.default_rng(3)
        for _ in range(20):
            late, error = chance.uniform(-1.5, 1.5), chance.uniform(-0.003, 0.003)
            play = chance.uniform(0.001, 0.005, 2)
            turn, shift = chance.uniform(-0.1, 0.1), chance.uniform(-0.3, 0.3, 2)
            turns = marks.turns - np.median(marks.turns)
            along = marks.pitch * 2 * (late / (2 * math.pi) + error * turns)
            along -= marks.pitch * np.round(along / marks.pitch)
            places = marks.places + along[:, None] * marks.travel
            places = places + marks.moved_by_play(0, play[0]) + marks.moved_by_play(1, play[1])
            c, s = math.cos(turn), math.sin(turn)
            found = (places - shift) @ np.array([[c, -s], [s, c]])
            fit = late_marks(found, marks, marks.places, SPACING, [(turn + 0.002, shift + 0.08)])
            self.assertAlmostEqual(math.remainder(fit.late - late, math.pi), 0.0, delta=1e-3)
            self.assertAlmostEqual(fit.error, error, delta=1e-6)
            np.testing.assert_allclose(fit.play, play, atol=2e-5)
            self.assertAlmostEqual(fit.angle, turn, delta=1e-5)

    def measured(self, late, error, play, runout, chance):
        """MeasuredTexture of the relief that these deviations leave, with noise and holes."""
        samples = samples_with(self.plan, self.marks, late, error, play)
        relief = patchmill.simulate(self.plan, samples=samples, step=STEP, runout=runout).height_map()
        heights = relief.heights + chance.normal(size=relief.shape) * 0.0005
        heights[chance.random(relief.shape) < 0.05] = np.nan
        surface = HeightMap(heights, STEP, (3.0, -4.0))
        return patchmill.measured_texture(self.plan, surface, angle=0.0, reference=self.reference)

    def test_deviations_of_a_relief_are_found(self):
        chance = np.random.default_rng(11)
        for late, error, play, runout in (
            (0.0, 0.0, (0.0, 0.0), 0.0),
            (0.7, 0.0, (0.003, 0.001), 0.003),
            (-1.2, 0.002, (0.0, 0.004), -0.004),
            (1.5, 0.002, (0.0, 0.0), 0.004),  # so late that for half of the dimples another flute cuts
        ):
            told = self.measured(late, error, play, (0.0, runout), chance)
            wanted = {
                "flutes late": math.degrees(late),
                "spindle error": 100 * error,
                "play of X": 1e3 * play[0],
                "play of Y": 1e3 * play[1],
                "runout of flute 2 over flute 1": 1e3 * runout,
                "radius of the tool": 1.0,
            }
            for name, value in wanted.items():
                with self.subTest(name, late=late):
                    found = told.finding(name)
                    self.assertLessEqual(abs(found.value - value), 1.2 * found.uncertainty)
            self.assertLess(abs(told.finding("flutes late").value - math.degrees(late)), 1.0)
            self.assertLess(abs(told.finding("runout of flute 2 over flute 1").value - 1e3 * runout), 0.5)

    def test_what_cannot_be_told_is_unknown(self):
        """Without the turn a square of marks is the same from four sides."""
        samples = samples_with(self.plan, self.marks, 0.0, 0.0, (0.0, 0.0))
        surface = patchmill.simulate(self.plan, samples=samples, step=STEP).height_map()
        told = patchmill.measured_texture(self.plan, surface, reference=self.reference)
        self.assertIsNone(told.finding("flutes late").value)
        self.assertIn("say how it is turned", told.text())


if __name__ == "__main__":
    unittest.main()
