"""CopyMilling: no gouge by an independent check on the parts of the paper and on parts of others, scallops as
as predicted, roughing and finishing, faces, bad input.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parents[1] / "Resources" / "recipes" / "kobayashi2014"))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import make_parts  # noqa: E402
import numpy as np  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import make_job, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import CopyMilling, InputError  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from test_real_parts import IDF, OCCT, read  # noqa: E402

RADIUS, TOLERANCE = 3.0, 0.01
EDGE = 60.0  # mm that the tool's cutting edges are long
LARGEST = 80.0  # mm: longer parts are made smaller; tools/parts_of_others.py takes them as they are
REAL_PARTS = [
    OCCT / "occ/Axis_of_bearing.brep", OCCT / "occ/Pump_TopCover.brep", OCCT / "step/linkrods.step",
    OCCT / "occ/CrankArm.brep", IDF / "EPL22_6_16.stp",
]  # fmt: skip


def ball_centres(path, step, first=0):
    """Ball centres every `step` mm of all moves from number `first` on, rapids too."""
    ends = (np.vstack([np.array(path.start)[None], path.tips]) + (0, 0, path.tool.radius))[first:]
    out = [ends[:1]]
    for a, b in zip(ends[:-1], ends[1:]):
        n = max(1, int(np.ceil(np.linalg.norm(b - a) / step)))
        out.append(a + (b - a) * (np.arange(1, n + 1) / n)[:, None])
    return np.vstack(out)


def deepest_gouge(shape, path, step, first=0):
    """How deep the ball goes into the part anywhere on the path from move `first` on."""
    return deepest_at(shape, ball_centres(path, step, first), path.tool.radius)


def deepest_at(shape, centres, radius, deflection=0.002):
    """How deep balls go into a finer mesh of the part than the one they were led by, by distances alone."""
    solid = core.solid_of_brep(shape.exportBrepToString(), deflection, "part")
    low, high = solid.bounds
    near = ((centres > np.array(low) - RADIUS) & (centres < np.array(high) + RADIUS)).all(axis=1)
    if not near.any():
        return 0.0
    return float(radius - solid.signed_distances(centres[near]).min())


def no_longer(shape, largest):
    """A shape, made smaller where its box is longer than `largest` [mm]."""
    box = shape.BoundBox
    return shape.scaled(min(1.0, largest / max(box.XLength, box.YLength, box.ZLength)))


def job_with_stock(shape, margin=0.0, name="copy"):
    """A job whose stock is the part's box, `margin` larger."""
    document, job = make_job(shape, name, ball=True)
    box = job.Model.Group[0].Shape.BoundBox
    stock = document.addObject("Part::Feature", "StockBox")
    stock.Shape = Part.makeBox(
        box.XLength + 2 * margin, box.YLength + 2 * margin, box.ZLength + margin,
        FreeCAD.Vector(box.XMin - margin, box.YMin - margin, box.ZMin),
    )  # fmt: skip
    job.Stock = stock
    document.recompute()
    return document, job


class CopyMillingTest(WithDocuments):
    def mill(self, job, **properties):
        operation = CopyMilling.Create("Copy", parentJob=job)
        for name, value in properties.items():
            setattr(operation, name, value)
        return operation, CopyMilling.recompute(operation)

    def check(self, shape, mode, step=0.3, **properties):
        document, job = job_with_stock(shape, 1.0)
        operation, path = self.mill(job, Mode=mode, **properties)
        gouge = deepest_gouge(job.Model.Group[0].Shape, path, step)
        print("%s: %d moves, deepest gouge %.4f mm" % (mode, len(path), gouge))
        self.assertGreater(path.statistics()["cut_length_mm"], 10.0)
        self.assertLessEqual(gouge, TOLERANCE)
        return operation, path

    def test_the_papers_parts(self):
        for shape in (make_parts.convex_part(), make_parts.overhanging_part()):
            for mode in CopyMilling.MODES:
                with self.subTest(mode=mode):
                    self.check(shape, mode, RadialDepth=4.0, AxialDepth=6.0)

    def test_parts_of_others(self):
        for file in REAL_PARTS:
            shape = read(file)
            solid = no_longer(max(shape.Solids, key=lambda s: s.Volume) if shape.Solids else shape, LARGEST)
            size = solid.BoundBox
            for mode in ("Scanning", "Contour"):
                with self.subTest(part=file.name, mode=mode):
                    print(file.name, "%.1f x %.1f x %.1f mm" % (size.XLength, size.YLength, size.ZLength))
                    big = max(size.XLength, size.YLength)
                    depths = {"RadialDepth": big / 12, "AxialDepth": min(max(1.0, size.ZLength / 4), EDGE)}
                    self.check(solid, mode, max(0.3, big / 300), **depths)

    def test_scallop_on_a_flat(self):
        for radial in (1.0, 2.0):
            document, job = job_with_stock(Part.makeBox(30, 20, 10), 1.0)
            operation, path = self.mill(job, RadialDepth=radial, AxialDepth=5.0)
            centres = ball_centres(path, 0.5)
            middle = centres[(np.abs(centres[:, 0] - 15) < 0.3) & (centres[:, 2] < 20)]
            y = np.unique(np.round(middle[:, 1], 6))
            y = y[(y > 2) & (y < 18)]
            gap = np.diff(y).max()
            heights = []
            for place in np.linspace(y[0], y[-1], 2001):  # the surface that the balls leave, at x = 15
                d = middle[:, 1] - place
                under = np.abs(d) < RADIUS
                heights.append((middle[under, 2] - np.sqrt(RADIUS**2 - d[under] ** 2)).min())
            ridge = max(heights) - min(heights)
            self.assertAlmostEqual(ridge, core.scallop_height(RADIUS, gap), delta=0.002)
            self.assertLessEqual(gap, radial + 1e-6)
            self.assertAlmostEqual(operation.Scallop, core.scallop_height(RADIUS, radial), places=9)

    def test_roughing_leaves_the_allowance_and_finishing_takes_it(self):
        shape = make_parts.convex_part()
        document, job = job_with_stock(shape, 1.0)
        part = job.Model.Group[0].Shape
        kwargs = {"RadialDepth": 4.0, "AxialDepth": 6.0, "Allowance": 0.5}
        operation, rough = self.mill(job, Passes="Roughing", **kwargs)
        self.assertAlmostEqual(deepest_gouge(part, rough, 0.3), -0.5, delta=0.02)
        operation, both = self.mill(job, FinishingRadialDepth=2.0, **kwargs)
        self.assertAlmostEqual(deepest_gouge(part, both, 0.3), 0.0, delta=TOLERANCE)
        self.assertGreater(len(both), len(rough))
        self.assertAlmostEqual(operation.Scallop, core.scallop_height(RADIUS, 2.0), places=9)
        operation, last = self.mill(job, Passes="Finishing", FinishingRadialDepth=2.0, **kwargs)
        self.assertLess(last.statistics()["cut_length_mm"], both.statistics()["cut_length_mm"])

    def test_chosen_faces_and_nothing_else(self):
        shape = pocket_part()
        document, job = job_with_stock(shape, 1.0)
        model = job.Model.Group[0]
        levels = {}  # of its level faces and its round wall: whether the ball gets there, and how low
        for number, face in enumerate(model.Shape.Faces, 1):
            box = face.BoundBox
            if box.ZLength < 1e-6:
                levels[number] = box.ZMin > 1, box.ZMin
            elif box.ZMin > 1:
                levels[number] = True, None
        self.assertEqual(len(levels), 4)
        for mode in CopyMilling.MODES[:2]:
            for number, (reached, height) in levels.items():
                operation = CopyMilling.Create("Faces", parentJob=job)
                operation.Base = [(model, ["Face%d" % number])]
                operation.RadialDepth, operation.Mode = 1.0, mode
                if not reached:
                    with self.assertRaises(InputError) as caught:
                        CopyMilling.recompute(operation)
                    self.assertEqual(caught.exception.property, "Base")
                    continue
                path = CopyMilling.recompute(operation)
                gouge = deepest_gouge(model.Shape, path, 0.3)
                print("%s, face %d: deepest gouge %.4f mm" % (mode, number, gouge))
                self.assertLessEqual(gouge, TOLERANCE)
                cuts = path.tips[path.kinds == 2]
                if height is not None:  # the ball rolls over an edge by 60 degrees
                    self.assertGreaterEqual(cuts[:, 2].min(), height - 0.5 * RADIUS - 0.05)
                if height == 12.0:  # the pocket's floor: within its wall, and all of it
                    out = np.hypot(cuts[:, 0] - 30.0, cuts[:, 1] - 20.0)
                    self.assertLessEqual(out[cuts[:, 2] < 17.0].max(), 12.0 - RADIUS + 0.02)
                    low = cuts[cuts[:, 2] < 12.01]
                    self.assertGreater(np.ptp(low[:, 0]), 2 * (12.0 - RADIUS) - 0.2)
                    self.assertGreater(np.ptp(low[:, 1]), 2 * (12.0 - RADIUS) - 2.2)

    def test_base_is_faces(self):
        document, job = job_with_stock(pocket_part(), 1.0)
        operation = CopyMilling.Create("Edge", parentJob=job)
        operation.Base = [(job.Model.Group[0], ["Edge1"])]
        with self.assertRaises(InputError) as caught:
            CopyMilling.recompute(operation)
        self.assertEqual(caught.exception.property, "Base")
        operation.Base = [(job.Model.Group[0], ["Face2"])]
        with self.assertRaises(InputError) as caught:
            patchmill.live.start(operation, 2.0, 400 / 60, 800 / 60)
        self.assertEqual(caught.exception.property, "Base")

    def test_goes_down_no_faster_than_the_tool_controller_says(self):
        document, job = job_with_stock(pocket_part(), 1.0)
        host.tool_controllers(job)[0].VertFeed = 2.0  # mm/s; 400 mm/min level
        for mode in CopyMilling.MODES[:2]:
            operation, path = self.mill(job, Mode=mode, RadialDepth=4.0)
            text = host.post_parts(job, "linuxcnc", job.PostProcessorArgs)[0]
            read = core.read_gcode(text, path.tool)[-1].path
            for made in (path, read):
                way = np.diff(np.vstack([[made.start], made.tips]), axis=0)
                with np.errstate(invalid="ignore"):
                    fall = -way[:, 2] / (made.turns / made.spindle.speed)
                timed = (made.kinds > 0) & np.isfinite(fall)
                self.assertLessEqual(fall[timed].max(), 2.0 + 2e-3)
                self.assertGreater(fall[timed].max(), 1.99)
            document.removeObject(operation.Name)

    def test_same_input_same_path(self):
        document, job = job_with_stock(make_parts.convex_part(), 1.0)
        _, a = self.mill(job, RadialDepth=5.0, AxialDepth=8.0, Mode="Contour")
        _, b = self.mill(job, RadialDepth=5.0, AxialDepth=8.0, Mode="Contour")
        self.assertEqual(a.tips.tobytes(), b.tips.tobytes())
        controller = host.tool_controllers(job)[0]
        self.assertEqual(a.spindle.speed, controller.SpindleSpeed / 60.0)

    def test_bad_input(self):
        document, job = job_with_stock(make_parts.convex_part(), 1.0)
        operation, _ = self.mill(job, RadialDepth=5.0, AxialDepth=8.0)
        for name, bad in [("RadialDepth", 0.0), ("AxialDepth", 0.0), ("Tolerance", 0.0)]:
            good = getattr(operation, name)
            setattr(operation, name, bad)
            with self.assertRaises(InputError) as caught:
                CopyMilling.recompute(operation)
            self.assertEqual(caught.exception.property, name)
            self.assertEqual(len(operation.Path.Commands), 0)
            setattr(operation, name, good)
        controller = operation.ToolController
        for owner, name, bad in [
            (operation, "Allowance", 9.0),  # more than AxialDepth: the last pass would take it at once
            (controller, "HorizFeed", 0.0),
            (controller, "VertFeed", 0.0),
            (controller, "SpindleSpeed", 0.0),
            (controller.Tool, "Diameter", 0.0),
        ]:
            good = getattr(owner, name)
            setattr(owner, name, bad)
            with self.assertRaises(InputError) as caught:
                CopyMilling.recompute(operation)
            self.assertEqual(caught.exception.property, name)
            setattr(owner, name, good)
            document.recompute()  # FreeCAD 1.1 needs one to draw a tool again that had no diameter
        controller.Tool.CuttingEdgeHeight = 7.0
        with self.assertRaises(InputError) as caught:
            CopyMilling.recompute(operation)
        self.assertEqual(caught.exception.property, "AxialDepth")
        controller.Tool.CuttingEdgeHeight = EDGE
        operation.setExpression("SafeHeight", None)
        operation.SafeHeight = job.Stock.Shape.BoundBox.ZMax - 5.0
        with self.assertRaises(InputError) as caught:
            CopyMilling.recompute(operation)
        self.assertEqual(caught.exception.property, "SafeHeight")
        operation.SafeHeight = job.Stock.Shape.BoundBox.ZMax + 5.0
        job.Stock = document.addObject("Part::Box", "Small")
        with self.assertRaises(InputError) as caught:
            CopyMilling.recompute(operation)
        self.assertEqual(caught.exception.property, "Model")
        document, job = make_job(make_parts.convex_part(), "endmill")
        with self.assertRaises(InputError) as caught:
            self.mill(job)
        self.assertEqual(caught.exception.property, "ToolController")

    def test_posts(self):
        document, job = job_with_stock(make_parts.convex_part(), 1.0)
        operation, path = self.mill(job, RadialDepth=5.0, AxialDepth=8.0)
        text = host.post_parts(job, "linuxcnc", job.PostProcessorArgs)[0]
        section = core.read_gcode(text, path.tool)[-1]
        self.assertLess(
            deepest_gouge(job.Model.Group[0].Shape, section.path, 0.3, section.unplaced), TOLERANCE + 1e-4
        )
        # from nobody knows where only straight to the safe height, and then across
        self.assertEqual(section.unplaced, 2)
        safe = path.start[2]
        np.testing.assert_allclose(section.path.tips[:2, 2], safe, atol=1e-4)
        first = next(c for c in operation.Path.Commands if c.Name == "G0")
        self.assertEqual(list(first.Parameters), ["Z"])
        self.assertAlmostEqual(first.Parameters["Z"], safe, 4)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
