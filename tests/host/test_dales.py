"""Dales of surfaces by watershed and Wolf pruning, against closed forms.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import unittest

import numpy as np
import patchmill
from patchmill import InputError
from patchmill.areal import filters
from patchmill.surface.height_map import HeightMap

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from test_areal_parameters import caps, waves  # noqa: E402


class Dales(unittest.TestCase):
    def test_caps_of_a_ball_have_their_closed_forms(self):
        surface, _, radius = caps(step=0.005)
        depth, count, size = 0.03, 64, 16.0
        found = patchmill.dales(surface)
        self.assertEqual(len(found.depths), count)
        self.assertFalse(found.open.any())
        told = found.parameters()
        volume = math.pi * depth * (3 * radius**2 + depth**2) / 6
        for name, wanted, share in (
            ("Svd", count / size, 1e-9),
            ("Sda", math.pi * radius**2, 0.01),
            ("Sdv", volume, 0.005),
            ("S5v", depth - volume * count / size, 0.005),
            ("depth", depth, 0.003),
            ("share", math.pi * radius**2 * count / size, 0.01),
            ("volume", volume * count / size, 0.005),
        ):
            with self.subTest(name):
                self.assertAlmostEqual(told[name], wanted, delta=share * wanted)

    def test_noise_and_holes_leave_the_dimples(self):
        """Noise of a fortieth of the depth makes hundreds of pits; smoothed and pruned they are the
        dimples."""
        surface, _, radius = caps(step=0.01)
        chance = np.random.default_rng(7)
        surface.heights = surface.heights + chance.normal(size=surface.shape) * 0.00075
        surface.heights[chance.random(surface.shape) < 0.05] = np.nan
        self.assertGreater(len(patchmill.dales(surface, pruned=0.0).depths), 1000)
        found = patchmill.dales(filters.smoothed(surface, 0.05), pruned=0.2)
        self.assertEqual(len(found.depths), 64)
        i, j = np.meshgrid(np.arange(8), np.arange(8))
        middles = 0.5 * np.column_stack([i.ravel(), j.ravel()]) + 0.245
        away = np.hypot(*(found.pits[:, None] - middles[None]).transpose(2, 0, 1)).min(axis=0)
        self.assertLess(away.max(), 0.06)
        self.assertAlmostEqual(found.parameters()["depth"], 0.03, delta=0.003)

    def test_a_surface_that_is_moved_has_the_same_dales(self):
        surface = waves()
        wanted = patchmill.dales(surface)
        moved = patchmill.dales(HeightMap(surface.heights + 100.0, surface.step, (3.0, -2.0)))
        np.testing.assert_allclose(moved.pits, wanted.pits + (3.0, -2.0))
        np.testing.assert_allclose(moved.depths, wanted.depths, atol=1e-6)
        for name, value in wanted.parameters().items():
            self.assertAlmostEqual(moved.parameters()[name], value, delta=1e-5 * abs(value) + 1e-12)

    def test_bad_input_is_named(self):
        unknown = HeightMap(np.full((5, 5), np.nan), 0.1)
        for call, name in (
            (lambda: patchmill.dales(waves(), pruned=1.0), "Pruning"),
            (lambda: patchmill.dales(waves(), pruned=math.nan), "Pruning"),
            (lambda: patchmill.dales(unknown), "Heights"),
        ):
            with self.assertRaises(InputError) as raised:
                call()
            self.assertEqual(raised.exception.property, name)


if __name__ == "__main__":
    unittest.main()
