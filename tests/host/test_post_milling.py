"""Posting of copy milling and DCM modifiers: what would break tool or part is refused, and no file is left.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parents[1] / "Resources" / "recipes" / "kobayashi2014"))

import make_parts  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import dress, make_job, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import CopyMilling, DressupDCM, InputError  # noqa: E402

PLAIN = "--no-header --no-show-editor"


class PostMilling(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = os.path.join(folder.name, "program.ngc")

    def posts(self, job, *arguments):
        patchmill.post(job, self.program, *arguments)
        self.assertTrue(os.path.exists(self.program))
        os.remove(self.program)

    def refused(self, name, job, *arguments):
        with self.assertRaises(InputError) as caught:
            patchmill.post(job, self.program, *arguments)
        self.assertEqual(caught.exception.property, name, caught.exception)
        self.assertFalse(os.path.exists(self.program))
        print("refused:", caught.exception)

    def test_a_file_that_cannot_be_written(self):
        document, job = make_job(pocket_part(), "unwritable", ball=True)
        CopyMilling.recompute(CopyMilling.Create("Copy", parentJob=job))
        folder = os.path.dirname(self.program)
        for name in (os.path.join(folder, "none", "x.ngc"), folder):
            with self.assertRaises(InputError) as caught:
                patchmill.post(job, name)
            self.assertEqual(caught.exception.property, "filename")
            self.assertEqual(os.listdir(folder), [])

    def test_what_is_for_textures_says_so(self):
        document, job = make_job(pocket_part(), "copied", ball=True)
        operation = CopyMilling.Create("Copy", parentJob=job)
        patchmill.recompute(operation)
        for function in (patchmill.check, patchmill.simulate, patchmill.planned):
            with self.assertRaises(InputError) as caught:
                function(operation)
            self.assertEqual(caught.exception.property, "Operation")

    def test_a_dressup_is_recomputed_like_an_operation(self):
        document, job = make_job(pocket_part(), "dressed", ball=True)
        operation = CopyMilling.Create("Copy", parentJob=job)
        dressup = dress(operation)
        self.assertGreater(patchmill.recompute(dressup).seconds, 0.0)
        dressup.VoxelSize = 0.0
        with self.assertRaises(InputError) as caught:
            patchmill.recompute(dressup)
        self.assertEqual(caught.exception.property, "VoxelSize")
        dressup.VoxelSize = 1.0
        named = DressupDCM.Create("Last", dressup)
        self.assertEqual(named.Label, "Last")
        self.assertIn("Dressup", named.Name)  # by which FreeCAD knows it

    def test_below_overhangs_only_with_a_tilted_tool(self):
        document, job = make_job(make_parts.overhanging_part(), "undercut", ball=True)
        operation = CopyMilling.Create("Copy", parentJob=job)
        operation.Mode, operation.RadialDepth, operation.AxialDepth = CopyMilling.MODES[2], 12.0, 8.0
        CopyMilling.recompute(operation)
        self.refused("Mode", job)
        dressup = dress(operation, VoxelSize=3.0)
        DressupDCM.recompute(dressup)
        self.refused("Mode", job)  # its feed alone does not tilt the tool
        dressup.Controls, dressup.Machine = "Feed and posture", "table-table-ac"
        DressupDCM.recompute(dressup)
        self.posts(job, "patchmill_linuxcnc", PLAIN)
        made = CopyMilling.mill(CopyMilling.input_of(operation))
        self.assertEqual(len(CopyMilling.remarks(made)), len(CopyMilling.remarks(made, True)) + 1)
        operation.Mode = "Scanning"
        dressup.Controls = "Feed"
        self.posts(job)

    def test_tilted_paths_need_a_post_that_keeps_their_words(self):
        document, job = make_job(pocket_part(), "tilted", ball=True)
        operation = CopyMilling.Create("Copy", parentJob=job)
        operation.RadialDepth = 6.0
        dressup = dress(operation, VoxelSize=2.0, Controls="Posture", Machine="table-table-ac")
        DressupDCM.recompute(dressup)
        for post in ("centroid", "smoothie"):  # they drop C
            self.refused("PostProcessor", job, post, PLAIN)
        self.refused("PostProcessorArgs", job, "linuxcnc", PLAIN + " --inches")  # scales inverse time
        self.refused("PostProcessor", job, "linuxcnc", PLAIN + " --none-such")
        self.posts(job, "linuxcnc", PLAIN)
        dressup.Controls = "Feed"
        self.posts(job, "linuxcnc", PLAIN + " --inches")


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
