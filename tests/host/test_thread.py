"""Cylinders milled all round along one thread: the lattice closes, the program is one locked move, what is
read back from it is the plan, and the marks are where the plan has them, all round.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import os
import re
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import Part  # noqa: E402
import _patchmill as core  # noqa: E402
import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from patchmill.advice import assessment  # noqa: E402
from parts import V, WithDocuments, job_on  # noqa: E402
from patchmill.machine import machines  # noqa: E402
from patchmill.textures.thread import lattice  # noqa: E402

MICROMETRE = 1e-3


def roller(radius=20.0, length=60.0, shape="Hexagon", spacing=0.5, **properties):
    """(document, operation) of a roller along X, its axis on that of A."""
    cylinder = Part.makeCylinder(radius, length, V(0, 0, 0), V(1, 0, 0))
    face = next(n for n, f in enumerate(cylinder.Faces, 1) if type(f.Surface).__name__ == "Cylinder")
    document, op = job_on(cylinder, "Face%d" % face)
    set_up(op, PatchShape=shape, Spacing=spacing, **properties)
    return document, op


def set_up(op, **properties):
    values = {
        "Machine": "four-axis-mill",
        "Order": "Thread",
        "Strategy": "Spindle-locked",
        "SameFlute": False,
        "ToolAxisMode": "Normal",
        "Lead": 20.0,
        "Decimals": 4,
    }
    for name, value in dict(values, **properties).items():
        setattr(op, name, value)
    op.ToolController.SpindleSpeed = 1000


def unrolled_steps(found):
    """(n, 2) ways on the unrolled cylinder to the neighbours that come later on a ThreadLattice's thread."""
    steps = []
    for number in found.neighbours:
        turns = round(number / found.round)
        steps.append((number * found.along - turns * found.circumference, number * found.up))
    return np.array(steps)


class Lattice(unittest.TestCase):
    def test_nothing_of_a_cylinder_looks_away(self):
        _, op = roller(length=3.0)
        found = assessment.assess(patchmill.simulate, op.Proxy.texture_input(op))
        self.assertEqual((found.away_fraction, found.milled_fraction), (0.0, 1.0))

    def test_all_neighbours_are_one_spacing_away(self):
        for radius, spacing in ((20.0, 0.5), (4.0, 0.55), (3.7, 1.3), (50.0, 0.21), (1.0, 2.0)):
            for triangular in (True, False):
                with self.subTest(radius=radius, spacing=spacing, triangular=triangular):
                    found = lattice.closing(2.0 * math.pi * radius, spacing, triangular)
                    ways = np.linalg.norm(unrolled_steps(found), axis=1)
                    np.testing.assert_allclose(ways, found.spacing, rtol=0.0, atol=1e-12)
                    area = found.spacing**2 * (math.sqrt(3.0) / 2.0 if triangular else 1.0)
                    self.assertAlmostEqual(found.up * found.circumference, area, places=12)

    def test_spacing_changes_by_the_least_that_closes(self):
        circumference = 40.0 * math.pi
        found = lattice.closing(circumference, 0.5, True)
        every = [circumference / math.sqrt(m * m - m + 1) for m in range(200, 300)]
        self.assertEqual(found.spacing, min(every, key=lambda f: abs(f - 0.5)))
        self.assertLess(abs(found.spacing - 0.5), 0.5 * 0.5**2 / circumference)

    def test_too_few_round_are_refused(self):
        with self.assertRaises(patchmill.InputError) as caught:
            lattice.closing(5.0, 2.0, True)
        self.assertEqual(caught.exception.property, "Spacing")


class Thread(WithDocuments):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="patchmill-thread-")
        self.addCleanup(self.folder.cleanup)

    def post(self, op):
        job = op.Document.getObject("Job")
        job.PostProcessor, job.PostProcessorArgs = "patchmill_linuxcnc", "--precision=4"
        name = os.path.join(self.folder.name, "roller.ngc")
        posted = patchmill.post(job, name)[0]
        with open(name, encoding="ascii") as file:
            return posted, file.read(), name

    def test_roller_has_no_seam(self):
        for shape, near in (("Hexagon", 6), ("Square", 4)):
            with self.subTest(shape=shape):
                _, op = roller(length=4.0, shape=shape)
                plan = patchmill.recompute(op)
                cut = plan.dimples.states == core.DimpleState.CUT
                places = plan.dimples.positions[cut]
                np.testing.assert_allclose(np.hypot(places[:, 1], places[:, 2]), 20.0, atol=1e-9)
                inside = np.flatnonzero((places[:, 0] > 1.0) & (places[:, 0] < 3.0))
                self.assertGreater(len(inside), 400)
                for k in inside[::7]:
                    away = np.sort(np.linalg.norm(places - places[k], axis=1))
                    self.assertLess(np.abs(away[1 : near + 1] - plan.input.spacing).max(), 0.15 * MICROMETRE)
                    self.assertGreater(away[near + 1], 1.3 * plan.input.spacing)
                self.assertLess(op.SpacingGreatest.Value - op.SpacingLeast.Value, 0.2 * MICROMETRE)
                share = cut.sum() * plan.input.spacing**2 * core.row_pitch(shape)
                self.assertAlmostEqual(share / (40.0 * math.pi * 4.0), 1.0, delta=0.005)

    def test_tool_leads_by_what_is_asked_for(self):
        for lead in (20.0, -35.0, 5.0):
            with self.subTest(lead=lead):
                _, op = roller(6.0, 3.0, Lead=lead)
                plan = patchmill.recompute(op)
                ends = np.flatnonzero(plan.path.dimples >= 0)
                number = plan.path.dimples[ends]
                normals = plan.dimples.normals[number]
                cosine = np.einsum("ij,ij->i", plan.path.axes[ends], normals)
                np.testing.assert_allclose(np.degrees(np.arccos(cosine)), abs(lead), atol=2e-3)
                feed = np.diff(plan.dimples.positions[number], axis=0)
                towards = np.einsum("ij,ij->i", plan.path.axes[ends][:-1], feed)
                self.assertTrue((np.sign(towards) == math.copysign(1.0, lead)).all())
                centre = plan.path.tips[ends] + plan.path.axes[ends]
                wanted = plan.dimples.positions[number] + normals
                self.assertLess(np.abs(centre - wanted).max(), 0.75 * 10.0**-plan.input.decimals)

    def test_program_is_one_locked_move_and_reads_back(self):
        _, op = roller(6.0, 3.0)
        plan = patchmill.recompute(op)
        posted, text, _ = self.post(op)
        found = re.findall(r"G0?33 X([-.\d]+)(?: Y[-.\d]+)?(?: Z[-.\d]+)? A([-.\d]+) K([.\d]+)", text)
        self.assertEqual(len(found), 1, text)
        last, angle, lead = (float(word) for word in found[0])
        turns = (last - plan.thread.start[0]) / lead
        per_turn = 360.0 * 2.0 * turns / angle
        rise = lead * per_turn / 2.0  # in one turn of A
        up, along = lead / 2.0, 12.0 * math.pi / per_turn
        self.assertAlmostEqual(math.hypot(up, along), plan.input.spacing, delta=0.1 * MICROMETRE)
        self.assertAlmostEqual(rise, plan.input.spacing * math.sqrt(0.75), delta=2.0 * MICROMETRE)
        ends = np.flatnonzero(posted.path.dimples >= 0)
        self.assertEqual(len(ends), plan.counts["cut"])
        centre = posted.path.tips[ends] + posted.path.axes[ends]
        number = posted.path.dimples[ends]
        wanted = plan.dimples.positions[number] + plan.dimples.normals[number]
        self.assertLess(np.abs(centre - wanted).max(), 0.75 * 10.0**-plan.input.decimals)
        self.assertLess(math.degrees(posted.errors["largest"]), 0.1)
        self.assertEqual(posted.check.outcome, "clear")

    def test_a_changed_word_is_not_read_back(self):
        _, op = roller(6.0, 3.0)
        patchmill.recompute(op)
        _, text, name = self.post(op)
        lead = re.search(r"K([.\d]+)", text).group(1)
        angle = re.search(r"G0?33 .*A([-.\d]+) ", text).group(1)
        for old, new in ((lead, "%.6f" % (float(lead) + 2e-6)), (angle, "%.4f" % (float(angle) + 0.01))):
            with open(name, "w", encoding="ascii") as file:
                file.write(text.replace(old, new))
            with self.assertRaises(patchmill.InputError):
                patchmill.read_back(op.Document.getObject("Job"), name)

    def test_marks_all_round(self):
        for kind, depth in (("Overlapping", 0.0), ("Isolated", 0.02)):
            with self.subTest(kind=kind):
                _, op = roller(6.0, 3.0, TextureKind=kind, Depth=depth)
                plan = patchmill.recompute(op)
                _, _, name = self.post(op)
                result = patchmill.simulate_round(op, program=name, along=(0.6, 2.4))
                looked, found = result.dimples
                inside = plan.dimples.positions[looked]
                self.assertGreater(len(looked), 200)
                angles = np.sort(np.arctan2(inside[:, 1], inside[:, 2]))
                self.assertLess(np.diff(angles).max(), 0.1)  # all round
                self.assertEqual((result.missing, result.extra), (0, 0))
                self.assertGreater(result.quality, 0.95)
                relief = result.unrolled()
                self.assertAlmostEqual(len(relief.heights) * relief.step[0], 12.0 * math.pi, delta=0.05)

    def test_the_best_speed_is_the_fastest_at_which_the_table_keeps_up(self):
        """The time falls as the speed rises, but for the way down."""
        _, op = roller(6.0, 4.0)
        found = patchmill.best_speed(op, speeds=(500, 1000, 2000))
        self.assertEqual([point.holds for point in found.curve] + [found.best.rpm], [True, True, False, 1000])
        self.assertIn("give", found.curve[-1].trouble)
        turned = [point.seconds * point.rpm for point in found.curve[:2]]
        self.assertAlmostEqual(turned[0], turned[1], delta=0.1 * turned[0])

    def test_what_a_thread_cannot_have_is_refused(self):
        _, op = roller(6.0, 3.0)
        for name, value, said in (
            ("Strategy", "Constant feed", "Strategy"),
            ("Machine", "", "Machine"),
            ("Machine", "table-table-ac", "Machine"),
            ("Machine", "linuxcnc-mill", "Machine"),
            ("ToolAxisMode", "Fixed", "ToolAxisMode"),
            ("Tilt", 5.0, "Tilt"),
            ("Lead", 90.0, "Lead"),
            ("SameFlute", True, "SameFlute"),
            ("FirstPatch", 2, "FirstPatch"),
            ("LeadTowards", V(1, 0, 0), "LeadTowards"),
            ("Spacing", 15.0, "Spacing"),
        ):
            with self.subTest(name=name, value=value):
                before = getattr(op, name)
                setattr(op, name, value)
                self.assert_refused(op, said)
                setattr(op, name, before)
        op.ToolController.SpindleSpeed = 20000
        self.assert_refused(op, "SpindleSpeed")
        with self.assertRaises(patchmill.InputError) as caught:
            patchmill.recompute(op)
        op.ToolController.SpindleSpeed = int(re.search(r"give (\d+) rpm", str(caught.exception)).group(1))
        patchmill.recompute(op)

    def test_faces_that_are_no_free_cylinder_are_refused(self):
        cylinder = Part.makeCylinder(6.0, 8.0, V(0, 0, 0), V(1, 0, 0))
        holed = cylinder.cut(Part.makeCylinder(1.0, 20.0, V(4, 0, -10), V(0, 0, 1)))
        half = cylinder.cut(Part.makeBox(8.0, 12.0, 6.0, V(0, -6, 0)))
        tube = Part.makeCylinder(6.0, 8.0, V(0, 0, 0), V(1, 0, 0)).cut(
            Part.makeCylinder(4.0, 8.0, V(0, 0, 0), V(1, 0, 0))
        )
        beside = Part.makeCylinder(6.0, 8.0, V(0, 0.01, 0), V(1, 0, 0))
        askew = Part.makeCylinder(6.0, 8.0, V(0, 0, 0), V(1, 0.001, 0))
        for name, shape, radius in (
            ("holed", holed, 6.0),
            ("half", half, 6.0),
            ("bore", tube, 4.0),
            ("beside", beside, 6.0),
            ("askew", askew, 6.0),
            ("flat", cylinder, None),
        ):
            with self.subTest(name):
                face = next(n for n, f in enumerate(shape.Faces, 1) if _radius(f) == radius)
                _, op = job_on(shape, "Face%d" % face)
                set_up(op)
                self.assert_refused(op, "Base")

    def test_an_axis_with_limits_does_not_wind(self):
        with mock.patch.dict(os.environ, PATCHMILL_MACHINES=self.folder.name):
            data = machines.load("four-axis-mill").data
            _, op = roller(6.0, 3.0)
            last = math.degrees(patchmill.recompute(op).thread.angle)
            for high, good in ((last + 0.01, True), (last - 0.01, False)):
                machines.save("other", dict(data, rotary_axes=[
                    dict(data["rotary_axes"][0], limits_degrees=[-1.0, high])]))  # fmt: skip
                op.Machine = "other"
                if good:
                    patchmill.recompute(op)
                else:
                    self.assert_refused(op, "Machine")

    def test_collar_in_the_way_is_found(self):
        collar = Part.makeCylinder(9.0, 4.0, V(-4, 0, 0), V(1, 0, 0))
        shaft = Part.makeCylinder(6.0, 0.6, V(0, 0, 0), V(1, 0, 0)).fuse(collar)
        face = next(n for n, f in enumerate(shaft.Faces, 1) if _radius(f) == 6.0)
        _, op = job_on(shaft, "Face%d" % face)
        set_up(op)
        patchmill.recompute(op)
        with self.assertRaises(patchmill.InputError) as caught:
            self.post(op)
        self.assertEqual(caught.exception.property, "PostGouging")

    def test_axis_b_and_a_turned_part(self):
        """The same roller along Y, on a B table whose positive angle turns the other way."""
        with mock.patch.dict(os.environ, PATCHMILL_MACHINES=self.folder.name):
            data = machines.load("four-axis-mill").data
            turned = dict(data["rotary_axes"][0], letter="B", direction=[0, -1, 0], point_mm=[3.0, 0.0, 20.0])
            machines.save("other", dict(data, axes="XYZB", rotary_axes=[turned]))
            cylinder = Part.makeCylinder(6.0, 3.0, V(3, 1, 20), V(0, 1, 0))
            face = next(n for n, f in enumerate(cylinder.Faces, 1) if _radius(f) == 6.0)
            _, op = job_on(cylinder, "Face%d" % face)
            set_up(op, Machine="other")
            plan = patchmill.recompute(op)
            posted, _, _ = self.post(op)
            ends = np.flatnonzero(posted.path.dimples >= 0)
            number = posted.path.dimples[ends]
            self.assertEqual(len(ends), plan.counts["cut"])
            centre = posted.path.tips[ends] + posted.path.axes[ends]
            wanted = plan.dimples.positions[number] + plan.dimples.normals[number]
            self.assertLess(np.abs(centre - wanted).max(), 0.75 * 10.0**-plan.input.decimals)


def _radius(face):
    return getattr(face.Surface, "Radius", None) if type(face.Surface).__name__ == "Cylinder" else None


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
