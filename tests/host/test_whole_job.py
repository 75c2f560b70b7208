"""What the operations of a job do to each other in a program: work offsets on every control, state that one
leaves to the next, coolant below modifiers, arrays and copies.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib
import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import numpy as np  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import dress, make_job  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import CopyMilling, InputError  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.verify.posted_program import offset_number  # noqa: E402
from roof_job import custom, roof_job  # noqa: E402

CONTROLS = [control["name"] for control in core.controls()]
V = FreeCAD.Vector
UPRIGHT = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X45 F10", "G0 Z30"]


def array_of(job, operation):
    """FreeCAD's array of two copies of an operation, 50 mm apart, in its place."""
    name = "Path.Op.Gui.Array" if host.VERSION >= (0, 21) else "PathScripts.PathArray"
    made = job.Document.addObject("Path::FeaturePython", "Array")
    importlib.import_module(name).ObjectArray(made)
    made.Base = [operation]
    made.Copies, made.Offset = 1, V(50, 0, 0)
    job.Proxy.addOperation(made, operation)
    job.Document.recompute()
    return made


class WholeJob(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = os.path.join(folder.name, "program.nc")

    def posted(self, job, control):
        """(what posting returned, sections of the program)."""
        posted = patchmill.post(job, self.program, "patchmill_" + control)
        text = pathlib.Path(self.program).read_text(encoding="ascii")
        return posted, core.read_gcode(text, core.BallEndMill(1.0, 2), control, rotary=True)

    def copy(self, **properties):
        """(job, operation): copy milling of a block with a slope."""
        wedge = Part.makeBox(30, 20, 20, V(-5, -5, 0))
        wedge.rotate(V(), V(0, 1, 0), -10)
        wedge.translate(V(0, 0, 6))
        _, job = make_job(Part.makeBox(20, 10, 10).cut(wedge), ball=True)
        operation = CopyMilling.Create("Copy", parentJob=job)
        operation.RadialDepth = operation.AxialDepth = 3.0
        for name, value in properties.items():
            setattr(operation, name, value)
        job.Document.recompute()
        return job, operation

    def test_the_offset_in_force_is_the_jobs_or_it_is_refused(self):
        job, _ = roof_job("Constant feed")
        refused = []
        for control in CONTROLS:
            for offsets in (["G54"], ["G55"], ["G57", "G54"], ["G58"], ["G59.1"]):
                job.Fixtures = offsets
                try:
                    posted, sections = self.posted(job, control)
                except InputError as error:
                    self.assertEqual(error.property, "Fixtures", error)
                    refused.append((control, offsets[-1]))
                    continue
                self.assertEqual([one.offset for one in posted], offsets)
                cutting = [s for s in sections if (s.path.kinds > 0).any()]
                said = [offset_number(s.offset or "G54") for s in cutting]
                order = [n for k, n in enumerate(said) if k == 0 or said[k - 1] != n]
                self.assertEqual(order, [offset_number(name) for name in offsets], (control, offsets))
        self.assertIn(("siemens", "G59.1"), refused)
        self.assertEqual({c for c, o in refused if o == "G58"}, {"heidenhain"})
        self.assertEqual({c for c, o in refused if o == "G54"}, {"heidenhain"})  # G57 before it

    def test_what_is_no_work_offset(self):
        job, _ = roof_job("Constant feed")
        for post in ["patchmill_" + control for control in CONTROLS] + ["linuxcnc"]:
            for names in ([], ["G53"], ["G59.9"], ["G505"], ["here"], [""], ["G54", "G53"], ["G54.1 P0"]):
                job.Fixtures = names
                with self.assertRaises(InputError) as caught:
                    patchmill.post(job, self.program, post)
                self.assertEqual(caught.exception.property, "Fixtures", (post, names))
                self.assertIn("choose", str(caught.exception))

    def test_an_upright_operation_finds_the_table_at_zero(self):
        machines = {
            "linuxcnc": "table-table-ac",
            "fanuc": "head-head-ca",
            "siemens": "head-table-bc",
            "heidenhain": "nutating-table-bc-45",
        }
        for control, machine in machines.items():
            job, (texture,) = roof_job("Feed per move")
            texture.Machine, texture.FixedAxis = machine, V(0.25, 0.1, 1)
            texture.PostGouging = True
            other = custom(job, UPRIGHT)
            posted, sections = self.posted(job, control)
            self.assertEqual([one.operation for one in posted], [texture, other])
            tips = np.vstack([s.path.tips for s in sections])
            angles = np.vstack([s.angles[1:] for s in sections])
            tcp = np.concatenate([s.tcp for s in sections])
            kinds = np.concatenate([s.path.kinds for s in sections])
            self.assertGreater(np.abs(angles).max(), 0.1)
            cut = np.flatnonzero((kinds > 0) & (np.abs(tips[:, 0] - 40.0) < 1e-9))[0]
            self.assertTrue((angles[cut:] == 0.0).all(), control)
            self.assertFalse(tcp[cut:].any(), control)
            self.tearDown()

    def test_freecads_own_fixture_operation(self):
        """It is refused by name with what to do instead, with a window and without; a switched off one is no
        matter."""
        name = "Path.Main.Gui.Fixture" if host.VERSION >= (0, 21) else "PathScripts.PathFixture"
        for offset in ("G54", "G55"):
            job, (texture,) = roof_job("Constant feed")
            fixture = job.Document.addObject("Path::FeaturePython", "Fixture")
            importlib.import_module(name).Fixture(fixture)
            fixture.Fixture, fixture.Active = offset, True
            job.Operations.Group = [fixture, texture]
            for headless in (True, False):
                if not headless:  # a path as it has it where there is a window
                    fixture.Proxy = 0
                    fixture.Path = host.Path.Path("%s\nG03.5" % offset)
                with self.assertRaises(InputError) as caught:
                    self.posted(job, "linuxcnc")
                self.assertEqual((caught.exception.property, caught.exception.value), (fixture.Label, offset))
                self.assertIn("choose it in the job's setup", caught.exception.remedy)
            fixture.Active = False
            self.assertEqual(len(self.posted(job, "linuxcnc")[0]), 1)
            job.Document.removeObject(fixture.Name)
            job.Fixtures = [offset]
            posted, sections = self.posted(job, "linuxcnc")
            self.assertEqual((len(posted), sections[-1].offset), (1, offset))
            self.tearDown()

    def test_coolant_below_two_modifiers(self):
        job, operation = self.copy(CoolantMode="Flood")
        first = dress(operation, VoxelSize=2.0)
        patchmill.recompute(first)
        second = dress(first, VoxelSize=2.0)
        patchmill.recompute(second)
        for control in CONTROLS:
            posted, _ = self.posted(job, control)
            self.assertEqual([one.operation for one in posted], [second])
            text = pathlib.Path(self.program).read_text(encoding="ascii")
            words = [w for _, line in core.program_lines(text, control) for w in line]
            on, off = words.index(("M", 8.0)), words.index(("M", 9.0))
            self.assertLess(on, words.index(("G", 1.0)))
            self.assertGreater(off, len(words) - 1 - words[::-1].index(("G", 1.0)))

    def test_an_array_of_a_texture_is_refused_by_name(self):
        job, (texture,) = roof_job("Constant feed")
        array = array_of(job, texture)
        with self.assertRaises(InputError) as caught:
            self.posted(job, "linuxcnc")
        self.assertEqual(caught.exception.property, array.Label)

    def test_an_array_of_copy_milling_is_read_back_and_not_stale(self):
        job, operation = self.copy()
        array = array_of(job, operation)
        counts = []
        for depth in (3.0, 2.0):
            operation.RadialDepth = depth
            posted, sections = self.posted(job, "linuxcnc")
            self.assertEqual({one.operation for one in posted}, {array, operation})
            posted = next(one for one in posted if one.operation is array)
            self.assertEqual(posted.unknown, "")
            tips = np.vstack([s.path.tips for s in sections])
            self.assertGreater(tips[:, 0].max(), 60.0)
            counts.append(posted.moves)
        self.assertGreater(counts[1], counts[0])

    def test_a_simple_copy_of_a_locked_texture_is_read_back(self):
        job, (texture,) = roof_job("Spindle-locked")
        copy = custom(job, [c.toGCode() for c in texture.Path.Commands])
        posted, _ = self.posted(job, "linuxcnc")
        self.assertEqual([one.operation for one in posted], [texture, copy])
        self.assertGreater(posted[1].moves, 50)
        from patchmill.verify import posted_job

        text = pathlib.Path(self.program).read_text(encoding="ascii")
        (objects,) = host.post_objects(job, "patchmill_linuxcnc")
        last = text.rindex(" K")
        spoilt = text[: last + 2] + "9" + text[last + 2 :]
        with self.assertRaises(InputError) as caught:
            posted_job.read_back(spoilt, objects, "linuxcnc", 0.0005)
        self.assertEqual(caught.exception.property, copy.Label)

    def test_links_and_plain_paths_are_read_back_or_named_if_left_out(self):
        job, (texture,) = roof_job("Spindle-locked")
        link = job.Document.addObject("App::Link", "Link")
        link.LinkedObject = texture
        job.Proxy.addOperation(link)
        posted, _ = self.posted(job, "linuxcnc")
        self.assertEqual([one.operation for one in posted], [texture, link])
        self.assertGreater(posted[1].moves, 50)
        for kind in ("Path::Feature", "Path::FeatureCompound"):
            other = job.Document.addObject(kind, "Other")
            other.Path = texture.Path
            if kind == "Path::FeatureCompound":
                other.Group = [texture]
            job.Proxy.addOperation(other)
            if host.VERSION >= (0, 21):  # FreeCAD posts it: it is looked at like any operation
                posted, _ = self.posted(job, "linuxcnc")
                self.assertEqual([one.operation for one in posted], [texture, link, other])
            else:
                with self.assertRaises(InputError) as caught:
                    self.posted(job, "linuxcnc")
                self.assertEqual(caught.exception.property, other.Label)
            job.Document.removeObject(other.Name)

    def test_a_program_of_another_editor_is_simulated(self):
        job, (texture,) = roof_job("Constant feed")
        self.posted(job, "linuxcnc")
        content = pathlib.Path(self.program).read_bytes()
        plain = patchmill.simulate(texture, program=self.program, step=0.1)
        for before, comment in ((b"\xef\xbb\xbf", "(Fräsen)\n".encode()), (b"", b"(Fr\xe4sen)\n")):
            pathlib.Path(self.program).write_bytes(before + comment + content)
            again = patchmill.simulate(texture, program=self.program, step=0.1)
            np.testing.assert_array_equal(np.array(again.heights), np.array(plain.heights))


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
