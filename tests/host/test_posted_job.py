"""A job of several operations and work offsets is read back whole: every copy of every operation, in order.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import re
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import patchmill  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.verify import checks, posted_job  # noqa: E402
from roof_job import custom, roof_job  # noqa: E402


class PostedJob(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = os.path.join(folder.name, "program.ngc")

    def job(self, *strategies):
        return roof_job(*strategies)

    def post(self, job, name="patchmill_linuxcnc"):
        """(text, what posting returned)."""
        posted = patchmill.post(job, self.program, name)
        with open(self.program) as file:
            return file.read(), posted

    def refused(self, name, function, *arguments):
        with self.assertRaises(InputError) as caught:
            function(*arguments)
        self.assertEqual(caught.exception.property, name, caught.exception)
        print("refused:", caught.exception)

    def read(self, job, lines, known=()):
        (objects,) = host.post_objects(job, "patchmill_linuxcnc")
        return posted_job.read_back("\n".join(lines) + "\n", objects, "linuxcnc", 0.0005, known)

    def test_two_textures_with_one_tool(self):
        locked, timed = "Spindle-locked", "Feed per move"
        for strategies in ((locked, locked), (timed, locked), ("Constant feed", timed)):
            job, textures = self.job(*strategies)
            _, posted = self.post(job)
            self.assertEqual([one.operation for one in posted], textures)
            for one in posted:
                self.assertEqual(one.match.found, one.operation.Proxy.planned.counts["cut"])
                self.assertTrue(one.match.complete)

    def test_beside_another_operation_of_the_tool(self):
        lines = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X45 F10", "G4 P0.5", "G1 X47", "G0 Z30"]
        for first in (True, False):
            job, (texture,) = self.job("Spindle-locked")
            other = custom(job, lines)
            if first:
                job.Operations.Group = [other, texture]
            text, posted = self.post(job)
            self.assertEqual([one.operation for one in posted], [texture, other])
            self.assertEqual(posted[1].moves, 4)
            changes = (("X45.0", "X45.1"), ("F600.000", "F700.000"), ("G1 X47", "G0 X47"))
            for old, new in changes:
                spoilt = text.replace(old, new)
                self.assertNotEqual(spoilt, text, old)
                self.refused(other.Label, self.read, job, spoilt.split("\n"))
            self.refused("Program", self.read, job, (text + "G1 X0 Y0 Z-1 F600\n").split("\n"))

    def test_arcs_cycles_and_words_of_other_operations(self):
        job, (texture,) = self.job("Constant feed")
        lines = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G2 X44 Y0 I2 J0 K0 F10", "G3 X44 Y0 Z19 I-2 J0 K0"]
        lines += ["G1 X46", "G0 Z30", "M62 P3", "G98", "G83 X50 Y5 Z18 R25 Q2 F5", "G80", "M101 P1 Q2"]
        other = custom(job, lines)
        for name in ("patchmill_linuxcnc", "patchmill_siemens", "patchmill_heidenhain", "linuxcnc"):
            if name in ("patchmill_siemens", "patchmill_heidenhain"):
                other.Gcode = [line for line in lines if line[0] != "M"]
            _, posted = self.post(job, name)
            self.assertEqual([one.operation for one in posted], [texture, other], name)
            self.assertGreater(posted[1].moves, 10)
            other.Gcode = lines
        text, _ = self.post(job)
        for old, new in (
            ("G2 X44", "G3 X44"),
            ("I2.000", "I2.020"),
            ("I-2.000", "I-2.020"),
            ("Q2.000 ", "Q3.000 "),
            ("R25.000", "R24.000"),
            ("M62 P3", "M62 P4"),
            ("M101", "M102"),
        ):
            spoilt = text.replace(old, new)
            self.assertNotEqual(spoilt, text, old)
            with self.assertRaises(InputError, msg=old) as caught:
                self.read(job, spoilt.split("\n"))
            print(old, "->", caught.exception)

    def test_every_offset_is_compared(self):
        job, (texture,) = self.job("Constant feed")
        job.Fixtures = ["G54", "G55"]
        text, posted = self.post(job)
        self.assertEqual([one.offset for one in posted], ["G54", "G55"])
        lines = text.split("\n")
        second = next(k for k, line in enumerate(lines) if "G55" in line)
        cuts = [k for k in range(second, len(lines)) if lines[k].startswith("G1")]
        middle = cuts[len(cuts) // 2]
        x = next(word for word in lines[middle].split() if word[0] == "X")
        moved = lines[middle].replace(x, "X%.3f" % (float(x[1:]) + 0.2))
        self.read(job, lines)
        faults = {
            "moved": lines[:middle] + [moved] + lines[middle + 1 :],
            "left out": lines[:middle] + lines[middle + 1 :],
            "cut off": lines[:middle],
            "another feed": lines[:middle] + [lines[middle].replace("F600", "F500")] + lines[middle + 1 :],
            "slower spindle": lines[: cuts[0]] + ["M3 S900"] + lines[cuts[0] :],
            "the first offset": [line.replace("G55", "G54") for line in lines],
        }
        for how, spoilt in faults.items():
            with self.assertRaises(InputError, msg=how) as caught:
                self.read(job, spoilt)
            print(how, "->", caught.exception)

    def test_what_no_program_can_be_made_of(self):
        job, (texture,) = self.job("Constant feed")
        job.PostProcessor = "linuxcnc"
        for arguments in ("--precision='3", "--precision=many", "--precision -1", "--precision"):
            self.refused("PostProcessorArgs", patchmill.post, job, self.program, None, arguments)
        self.refused("PostProcessor", patchmill.post, job, self.program, "os; import antigravity")
        job.Fixtures = []
        self.refused("Fixtures", patchmill.post, job, self.program)

    def test_going_down_nobody_knows_where(self):
        job, (texture,) = self.job("Constant feed")
        text, posted = self.post(job, "linuxcnc")
        self.assertTrue(posted[0].check.clear)
        line = next(line for line in text.split("\n") if line.startswith("G0") and "X" not in line)
        for low in (line.split("Z")[0] + "Z1.000", "G0 X0 Z-4.000"):
            spoilt = text.replace(line, low).split("\n")
            self.refused("Program", self.read, job, spoilt)
            said = [("X", 0.0), ("Z", 1.0), ("Z", -4.0)]  # as if the preamble had it
            (again,) = self.read(job, spoilt, said)
            self.assertLess(again.blind, 1.1)
            with self.assertRaises(InputError) as caught:
                checks.require_clear(texture, again.path, again.unplaced, blind=again.blind)
            self.assertIn("Unknown", str(caught.exception))

    def test_words_between_operations(self):
        job, (texture,) = self.job("Spindle-locked")
        other = custom(job, ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X46", "G0 Z30"])
        text, _ = self.post(job)
        lines = text.split("\n")
        self.read(job, lines)
        into = next(k for k, line in enumerate(lines) if "X40.000 Y0.000" in line)
        words = ("G0 Z-30.000", "G0 X41.000 Y0.000", "M8", "T5", "M3 S5000", "G55", "M0", "G43 H2")
        for word in words:
            self.refused("Program", self.read, job, lines[:into] + [word] + lines[into:])
        self.refused("Program", self.read, job, lines[: len(lines) - 1] + ["M3"])
        job.Operations.Group = [other, texture]
        lines = self.post(job)[0].split("\n")
        mode = next(k for k, line in enumerate(lines) if line.startswith("G64 P"))
        for line, name in (("G64", texture.Label), ("G61", texture.Label), ("G64 P0.5 Q0", "Program")):
            self.refused(name, self.read, job, lines[:mode] + [line] + lines[mode + 1 :])

    def test_an_f_is_exact_to_its_last_decimal(self):
        job, (texture,) = self.job("Constant feed")
        arc = "G2 X44 Y0 I2 J0 K0 F10"
        other = custom(job, ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", arc, "G1 X46 F7.654321"])
        text, _ = self.post(job)
        for label, old, new in (
            (texture.Label, "F600.000", "F600.001"),
            (other.Label, "Z20.000 F600.000", "Z20.000 F600.001"),
            (other.Label, "F459.259", "F459.260"),
        ):
            at = text.index(old)
            self.refused(label, self.read, job, (text[:at] + text[at:].replace(old, new, 1)).split("\n"))

    def test_the_spindle_of_the_text(self):
        job, _ = self.job("Constant feed")
        text, _ = self.post(job)
        (said,) = set(re.findall(r"S[0-9]+", text))
        for faster in (said[:-1] + "1", said + "0"):  # by one turn a minute, and ten times
            self.refused("SpindleSpeed", self.read, job, text.replace(said, faster).split("\n"))
        self.refused("SpindleSpeed", self.read, job, text.replace("M3", "M4").split("\n"))

    def test_words_before_the_first_move_of_an_operation(self):
        cut = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X46", "G0 Z30"]
        for words in (["M8"], ["M7", "M8"], ["M48"], ["G43 H5"], ["M62 P3"]):
            for first in (True, False):
                job, (texture,) = self.job("Spindle-locked")
                other = custom(job, words + cut)
                if first:
                    job.Operations.Group = [other, texture]
                text, _ = self.post(job)
                for word in words:
                    self.refused(other.Label, self.read, job, text.replace("\n%s\n" % word, "\n").split("\n"))

    def test_a_spindle_that_is_stopped_and_started_again(self):
        stop = ["M5", "M0", "M3"]
        for stops in ((stop, []), ([], stop)):
            cut = ["G0 Z30", "G0 X40 Y0", *stops[0], "G1 Z20 F10", *stops[1], "G1 X46 F10", "G0 Z30"]
            for name in ("patchmill_linuxcnc", "patchmill_fanuc", "patchmill_siemens"):
                job, (texture,) = self.job("Spindle-locked")
                other = custom(job, cut)
                text, posted = self.post(job, name)
                self.assertEqual([one.operation for one in posted], [texture, other])
            text, _ = self.post(job)
            at = text.rindex("S1000")
            with self.assertRaises(InputError):
                self.read(job, (text[:at] + "S900" + text[at + 5 :]).split("\n"))

    def test_the_tools_length_is_in_force(self):
        cut = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X46", "G0 Z30"]
        for left in ("G49", "G43 H5"):
            job, (texture,) = self.job("Spindle-locked")
            job.Operations.Group = [custom(job, cut + [left]), texture]
            lines = self.post(job)[0].split("\n")
            again = next(k for k in range(lines.index(left), len(lines)) if lines[k] == "G43 H1")
            self.refused(texture.Label, self.read, job, lines[:again] + lines[again + 1 :])
            job, (texture,) = self.job("Constant feed")
            job.Operations.Group = [custom(job, cut + [left]), texture]
            self.refused(texture.Label, self.post, job, "linuxcnc")

    def test_a_full_circle_by_its_centre_alone(self):
        for name in ("patchmill_linuxcnc", "patchmill_fanuc", "patchmill_siemens", "patchmill_heidenhain"):
            job, (texture,) = self.job("Constant feed")
            circle = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G2 I2 J0 F10", "G1 X46", "G0 Z30"]
            other = custom(job, circle)
            self.assertEqual([one.operation for one in self.post(job, name)[1]], [texture, other])

    def test_coolant_that_is_lost(self):
        job, (texture,) = self.job("Constant feed")
        texture.CoolantMode = "Flood"
        text, _ = self.post(job)
        self.refused("CoolantMode", self.read, job, text.replace("M8", "").split("\n"))


if __name__ == "__main__":
    unittest.main()
