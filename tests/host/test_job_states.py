"""States that a job's program must have where an operation is milled (tool-centre-point control, the tool and
its length, feeds), and what is drawn elsewhere than it is milled: found in the program, or refused by name
with a remedy that works when it is followed.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import add_profile, dress, make_job, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError, posting  # noqa: E402
from roof_job import custom, roof_job  # noqa: E402

V = FreeCAD.Vector
OWN, STOCK = "patchmill_linuxcnc", "linuxcnc"
CUT = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X46 F10", "G0 Z30"]
MACHINES = {
    "linuxcnc": "table-table-ac",
    "fanuc": "head-head-ca",
    "siemens": "head-table-bc",
    "heidenhain": "nutating-table-bc-45",
}
TCP_ON = {"linuxcnc": "M428", "fanuc": r"G43\.4 H1", "siemens": "TRAORI", "heidenhain": "M128"}
TCP_OFF = {"linuxcnc": "M429", "fanuc": "G49", "siemens": "TRAFOOF", "heidenhain": "M129"}


class WithProgram(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = os.path.join(folder.name, "x.nc")

    def post(self, job, post=OWN, decimals=3):
        """(text, what posting returned)."""
        arguments = "--no-header --no-show-editor --precision=%d" % decimals
        posted = patchmill.post(job, self.program, post, arguments)
        text = pathlib.Path(self.program).read_text(encoding="ascii")
        os.remove(self.program)
        return text, posted

    def refused(self, job, name, value, post=OWN, remedy=""):
        with self.assertRaises(InputError) as caught:
            self.post(job, post)
        self.assertEqual((caught.exception.property, caught.exception.value), (name, value))
        self.assertIn(remedy, caught.exception.remedy)
        self.assertFalse(os.path.exists(self.program))

    def spoilt(self, job, text, control, decimals=3):
        """What is said of a program of the job that was changed."""
        pathlib.Path(self.program).write_text(text, encoding="ascii")
        with self.assertRaises(InputError) as caught:
            posting.read_back(job, self.program, "patchmill_" + control, "--precision=%d" % decimals)
        return caught.exception


class TcpIsAsPlanned(WithProgram):
    def without(self, job, control, text, word, decimals=3):
        pattern = r"(?m)^(N?\d+ )?%s\n" % word
        self.assertRegex(text, pattern, control)
        return self.spoilt(job, re.sub(pattern, "", text), control, decimals)

    def test_under_a_modifier_that_tilts_the_tool(self):
        for control, machine in MACHINES.items():
            _, job = make_job(pocket_part(), ball=True)
            modifier = dress(add_profile(job), VoxelSize=2.0, Controls="Posture", Machine=machine)
            patchmill.recompute(modifier)
            text, (posted,) = self.post(job, "patchmill_" + control, 4)
            self.assertEqual(posted.unknown, "")
            said = self.without(job, control, text, TCP_ON[control], 4)
            self.assertEqual(said.property, modifier.Label)
            self.assertIn("TCP is off", said.value)
            said = self.without(job, control, text, TCP_OFF[control], 4)  # to the end of the program
            self.assertEqual((said.property, said.value), (modifier.Label, "TCP is on"))
            self.tearDown()

    def test_of_a_texture_and_of_what_is_upright_after_it(self):
        for control, machine in MACHINES.items():
            job, (texture,) = roof_job("Feed per move")
            texture.Machine, texture.FixedAxis = machine, V(0.25, 0.1, 1)
            texture.PostGouging = True
            other = custom(job, CUT)
            text, _ = self.post(job, "patchmill_" + control)
            said = self.without(job, control, text, TCP_ON[control])
            self.assertEqual(said.property, texture.Label)
            if control != "fanuc":  # whose G49 at the end ends it, too
                said = self.without(job, control, text, TCP_OFF[control])
                self.assertEqual(said.property, other.Label)
                self.assertIn("TCP is on", said.value)
            self.tearDown()


class ToolsAndFeeds(WithProgram):
    def job(self, lines, before=True):
        job, (texture,) = roof_job("Constant feed")
        other = custom(job, lines)
        if before:
            job.Operations.Group = [other, texture]
        job.Document.recompute()
        return job, texture, other

    def test_a_tool_and_its_length_that_are_not_called(self):
        job, texture, _ = self.job(CUT, before=False)
        text, _ = self.post(job)
        said = self.spoilt(job, text.replace("\nT1 M6\n", "\n"), "linuxcnc")
        self.assertEqual(said.property, "ToolNumber")
        said = self.spoilt(job, text.replace("\nG43 H1\n", "\n"), "linuxcnc")
        self.assertEqual((said.property, said.value), (texture.Label, "no G43 H1"))
        patchmill.post(job, self.program, OWN, "--no-header --no-tlo --precision=3")  # as it is asked for

    def test_a_spindle_that_is_turned_to_an_angle(self):
        job, _, other = self.job([*CUT, "M19 R45"])
        self.refused(job, other.Label, "M19", remedy="end this one by M3")
        other.Gcode = [*CUT, "M19 R45", "M3"]
        self.assertEqual(len(self.post(job)[1]), 2)

    def test_a_tools_number_that_is_changed(self):
        job, _, other = self.job([*CUT, "M61 Q5"])
        self.refused(job, other.Label, "M61 Q5", remedy="tool controllers")

    def test_axes_beside_x_y_z(self):
        job, _, other = self.job([*CUT, "G0 U5"])
        self.refused(job, other.Label, "U5", remedy="a job of its own")
        job.Operations.Group = [other]
        self.assertIn("G0 U5.000", self.post(job)[0])

    def test_a_feed_that_is_none(self):
        for post in (OWN, STOCK):
            for line in ("G1 X44 F0", "G1 X44 F-5", "G1 X44"):
                lines = ["G0 Z30", "G0 X40 Y0", line] if line == "G1 X44" else [*CUT[:4], line]
                job, _, other = self.job(lines)
                with self.assertRaises(InputError) as caught:
                    self.post(job, post)
                self.assertEqual(caught.exception.property, other.Label)
                self.assertIn("X44", caught.exception.value)
                self.assertIn("greater than zero", caught.exception.remedy)
                other.Gcode = [*CUT[:4], "G1 X44 F5"]
                self.assertEqual(len(self.post(job, post)[1]), 2)
                self.tearDown()

    def test_a_tool_controller_without_feeds(self):
        for post in (OWN, STOCK):
            _, job = make_job(pocket_part())
            profile = add_profile(job)
            controller = profile.ToolController
            for name in ("HorizFeed", "VertFeed"):
                before = getattr(controller, name)
                setattr(controller, name, 0.0)
                job.Document.recompute()
                with self.assertRaises(InputError) as caught:
                    self.post(job, post)
                self.assertIn(caught.exception.property, (name, profile.Label))
                self.assertIn(controller.Label, caught.exception.remedy)
                setattr(controller, name, before)
                job.Document.recompute()
                self.assertEqual(len(self.post(job, post)[1]), 1)
            self.tearDown()

    def test_a_tool_controller_of_number_zero(self):
        job, (texture,) = roof_job("Constant feed")
        texture.ToolController.ToolNumber = 0
        self.refused(job, "ToolNumber", "0", remedy=texture.ToolController.Label)
        texture.ToolController.ToolNumber = 3
        self.assertIn("\nT3 M6\n", self.post(job)[0])


class ApproachIsAsPlanned(WithProgram):
    def test_rapids_that_end_elsewhere_before_a_cut_that_names_its_end(self):
        """Each word is one that may stand there, and the first cut ends where it should: it would slant."""
        job, (texture,) = roof_job("Constant feed")
        lines = ["G0 Z30", "G0 X46 Y0", "G0 X40 Y0", "G1 X40 Y0 Z20 F10", "G1 X46 F10", "G0 Z30"]
        other = custom(job, lines)
        for control in ("linuxcnc", "fanuc"):
            text, _ = self.post(job, "patchmill_" + control)
            at = text.rindex("X40.000 Y0.000\n" if control == "linuxcnc" else "X40.000\n")
            changed = text[:at] + text[at:].replace("X40.000", "X46.000", 1)
            said = self.spoilt(job, changed, control)
            self.assertEqual(said.property, other.Label)

    def test_of_a_texture(self):
        job, (texture,) = roof_job("Constant feed")
        text, _ = self.post(job)
        across = next(line for line in text.splitlines() if re.match(r"G0 X-.* Z", line))
        x = re.search(r"X\S+", across).group()
        elsewhere = re.findall(r"G1 (X\S+)", text)[-1]  # a word of the texture
        self.assertNotEqual(x, elsewhere)
        first = text.index("\nG1 ")
        said = self.spoilt(job, text[:first].replace(x, elsewhere) + text[first:], "linuxcnc")
        self.assertEqual(said.property, texture.Label)
        self.assertIn("begins at", said.value)


class DrawnElsewhere(WithProgram):
    def test_an_operation_or_a_link_that_was_moved(self):
        for post in (OWN, STOCK):
            job, (texture,) = roof_job("Constant feed")
            other = custom(job, CUT)
            link = job.Document.addObject("App::Link", "Link")
            link.LinkedObject = texture
            job.Proxy.addOperation(link)
            for moved in (texture, other, link):
                for placement in (
                    FreeCAD.Placement(V(30, 0, 0), FreeCAD.Rotation()),
                    FreeCAD.Placement(V(), FreeCAD.Rotation(V(0, 0, 1), 90)),
                ):
                    moved.Placement = placement
                    said = "X%g Y0 Z0" % placement.Base.x
                    self.refused(job, "Placement", said, post, remedy=moved.Label)
                moved.Placement = FreeCAD.Placement()
            self.assertEqual(len(self.post(job, post)[1]), 3)
            self.tearDown()


class WordsThatAControlWritesOtherwise(WithProgram):
    def posted(self, lines, controls):
        for control in controls:
            job, (texture,) = roof_job("Constant feed")
            other = custom(job, lines)
            _, posted = self.post(job, control)
            self.assertEqual([one.operation for one in posted], [texture, other], control)
            self.assertEqual(posted[1].unknown, "")
            self.tearDown()

    def test_a_cycle_on_the_line_of_its_return(self):
        """Siemens and Heidenhain get the moves of the cycle."""
        lines = [*CUT[:4], "G0 Z30", "G98 G83 X41 Y1 Z18 R25 Q2 F5", "G80", "G0 Z30"]
        self.posted(lines, ["patchmill_" + name for name in ("siemens", "heidenhain", "fanuc", "linuxcnc")])

    def test_arcs_that_are_shorter_than_the_last_decimal(self):
        for arc in ("G2 X46 Y0.0001 I1 J0 F5", "G2 X46.0004 Y0.0004 I0.0002 J0.0002 F5"):
            self.posted([*CUT[:4], arc, "G1 X48", "G0 Z30"], ["patchmill_heidenhain", OWN])

    def test_an_arc_that_is_none_is_named_with_its_operation(self):
        job, (texture,) = roof_job("Constant feed")
        other = custom(job, [*CUT[:4], "G2 X56 Y0 I2 J0 F5", "G0 Z30"])
        with self.assertRaises(InputError) as caught:
            self.post(job)
        self.assertEqual(caught.exception.property, other.Label)
        self.assertIn("not equally far", caught.exception.remedy)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
