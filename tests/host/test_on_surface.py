"""Lattices laid on bent faces: no two dimples nearer than 0.9 of the spacing, faces covered, and the same
dimples wherever the part stands.

PATCHMILL_FACES=1000 tries so many new ones instead of a few that are the same each time (tools/fuzz does).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import random
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import Part  # noqa: E402
from random_faces import (  # noqa: E402
    KINDS,
    V,
    judged,
    laid_positions,
    largest_move,
    placed_on,
    random_face,
    spacing_for,
    turned,
)

FACES = int(os.environ.get("PATCHMILL_FACES", 0))
SHAPES = ("Square", "Hexagon", "Triangle")
PLACEMENTS = 8  # of new faces and of known ones; 2 of the others
# once laid otherwise in another placement: a line of the map's mesh lies in the middle of an even face, and
# rounding said on which side of it the lattice begins
KNOWN = [(1795753168026, "fillet"), (1795753168086, "fillet")]


def cases():
    """(seed, kind, number of placements) of each face."""
    first = int(time.time()) * 1000 if FACES else 0
    some = [(first + n, KINDS[n % len(KINDS)], PLACEMENTS if FACES else 2) for n in range(FACES or 24)]
    return [(seed, kind, PLACEMENTS) for seed, kind in KNOWN] + some


class RandomFaces(unittest.TestCase):
    def test_dimples_are_apart_and_cover_the_face(self):
        nearest, short, slowest, moves = [], [], 0.0, []
        for seed, kind, placements in cases():
            with self.subTest(seed=seed, kind=kind):
                rng = random.Random(seed)
                face, _ = turned(random_face(rng, kind), rng)
                spacing, shape = spacing_for(face, rng), rng.choice(SHAPES)
                began = time.perf_counter()
                placed = placed_on(face, spacing, shape, auto_direction=True)
                slowest = max(slowest, time.perf_counter() - began)
                found = judged(placed, face)
                nearest.append(found["nearest"])
                self.assertGreaterEqual(found["nearest"], 0.9 * (1.0 - 1e-9))
                self.assertEqual(sum(found["counts"].values()), len(placed.dimples))
                if abs(found["laid"] - 1.0) > 0.1:
                    short.append((seed, kind, round(found["laid"], 3), found["counts"], found["pieces"]))
                    self.check_said(placed, found)
                points = laid_positions(placed)
                for _ in range(placements):
                    moved, there = turned(face, rng)
                    again = placed_on(moved, spacing, shape, auto_direction=True)
                    back = there.inverse()
                    points_again = [back.multVec(V(*p)) for p in laid_positions(again)]
                    moves.append(largest_move(points, points_again))
                    self.assertLess(moves[-1], 1e-3, "mm: other dimples in another placement")
        print(
            "%d faces, nearest %.4f spacings, %d not within 10 %%, slowest %.2f s, moved %.2g mm at most"
            % (len(nearest), min(nearest), len(short), slowest, max(moves))
        )
        for line in short:
            print("  ", *line)

    def check_said(self, placed, found):
        """What is not covered is counted by reason, and said."""
        self.assertLess(found["laid"], 1.1, found)
        self.assertTrue(any("%" in r for r in placed.remarks), placed.remarks)


class KnownFaces(unittest.TestCase):
    def laid(self, face, spacing, shape="Square", **more):
        return judged(placed_on(face, spacing, shape, auto_direction=True, **more), face)

    def test_a_face_that_rolls_out_keeps_every_spacing(self):
        for face in (
            Part.makeCylinder(8, 20, V(), V(0, 0, 1), 120).Faces[0],
            Part.makeCone(9, 3, 12, V(), V(0, 0, 1), 100).Faces[0],
            Part.makePlane(15, 12),
        ):
            placed = placed_on(face, 0.5, "Hexagon", auto_direction=True)
            spread = placed.spread()
            self.assertLess(spread["rms"], 2e-3)  # the chord's own shortening
            self.assertLess(abs(judged(placed, face)["laid"] - 1.0), 0.05)

    def test_a_closed_cylinder_is_not_doubled_at_its_seam(self):
        found = self.laid(Part.makeCylinder(5, 20).Faces[0], 0.7)
        self.assertGreaterEqual(found["nearest"], 0.9)
        self.assertLess(abs(found["laid"] - 1.0), 0.05)

    def test_a_whole_sphere_is_covered(self):
        found = self.laid(Part.makeSphere(10).Faces[0], 0.8, "Triangle")
        self.assertGreaterEqual(found["nearest"], 0.9)
        self.assertLess(abs(found["laid"] - 1.0), 0.1)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
