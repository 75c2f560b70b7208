"""FreeCAD's own Post command: PatchMill's posts compare by themselves and refuse what does not hold; what
posts of others wrote is compared afterwards, and it is said.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import make_job  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError, posting  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.posting import native_post  # noqa: E402
from patchmill.posting.post_dialect import Dialect  # noqa: E402
from roof_job import custom, roof_job  # noqa: E402

ARGUMENTS = "--no-header --precision=3"
UPRIGHT = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X45 F10", "G0 Z30"]


class OwnPosts(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = os.path.join(folder.name, "x.ngc")

    def export(self, job, control="linuxcnc", arguments=ARGUMENTS):
        """As FreeCAD's command calls the post."""
        name = "patchmill_" + control
        (objects,) = host.post_objects(job, name)
        return posting.own_dialect(name).export(objects, self.program, arguments)

    def refused(self, name, *call):
        with self.assertRaises(InputError) as caught:
            self.export(*call)
        self.assertEqual(caught.exception.property, name, caught.exception)
        self.assertFalse(os.path.exists(self.program))

    def test_what_holds_is_written_as_post_writes_it(self):
        job, _ = roof_job("Spindle-locked", "Constant feed")
        patchmill.post(job, self.program, "patchmill_linuxcnc", ARGUMENTS)
        wanted = pathlib.Path(self.program).read_text(encoding="ascii")
        os.remove(self.program)
        self.assertEqual(self.export(job), wanted)
        self.assertEqual(pathlib.Path(self.program).read_text(encoding="ascii"), wanted)

    def test_what_does_not_hold_is_refused(self):
        job, (texture,) = roof_job("Constant feed")
        plain = Dialect.program

        def spoilt(dialect, objects, arguments):
            return plain(dialect, objects, arguments).replace("F600.000", "F600.001")

        with mock.patch.object(Dialect, "program", spoilt):
            self.refused(texture.Label, job)
            self.export(job, "linuxcnc", ARGUMENTS + " --no-compare")
            os.remove(self.program)

    def test_what_post_refuses_is_refused_here(self):
        job, (texture,) = roof_job("Constant feed")
        job.Fixtures = ["G55"]
        self.refused("Fixtures", job, "heidenhain")
        job.Fixtures = ["G54"]
        self.refused("Decimals", job, "linuxcnc", "--no-header --precision=4")
        texture.Strategy, texture.Machine, texture.PostUnheld = "Feed per move", "linuxcnc-mill", False
        texture.SameFlute, texture.ExtraTurns = False, 0.0
        self.refused("SpindleSpeed", job)

    def test_arguments_of_the_job_stay(self):
        job, _ = roof_job("Constant feed")
        patchmill.post(job, self.program, "patchmill_linuxcnc", ARGUMENTS)
        self.assertEqual(job.PostProcessorArgs, ARGUMENTS)


class PostsOfOthers(WithDocuments):
    def found(self, job, post="linuxcnc", arguments="--no-header --no-show-editor"):
        """What is said of the program that FreeCAD's command would write."""
        job.PostProcessor = post
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "x.ngc")
            texts = host.post_parts(job, post, arguments)
            pathlib.Path(program).write_text(texts[0], encoding="ascii")
            return native_post.findings(job, program)

    def test_a_program_that_holds(self):
        job, _ = roof_job("Constant feed")
        self.assertEqual(self.found(job), [])

    def test_a_lock_that_is_lost(self):
        job, _ = roof_job("Spindle-locked")
        (said,) = self.found(job)
        self.assertIn("Do not run", said)

    def test_a_table_that_is_left_turned(self):
        job, (texture,) = roof_job("Feed per move")
        texture.Machine, texture.FixedAxis = "table-table-ac", FreeCAD.Vector(0.25, 0.1, 1)
        texture.PostGouging = True
        custom(job, UPRIGHT)
        (said,) = self.found(job)
        self.assertIn("bring them back", said)

    def test_several_files_are_not_compared(self):
        job, _ = roof_job("Constant feed")
        job.SplitOutput = True
        (said,) = self.found(job)
        self.assertIn("not compared", said)

    def test_which_jobs_are_looked_at(self):
        job, _ = roof_job("Constant feed")
        for post, concerns in (("linuxcnc", True), ("patchmill_linuxcnc", False)):
            known = job.getEnumerationsOfProperty("PostProcessor")
            job.PostProcessor = sorted({*known, post})
            job.PostProcessor = post
            self.assertEqual(native_post.concerns(job), concerns)
        _, job = make_job(Part.makeBox(10, 10, 5))
        custom(job, UPRIGHT)
        self.assertFalse(native_post.concerns(job))


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
