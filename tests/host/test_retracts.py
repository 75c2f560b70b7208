"""The words by which PatchMill's own posts come clear of everything, where the machine's file says where that
is: before tool changes, turns of the table or head and the end. A program without one of them is refused.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile
import unittest
import unittest.mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
import patchmill  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError, posting  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.machine import machines  # noqa: E402
from patchmill.posting.control_match import own_dialect  # noqa: E402
from patchmill.verify.posted_between import bare  # noqa: E402
from roof_job import custom, roof_job  # noqa: E402

CUT = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X46 F10", "G0 Z30"]
ARGUMENTS = "--no-header --precision=3"
TILTED = {
    "linuxcnc": ("table-table-ac", ["G53G0Z390"]),
    "fanuc": ("head-head-ca", ["G90G53G0Z0"]),
    "siemens": ("head-table-bc", ["SUPAG0Z0D0", "D1"]),
    "heidenhain": ("nutating-table-bc-45", ["LZ0R0FMAXM91"]),
}
UPRIGHT = {"haas": ["G90G53G0Z0"], "grblhal": ["G53G0Z0"]}  # they have no TCP


class Retracts(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = os.path.join(folder.name, "x.nc")

    def job(self, machine, strategy="Feed per move"):
        """A texture, an operation with another tool, one with the first tool again: three tool changes."""
        job, (texture,) = roof_job(strategy)
        texture.Machine, texture.PostGouging, texture.PostUnheld = machine, True, True
        second = host.append_controller(job)
        host.add_ball_end_controller(job, 2.0, 2, 600.0, 1000.0, controller=second)
        custom(job, CUT).ToolController = second
        custom(job, CUT)
        return job, texture

    def lines(self, job, control, arguments=ARGUMENTS):
        patchmill.post(job, self.program, "patchmill_" + control, arguments)
        return pathlib.Path(self.program).read_text(encoding="ascii").split("\n")

    def said(self, job, control, lines, arguments=ARGUMENTS):
        """What is said of a program of the job; None if it holds the job."""
        pathlib.Path(self.program).write_text("\n".join(lines), encoding="ascii")
        try:
            posting.read_back(job, self.program, "patchmill_" + control, arguments)
        except InputError as error:
            return error
        return None

    def require_each(self, job, control, machine, words):
        lines = self.lines(job, control)
        post = own_dialect("patchmill_" + control)
        self.assertEqual(post.retract_lines(ARGUMENTS, machines.load(machine)), words)
        self.assertEqual(post.retract_lines(ARGUMENTS, None), [])
        self.assertIsNone(self.said(job, control, lines))
        at = [k for k, line in enumerate(lines) if bare(line) in words]
        self.assertEqual(len(at), 4 * len(words), control)
        reasons = 3 * ["the tool is changed"] + ["the program ends"]
        for number, k in enumerate(at):
            error = self.said(job, control, lines[:k] + lines[k + 1 :])
            self.assertEqual((error.property, error.value), ("Program", "no " + " ".join(words)), control)
            self.assertIn(reasons[number // len(words)], error.remedy)

    def test_of_a_tilted_texture(self):
        for control, (machine, words) in TILTED.items():
            job, texture = self.job(machine)
            texture.FixedAxis = FreeCAD.Vector(0.25, 0.1, 1)
            self.require_each(job, control, machine, words)
            self.tearDown()

    def test_before_a_turn(self):
        """Of the same tool: an upright operation after a tilted one, and one that is tilted after it."""
        for control, (machine, words) in TILTED.items():
            job, (first, second) = roof_job("Feed per move", "Feed per move")
            for texture in (first, second):
                texture.Machine, texture.PostGouging, texture.PostUnheld = machine, True, True
                texture.FixedAxis = FreeCAD.Vector(0.25, 0.1, 1)
            upright = custom(job, CUT)
            job.Operations.Group = [first, upright, second]
            lines = self.lines(job, control)
            self.assertIsNone(self.said(job, control, lines))
            at = [k for k, line in enumerate(lines) if bare(line) in words]
            self.assertEqual(len(at), 4 * len(words), control)
            reasons = ["the tool is changed", "the table or head turns", "the table or head turns", "ends"]
            for number, k in enumerate(at):
                error = self.said(job, control, lines[:k] + lines[k + 1 :])
                self.assertEqual((error.property, error.value), ("Program", "no " + " ".join(words)))
                self.assertIn(reasons[number // len(words)], error.remedy)
            self.tearDown()

    def test_on_controls_without_tcp(self):
        with tempfile.TemporaryDirectory() as folder:
            with unittest.mock.patch.dict(os.environ, PATCHMILL_MACHINES=folder):
                data = machines.load("haas-mill").data
                for control, words in UPRIGHT.items():
                    controller = dict(data["controller"], dialect=control)
                    machines.save(control, dict(data, retract_mm={"Z": 0.0}, controller=controller))
                    job, texture = self.job(control, "Constant feed")
                    self.require_each(job, control, control, words)
                    self.tearDown()

    def test_one_after_which_the_tool_has_moved(self):
        job, _ = self.job("table-table-ac")
        lines = self.lines(job, "linuxcnc")
        k = lines.index("T2 M6")
        moved = [*lines[:k], "G0 X40.000 Y0.000", *lines[k:]]  # words of the operation behind
        self.assertIn("the tool is changed", self.said(job, "linuxcnc", moved).remedy)

    def test_words_of_the_user(self):
        """Whoever gives the first and last lines knows where the tool is."""
        job, _ = self.job("table-table-ac")
        arguments = ARGUMENTS + " --preamble='G90\\nT9 M6' --postamble='G0 Z100\\nM2'"
        self.assertIn("T9 M6", self.lines(job, "linuxcnc", arguments))

    def test_an_axis_that_an_operation_turns_by_itself(self):
        job, _ = self.job("table-table-ac")
        custom(job, ["G0 A0", *CUT])
        self.assertIn("G0 A0.000", self.lines(job, "linuxcnc"))

    def test_a_machine_that_does_not_say_where(self):
        job, texture = self.job("linuxcnc-mill")
        texture.Machine = "linuxcnc-mill"
        self.assertNotIn("G53", "\n".join(self.lines(job, "linuxcnc")))


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
