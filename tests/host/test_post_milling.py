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
import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import dress, make_job, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import CopyMilling, DressupDCM, InputError  # noqa: E402
from patchmill.verify import posted_milling  # noqa: E402

PLAIN = "--no-header --no-show-editor"


class PostMilling(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = os.path.join(folder.name, "program.ngc")

    def posts(self, job, *arguments):
        posted = patchmill.post(job, self.program, *arguments)
        self.assertTrue(os.path.exists(self.program))
        os.remove(self.program)
        return posted

    def refused(self, name, job, *arguments):
        with self.assertRaises(InputError) as caught:
            patchmill.post(job, self.program, *arguments)
        self.assertEqual(caught.exception.property, name, caught.exception)
        self.assertFalse(os.path.exists(self.program))
        print("refused:", caught.exception)
        return str(caught.exception)

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
        for function in (patchmill.simulate, patchmill.planned):
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

    def test_every_move_is_read_back(self):
        document, job = make_job(pocket_part(), "read_back", ball=True)
        operation = CopyMilling.Create("Copy", parentJob=job)
        operation.RadialDepth = 6.0
        moves = patchmill.recompute(operation).kinds
        (posted,) = patchmill.post(job, self.program, "linuxcnc", PLAIN)
        self.assertEqual((posted.operation, posted.unknown), (operation, ""))
        self.assertGreater(posted.moves, np.count_nonzero(moves > 0) - 1)
        with open(self.program) as file:
            lines = file.read().splitlines()
        cutting = [n for n, line in enumerate(lines) if line.startswith("G1 ")]
        middle = cutting[len(cutting) // 2]
        number = next(word for word in lines[middle].split() if word[0] in "XYZ")
        value = number[0] + "%.3f" % (float(number[1:]) + 0.002)
        spoilt = {
            "left out": lines[:middle] + lines[middle + 1 :],
            "moved": lines[:middle] + [lines[middle].replace(number, value)] + lines[middle + 1 :],
            "put in": lines[:middle] + ["G1 X1.000 Y2.000 Z3.000 F100.000"] + lines[middle:],
            "made rapid": lines[:middle] + [lines[middle].replace("G1 ", "G0 ")] + lines[middle + 1 :],
            "turned": lines[:middle] + [lines[middle] + " C1.000"] + lines[middle + 1 :],
            "cut short": lines[: cutting[-1]],
        }
        for how, text in spoilt.items():
            with self.assertRaises(InputError, msg=how) as caught:
                posted_milling.read_back(operation, "\n".join(text) + "\n", "linuxcnc", 0.0005)
            self.assertEqual(caught.exception.property, operation.Label)
            print(how, "->", caught.exception)
        whole = "\n".join(lines) + "\n"
        again = posted_milling.read_back(operation, whole, "linuxcnc", 0.0005)
        self.assertEqual((again.moves, again.unknown, posted.offset), (posted.moves, "", "G54"))
        arc = posted_milling.read_back(operation, whole + "G2 X1 Y1 I1 J0\n", "linuxcnc", 0.0005)
        self.assertIn("G2", arc.unknown)  # cannot be read: neither passed nor refused

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
        # it is tilted, but nobody has said what is above its ball: the edges, 60 mm long, are in the overhang
        self.assertIn("The flute cuts 2.8", self.refused("PostGouging", job, "patchmill_linuxcnc", PLAIN))
        dressup.PostGouging = True
        (posted,) = self.posts(job, "patchmill_linuxcnc", PLAIN)
        self.assertEqual({f.part for f in posted.check.findings}, {"flute"})
        dressup.PostGouging = False
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
        for post in ("linuxcnc", "patchmill_linuxcnc", "patchmill_fanuc", "patchmill_siemens"):
            (posted,) = self.posts(job, post, PLAIN)
            self.assertEqual((posted.unknown, posted.operation), ("", dressup), post)
            self.assertGreater(posted.moves, 100)
        dressup.Controls = "Feed"
        (posted,) = self.posts(job, "linuxcnc", PLAIN + " --inches")
        self.assertEqual((posted.unknown, posted.moves > 100), ("", True))


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
