"""Areal parameters against closed forms and against Gwyddion's own, and the filters before them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import math
import os
import subprocess
import tempfile
import unittest

import numpy as np
from patchmill import InputError
from patchmill.areal import filters
from patchmill.areal.parameters import areal_parameters
from patchmill.surface.height_map import HeightMap

# Gwyddion's library: mean, Sa, Sq, Ssk, excess kurtosis and the area of the surface
PEER = """
import ctypes, json, sys, numpy
ctypes.CDLL("libgwyddion2.so.0", mode=ctypes.RTLD_GLOBAL)
lib = ctypes.CDLL("libgwyprocess2.so.0")
lib.gwy_process_type_init()
number, pointer = ctypes.c_double, ctypes.c_void_p
lib.gwy_data_field_new.restype = pointer
lib.gwy_data_field_new.argtypes = [ctypes.c_int, ctypes.c_int, number, number, ctypes.c_int]
lib.gwy_data_field_get_data.restype = ctypes.POINTER(number)
lib.gwy_data_field_get_data.argtypes = [pointer]
lib.gwy_data_field_get_surface_area.restype = number
lib.gwy_data_field_get_surface_area.argtypes = [pointer]
lib.gwy_data_field_get_stats.argtypes = [pointer] + 5 * [ctypes.POINTER(number)]
heights, step = numpy.load(sys.argv[1]), float(sys.argv[2])
rows, columns = heights.shape
field = lib.gwy_data_field_new(columns, rows, columns * step, rows * step, 0)
ctypes.memmove(lib.gwy_data_field_get_data(field), heights.astype(float).tobytes(), heights.size * 8)
found = [number() for _ in range(5)]
lib.gwy_data_field_get_stats(field, *[ctypes.byref(one) for one in found])
area = lib.gwy_data_field_get_surface_area(field)
print(json.dumps([one.value for one in found] + [area / (rows * columns * step**2) - 1]))
"""


def gwyddion(surface):
    """Sa, Sq, Ssk, Sku, Sdr as Gwyddion's library finds them."""
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "heights.npy")
        np.save(name, surface.heights)
        command = ["/usr/bin/python3", "-c", PEER, name, repr(surface.step[0])]
        told = subprocess.run(command, capture_output=True, text=True, timeout=120)
    if told.returncode:
        raise AssertionError(told.stderr)
    _, sa, sq, ssk, sku, sdr = json.loads(told.stdout)
    return {"Sa": sa, "Sq": sq, "Ssk": ssk, "Sku": sku + 3.0, "Sdr": sdr}


def waves(amplitude=0.02, length=1.0, side=10.0, step=0.02, across=True):
    """A product of two sines, or one along x."""
    x = (np.arange(round(side / step)) + 0.5) * step
    wave = np.sin(2 * math.pi * x / length)
    return HeightMap(amplitude * np.outer(wave if across else np.ones(len(x)), wave), step)


def caps(depth=0.03, spacing=0.5, step=0.01, count=8):
    """Dimples of a ball that just do not touch, in a flat plane."""
    radius = spacing / 2 * 0.9
    ball = (radius**2 + depth**2) / (2 * depth)
    x = (np.arange(round(count * spacing / step)) + 0.5) * step % spacing - spacing / 2
    square = x[None, :] ** 2 + x[:, None] ** 2
    heights = np.where(square < radius**2, -(np.sqrt(np.maximum(ball**2 - square, 0)) - (ball - depth)), 0.0)
    return HeightMap(heights, step), ball, radius


def random_surface(seed, length, side=512, step=0.01, sq=0.004):
    """Gaussian heights with a Gaussian autocorrelation exp(-(t/length)²), and so known Sal and Sdq."""
    chance = np.random.default_rng(seed)
    frequency = np.hypot(*np.meshgrid(*[np.fft.fftfreq(side, step)] * 2))
    power = np.exp(-((math.pi * length * frequency) ** 2))
    noise = np.fft.fft2(chance.normal(size=(side, side)))
    heights = np.fft.ifft2(noise * np.sqrt(power)).real
    return HeightMap(heights * sq / heights.std(), step)


class ArealParameters(unittest.TestCase):
    def assert_near(self, found, wanted, share=0.005):
        for name, value in wanted.items():
            with self.subTest(name):
                self.assertLessEqual(abs(found[name] - value), share * max(abs(value), 1e-2 * share), found)

    def test_sines_have_their_closed_forms(self):
        found, a = areal_parameters(waves(side=20.0)), 0.02
        k = 2 * math.pi
        self.assert_near(found, {
            "Sq": a / 2, "Sa": a * (2 / math.pi) ** 2, "Ssk": 0.0, "Sku": 2.25, "Sp": a, "Sv": a, "Sz": 2 * a,
            "Sdq": a * k / math.sqrt(2), "Sdr": (a * k) ** 2 / 4 * (1 - (a * k) ** 2 * 9 / 64),
        }, 0.01)  # fmt: skip
        one = areal_parameters(waves(across=False, side=40.0, step=0.04))
        self.assert_near(one, {"Sq": a / math.sqrt(2), "Sa": 2 * a / math.pi, "Sku": 1.5})
        self.assertAlmostEqual(one["Sal"], math.acos(0.2) / k, delta=0.005 * one["Sal"])
        self.assertLess(one["Str"], 0.02)

    def test_volumes_of_a_linear_ratio_curve(self):
        """Heights spread evenly over h: a straight curve. Vmp = h/2 · 0.1², Vvv = h/2 · 0.2², and so on."""
        h = 0.1
        heights = np.random.default_rng(3).permutation((np.arange(250000) + 0.5) / 250000 * h)
        found = areal_parameters(HeightMap(heights.reshape(500, 500), 0.01), lags=False)
        self.assert_near(found, {
            "Vmp": h / 2 * 0.1**2, "Vmc": h / 2 * (0.8**2 - 0.1**2),
            "Vvc": h / 2 * (0.9**2 - 0.2**2), "Vvv": h / 2 * 0.2**2,
        }, 1e-3)  # fmt: skip

    def test_caps_of_a_ball(self):
        surface, ball, radius = caps(step=0.0025, count=4)
        found = areal_parameters(surface, lags=False)
        depth, each = 0.03, 0.25
        volume = math.pi * depth * (3 * radius**2 + depth**2) / 6
        share = math.pi * radius**2 / each
        area = 2 * math.pi * ball * depth / each - share
        self.assert_near(found, {"Sv": depth - volume / each, "Sp": volume / each, "Sdr": area}, 0.01)

    def test_random_surfaces_have_the_length_of_their_spectrum(self):
        """exp(-(t/l)²) falls to 0.2 at l·sqrt(ln 5); the gradient's mean square is 4 Sq²/l²."""
        length = 0.1
        surface = random_surface(1, length, side=1024)
        found = areal_parameters(surface)
        self.assert_near(found, {"Sq": 0.004, "Sku": 3.0}, 0.05)
        self.assert_near(found, {"Sdq": math.sqrt(4 * 0.004**2 / length**2)}, 0.05)
        self.assert_near(found, {"Sal": length * math.sqrt(math.log(5))}, 0.05)
        self.assertGreater(found["Str"], 0.85)

    def test_gwyddion_finds_the_same_on_five_reliefs(self):
        tilted = waves(0.01, 0.7)
        tilted.heights += 0.001 * np.arange(500)[:, None] * 0.02
        random = [random_surface(2, 0.05), random_surface(3, 0.2, 300)]
        for number, surface in enumerate([waves(), caps(step=0.005)[0], tilted, *random]):
            with self.subTest(number):
                self.assert_near(areal_parameters(surface, lags=False), gwyddion(surface))

    def test_turning_and_moving_change_nothing(self):
        surface = random_surface(4, 0.08, 256)
        wanted = areal_parameters(surface)
        z = surface.heights
        for other in (z.T, z[::-1], np.rot90(z), z + 5.0):
            found = areal_parameters(HeightMap(other, 0.01))
            self.assert_near(found, wanted, 1e-6)

    def test_holes_count_nothing(self):
        surface = random_surface(5, 0.05, 512)
        wanted = areal_parameters(surface)
        holes = surface.heights.copy()
        holes[np.random.default_rng(6).random(holes.shape) < 0.05] = np.nan
        found = areal_parameters(HeightMap(holes, 0.01))
        self.assert_near(found, {name: wanted[name] for name in ("Sq", "Sa", "Sal", "Sdq")}, 0.03)

    def test_the_form_is_taken_away(self):
        surface = waves()
        x, y = np.meshgrid(surface.x(), surface.y())
        bent = HeightMap(surface.heights + 0.3 + 0.02 * x - 0.01 * y + 0.004 * x * y - 0.003 * x**2, 0.02)
        self.assertGreater(np.ptp(filters.without_form(bent, "plane").heights), 0.1)
        left = filters.without_form(bent, "quadric")
        np.testing.assert_allclose(left.heights, filters.without_form(surface, "quadric").heights, atol=1e-9)
        with self.assertRaises(InputError):
            filters.without_form(surface, "sphere")

    def test_half_of_a_wave_passes_at_the_cut_off(self):
        """ISO 16610-61: the amplitude passes as exp(-pi (alpha cutoff / length)²), half at the cut-off."""
        for cut_off in (0.5, 1.0, 2.0):
            passed = filters.smoothed(waves(across=False, side=40.0), cut_off).heights[1000, 800:1200]
            share = np.ptp(passed) / 0.04
            self.assertAlmostEqual(share, math.exp(-math.pi * (filters.ALPHA * cut_off) ** 2), delta=2e-3)
        kept = filters.without_waviness(waves(across=False, side=40.0), 1.0).heights[1000, 800:1200]
        self.assertAlmostEqual(np.ptp(kept) / 0.04, 0.5, delta=2e-3)

    def test_bad_input_is_named(self):
        flat = HeightMap(np.zeros((5, 5)), 0.1)
        unknown = HeightMap(np.full((5, 5), np.nan), 0.1)
        for call, name in (
            (lambda: areal_parameters(flat), "Heights"),
            (lambda: areal_parameters(unknown), "Heights"),
            (lambda: filters.smoothed(flat, 0.1), "CutOff"),
            (lambda: filters.smoothed(flat, math.nan), "CutOff"),
            (lambda: filters.without_form(unknown, "plane"), "Heights"),
        ):
            with self.assertRaises(InputError) as raised:
                call()
            self.assertEqual(raised.exception.property, name)


if __name__ == "__main__":
    unittest.main()
