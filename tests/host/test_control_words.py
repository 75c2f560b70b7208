"""Every control's post in FreeCAD: words of other operations are in the program or refused by name, labels
are never commands, a machine's file and the post agree, and a decimal comma changes nothing.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib
import locale
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import add_profile, make_job, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError, posting  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.machine import schema  # noqa: E402
from recipe import small_job  # noqa: E402

CONTROLS = [control["name"] for control in core.controls()]
PLAIN = "--no-header --no-show-editor --precision=3"


def custom(job, *lines):
    """FreeCAD's Custom operation with these lines."""
    name = "Path.Op.Custom" if host.VERSION >= (0, 21) else "PathScripts.PathCustom"
    operation = importlib.import_module(name).Create("Custom", parentJob=job)
    operation.ToolController = host.tool_controllers(job)[0]
    operation.Gcode = list(lines)
    job.Document.recompute()
    return operation


class ControlWords(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def posted(self, job, post, arguments=PLAIN):
        name = os.path.join(self.folder, "x.nc")
        patchmill.post(job, name, post, arguments)
        return pathlib.Path(name).read_text(encoding="ascii")

    def refused(self, named, job, post, arguments=PLAIN):
        with self.assertRaises(InputError) as caught:
            self.posted(job, post, arguments)
        self.assertEqual(caught.exception.property, named, caught.exception)
        return str(caught.exception)

    def test_each_has_a_post_and_stands_in_machine_files(self):
        for name in CONTROLS:
            own = posting.own_dialect("patchmill_" + name)
            self.assertEqual(own.dialect, name)
            self.assertIn(name, schema.DIALECTS)
            self.assertIn(own.controller, own.tooltip)

    def test_words_of_other_operations(self):
        words = ("G53 G0 Z0", "G91 G0 Z5", "M19 R45", "M62 P3", "M66 P0 L3 Q5", "M68 E0 Q2.5", "M101 P1 Q2")
        for line in words + ("G43 H5", "G0 U5", "M2", "G20", "G38.2 Z1", "G1 X1 E5"):
            for name in CONTROLS:
                _, job = make_job(Part.makeBox(10, 10, 5))
                custom(job, "G0 X0 Y0", line, "G0 X3 Y3")
                try:
                    text = self.posted(job, "patchmill_" + name)
                except InputError as error:
                    self.assertIn(error.property, ("Custom", "PostProcessor"))
                    self.assertFalse(name == "linuxcnc" and line in words, error)
                else:
                    between = re.search(r"X\+?0\.000.*?X\+?3\.000", text, re.S).group(0)
                    for word in line.split():
                        self.assertIn(word.rstrip("0"), between.replace("+", ""), (name, line))
                self.doCleanups()
                self.setUp()

    def test_a_stock_post_that_loses_words_is_refused(self):
        for line, kept in (("G0 G53 Z0", False), ("G0 U5", False), ("G0 X5", True), ("M8", True)):
            _, job = make_job(Part.makeBox(10, 10, 5))
            custom(job, "G0 X0 Y0", line, "G0 X3 Y3")
            if kept:
                self.assertIn("X3.000", self.posted(job, "linuxcnc"))
            else:
                self.assertIn("Custom", self.refused("PostProcessor", job, "linuxcnc"))

    def test_arcs_of_a_profile_are_posted_with_its_feed(self):
        for name in CONTROLS:
            _, job = make_job(pocket_part())
            profile = add_profile(job)
            arcs = [c for c in profile.Path.Commands if c.Name in ("G2", "G3")]
            text = self.posted(job, "patchmill_" + name)
            read = core.program_lines(text, name)
            found = [dict(words) for _, words in read if ("G", 2.0) in words or ("G", 3.0) in words]
            self.assertEqual(len(found), len(arcs), name)
            sections = core.read_gcode(text, core.BallEndMill(1.0, 2), name, rotary=True)
            ends = [tuple(tip) for section in sections for tip in section.path.tips.round(3)]
            for arc in arcs:
                end = [round(arc.Parameters[letter], 3) for letter in "XY"]
                self.assertTrue(any(abs(e[0] - end[0]) + abs(e[1] - end[1]) < 3e-3 for e in ends))
            self.assertNotIn("K0", text)
            feeds = {w["F"] for w in found if "F" in w} or {600.0}
            self.assertEqual(feeds, {600.0}, name)  # HorizFeed is 10 mm/s

    def test_labels_are_never_commands(self):
        for name in CONTROLS:
            _, job = make_job(Part.makeBox(10, 10, 5))
            operation = custom(job, "G0 X1 Y1")
            plain = core.program_lines(self.posted(job, "patchmill_" + name), name)
            for label in ("x)\nG0 Z-5\n(", "x)\rM30\r(", "abort, %", "py, x", "x; M30", "ä" * 300):
                operation.Label = label
                job.Document.recompute()
                text = self.posted(job, "patchmill_" + name)
                self.assertEqual([w for _, w in core.program_lines(text, name)], [w for _, w in plain], label)
                self.assertLess(max(map(len, text.splitlines())), 256)

    def test_machine_and_post_agree(self):
        _, job, operation = small_job()
        operation.Machine, operation.PostUnheld, operation.PostGouging = "linuxcnc-mill", True, True
        self.refused("PostProcessor", job, "patchmill_fanuc") if self._names_its_control() else None
        operation.Machine = "head-table-bc"
        said = self.refused("PostProcessor", job, "patchmill_fanuc")
        self.assertIn("patchmill_siemens", said)
        self.assertTrue(self.posted(job, "patchmill_siemens"))
        operation.Decimals = 6
        self.refused("Decimals", job, "patchmill_siemens", PLAIN.replace("3", "6"))

    def test_arguments_with_a_quote_that_is_left_open(self):
        _, job, _ = small_job()
        for name in ["patchmill_" + control for control in CONTROLS] + ["linuxcnc"]:
            for end in (' "', " 'x", " \\"):
                self.refused("PostProcessorArgs", job, name, PLAIN + end)

    def test_a_preamble_by_which_all_else_would_be_read_otherwise(self):
        _, job, operation = small_job()
        operation.PostGouging = True
        for name in ("patchmill_linuxcnc", "linuxcnc"):
            for text in ("G91", "G20", "G90\\nG91", "G21 G18", "G93", "(G21) G20"):
                for argument in (" --preamble='%s'" % text, " --preamble '%s'" % text):
                    said = self.refused("PostProcessorArgs", job, name, PLAIN + argument)
                    self.assertIn("take it out of the preamble", said)
        ended = PLAIN + " --preamble='(G91)\\nG90 G21 (G20)'"
        self.assertTrue(self.posted(job, "patchmill_linuxcnc", ended))

    def test_arguments_in_quotes_are_what_is_between_them(self):
        _, job, operation = small_job()
        operation.PostGouging = True
        plain = self.posted(job, "patchmill_linuxcnc", "--no-header --precision=3")
        for quoted in ("--precision='3'", '--precision="3"', "'--precision=3'", "--precision\t3"):
            self.assertEqual(self.posted(job, "patchmill_linuxcnc", "--no-header " + quoted), plain)
        for wrong in ("--precision=3.0", "--precision=", "--precision=' 3 4'", "--pre cision=3", "-h"):
            self.refused("PostProcessorArgs", job, "patchmill_linuxcnc", "--no-header " + wrong)

    def _names_its_control(self):
        from patchmill.machine import machines

        return machines.load("linuxcnc-mill").controller["dialect"] != "freecad"

    def test_a_decimal_comma_changes_nothing(self):
        german = os.path.join(self.folder, "de_DE.UTF-8")
        made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", german], capture_output=True)
        if not os.path.isdir(german):
            self.skipTest("no locale with a decimal comma can be made here: %s" % made.stderr)
        _, job, operation = small_job()
        operation.PostGouging = True
        before = self.posted(job, "patchmill_linuxcnc")
        os.environ["LOCPATH"] = self.folder
        self.addCleanup(os.environ.pop, "LOCPATH")
        self.addCleanup(locale.setlocale, locale.LC_NUMERIC, "C")
        locale.setlocale(locale.LC_NUMERIC, "de_DE.UTF-8")
        self.assertEqual(locale.localeconv()["decimal_point"], ",")
        operation.touch()
        job.Document.recompute()
        for number in ("de_DE.UTF-8", "C", "de_DE.UTF-8"):  # also between two posts
            locale.setlocale(locale.LC_NUMERIC, number)
            self.assertEqual(self.posted(job, "patchmill_linuxcnc"), before)

    def test_more_decimals_make_the_phase_better(self):
        largest = []
        for decimals in (3, 4, 5, 6):
            _, job, operation = small_job(decimals, name="d%d" % decimals)
            operation.PostGouging = True
            name = os.path.join(self.folder, "x.ngc")
            arguments = "--no-header --precision=%d" % decimals
            (posted,) = patchmill.post(job, name, "patchmill_linuxcnc", arguments)
            largest.append(posted.errors["largest"])
            FreeCAD.closeDocument(job.Document.Name)
        self.assertLess(largest[3], 0.2 * largest[0])
        self.assertLess(max(largest[1:]), 2e-3)  # 0.12 degrees


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
