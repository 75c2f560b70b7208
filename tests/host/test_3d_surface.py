"""FreeCAD's own 3D Surface: a dressup on its path, and copy milling compared with it. Where OpenCAMLib is
not installed its drop-cutter is replaced by a slow one of the tests (drop_cutter.py), so that FreeCAD's code
still writes the path; the comparison is then of that, and the one with OpenCAMLib is unknown, and says so.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parents[1] / "Resources" / "recipes" / "kobayashi2014"))

import drop_cutter  # noqa: E402

STAND_IN = drop_cutter.install()

import FreeCAD  # noqa: E402
import make_parts  # noqa: E402
import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import contact_off, distance_to_lines, native, trace  # noqa: E402
from patchmill import CopyMilling, DressupDCM  # noqa: E402
from test_copy_milling import deepest_at, job_with_stock  # noqa: E402

RADIUS, CONTACT, TOLERANCE, STEP = 3.0, 0.001, 0.01, 4.0
LOW, HIGH = 400.0 / 60.0, 800.0 / 60.0


def surface_job():
    """(job, operation): FreeCAD's 3D Surface in zigzag lines over the paper's convex part, ball of 6 mm."""
    document, job = job_with_stock(make_parts.convex_part(), 1.0)
    controller = patchmill.host.tool_controllers(job)[0]
    controller.HorizRapid = controller.VertRapid = 100.0
    job.GeometryTolerance = 0.01
    operation = native("Surface").Create("Surface", parentJob=job)
    operation.ToolController = controller
    operation.setExpression("StepDown", None)
    operation.BoundBox, operation.CutPattern, operation.LayerMode = "Stock", "ZigZag", "Single-pass"
    operation.StepOver = int(round(100.0 * STEP / (2.0 * RADIUS)))
    operation.SampleInterval = 0.5
    document.recompute()
    return job, operation


def ball_centres(commands):
    """Of feed moves that do not plunge, every 0.1 mm."""
    points, tangents, _ = trace(commands, 0.1)
    return points[np.abs(tangents[:, 2]) < 0.95] + (0.0, 0.0, RADIUS)


class OnItsPath(unittest.TestCase):
    def setUp(self):
        self.job, self.operation = surface_job()

    def tearDown(self):
        FreeCAD.closeDocument(self.job.Document.Name)

    def test_it_is_a_path_of_the_operations_own(self):
        names = [c.Name for c in self.operation.Path.Commands]
        self.assertTrue(any(name.startswith("(Begin step") for name in names))
        self.assertGreater(names.count("G1"), 500)
        self.assertGreater(names.count("G0"), 3)

    def test_feed(self):
        dressup = DressupDCM.Create("DressupDCM", self.operation)
        dressup.VoxelSize = 1.0
        result = DressupDCM.recompute(dressup)
        base, out = trace(self.operation.Path.Commands), trace(dressup.Path.Commands)
        off = contact_off(self.operation, dressup)
        print("3D Surface (%s): %d commands -> %d, contact off by %.2g um; %.0f s -> %.0f s" % (
            "drop-cutter of the tests" if STAND_IN else "OpenCAMLib", len(self.operation.Path.Commands),
            len(dressup.Path.Commands), 1000 * off, result.base_seconds, result.seconds))  # fmt: skip
        self.assertLess(off, CONTACT)
        self.assertGreaterEqual(out[2].min(), min(LOW, base[2].min()) * (1 - 1e-9))
        self.assertLessEqual(out[2].max(), HIGH * (1 + 1e-9))
        self.assertGreater(np.ptp(out[2]), 2.0)
        others = [
            [c.toGCode() for c in obj.Path.Commands if c.Name != "G1"] for obj in (self.operation, dressup)
        ]
        self.assertEqual(*others)  # comments and rapids, in their order

    def test_posture(self):
        dressup = DressupDCM.Create("DressupDCM", self.operation)
        dressup.Controls, dressup.Machine, dressup.TiltLimit = "Feed and posture", "table-table-ac", 40.0
        result = DressupDCM.recompute(dressup)
        path, base = result.path, result.base
        planned = np.vstack([np.array(base.start)[None], base.tips]) + (0, 0, RADIUS)
        axes = np.vstack([path.axes[:1], path.axes])
        tips = np.vstack([np.array(path.start)[None], path.tips])
        centres = []
        for s in (0.25, 0.5, 0.75, 1.0):  # tip and axis go evenly
            axis = axes[:-1] + s * np.diff(axes, axis=0)
            axis /= np.linalg.norm(axis, axis=1)[:, None]
            centres.append((tips[:-1] + s * np.diff(tips, axis=0) + RADIUS * axis)[path.kinds > 0])
        off = distance_to_lines(np.vstack(centres), planned)
        tilt = np.degrees(np.arccos(path.axes[:, 2].min()))
        print("3D Surface: ball centre off by %.2f um, tilts up to %.1f degrees" % (1000 * off, tilt))
        self.assertLess(off, CONTACT)
        self.assertGreater(tilt, 15.0)


class CopyMillingBesideIt(unittest.TestCase):
    """The same part, ball and cross-feed by both."""

    def measure(self):
        """{name: figures} of both paths, against distances and a ball lowered on a finer mesh."""
        job, operation = surface_job()
        began = time.monotonic()
        operation.touch()
        job.Document.recompute()
        surface_seconds = time.monotonic() - began
        copy = CopyMilling.Create("Copy", parentJob=job)
        copy.RadialDepth, copy.Passes, copy.Tolerance = STEP, "Finishing", TOLERANCE
        began = time.monotonic()
        CopyMilling.recompute(copy)
        copy_seconds = time.monotonic() - began
        part = job.Model.Group[0].Shape
        vertices, facets = part.tessellate(0.002)
        heights = drop_cutter.Heights(np.array(vertices)[np.array(facets)], RADIUS)
        figures = {}
        both = (("3D Surface", operation, surface_seconds), ("copy milling", copy, copy_seconds))
        for name, obj, seconds in both:
            centres = ball_centres(obj.Path.Commands)
            box = part.BoundBox
            inside = (centres[:, 0] > box.XMin + 1) & (centres[:, 0] < box.XMax - 1)
            inside &= (centres[:, 1] > box.YMin + 1) & (centres[:, 1] < box.YMax - 1)
            low = centres[inside & (centres[:, 2] < box.ZMax + RADIUS)]
            off = np.array([z - RADIUS - heights.at(x, y) for x, y, z in low[:: max(1, len(low) // 3000)]])
            figures[name] = {
                "moves": sum(c.Name == "G1" for c in obj.Path.Commands),
                "gouge_mm": round(float(deepest_at(part, centres, RADIUS)), 4),
                "above_mm": round(float(np.quantile(off, 0.95)), 4),
                "seconds": round(seconds, 2),
            }
            print("%s: %s" % (name, figures[name]))
        FreeCAD.closeDocument(job.Document.Name)
        return figures

    def check(self, figures):
        ours, theirs = figures["copy milling"], figures["3D Surface"]
        self.assertLessEqual(ours["gouge_mm"], TOLERANCE)
        self.assertLessEqual(ours["gouge_mm"], max(theirs["gouge_mm"], TOLERANCE))
        self.assertLess(abs(ours["above_mm"]), 2 * TOLERANCE)
        self.assertLess(abs(theirs["above_mm"]), 0.1)  # between samples 0.5 mm apart

    @unittest.skipIf(STAND_IN, "unknown: OpenCAMLib (Python module ocl) is not installed here")
    def test_with_opencamlib(self):
        self.check(self.measure())

    @unittest.skipUnless(STAND_IN, "OpenCAMLib is here, and is compared with itself")
    def test_with_the_drop_cutter_of_the_tests(self):
        self.check(self.measure())


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2, argv=["test"] + sys.argv[1:]).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
