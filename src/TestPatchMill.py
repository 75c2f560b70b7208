"""PatchMill's own tests inside FreeCAD, for whoever has installed it: `freecadcmd -t TestPatchMill`, or the
workbench Test. A part is milled from its face to the program that was read back.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import tempfile
import unittest

import FreeCAD
import Part


class Installation(unittest.TestCase):
    """What is there, and fits."""

    def test_the_core_is_loaded_and_of_this_version(self):
        from patchmill.install import core_loader

        self.assertEqual(core_loader.load(), "")

    def test_the_doctor_finds_nothing_wrong(self):
        from patchmill.install import doctor

        wrong = [finding.text() for finding in doctor.findings() if finding.state == doctor.WRONG]
        self.assertEqual(wrong, [])


class FaceToProgram(unittest.TestCase):
    """A texture on an inclined face, posted by FreeCAD and read back."""

    def setUp(self):
        self.document = FreeCAD.newDocument("TestPatchMill")
        box = Part.makeBox(12, 12, 5)
        box.rotate(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(0, 1, 0), 20.0)
        part = self.document.addObject("Part::Feature", "Part")
        part.Shape = box
        self.document.recompute()
        self.face = "Face%d" % (1 + max(range(6), key=lambda k: box.Faces[k].normalAt(0, 0).z))
        self.part = part

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def test_a_texture_is_planned_posted_and_read_back(self):
        import patchmill
        from patchmill.freecad import host

        job = host.create_job("Job", [self.part])
        job.PostProcessor, job.PostProcessorArgs = "linuxcnc", "--no-header --no-show-editor --precision=3"
        host.add_ball_end_controller(job, 2.0, 2, 600.0, 1000.0)
        operation = patchmill.CurvedTexture.Create("Texture", parentJob=job)
        operation.Base = [(job.Model.Group[0], [self.face])]
        operation.PatchSide = 6
        plan = patchmill.recompute(operation)
        self.assertGreater(plan.counts["cut"], 100)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "texture.ngc")
            patchmill.post(job, file)  # keeps only what holds the plan
            self.assertGreater(os.path.getsize(file), 1000)
