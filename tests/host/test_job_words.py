"""Words in operations of others that belong to the job or to a tool controller, lines that FreeCAD would
misread, and what an operation leaves to the next one: refused by the operation's name with a remedy that
works when it is followed, or undone.

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
import patchmill  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from roof_job import custom, roof_job  # noqa: E402

OWN, STOCK = "patchmill_linuxcnc", "linuxcnc"
CONTROLS = [control["name"] for control in core.controls()]


def cut(number=0, *words):
    """A cut beside the textures, with words after its first `number` lines."""
    lines = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X46 F10", "G0 Z30"]
    return lines[:number] + list(words) + lines[number:]


class JobWords(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = os.path.join(folder.name, "x.nc")

    def job(self, lines, before=True):
        """(job, texture, Custom operation of the lines before or after it)."""
        job, (texture,) = roof_job("Constant feed")
        texture.SameFlute, texture.ExtraTurns = True, 5.0
        other = custom(job, lines)
        if before:
            job.Operations.Group = [other, texture]
        return job, texture, other

    def post(self, job, post=OWN):
        """The text of a program, without its comments' lines."""
        patchmill.post(job, self.program, post, "--no-header --no-show-editor --precision=3")
        text = pathlib.Path(self.program).read_text(encoding="ascii")
        os.remove(self.program)
        return text.splitlines()

    def refused(self, job, other, value, remedy, post=OWN):
        with self.assertRaises(InputError) as caught:
            self.post(job, post)
        said = caught.exception
        self.assertEqual((said.property, said.value), (other.Label, value), said)
        self.assertIn(remedy, said.remedy)
        self.assertFalse(os.path.exists(self.program))
        return said

    def followed(self, job, other, lines, post=OWN):
        """What the remedy says, done."""
        other.Gcode = lines
        job.Document.recompute()
        self.assertTrue(self.post(job, post))

    def test_work_offsets_are_the_jobs(self):
        for post in (OWN, STOCK):
            for lines in (cut(1, "G55"), cut(5, "G55"), ["G55", *cut(), "G54"], cut(0, "G0 G55 Z31")):
                job, _, other = self.job(lines)
                self.refused(job, other, "G55", "choose it in the job's setup", post)
                job.Fixtures = ["G55"]
                self.followed(job, other, cut(), post)
                self.tearDown()
        job, _, other = self.job(cut(0, "G54"))
        self.assertTrue(self.post(job))  # it is in force anyway

    def test_the_spindle_is_the_tool_controllers(self):
        for post in (OWN, STOCK):
            for lines in (cut(3, "S500"), cut(0, "M3 S500")):
                job, _, other = self.job(lines)
                self.refused(job, other, "S500", "a tool controller of 500 rpm", post)
                slower = host.append_controller(job)
                host.add_ball_end_controller(job, 2.0, 2, 600.0, 500.0, controller=slower)
                other.ToolController = slower
                self.followed(job, other, cut(), post)
                self.tearDown()

    def test_a_spindle_that_is_left_otherwise(self):
        for word in ("M4", "M5"):
            job, _, other = self.job(cut(5, word))
            self.refused(job, other, word, "end this one by M3")
            self.followed(job, other, cut(5, word, "M3"))
            self.tearDown()
            job, _, _ = self.job(cut(5, word), before=False)
            self.assertTrue(self.post(job))  # nothing comes after it
            job.Fixtures = ["G54", "G55"]  # now the texture does
            with self.assertRaises(InputError):
                self.post(job)
            self.tearDown()

    def test_tools_are_changed_by_tool_controllers(self):
        for lines in (cut(1, "M6 T2"), cut(1, "T2 M6")):
            job, _, other = self.job(lines)
            self.refused(job, other, "M6 T2", "give the operation that of the tool")
            second = host.append_controller(job)
            host.add_ball_end_controller(job, 2.0, 2, 600.0, 1000.0, controller=second)
            other.ToolController = second
            self.followed(job, other, cut())
            self.tearDown()

    def test_coolant_that_is_left_on_is_switched_off(self):
        for control in CONTROLS:
            job, texture, _ = self.job(cut(1, "M8"))
            text = self.post(job, "patchmill_" + control)
            words = [word for _, line in core.program_lines("\n".join(text) + "\n", control) for word in line]
            on, off = words.index(("M", 8.0)), words.index(("M", 9.0))
            self.assertLess(on, off, control)
            self.assertLess(max(k for k, w in enumerate(words) if w == ("X", 46.0)), off)
            self.tearDown()
        job, texture, _ = self.job(cut(1, "M8"))
        text = self.post(job)
        off = text.index("M9")
        from patchmill.verify import posted_job

        (objects,) = host.post_objects(job, OWN)
        with self.assertRaises(InputError) as caught:
            posted_job.read_back("\n".join(text[:off] + text[off + 1 :]) + "\n", objects, "linuxcnc", 0.0005)
        self.assertEqual(caught.exception.property, "CoolantMode")

    def test_coolant_for_what_comes_after(self):
        job, texture, other = self.job(["M8"])
        self.refused(job, other, "M8", "Flood")
        texture.CoolantMode = "Flood"
        self.followed(job, other, ["G4 P0.5"])
        self.tearDown()
        job, _, other = self.job(cut(1, "M7"))
        self.refused(job, other, "M7", "end the operation by M9", STOCK)
        self.followed(job, other, cut(1, "M7") + ["M9"], STOCK)

    def test_different_tools_have_different_numbers(self):
        for post in (OWN, STOCK):
            job, texture, other = self.job(cut())
            second = host.append_controller(job)
            host.add_ball_end_controller(job, 4.0, 2, 600.0, 800.0, controller=second)
            second.ToolNumber, other.ToolController = texture.ToolController.ToolNumber, second
            with self.assertRaises(InputError) as caught:
                self.post(job, post)
            self.assertEqual(caught.exception.property, "ToolNumber")
            self.assertIn(second.Label, caught.exception.remedy)
            second.Tool.Diameter = texture.ToolController.Tool.Diameter  # one tool, two speeds
            self.assertTrue(self.post(job, post))
            second.Tool.Diameter, second.ToolNumber = 4.0, 7
            self.assertTrue(self.post(job, post))
            self.tearDown()

    def test_a_speed_that_a_stock_post_rounds(self):
        job, _, other = self.job(cut())
        second = host.append_controller(job)
        host.add_ball_end_controller(job, 4.0, 2, 600.0, 800.4, controller=second)
        second.ToolNumber, other.ToolController = 7, second
        for post in (OWN, STOCK):
            self.assertTrue(self.post(job, post))

    def test_coolant_that_an_operation_says_itself(self):
        for words in (["M8"], ["M9"], ["M9", "M7"]):
            job, _, other = self.job(cut(2, *words))
            other.CoolantMode = "Flood"
            job.Document.recompute()
            self.assertTrue(self.post(job))
            self.tearDown()

    def test_labels_that_a_stock_post_would_not_keep_in_a_comment(self):
        for label in ("a)b(c", "a" * 300, "a\nM30", "a\x1aM30", "(msg,hi)"):
            job, texture, other = self.job(cut())
            for named in (texture, other, texture.ToolController):
                plain, named.Label = named.Label, label
                with self.assertRaises(InputError) as caught:
                    self.post(job, STOCK)
                said = caught.exception
                self.assertEqual((said.property, said.value), ("Label", repr(named.Label)))
                self.assertTrue(self.post(job, OWN))
                named.Label = plain
            self.assertTrue(self.post(job, STOCK))
            self.tearDown()

    def test_arguments_that_a_post_does_not_take(self):
        job, _, _ = self.job(cut())
        for post in (OWN, STOCK):
            for arguments in ("extra", "--bogus=1", "--precision", "--preamble", "--preamble='\u00e4'"):
                with self.assertRaises(InputError) as caught:
                    patchmill.post(job, self.program, post, "--precision=3 " + arguments)
                self.assertIn(arguments.split("=")[0].lstrip("-"), str(caught.exception))
                if post == OWN:
                    self.assertEqual(caught.exception.property, "PostProcessorArgs", arguments)

    def test_an_offset_that_stands_twice(self):
        job, _, _ = self.job(cut())
        for offsets in (["G54", "G54"], ["G55", "G54", "g55"]):
            job.Fixtures = offsets
            with self.assertRaises(InputError) as caught:
                self.post(job)
            self.assertEqual(caught.exception.property, "Fixtures")

    def test_lines_that_freecad_misreads(self):
        for line in (
            "G1 X#1", "G1 X[1+2]", "G1 X1,5", "/G0 Z35", "O100 call", "#1=5", "%", "G1 Xnan", "G1 X1 (in) Y2",
            "G1 X1 ; c", "G1 X5 X6", "(a) G1 X1", "G1 X=5", "M98 P<sub>", "(a (b) c)", "G1 X--5",
        ):  # fmt: skip
            job, _, other = self.job(cut(3, line))
            self.refused(job, other, line, "a letter and a number")
            self.followed(job, other, cut(3, "G1 X44 F10"))
            self.tearDown()

    def test_lines_that_are_read_as_they_stand(self):
        for lines in (
            [line.lower() for line in cut()],
            cut(3, "G90 G1 X44"), cut(3, "N10 G1 X44 F10"), cut(3, "G1X44Y-.5F10"), cut(3, "  G1 X +44 "),
            cut(3, "(a comment; with, words)"), cut(3, "M8 M7"), cut(2, "G98 G81 Z20 R25 F10", "G80"),
            cut(2, "G17 G90 G21"), cut(0, "G00 G90 Z31"),
        ):  # fmt: skip
            for before in (True, False):
                job, texture, other = self.job(lines, before)
                posted = patchmill.post(job, self.program, OWN, "--no-header --precision=3")
                self.assertEqual({one.operation for one in posted}, {texture, other}, lines)
                self.assertEqual([getattr(one, "unknown", "") for one in posted], ["", ""])
                self.tearDown()

    def test_a_word_that_a_control_has_not_is_refused_by_the_operations_name(self):
        words = {
            "linuxcnc": ("G92 X0", "G52 X1", "G10 L2 P1 X0", "G68 X0 Y0 R30", "G51 X2", "G16", "G43.1 Z5",
                         "M98 P1", "G95"),
            "haas": ("M7", "G10 L2 P1 X0", "M98 P1", "G51 X2"),
            "siemens": ("G92 X0", "G68 R30", "M98 P1"),
        }  # fmt: skip
        for control, refused in words.items():
            for word in refused:
                job, _, other = self.job(cut(1, word))
                with self.assertRaises(InputError) as caught:
                    self.post(job, "patchmill_" + control)
                self.assertEqual(caught.exception.property, other.Label, (control, word))
                self.assertIn("cannot be posted for", caught.exception.remedy)
                self.tearDown()


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
