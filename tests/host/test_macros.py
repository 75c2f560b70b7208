"""Jobs and textures in one call each, and faces chosen by what they are.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import re
import shutil
import struct
import sys
import tempfile
import unittest
import zipfile
from unittest import mock

import FreeCAD
import Import
import Part
import patchmill
from patchmill.freecad import host
from patchmill.machine import machines
from patchmill.macros import jobs

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from parts import WithDocuments  # noqa: E402

V = FreeCAD.Vector
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
STEP = os.path.join(ROOT, "Resources", "recipes", "xu2016", "block.step")


class Faces(unittest.TestCase):
    """On a box of 10 x 20 x 30 mm, whose faces are known, and on a cylinder."""

    def setUp(self):
        self.box = Part.makeBox(10, 20, 30)

    def only(self, choice):
        names = patchmill.faces(self.box, choice)
        self.assertEqual(len(names), 1)
        return self.box.getElement(names[0])

    def test_by_words(self):
        self.assertEqual(len(patchmill.faces(self.box, "all")), 6)
        self.assertAlmostEqual(self.only("top").CenterOfMass.z, 30.0)
        self.assertAlmostEqual(self.only("largest").Area, 600.0)

    def test_of_equals_the_first(self):
        self.assertEqual(patchmill.faces(self.box, "largest"), ["Face1"])

    def test_by_normal_outward(self):
        self.assertAlmostEqual(self.only({"normal": [0, 0, -1]}).CenterOfMass.z, 0.0)
        self.assertEqual(len(patchmill.faces(self.box, {"normal": [1, 1, 0], "within": 50})), 2)
        moved = self.box.copy()
        moved.rotate(V(1, 2, 3), V(1, 0, 0), 90)
        self.assertEqual(
            patchmill.faces(moved, {"normal": [0, -1, 0]}),
            patchmill.faces(self.box, {"normal": [0, 0, 1]}),
        )

    def test_nearest(self):
        self.assertAlmostEqual(self.only({"nearest": [5, -3, 15]}).CenterOfMass.y, 0.0)

    def test_free_form(self):
        block = Part.read(STEP)
        (name,) = patchmill.faces(block, "largest free-form")
        self.assertIn(type(block.getElement(name).Surface).__name__, ("BSplineSurface", "BezierSurface"))

    def test_a_shape_has_no_colours_and_no_labels(self):
        for choice in ({"colour": "#ff0000"}, {"label": "Lid"}):
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.faces(self.box, choice)
            self.assertIn("give the object", str(caught.exception))

    def test_refused_by_name(self):
        for choice in (
            "Face7", "biggest", "largest free-form", [], ["Face0"], [1], None, 3, {}, {"normal": [0, 0, 0]},
            {"normal": [1, 2]}, {"normal": [0, 0, float("nan")]}, {"nearest": "abc"}, {"names": []},
            {"normal": [0, 0, 1], "within": 0}, {"normal": [0, 0, 1], "nearest": [0, 0, 0]},
        ):  # fmt: skip
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.faces(self.box, choice)
            self.assertEqual(caught.exception.property, "Faces", choice)


class ColoursAndLabels(WithDocuments):
    """On a STEP file of FreeCAD's with one colour for each of 90 faces, on two named boxes, and on a document
    with colours."""

    STEP = os.path.join(FreeCAD.getHomePath(), "Mod", "Idf", "Idflibs", "0603_SMD.stp")

    def setUp(self):
        super().setUp()
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def test_colours_of_a_step_file(self):
        part = jobs.read_part(self.STEP)
        orange = patchmill.faces(part, {"colour": "#e87108"})
        others = patchmill.faces(part, {"colour": "#ffffff"})
        self.assertEqual(len(set(orange + others)), len(orange) + len(others))
        with open(self.STEP, encoding="latin-1") as file:
            text = file.read()
        styled = set(re.findall(r"COLOUR_RGB\s*\(\s*'[^']*'\s*,\s*0\.909\d*,\s*0\.443", text))
        self.assertTrue(styled)  # the file itself says so
        job = patchmill.job(self.STEP)
        self.assertEqual(patchmill.faces(job.Model.Group[0], {"colour": "#E87108"}), orange)
        with self.assertRaises(patchmill.InputError) as caught:
            patchmill.faces(part, {"colour": "#123456"})
        self.assertIn("#e87108", str(caught.exception))

    def test_labels_of_a_step_file(self):
        document = FreeCAD.newDocument("two")
        boxes = [document.addObject("Part::Box", name) for name in ("Base", "Lid")]
        boxes[1].Placement.Base = V(0, 0, 20)
        document.recompute()
        filename = os.path.join(self.folder, "two.step")
        Import.export(boxes, filename)
        part = jobs.read_part(filename)
        self.assertEqual(len(part.Shape.Faces), 12)
        for label, low in (("Base", 0.0), ("Lid", 20.0)):
            names = patchmill.faces(part, {"label": label})
            self.assertEqual(len(names), 6)
            heights = {round(part.Shape.getElement(n).CenterOfMass.z, 6) for n in names}
            self.assertEqual(heights, {low, low + 5.0, low + 10.0})
        with self.assertRaises(patchmill.InputError) as caught:
            patchmill.faces(part, {"label": "Roof"})
        self.assertIn("Base", str(caught.exception))

    def test_a_label_in_a_document(self):
        document = FreeCAD.newDocument("labelled")
        box = document.addObject("Part::Box", "Box")
        document.recompute()
        face = document.addObject("Part::Feature", "Area")
        face.Label, face.Shape = "Texture here", box.Shape.Faces[3]
        job = patchmill.job(box)
        self.assertEqual(patchmill.faces(job.Model.Group[0], {"label": "Texture here"}), ["Face4"])

    def saved(self, colours):
        """A document as FreeCAD's window saves one: with the colours of the box's faces."""
        document = FreeCAD.newDocument("saved")
        document.addObject("Part::Box", "Box")
        document.recompute()
        filename = os.path.join(self.folder, "saved.FCStd")
        document.saveAs(filename)
        FreeCAD.closeDocument(document.Name)
        words = struct.pack("<I%dI" % len(colours), len(colours), *colours)
        with zipfile.ZipFile(filename, "a") as archive:
            archive.writestr(
                "GuiDocument.xml",
                "<Document><ViewProviderData><ViewProvider name='Box'><Properties>"
                "<Property name='DiffuseColor' type='App::PropertyColorList'><ColorList file='DiffuseColor'/>"
                "</Property></Properties></ViewProvider></ViewProviderData></Document>",
            )
            archive.writestr("DiffuseColor", words)
        return jobs.read_part(filename)

    def test_colours_that_a_window_saved(self):
        if FreeCAD.GuiUp:
            return
        part = self.saved([0xFF000000, 0x00FF0000, 0x0000FF00, 0xFF000000, 0x00FF0000, 0x00FF0000])
        self.assertEqual(patchmill.faces(part, {"colour": "#ff0000"}), ["Face1", "Face4"])
        self.assertEqual(patchmill.faces(part, {"colour": "#0000ff"}), ["Face3"])

    def test_colours_in_a_document_of_freecad_itself(self):
        if host.VERSION >= (1, 0):
            return
        name = os.path.join(FreeCAD.getHomePath(), "Mod", "Path", "Tools", "Shape", "ballend.fcstd")
        document = FreeCAD.openDocument(name)
        body = next(o for o in document.Objects if getattr(o, "Shape", None) and o.Shape.Faces)
        self.assertEqual(len(patchmill.faces(body, {"colour": "#cccccc"})), len(body.Shape.Faces))


class Jobs(WithDocuments):
    def test_from_a_file_to_a_program(self):
        job = patchmill.job(STEP, tool={"diameter": 2, "flutes": 2, "speed": 1000, "feed": 434.413})
        op = patchmill.texture(
            job, "largest free-form", PatchSide=4, PatchesX=2, PatchesY=2, Rotation=10
        )
        plan = patchmill.recompute(op)
        self.assertEqual(plan.counts["cut"], 64)
        with tempfile.TemporaryDirectory() as folder:
            posted = patchmill.post(job, os.path.join(folder, "x.ngc"))
        self.assertEqual(posted[0].path.statistics()["dimples"], 64)

    def test_a_program_is_checked_and_reported(self):
        job = patchmill.job(STEP)
        op = patchmill.texture(job, "largest free-form", PatchSide=4, PatchesX=2, PatchesY=2, Rotation=10)
        patchmill.recompute(op)
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "x.ngc")
            posted = patchmill.post(job, program)
            again = patchmill.read_back(job, program)
            self.assertEqual([o.operation for o in again], [o.operation for o in posted])
            self.assertEqual(again[0].errors["largest"], posted[0].errors["largest"])
            names = patchmill.report(again, program, os.path.join(folder, "said"))
            self.assertIn("report.html", [os.path.basename(n) for n in names])
            self.assertTrue(all(os.path.getsize(n) for n in names))
            self.changed_is_refused(job, program)

    def changed_is_refused(self, job, program):
        """One coordinate in another decimal place, and a file that is none."""
        with open(program) as file:
            lines = file.read().split("\n")
        number = next(k for k, line in enumerate(lines) if re.match(r"G1 .*X", line) and k > len(lines) // 2)
        x = re.search(r"X(-?[\d.]+)", lines[number])
        lines[number] = lines[number].replace(x.group(0), "X%.3f" % (float(x.group(1)) + 0.05))
        with open(program, "w") as file:
            file.write("\n".join(lines))
        with self.assertRaises(patchmill.InputError):
            patchmill.read_back(job, program)
        with self.assertRaises(patchmill.InputError) as caught:
            patchmill.read_back(job, program + ".none")
        self.assertEqual(caught.exception.property, "Program")

    def test_the_machine_goes_into_its_textures(self):
        job = patchmill.job(STEP, machine="linuxcnc-mill", offset="G55")
        op = patchmill.texture(job, "top")
        self.assertEqual((op.Machine, list(job.Fixtures)), ("linuxcnc-mill", ["G55"]))

    def test_the_post_is_that_of_the_machines_control(self):
        for machine, post in (
            ("linuxcnc-mill", "linuxcnc"),  # it says nothing of its control
            ("table-table-ac", "patchmill_linuxcnc"),
        ):
            self.assertEqual(patchmill.job(STEP, machine=machine).PostProcessor, post)
        data = dict(machines.load("table-table-ac").data, controller={"dialect": "grblhal"})
        with mock.patch.object(machines, "load", lambda name: machines.Machine("m", data)):
            self.assertEqual(patchmill.job(STEP, machine="m").PostProcessor, "patchmill_grblhal")

    def test_refused_by_name(self):
        for name, value in (
            ("tool", {"diameter": -1}), ("tool", {"flutes": 2.5}), ("tool", {"teeth": 2}),
            ("tool", {"speed": True}),
            ("machine", "no-such"), ("offset", "G53"), ("post", "no_such"),
        ):  # fmt: skip
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.job(STEP, **{name: value})
            self.assertEqual(caught.exception.property.lower(), name, value)
        for part in ("none.step", __file__):
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.job(part)
            self.assertEqual(caught.exception.property, "part")
        job = patchmill.job(STEP)
        for kind, properties, name in (
            ("Round", {}, "kind"), ("Curved", {"Spacinng": 1}, "Spacinng"),
            ("Curved", {"Spacing": "wide"}, "Spacing"),
            ("Curved", {"Strategy": "Magic"}, "Strategy"), ("Curved", {"Direction": 5}, "Direction"),
        ):  # fmt: skip
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.texture(job, "top", kind, **properties)
            self.assertEqual(caught.exception.property, name)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
