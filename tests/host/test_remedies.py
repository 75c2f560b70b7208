"""Refusals of a control name what it lacks, and a remedy by which the job is posted when it is followed:
words of operations of others, tool-centre-point control, strategies and machines of textures.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import patchmill  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from roof_job import custom, roof_job  # noqa: E402

CONTROLS = {control["name"]: control for control in core.controls()}
CUT = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X46 F10", "G0 Z30"]
TCP = {"linuxcnc": "M428", "fanuc": "G43.4 H1", "haas": "G234 H1", "siemens": "TRAORI", "heidenhain": "M128"}
TAKEN_OUT = (
    "G92 X0", "G52 X1", "G10 L2 P1 X0", "G10 L20 P1 X0", "G68 X0 Y0 R30", "G51 X2", "G16", "G15", "G41 D1",
    "G42 D1", "G43.1 Z5", "G43.4 H1", "G234 H1", "G31 Z5 F10", "G38.2 Z5 F10", "G65 P1", "G95", "G96 S100",
    "G20", "M30", "M2", "M97 P1", "M98 P1", "M99", "M428", "G64 P0.01", "G61.1", "M128", "M7", "M62 P1",
    "G84 X40 Y0 Z20 R25 F10", "G76 P1", "G33 Z20 K1", "G5.1 Q1", "G187 P1", "G54.2", "G40", "M48",
)  # fmt: skip


class Remedies(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = os.path.join(folder.name, "x.nc")

    def job(self, lines=CUT, strategy="Constant feed"):
        job, (texture,) = roof_job(strategy)
        texture.PostUnheld = True
        other = custom(job, lines)
        job.Operations.Group = [other, texture]
        job.Document.recompute()
        return job, texture, other

    def post(self, job, post):
        patchmill.post(job, self.program, post, "--no-header --precision=3")
        return pathlib.Path(self.program).read_text(encoding="ascii")

    def choose(self, texture, strategy):
        """The turns that roof_job() leaves out are for constant feed."""
        texture.Strategy = strategy
        if strategy == "Constant feed":
            texture.SameFlute, texture.ExtraTurns = True, 5.0

    def said(self, job, post):
        with self.assertRaises(InputError) as caught:
            self.post(job, post)
        return caught.exception

    def test_words_are_posted_or_taken_out(self):
        """Each is in the program, or the remedy, which is to take it out, works."""
        for control in CONTROLS:
            job, _, other = self.job()
            plain = self.post(job, "patchmill_" + control)
            refused = 0
            for word in TAKEN_OUT:
                other.Gcode = [*CUT[:4], word, *CUT[4:]]
                job.Document.recompute()
                try:
                    self.assertNotEqual(self.post(job, "patchmill_" + control), "")
                except InputError as said:
                    refused += 1
                    self.assertEqual(said.property, other.Label, (control, word, str(said)))
                    helps = "take it out", "take the word out", "leave it out", "the subprogram's lines"
                    self.assertTrue(any(text in said.remedy for text in helps), (control, word, str(said)))
            self.assertGreater(refused, 10, control)
            other.Gcode = CUT
            job.Document.recompute()
            self.assertEqual(self.post(job, "patchmill_" + control), plain)
            self.tearDown()

    def test_tcp_of_other_operations(self):
        """Posted in the words of the control, off where the texture begins; a control without it says so."""
        for control in CONTROLS:
            for on, off in (("G43.4 H1", "G49"), ("M428", "M429")):
                job, _, other = self.job([*CUT[:2], on, *CUT[2:], off])
                if control == "grblhal":
                    said = self.said(job, "patchmill_grblhal")
                    self.assertEqual(said.property, other.Label)
                    self.assertIn("no tool-centre-point control: take it out", said.remedy)
                else:
                    text = self.post(job, "patchmill_" + control)
                    self.assertEqual(text.count(TCP[control]), 1, control)
                self.tearDown()

    def test_tcp_that_a_stock_post_leaves_on(self):
        for on, end in (("G43.4 H1", ["G49", "G43 H1"]), ("M428", ["M429"])):
            job, _, other = self.job([*CUT[:2], on, *CUT[2:]])
            said = self.said(job, "linuxcnc")
            self.assertEqual((said.property, said.value), (other.Label, on.split()[0]))
            self.assertIn("end the operation by %s." % " and ".join(end), said.remedy)
            other.Gcode = [*other.Gcode, *end]
            job.Document.recompute()
            self.assertTrue(self.post(job, "linuxcnc"))
            self.tearDown()

    def test_words_of_builders_are_no_tcp(self):
        for control in ("linuxcnc", "fanuc", "siemens"):
            job, _, _ = self.job([*CUT[:2], "M128", *CUT[2:]])
            self.assertIn("M128", self.post(job, "patchmill_" + control))
            self.tearDown()

    def test_states_that_a_stock_post_leaves_on(self):
        """Or an end within the program, which would be the end of the texture's as well."""
        left = (("G91", "G90"), ("G93", "G94"), ("G18", "G17"))
        for word, end in left:
            job, texture, other = self.job([*CUT, word])
            said = self.said(job, "linuxcnc")
            self.assertEqual((said.property, said.value), (other.Label, word))
            self.assertIn("leaves it on for %s: end the operation by %s." % (texture.Label, end), said.remedy)
            other.Gcode = [*CUT, word, end]
            job.Document.recompute()
            self.assertTrue(self.post(job, "linuxcnc"))
            self.tearDown()
        for word in ("M30", "M2", "G20"):
            for post in ("linuxcnc", "patchmill_linuxcnc"):
                job, _, other = self.job([*CUT, word])
                said = self.said(job, post)
                self.assertEqual((said.property, said.value.strip("'")), (other.Label, word))
                self.assertIn("take it out", said.remedy)
                self.tearDown()

    def test_spindle_words_of_their_own_block(self):
        for control in CONTROLS:
            job, _, _ = self.job([*CUT, "M5", "M3 S1000"])
            self.assertTrue(self.post(job, "patchmill_" + control))
            self.tearDown()

    def test_axes_that_an_operation_leaves_turned(self):
        job, _, other = self.job([*CUT, "G0 A10"])
        self.assertIn("bring them back to zero", self.said(job, "patchmill_linuxcnc").remedy)
        other.Gcode = [*CUT, "G0 A10", "G0 A0"]
        job.Document.recompute()
        self.assertTrue(self.post(job, "patchmill_linuxcnc"))

    def test_strategies(self):
        cases = (
            ("grblhal", "Feed per move", "Constant feed", "use constant feed"),
            ("grblhal", "Spindle-locked", "Constant feed", "use constant feed"),
            ("haas", "Spindle-locked", "Feed per move", "use feed per move"),
            ("haas", "Spindle-locked", "Constant feed", "or constant feed"),
            ("heidenhain", "Spindle-locked", "Feed per move", "use feed per move"),
        )
        for control, strategy, other, remedy in cases:
            job, texture, _ = self.job(strategy=strategy)
            said = self.said(job, "patchmill_" + control)
            self.assertEqual(said.property, "Strategy")
            self.assertIn(remedy, said.remedy)
            self.choose(texture, other)
            self.assertTrue(self.post(job, "patchmill_" + control))
            self.tearDown()

    def test_a_lock_that_a_machine_has_not(self):
        for strategy in ("Feed per move", "Constant feed"):
            job, texture, _ = self.job(strategy="Spindle-locked")
            texture.Machine = "haas-mill"
            said = self.said(job, "patchmill_haas")
            self.assertEqual(said.property, "Strategy")
            self.assertIn(strategy.lower(), said.remedy)
            self.choose(texture, strategy)
            self.assertTrue(self.post(job, "patchmill_haas"))
            self.tearDown()

    def test_a_machine_of_another_control(self):
        job, texture, _ = self.job(strategy="Feed per move")
        texture.Machine, texture.FixedAxis = "table-table-ac", FreeCAD.Vector(0.25, 0.1, 1)
        for control in set(CONTROLS) - {"linuxcnc"}:
            said = self.said(job, "patchmill_" + control)
            self.assertEqual(said.property, "PostProcessor")
            self.assertIn("use patchmill_linuxcnc", said.remedy)
        self.assertTrue(self.post(job, "patchmill_linuxcnc"))

    def test_two_machines(self):
        job, (first, second) = roof_job("Feed per move", "Feed per move")
        second.Machine, second.FixedAxis = "table-table-ac", FreeCAD.Vector(0.25, 0.1, 1)
        for texture in (first, second):
            texture.PostUnheld = texture.PostGouging = True
        said = self.said(job, "patchmill_linuxcnc")
        self.assertEqual((said.property, said.value), ("Machine", "table-table-ac"))
        self.assertIn("choose the same", said.remedy)
        first.Machine = "table-table-ac"
        self.assertTrue(self.post(job, "patchmill_linuxcnc"))
        first.Machine = "linuxcnc-mill"
        for texture in (first, second):  # each in a job of its own
            job.Operations.Group = [texture]
            self.assertTrue(self.post(job, "patchmill_linuxcnc"))

    def test_a_group_among_the_operations(self):
        job, texture, other = self.job()
        group = job.Document.addObject("App::DocumentObjectGroup", "Group")
        job.Operations.Group = [group, texture, other]
        said = self.said(job, "patchmill_linuxcnc")
        self.assertEqual((said.property, said.value), (group.Label, group.TypeId))
        job.Operations.Group = [texture, other]
        self.assertTrue(self.post(job, "patchmill_linuxcnc"))

    def test_a_program_that_cannot_be_read(self):
        """FreeCAD's grbl writes 1e-06, which no control reads."""
        job, _, _ = self.job(strategy="Feed per move")
        said = self.said(job, "grbl")
        self.assertIn("1e-06", said.value)
        self.assertIn("use one of PatchMill's own posts", said.remedy)
        self.assertTrue(self.post(job, "patchmill_linuxcnc"))
        self.assertTrue(host.tool_controllers(job))


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
