"""Virtual measurements: dimples are found in them, laid on the plan, and say what the machine did.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import unittest

import numpy as np
import patchmill
from patchmill import InputError
from patchmill.areal.dimples import find_dimples
from patchmill.areal.measured_texture import measured_texture, travel_shift
from patchmill.areal.registration import register
from patchmill.surface.height_map import HeightMap

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from test_simulate import tilted_job  # noqa: E402

SPACING = 0.5


def lattice(hexagonal=False):
    """Places of a texture with a corner missing, so that it looks the same from no other side."""
    i, j = np.meshgrid(np.arange(20), np.arange(16))
    x = i + (0.5 * (j % 2) if hexagonal else 0.0)
    y = j * (math.sqrt(0.75) if hexagonal else 1.0)
    places = SPACING * np.column_stack([x.ravel(), y.ravel()])
    return places[~((places[:, 0] > 7.2) & (places[:, 1] > 4.8))]


def turned(places, angle):
    c, s = math.cos(angle), math.sin(angle)
    return places @ np.array([[c, s], [-s, c]])


def scanned(places, chance, radius=1.0, depth=0.02, step=0.02, noise=0.0005, holes=0.05):
    """HeightMap of ball dimples at the places, with noise and holes."""
    low = places.min(axis=0) - 0.5
    columns, rows = np.ceil((places.max(axis=0) + 0.5 - low) / step).astype(int)
    heights = np.zeros((rows, columns))
    surface = HeightMap(heights, step, tuple(low))
    x, y = surface.x(), surface.y()
    for place in places:
        c, r = np.round((place - low) / step).astype(int)
        block = (slice(max(r - 15, 0), r + 16), slice(max(c - 15, 0), c + 16))
        square = (x[block[1]][None, :] - place[0]) ** 2 + (y[block[0]][:, None] - place[1]) ** 2
        bowl = radius - depth - np.sqrt(np.maximum(radius**2 - square, 0.0))
        heights[block] = np.minimum(heights[block], bowl)
    heights += chance.normal(size=heights.shape) * noise
    heights[chance.random(heights.shape) < holes] = np.nan
    return surface


class Measured(unittest.TestCase):
    def test_hidden_turns_and_shifts_are_found(self):
        """In random cases, with places that scatter by 3 µm, a tool of unknown radius, noise and holes."""
        for seed in range(20):
            chance = np.random.default_rng(seed)
            hexagonal = bool(seed % 2)
            planned = lattice(hexagonal)
            angle, shift = chance.uniform(-math.pi, math.pi), chance.uniform(-20, 20, 2)
            radius = chance.uniform(0.8, 1.5)
            moved = planned + chance.normal(size=planned.shape) * 0.003
            surface = scanned(turned(moved - shift, -angle), chance, radius)
            with self.subTest(seed):
                found = find_dimples(surface, SPACING)
                self.assertEqual(len(found.places), len(planned))
                one = register(found.places, planned, SPACING, fold=6 if hexagonal else 4)
                self.assertEqual(len(one.pairs), len(planned))
                self.assertEqual((len(one.missing), len(one.extra)), (0, 0))
                away = (one.angle - angle + math.pi) % (2 * math.pi) - math.pi
                self.assertLess(abs(away), 4 * 0.003 / math.sqrt(len(planned)) / 2.5)
                np.testing.assert_allclose(one.placed(turned(planned - shift, -angle)), planned, atol=0.002)
                self.assertLess(one.doubt, 0.98)
                curved = np.sqrt(found.radii.prod(axis=1))
                self.assertAlmostEqual(np.median(curved), radius, delta=0.03 * radius)

    def test_what_is_missing_and_what_nobody_planned_is_counted(self):
        chance, planned = np.random.default_rng(5), lattice()
        there = np.delete(planned, [45, 130, 131], axis=0)
        there = np.vstack([there, planned[100] + (0.25, 0.25)])
        found = find_dimples(scanned(there, chance), SPACING)
        one = register(found.places, planned, SPACING)
        self.assertEqual(sorted(one.missing.tolist()), [45, 130, 131])
        self.assertEqual(len(one.extra), 1)
        extra = one.placed(found.places[one.extra])
        np.testing.assert_allclose(extra, [planned[100] + (0.25, 0.25)], atol=0.02)

    def test_a_piece_of_a_lattice_without_a_border_is_ambiguous(self):
        i, j = np.meshgrid(np.arange(20), np.arange(20))
        planned = SPACING * np.column_stack([i.ravel(), j.ravel()])
        inner = planned[(planned > 2.9).all(axis=1) & (planned < 6.1).all(axis=1)]
        one = register(inner + (0.1, 0.2), planned, SPACING)
        self.assertGreater(one.doubt, 0.98)

    def test_a_shift_along_the_travel_is_told_from_a_shift_of_the_part(self):
        planned = lattice()
        there = np.where((np.round(planned[:, 1] / SPACING) % 2 == 0)[:, None], 1.0, -1.0) * (1.0, 0.0)
        chance, inside = np.random.default_rng(1), 0
        for _ in range(100):
            off = chance.uniform(-0.01, 0.01)
            found = planned + off * there + (0.004, -0.003) + chance.normal(size=planned.shape) * 0.002
            finding = travel_shift(there, planned, register(found, planned, SPACING))
            inside += abs(finding.value - 1e3 * off) <= finding.uncertainty
        self.assertGreaterEqual(inside, 88)  # two standard deviations: 95 in the mean
        one_way = np.tile((1.0, 0.0), (len(planned), 1))
        self.assertIsNone(travel_shift(one_way, planned, register(found, planned, SPACING)).value)

    def test_a_simulated_relief_measures_as_it_was_simulated(self):
        _, _, op = tilted_job("Measured")
        patchmill.recompute(op)
        simulated = patchmill.simulate(op)
        surface = simulated.height_map()
        measured = measured_texture(op, surface, angle=0.0)
        data = simulated.data()
        self.assertIn("square", measured.text())
        self.assertEqual(len(measured.registration.missing), 0)
        self.assertGreaterEqual(len(measured.registration.pairs), 0.9 * data["found"])
        self.assertGreater(measured.quality, 0.97)
        self.assertLess(measured.registration.rms, 0.03 * SPACING)

    def test_bad_input_is_named(self):
        surface = scanned(lattice(), np.random.default_rng(0))
        for call, name in (
            (lambda: find_dimples(surface, 0.05), "Spacing"),
            (lambda: find_dimples(surface, math.nan), "Spacing"),
            (lambda: register(lattice()[:3], lattice(), SPACING), "Dimples"),
            (lambda: register(np.random.default_rng(3).random((50, 2)) * 9, lattice(), SPACING), "Dimples"),
        ):
            with self.assertRaises(InputError) as raised:
                call()
            self.assertEqual(raised.exception.property, name)


if __name__ == "__main__":
    unittest.main()
