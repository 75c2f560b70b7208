"""Masks of the texture operations: pictures and closed curves that leave out, thin or sink dimples.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np
import Part
import patchmill
from patchmill import InputError
from patchmill.textures import masks

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from parts import V, WithDocuments, job_on, tilted_box  # noqa: E402


class Masks(WithDocuments):
    def setUp(self):
        box, face = tilted_box(10.0)
        self.document, self.operation = job_on(box, face)
        self.operation.TextureKind, self.operation.Depth = "Isolated", 0.01

    def picture(self, pixels):
        from matplotlib import image

        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        name = str(pathlib.Path(folder.name) / "mask.png")
        image.imsave(name, pixels, cmap="gray", vmin=0.0, vmax=1.0)
        return name

    def cut_places(self):
        plan = patchmill.recompute(self.operation)
        self.assertEqual(sum(plan.counts.values()), len(plan.dimples))
        return plan.places()[plan.dimples.states == 0], plan

    def test_a_large_picture_is_refused_before_it_is_read(self):
        from PIL import Image

        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        name = os.path.join(folder.name, "large.png")
        Image.new("1", (8000, 4000)).save(name)
        self.assertLess(os.path.getsize(name), 1000000)
        with mock.patch("matplotlib.image.imread", side_effect=MemoryError):
            with self.assertRaises(InputError) as caught:
                masks.read_grey(name)
        self.assertEqual(caught.exception.property, "MaskImage")
        self.assertIn("8000 x 4000 pixels", str(caught.exception))

    def test_a_picture_leaves_out(self):
        pixels = np.ones((20, 20))
        pixels[:10, :10] = 0.0  # the upper left quarter
        self.operation.MaskUse, self.operation.MaskImage = "Leave out", self.picture(pixels)
        self.operation.MaskWidth = 10.0
        places, plan = self.cut_places()
        self.assertFalse(((places[:, 0] < -0.3) & (places[:, 1] > 0.3)).any())
        for x, y in ((1, 1), (1, -1), (-1, -1)):
            self.assertGreater(((x * places[:, 0] > 0) & (y * places[:, 1] > 0)).sum(), 80)
        self.assertLess(np.abs(places).max(), 5.0)
        self.assertGreater(plan.counts["masked"], 0)
        self.operation.MaskInvert = True
        self.assertTrue((self.cut_places()[0] @ [-1, 1] > 0).all())

    def test_density_and_depth(self):
        self.operation.MaskImage = self.picture(np.full((8, 8), 0.5))
        self.operation.MaskUse, self.operation.MaskWidth = "Density", 12.0
        places, plan = self.cut_places()
        inside = np.abs(plan.places()).max(axis=1) < 6.0
        self.assertAlmostEqual(len(places) / inside.sum(), 0.5, delta=0.03)
        self.operation.MaskUse, self.operation.DepthAtWhite = "Depth", 0.02
        self.assertAlmostEqual(self.cut_places()[1].dimples.depths.max(), 0.01, 4)
        self.operation.DepthAtWhite = 0.1
        self.assert_refused(self.operation, "Spacing")

    def test_inside_of_curves_with_a_hole(self):
        ring = self.document.addObject("Part::Feature", "Ring")
        ring.Shape = Part.makeCompound([Part.Wire(Part.makeCircle(r)) for r in (6.0, 3.0)])
        self.operation.MaskUse, self.operation.MaskCurves = "Leave out", [ring]
        self.operation.AutoOrigin = False
        places, plan = self.cut_places()
        distance = np.linalg.norm(places, axis=1)
        self.assertGreater(len(places), 200)
        self.assertTrue((distance > 2.99).all() and (distance < 6.01).all())
        self.operation.MaskInvert = True
        distance = np.linalg.norm(self.cut_places()[0], axis=1)
        self.assertTrue(((distance < 3.01) | (distance > 5.99)).all())

    def test_bad_masks_are_named(self):
        self.operation.MaskUse = "Leave out"
        self.assert_refused(self.operation, "MaskUse")
        self.operation.MaskImage = "/nowhere/at-all.png"
        self.assert_refused(self.operation, "MaskImage")
        self.operation.MaskImage = __file__
        self.assert_refused(self.operation, "MaskImage")
        self.operation.MaskImage = ""
        line = self.document.addObject("Part::Feature", "Line")
        line.Shape = Part.makePolygon([V(0, 0, 0), V(1, 0, 0), V(1, 1, 0)])
        self.operation.MaskCurves = [line]
        self.assert_refused(self.operation, "MaskCurves")

    def test_transparent_pixels_are_white(self):
        pixels = np.zeros((2, 2, 4))
        pixels[0, 0, 3] = 1.0  # one opaque black pixel
        grey = masks.read_grey(self.picture(pixels))
        self.assertTrue((np.round(grey, 6) == [[0, 1], [1, 1]]).all())


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
