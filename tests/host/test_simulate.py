"""patchmill.simulate: what the posted text leaves on the faces, and how that compares with the plan.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import runpy
import sys
import tempfile
import unittest

import FreeCAD
import numpy as np
import Part
import patchmill
from matplotlib import pyplot as plt
from patchmill.reports import relief_report

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from recipe import ROOT, small_job  # noqa: E402
from test_five_axis import five_axis_job  # noqa: E402


def tilted_job(name):
    """2 x 2 patches on the steepest corner, where the tool's tip is outside every mark."""
    document, job, op = small_job(name=name)
    op.Origin = (-24, -24, 0)
    return document, job, op


class Simulate(unittest.TestCase):
    def setUp(self):
        self.document, self.job, self.op = tilted_job("simulate")
        self.plan = patchmill.recompute(self.op)

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def test_planned_path_makes_the_planned_dimples(self):
        result = patchmill.simulate(self.op)
        data = result.data()
        self.assertEqual(data["planned"], 4 * 36)
        self.assertEqual(data["missing"], 0)
        self.assertEqual(data["extra"], 0)
        self.assertLess(data["place_rms_mm"], 0.015)
        self.assertGreater(data["quality"], 0.95)
        self.assertEqual(data["alignment"], "square")
        self.assertAlmostEqual(data["spacing_mm"], 0.5, delta=0.02)
        # isolated by the stock or by ridges of about f² / 8R (1 + slope) ... 2 of it
        self.assertTrue(0.02 < data["depth_mm"] < 0.1, data)
        self.assertIn("square", result.text())

    def test_two_textures_of_one_place_are_drawn_side_by_side(self):
        window = ((-1, -1), (1, 1))
        planned = patchmill.simulate(self.op, window=window)
        rough = patchmill.simulate(self.op, window=window, runout=(0.02, 0.0))
        with tempfile.TemporaryDirectory() as folder:
            drawn = relief_report.draw_beside((("one", planned), ("other", rough)), folder)
            name, caption = drawn["beside"]
            self.assertIn("one, %s; other, %s" % (planned.source, rough.source), caption)
            size = plt.imread(name).shape
            self.assertGreater(size[1], 1.5 * size[0])  # two in a row
            left, right = np.array_split(plt.imread(name)[..., 0], 2, axis=1)
            self.assertGreater(np.abs(left[:, : right.shape[1]] - right).mean(), 0.01)
            other = patchmill.simulate(self.op, window=((-2, -1), (1, 1)))
            with self.assertRaises(patchmill.InputError) as raised:
                relief_report.draw_beside((("one", planned), ("other", other)), folder)
            self.assertEqual(raised.exception.property, "Window")

    def test_posted_text_makes_the_same_relief(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "x.ngc")
            posted = patchmill.post(self.job, name)
            ours = patchmill.simulate(self.op, window=((-2, -2), (2, 2)))
            for other in (
                patchmill.simulate(self.op, program=name, window=((-2, -2), (2, 2))),
                patchmill.simulate(self.op, path=posted[0].path, window=((-2, -2), (2, 2))),
            ):
                self.assertEqual(ours.heights.shape, other.heights.shape)
                off = np.abs(ours.heights - other.heights)
                self.assertLess(np.nanquantile(off, 0.99), 2e-3)
                self.assertEqual(other.data()["missing"], 0)
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.simulate(self.op, program=name, path=posted[0].path)
            self.assertEqual(caught.exception.property, "Path")

    def test_posted_locks_make_the_same_relief(self):
        """K of a rounded corner's moves is smaller by what the rounding takes off the way."""
        locked = {"Strategy": "Spindle-locked", "Machine": "linuxcnc-mill", "SameFlute": False}
        for name, value in dict(locked, ExtraTurns=0.0).items():
            setattr(self.op, name, value)
        self.job.PostProcessor = "patchmill_linuxcnc"
        plan = patchmill.recompute(self.op)
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "x.ngc")
            posted = patchmill.post(self.job, name)
            timed = [one.turns[~np.isnan(one.turns)] for one in (posted[0].path, plan.path)]
            np.testing.assert_allclose(*timed, atol=1e-6)
            window = ((-2, -2), (2, 2))
            ours = patchmill.simulate(self.op, window=window)
            other = patchmill.simulate(self.op, program=name, window=window)
            on_machine = patchmill.simulate(self.op, program=name, machine="linuxcnc-mill", window=window)
        held = patchmill.simulate(self.op, machine="linuxcnc-mill", window=window)
        self.assertAlmostEqual(other.quality, ours.quality, places=4)
        self.assertAlmostEqual(on_machine.quality, held.quality, places=3)
        self.assertGreater(held.quality, 0.95)
        self.assertEqual(other.data()["missing"], 0)

    def test_a_window_is_the_part_of_the_whole(self):
        whole = patchmill.simulate(self.op)
        part = patchmill.simulate(self.op, window=((-1.0, -1.0), (1.0, 1.0)))
        self.assertEqual(len(part.found["dimple"]), 16)
        self.assertEqual(part.data()["missing"], 0)
        self.assertLess(part.heights.size, whole.heights.size)

    def test_open_loop_machine_loses_the_texture(self):
        good = patchmill.simulate(self.op)
        lost = patchmill.simulate(self.op, machine="open-loop-mill")
        self.assertLess(lost.quality, 0.5 * good.quality)
        self.assertIn("Mill without spindle encoder", lost.data()["source"])

    def test_a_recording_of_the_plan_is_the_plan(self):
        path = self.plan.path
        turns = np.nan_to_num(path.turns)
        timed = np.flatnonzero(turns > 0.0)
        turned = np.cumsum(turns)[timed]
        # flute 0 where the first dimple wants it
        ends = np.flatnonzero(path.dimples >= 0)
        n = self.plan.dimples.normals[path.dimples[ends[0]]]
        wanted = np.arctan2(-n[1], -n[0])
        azimuth = wanted - 2.0 * np.pi * (turned - np.cumsum(turns)[ends[0]])
        rows = np.column_stack([turned, path.tips[timed], azimuth])
        recorded = patchmill.simulate(self.op, samples=rows)
        self.assertEqual(recorded.data()["missing"], 0)
        planned = patchmill.simulate(self.op)
        self.assertAlmostEqual(recorded.quality, planned.quality, places=2)
        for bad in (rows[:, :4], rows[:1], rows * np.nan):
            with self.assertRaises(patchmill.InputError):
                patchmill.simulate(self.op, samples=bad)

    def test_mesh_lies_on_the_faces_and_in_them(self):
        result = patchmill.simulate(self.op, window=((-1.0, -1.0), (1.0, 1.0)))
        points, heights = result.surface(stride=5)
        every = result.heights[::5, ::5]
        self.assertEqual(points.shape, every.shape + (3,))
        np.testing.assert_array_equal(heights, every)
        face = self.job.Model.Group[0].Shape.getElement(self.op.Base[0][1][0])
        for row, column in ((3, 4), (7, 9), (10, 2)):
            vertex = Part.Vertex(*points[row, column])
            self.assertAlmostEqual(face.distToShape(vertex)[0], heights[row, column], delta=1e-4)
        block, _ = result.surface(stride=5, rows=(10, 31), columns=(5, 26))
        np.testing.assert_allclose(block, points[2:7, 1:6], rtol=0, atol=1e-9)

    def test_the_relief_and_its_dimples_are_written(self):
        import csv

        import Mesh

        result = patchmill.simulate(self.op, window=((-1.0, -1.0), (1.0, 1.0)))
        with tempfile.TemporaryDirectory() as folder:
            result.save(folder + "/relief.x3p")
            read = patchmill.measured(folder + "/relief.x3p")
            np.testing.assert_allclose(read.heights, result.heights, atol=1e-12)
            np.testing.assert_allclose(read.origin, result.origin, atol=1e-12)
            result.save(folder + "/relief.stl")
            box = Mesh.Mesh(folder + "/relief.stl").BoundBox
            points = result.surface()[0].reshape(-1, 3)
            self.assertAlmostEqual(box.XMin, np.nanmin(points[:, 0]), 5)
            self.assertAlmostEqual(box.ZMax, np.nanmax(points[:, 2]), 5)
            result.save_dimples(folder + "/dimples.csv")
            with open(folder + "/dimples.csv", newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
        data = result.data()
        states = [row["state"] for row in rows]
        self.assertEqual(len(rows), len(result.plan.dimples) + data["extra"])
        self.assertEqual(states.count("found"), data["found"])
        self.assertEqual(states.count("missing"), data["missing"])
        moved = [float(row["moved"]) for row in rows if row["state"] == "found"]
        self.assertAlmostEqual(max(moved), data["place_largest_mm"], 9)
        depths = [float(r["depth"]) for r in rows if r["state"] == "found" and r["at_edge"] == "0"]
        self.assertAlmostEqual(np.mean(depths), data["depth_mm"], 6)

    def test_progress_and_cancel(self):
        seen = []
        patchmill.simulate(self.op, progress=lambda share: seen.append(share) or True)
        self.assertGreater(len(seen), 3)
        self.assertAlmostEqual(seen[-1], 1.0)
        self.assertIsNone(patchmill.simulate(self.op, progress=lambda share: False))

    def test_bad_input_is_named(self):
        for keyword, value, name in (
            ("window", ((1, 1), (0, 0)), "Window"),
            ("step", 0.0, "GridStep"),
            ("program", "/nowhere.ngc", "Program"),
            ("machine", "no such", "Machine"),
            ("memory_limit", 1e5, "GridStep"),
            ("runout", (0.0,), "Runout"),
        ):
            with self.subTest(keyword):
                with self.assertRaises(patchmill.InputError) as caught:
                    patchmill.simulate(self.op, **{keyword: value})
                self.assertEqual(caught.exception.property, name)

    def test_runout_shows_with_any_flute_and_not_with_one(self):
        """5 µm on one flute: two depths if both make dimples, one if one does."""
        for same, spread in ((False, True), (True, False)):
            self.op.SameFlute = same
            plan = patchmill.recompute(self.op)
            result = patchmill.simulate(plan, runout=(0.0, -0.005))
            bottoms = result.found["bottoms"][result.found["found"]]
            two = bottoms.max() - bottoms.min() > 0.004
            self.assertEqual(two, spread, (bottoms.min(), bottoms.max()))


class Matsuda(unittest.TestCase):
    def test_arrays_are_recognised_from_their_marks(self):
        """The three states of Matsuda 2008, Fig. 2, each from a relief of one patch of the free form."""
        recipe = runpy.run_path(str(ROOT / "Resources" / "recipes" / "matsuda2008" / "run.py"))
        for array in recipe["ARRAYS"]:
            with self.subTest(array):
                document, _, op = recipe["make"]("inclined plane", array)
                op.PatchesX = op.PatchesY = 1
                patchmill.recompute(op)
                result = patchmill.simulate(op)
                self.assertEqual(result.alignment["state"], array, result.alignment)
                self.assertGreater(result.alignment["rows"], 4)
                FreeCAD.closeDocument(document.Name)


class RotaryAxes(unittest.TestCase):
    def test_machines_with_other_axes_cut_the_same_texture(self):
        """The tool inclined by 12 degrees on table, head and nutating axes: C turns the contact points under
        the spindle in other ways, and the phase makes up for it."""
        heights = []
        for machine in ("table-table-ac", "head-head-ca", "nutating-head-bc-45"):
            with self.subTest(machine):
                document, job, op = five_axis_job(machine)
                op.PostGouging = False
                patchmill.recompute(op)
                with tempfile.TemporaryDirectory() as folder:
                    posted = patchmill.post(job, os.path.join(folder, "x.nc"))[0]
                self.assertEqual(posted.check.outcome, "clear")
                result = patchmill.simulate(op, path=posted.path)
                data = result.data()
                self.assertEqual((data["missing"], data["extra"]), (0, 0))
                self.assertEqual(data["alignment"], "square")
                self.assertGreater(data["quality"], 0.95)
                heights.append(result.heights)
                FreeCAD.closeDocument(document.Name)
        for other in heights[1:]:
            self.assertLess(np.nanquantile(np.abs(heights[0] - other), 0.99), 1e-3)


class Surfaces(unittest.TestCase):
    def test_planar_and_pyramid_patches_are_measured_from_their_planes(self):
        for make in (patchmill.PlanarTexture, patchmill.PyramidTexture):
            document, job, curved = tilted_job("planes")
            op = make.Create("Texture", parentJob=job)
            for name in ("Base", "Spacing", "PatchSide", "PatchesX", "PatchesY", "Origin", "Decimals"):
                setattr(op, name, getattr(curved, name))
            op.AutoOrigin = False
            patchmill.recompute(op)
            data = patchmill.simulate(op).data()
            self.assertEqual(data["missing"], 0)
            self.assertLess(data["place_rms_mm"], 0.02)
            FreeCAD.closeDocument(document.Name)


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
