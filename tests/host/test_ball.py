"""Balls: lattices that are made for spheres, two set-ups of which each dimple belongs to exactly one,
programs that are read back, and marks all over the ball.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import os
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import Part  # noqa: E402
import _patchmill as core  # noqa: E402
import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from parts import V, WithDocuments, job_on  # noqa: E402
from patchmill.advice import assessment  # noqa: E402
from patchmill.textures.ball import lattice, laying, neighbours, order  # noqa: E402
from patchmill.textures.plan import place_texture  # noqa: E402

RADIUS, DIMPLES, DIAMETER = 21.35, 392, 3.5  # mm: a golf ball
GOLF = {
    "Mapping": "Ball",
    "BallDimples": DIMPLES,
    "BallSetups": "Two",
    "TextureKind": "Isolated",
    "Spacing": 0.0,
    "DimpleDiameter": DIAMETER,
    "Machine": "table-table-ac",
    "Strategy": "Spindle-locked",
    "ToolAxisMode": "Normal",
    "Lead": 45.0,
    "LeadTowards": V(0, 0, 1),
    "RowTolerance": 0.0,
    "ExtraTurns": 0.0,
    "SameFlute": False,
    "Decimals": 4,
}


def ball(turned=False, radius=RADIUS, shape=None, tool=12.0, **properties):
    """(document, operation) of a ball around the work's zero; `turned`: by 180 degrees about X."""
    made = Part.makeSphere(radius) if shape is None else shape
    if turned:
        made.rotate(V(0, 0, 0), V(1, 0, 0), 180.0)
    face = next(n for n, f in enumerate(made.Faces, 1) if type(f.Surface).__name__ == "Sphere")
    document, op = job_on(made, "Face%d" % face, diameter=tool)
    for name, value in dict(GOLF, **properties).items():
        setattr(op, name, value)
    op.ToolController.Tool.Flutes = 1
    op.ToolController.SpindleSpeed = 300
    return document, op


class Lattices(unittest.TestCase):
    def test_icosahedral_counts(self):
        """N = 10 T + 2, T = h² + h k + k²; twelve points with five neighbours, all others with six; Euler's
        3 N - 6 pairs."""
        for h, k in ((1, 0), (1, 1), (2, 0), (2, 1), (3, 1), (5, 0), (5, 2), (7, 0)):
            with self.subTest(h=h, k=k):
                points = lattice.icosahedral(h, k)
                self.assertEqual(len(points), 10 * (h * h + h * k + k * k) + 2)
                pairs = neighbours.pairs(points)
                self.assertEqual(len(pairs), 3 * len(points) - 6)
                counted = np.bincount(np.bincount(pairs.ravel(), minlength=len(points)))
                self.assertEqual(counted[5], 12)
                self.assertEqual(counted.sum(), len(points))
        self.assertEqual(lattice.nearest_count(DIMPLES), (DIMPLES, (5, 2)))

    def test_smallest_ones_are_known_solids(self):
        """(1, 0): the icosahedron's 12 corners, edges 4 / √(10 + 2 √5); (1, 1): with the 20 of its dual."""
        twelve = lattice.points("Icosahedral", 12)
        edges = neighbours.spread(twelve)
        self.assertAlmostEqual(edges["mean"], 4.0 / math.sqrt(10.0 + 2.0 * math.sqrt(5.0)), places=12)
        self.assertAlmostEqual(edges["greatest"] - edges["least"], 0.0, places=12)
        self.assertEqual(len(lattice.points("Icosahedral", 32)), 32)

    def test_icosahedral_keeps_its_symmetry(self):
        """A fifth of a turn about a corner takes the lattice to itself, relaxed or not."""
        points = lattice.points("Icosahedral", DIMPLES)
        angle = 2.0 * math.pi / 5.0
        c, s = math.cos(angle), math.sin(angle)
        turned = points @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
        nearest = np.argmax(turned @ points.T, axis=1)
        self.assertEqual(len(set(nearest)), DIMPLES)
        self.assertLess(np.abs(turned - points[nearest]).max(), 1e-9)

    def test_golf_ball_is_most_even(self):
        """Least over greatest distance of neighbours, beside the three others (docs/balls.md)."""
        evenness = {}
        for name in lattice.LATTICES:
            points = lattice.points(name, DIMPLES)
            self.assertEqual(len(points), DIMPLES)
            spread = neighbours.spread(points)
            evenness[name] = spread["least"] / spread["greatest"]
        projected = neighbours.spread(lattice.projected(0.1382))
        evenness["projected"] = projected["least"] / projected["greatest"]
        self.assertGreater(evenness["Icosahedral"], 0.82)
        self.assertTrue(all(v < 0.6 for n, v in evenness.items() if n != "Icosahedral"), evenness)
        raw = neighbours.spread(lattice.icosahedral(5, 2))
        self.assertGreater(evenness["Icosahedral"], 1.1 * raw["least"] / raw["greatest"])

    def test_neighbours_are_delaunay(self):
        """No point is nearer to the circle through three neighbours than they are: by trying all triples."""
        points = lattice.fibonacci(30)
        wanted = set()
        for i in range(30):
            for j in range(i + 1, 30):
                for k in range(j + 1, 30):
                    normal = np.cross(points[j] - points[i], points[k] - points[i])
                    side = (points - points[i]) @ normal
                    side[[i, j, k]] = 0.0
                    if (side <= 0.0).all() or (side >= 0.0).all():
                        wanted |= {(i, j), (j, k), (i, k)}
        self.assertEqual(set(map(tuple, neighbours.pairs(points))), wanted)

    def test_counts_that_there_are_none_of(self):
        for name, count in (("Icosahedral", 500), ("Fibonacci", 3), ("Rings", 10**7)):
            with self.assertRaises(patchmill.InputError) as caught:
                lattice.points(name, count)
            self.assertEqual(caught.exception.property, "BallDimples")
        with self.assertRaises(patchmill.InputError) as caught:
            lattice.points("Icosahedral", 500)
        self.assertIn("492 or 522", str(caught.exception))

    def test_every_place_is_in_one_of_two_halves(self):
        points = np.vstack([lattice.points("Rings", 401), np.eye(3), -np.eye(3), lattice.icosahedral(2, 0)])
        for up in ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.6, 0.0, 0.8), (1.0, 1.0, 1.0)):
            up = np.array(up) / np.linalg.norm(up)
            one, other = (laying.belongs(points, way, np.eye(3)) for way in (up, -up))
            self.assertTrue((one ^ other).all())

    def test_runs_go_from_neighbour_to_neighbour(self):
        points = lattice.points("Icosahedral", DIMPLES)
        pairs = neighbours.pairs(points)
        numbers, run = order.runs(points, pairs, np.array([0.0, 0.0, 1.0]))
        self.assertEqual(sorted(numbers), list(range(DIMPLES)))
        known = set(map(tuple, pairs))
        for i in range(DIMPLES - 1):
            step = (min(numbers[i : i + 2]), max(numbers[i : i + 2]))
            self.assertEqual(step in known, run[i] == run[i + 1])
        self.assertLess(run[-1], DIMPLES // 20)


class Balls(WithDocuments):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="patchmill-ball-")
        self.addCleanup(self.folder.cleanup)

    def post(self, op, name):
        job = op.Document.getObject("Job")
        job.PostProcessor, job.PostProcessorArgs = "patchmill_linuxcnc", "--precision=4"
        name = os.path.join(self.folder.name, name)
        return patchmill.post(job, name)[0], name

    def test_dimple_is_the_cap_that_was_asked_for(self):
        """The ball of the tool, R, sunk by d meets the part's sphere in a circle of that diameter."""
        _, op = ball()
        plan = patchmill.recompute(op)
        tool, depth = plan.input.tool.radius, plan.size["depth"]
        apart, rim = RADIUS + tool - depth, 0.5 * DIAMETER
        self.assertAlmostEqual(math.sqrt(tool**2 - rim**2) + math.sqrt(RADIUS**2 - rim**2), apart, places=12)
        self.assertAlmostEqual(op.FoundDiameter.Value, DIAMETER, places=9)
        share = DIMPLES * 0.5 * (1.0 - math.sqrt(RADIUS**2 - rim**2) / RADIUS)  # of the ball's area
        self.assertAlmostEqual(op.FoundAreaShare, share, places=9)
        _, other = ball(DimpleDiameter=0.0, Depth=depth)
        self.assertAlmostEqual(patchmill.recompute(other).size["diameter"], DIAMETER, places=9)

    def test_golf_ball_every_dimple_once(self):
        """Two set-ups, posted, checked and read back; the marks of both programs, all over the ball."""
        milled, marks = np.zeros(DIMPLES, int), np.zeros(DIMPLES, int)
        for turned in (False, True):
            _, op = ball(turned)
            plan = patchmill.recompute(op)
            cut = plan.dimples.states == core.DimpleState.CUT
            milled[plan.ball.numbers[cut]] += 1
            posted, name = self.post(op, "set-up-%d.ngc" % turned)
            self.assertEqual(posted.check.outcome, "clear")
            self.assertEqual((posted.path.dimples >= 0).sum(), cut.sum())
            self.assertLess(math.degrees(posted.errors["largest"]), 1.0)
            left = patchmill.simulate_ball(op, program=name)
            self.assertEqual(left.extra, 0)
            marks += left.marks_of_dimples()
        self.assertTrue((milled == 1).all())
        self.assertTrue((marks == 1).all())

    def test_no_single_patch_of_it_is_looked_at(self):
        """Its lattice is one for all of it, and is made once."""
        _, op = ball()
        given = op.Proxy.texture_input(op)
        self.assertEqual(assessment.assess(patchmill.simulate, given).patches, [])
        placed = place_texture(given)
        with mock.patch.object(assessment, "plan_texture", side_effect=AssertionError("a patch is planned")):
            self.assertIsNone(assessment.first_patch(patchmill.simulate, given, placed))
        name = lattice.ICOSAHEDRAL
        self.assertIs(lattice.points(name, DIMPLES), lattice.points(name, DIMPLES))

    def test_both_set_ups_have_the_same_lattice(self):
        """It turns with the part: what is milled after it was turned over is what was not before."""
        whole = []
        for turned in (False, True):
            _, op = ball(turned)
            plan = patchmill.recompute(op)
            whole.append(plan.ball.whole * ((1, -1, -1) if turned else (1, 1, 1)))
        np.testing.assert_allclose(whole[0], whole[1], rtol=0.0, atol=1e-12)

    def test_dome_has_the_dimples_of_its_face(self):
        dome = Part.makeSphere(RADIUS, V(0, 0, 0), V(0, 0, 1), 30.0, 90.0, 360.0)
        for name in lattice.LATTICES:
            with self.subTest(name):
                _, op = ball(shape=dome.copy(), BallLattice=name, BallSetups="One")
                plan = patchmill.recompute(op)
                cut = plan.dimples.states == core.DimpleState.CUT
                above = plan.ball.whole[:, 2] > 0.5
                self.assertEqual(cut.sum(), above.sum())
                self.assertTrue((plan.dimples.normals[cut][:, 2] > 0.5).all())

    def test_what_a_ball_cannot_have_is_refused(self):
        _, op = ball()
        for name, value, said in (
            ("BallDimples", 391, "BallDimples"),
            ("Order", "Rows", "Order"),
            ("AreaShare", 0.5, "AreaShare"),
            ("RidgeHeight", 0.1, "RidgeHeight"),
            ("Depth", 0.1, "Depth"),
            ("DimpleDiameter", 12.5, "DimpleDiameter"),
            ("PatchesX", 2, "PatchesX"),
        ):
            with self.subTest(name=name):
                before = getattr(op, name)
                setattr(op, name, value)
                self.assert_refused(op, said)
                setattr(op, name, before)
        patchmill.recompute(op)

    def test_other_faces_are_refused(self):
        hollow = Part.makeBox(60, 60, 30, V(-30, -30, -30)).cut(Part.makeSphere(RADIUS))
        two = Part.makeCylinder(5.0, 8.0)
        _, op = ball(shape=hollow)
        self.assert_refused(op, "Base")
        _, op = job_on(two, "Face1")
        op.Mapping = "Ball"
        self.assert_refused(op, "Base")


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
