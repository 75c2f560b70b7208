"""Attributes of the voxels as macros see them: distance to the product and material against the shapes, the
feed that a material makes, the saved model, and lines that are refused.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import numpy as np  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import CONTACT, HIGH, LOW, contact_off  # noqa: E402
from milling_jobs import add_profile, dress, make_job, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import DressupDCM, InputError  # noqa: E402
from patchmill.voxels import voxel_slices  # noqa: E402


class Attributes(WithDocuments):
    """Distance and material of voxels, and what a material does to the feed."""

    LINES = ["skin 0.5 2.2", "insert 0.25 Insert"]

    def setUp(self):
        self.document, self.job = make_job(pocket_part(), "attributes")
        self.job.Stock.ExtXneg = self.job.Stock.ExtYpos = 15
        insert = self.document.addObject("Part::Feature", "Insert")
        insert.Shape = Part.makeBox(100, 8, 100, FreeCAD.Vector(-40, 44, -40))
        self.document.recompute()
        self.operation = add_profile(self.job)

    def expected(self, model, points):
        """Number of the material and distance to the product, from the shapes alone."""
        low, high = (np.array(corner) for corner in model.stock.bounds)
        depth = np.minimum(points - low, high - points).min(axis=1)
        material = np.where(depth < 2.2, 1, 0)
        inside = ((points > (-40, 44, -40)) & (points < (60, 52, 60))).all(axis=1)
        material[inside] = 2
        part = self.job.Model.Group[0].Shape
        distance = [part.distToShape(Part.Vertex(*p))[0] for p in points[:40]]
        return material, np.array(distance)

    def test_of_voxels(self):
        dressup = dress(self.operation, Materials=self.LINES)
        DressupDCM.recompute(dressup)
        model = dressup.Proxy.model
        self.assertEqual(model.material_names, ["stock", "skin", "insert"])
        section = model.grid.section(2, 10.0)
        rows, columns = np.nonzero(section["kind"] > 1)
        points = np.column_stack([
            section["origin"][0] + (columns + 0.5) * section["pitch"],
            section["origin"][1] + (rows + 0.5) * section["pitch"],
            np.full(len(rows), section["place"]),
        ])  # fmt: skip
        np.random.default_rng(1).shuffle(points)
        found = model.attributes_at(points)
        material, distance = self.expected(model, points)
        np.testing.assert_array_equal(found["material"], material)
        self.assertEqual(set(material), {0, 1, 2})
        np.testing.assert_allclose(np.abs(found["distance"][:40]), distance, atol=0.06)  # deflection
        feed = model.feed(LOW, HIGH)
        plain = core.steady_feed(model.grid, LOW, HIGH)
        for direction in ((1, 0, 0), (0, 1, 0)):
            at = core.feed_at(model.grid, plain, points, direction)
            factor = np.array([1.0, 0.5, 0.25])[material]
            # voxel centres are read without neighbours
            np.testing.assert_allclose(
                model.attributes_at(points, feed, direction)["feed"], factor * at, rtol=1e-12
            )

    def test_slices(self):
        dressup = dress(self.operation, Materials=self.LINES)
        DressupDCM.recompute(dressup)
        model = dressup.Proxy.model
        for slice_of in (voxel_slices.distance_slice, voxel_slices.material_slice):
            centres, values = slice_of(model, 1, 20.0)
            self.assertEqual(len(centres), len(values))
            self.assertGreater(len(values), 200)
            self.assertGreater(np.ptp(values), 0.9)

    def test_the_path_is_slower_in_a_harder_material_and_stays_where_it_is(self):
        dressup = dress(self.operation)
        plain = DressupDCM.recompute(dressup)
        dressup.Materials = ["all 0.5 1000"]
        half = DressupDCM.recompute(dressup)
        # all of the stock lies above 1000 mm deep; the part of the profile in the air keeps its feed
        self.assertGreater(half.seconds, 1.3 * plain.seconds)
        self.assertLess(half.seconds, 2.0 * plain.seconds + 1e-9)
        self.assertLess(contact_off(self.operation, dressup), CONTACT)

    def test_saved_and_made_anew(self):
        with tempfile.TemporaryDirectory() as folder:
            dressup = dress(self.operation, Materials=self.LINES)
            self.document.saveAs(os.path.join(folder, "part.FCStd"))
            before = DressupDCM.recompute(dressup).seconds
            file = os.path.join(folder, "part-DressupDCM.voxels")
            model = dressup.Proxy.model
            given, names = model.given, model.material_names
            dressup.Proxy.model = dressup.Proxy.result = None
            del model
            loaded = patchmill.removal_model.make(given, file)
            self.assertTrue(loaded.loaded)
            self.assertEqual(loaded.material_names, names)
            del loaded
            dressup.Materials = ["skin 0.9 2.2", self.LINES[1]]  # another factor: the same voxels
            self.assertLess(DressupDCM.recompute(dressup).seconds, before)
            self.assertTrue(dressup.Proxy.model.loaded)
            dressup.Materials = ["skin 0.9 3.5", self.LINES[1]]  # another depth: others
            DressupDCM.recompute(dressup)
            self.assertFalse(dressup.Proxy.model.loaded)

    def test_bad_lines_are_named(self):
        dressup = dress(self.operation)
        factors = "skin x 2", "skin 0 2", "skin -1 2"
        for line in ("skin", *factors, "skin 0.5 -1", "skin 0.5 Nothing", "a b c d"):
            dressup.Materials = [line]
            with self.assertRaises(InputError) as caught:
                DressupDCM.recompute(dressup)
            self.assertEqual(caught.exception.property, "Materials", caught.exception)
            self.assertEqual(caught.exception.value, repr(line))
            self.assertEqual(len(dressup.Path.Commands), 0)
            print("refused:", caught.exception)
        dressup.Materials, dressup.Machine = ["soft 1000 2"], "linuxcnc-mill"
        with self.assertRaises(InputError) as caught:
            DressupDCM.recompute(dressup)
        self.assertEqual(caught.exception.property, "FeedAtSkin")


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2, argv=["test"] + sys.argv[1:]).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
