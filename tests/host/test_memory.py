"""What a job will take is refused before it is taken, with both numbers and what takes less.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import re
import resource
import sys
import types
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import numpy as np  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from parts import WithDocuments, job_on, tilted_box  # noqa: E402
from patchmill import InputError, posting  # noqa: E402
from patchmill.collision import clearance_check  # noqa: E402
from patchmill.operations import copy_milling  # noqa: E402
from patchmill.posting import requirements  # noqa: E402
from patchmill.system import memory  # noqa: E402
from patchmill.textures import division, plan  # noqa: E402
from patchmill.voxels import removal_model  # noqa: E402


SPHERE = 20.0  # mm, radius


class FineMeshes(unittest.TestCase):
    """A tolerance whose mesh would be too large is named with one that does, whoever meshes."""

    def refused(self, name, call):
        """The value that the refusal of call() asks for, in mm."""
        with self.assertRaises(InputError) as caught:
            call()
        self.assertEqual(caught.exception.property, name)
        self.assertRegex(caught.exception.value, r"0\.0001 mm, about [\d.]+ million triangles")
        return float(re.search(r"give ([\d.]+) mm or more", caught.exception.remedy).group(1))

    def test_the_value_that_a_deflection_comes_from_is_named(self):
        ball = Part.makeSphere(SPHERE).exportBrepToString()
        box = Part.makeBox(*3 * (3 * SPHERE,), FreeCAD.Vector(*3 * (-1.5 * SPHERE,))).exportBrepToString()
        copied = types.SimpleNamespace(mode="Lines", tolerance=1e-4, stock=box, model=ball, faces=None)
        checked = clearance_check.CheckInput(object(), [ball], 1e-4, 0.0)
        model = removal_model.ModelInput(box, ball, 1.0, 1e-4, 4096.0, False)
        for name, share, call in (
            ("Tolerance", 0.25, lambda: copy_milling.solids(copied)),
            ("GougeTolerance", 0.125, lambda: clearance_check.run_check(checked)),
            ("Deflection", 1.0, lambda: removal_model.make(model)),
        ):
            with self.subTest(name):
                # triangles of a ball go with 1 / deflection: there are to be two million of them
                enough = share * self.refused(name, call)
                triangles = len(core.tessellate(ball, 0.01).triangles) * 0.01 / enough
                self.assertLess(triangles, 2e6)
                self.assertGreater(triangles, 1.2e6)

    def test_they_are_within_their_deflection(self):
        """Of a torus, with both of its seams."""
        made = core.tessellate(Part.makeTorus(10, 2).exportBrepToString(), 8e-4)
        self.assertTrue(made.closed, made.reason)
        self.assertLess(len(made.triangles), 2e5)
        middles = made.vertices[made.triangles].mean(axis=1)
        off = np.hypot(np.hypot(middles[:, 0], middles[:, 1]) - 10.0, middles[:, 2]) - 2.0
        self.assertLess(np.abs(off).max(), 8e-4)


class Memory(WithDocuments):
    def setUp(self):
        _, op = job_on(*tilted_box())
        op.PatchSide = 10
        self.given = op.Proxy.texture_input(op)

    def with_free(self, free, call):
        with mock.patch.object(memory, "available", return_value=free):
            return call(self.given)

    def refused(self, free, call):
        with self.assertRaises(InputError) as caught:
            self.with_free(free, call)
        self.assertEqual(caught.exception.property, "Spacing")
        self.assertRegex(str(caught.exception), r"GB of memory, and .* GB are free: .* larger spacing")

    def test_a_lattice_is_foreseen_before_a_dimple_is_placed(self):
        points = len(plan.place_texture(self.given).dimples)
        takes = points * division.BYTES_PER_POINT["Projected"] + division.BYTES_AT_LEAST
        with mock.patch.object(core.FaceSampler, "place") as place:
            self.refused(takes - 1.0, plan.place_texture)
            place.assert_not_called()
        self.assertEqual(len(self.with_free(takes, plan.place_texture).dimples), points)

    def test_what_is_cut_is_foreseen_before_it_is_planned(self):
        cut = dict(plan.place_texture(self.given).dimples.counts())["cut"]
        takes = cut * division.BYTES_PER_DIMPLE + division.BYTES_AT_LEAST
        self.refused(takes - 1.0, plan.plan_texture)
        self.assertEqual(self.with_free(takes, plan.plan_texture).counts["cut"], cut)

    def test_what_will_surely_be_cut_is_foreseen_before_a_dimple_is_placed(self):
        cut = dict(plan.place_texture(self.given).dimples.counts())["cut"]
        looked_at_later = mock.patch.object(division, "require_memory")
        with looked_at_later, mock.patch.object(core.FaceSampler, "place") as place:
            self.refused(0.6 * cut * division.BYTES_PER_DIMPLE, plan.plan_texture)
            place.assert_not_called()

    def test_millions_of_dimples_are_refused_where_there_are_few_gigabytes(self):
        self.given.patches_x, self.given.patches_y = 200, 210  # of 100 dimples: 4.2 million
        self.refused(3e8, plan.place_texture)

    def test_a_program_is_foreseen_before_it_is_written(self):
        (op,) = (o for o in FreeCAD.ActiveDocument.Objects if hasattr(o, "PatchSide"))
        (job,) = (o for o in FreeCAD.ActiveDocument.Objects if hasattr(o, "Fixtures"))
        patchmill.recompute(op)
        job.Fixtures = ["G54", "G55"]
        takes = 2 * op.Path.Size * requirements.BYTES_PER_COMMAND
        with mock.patch.object(memory, "available", return_value=takes - 1.0):
            with self.assertRaises(InputError) as caught:
                posting.text_of(job, "patchmill_linuxcnc", "--precision=%d" % op.Decimals)
        self.assertEqual(caught.exception.property, "Operations")
        self.assertRegex(str(caught.exception), r"%d commands.* GB are free" % (2 * op.Path.Size))
        with mock.patch.object(memory, "available", return_value=takes):
            self.assertTrue(posting.text_of(job, "patchmill_linuxcnc", "--precision=%d" % op.Decimals))

    def test_free_is_no_more_than_the_limit_of_the_process(self):
        free = memory.available()
        self.assertGreater(free, 0.0)
        with open("/proc/self/statm", encoding="ascii") as own:
            taken = int(own.read().split()[0]) * resource.getpagesize()
        limits = resource.getrlimit(resource.RLIMIT_AS)
        resource.setrlimit(resource.RLIMIT_AS, (taken + 64_000_000, limits[1]))
        try:
            self.assertLess(memory.available(), 65_000_000)
        finally:
            resource.setrlimit(resource.RLIMIT_AS, limits)


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
