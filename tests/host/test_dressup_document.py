"""DressupDCM and its document: the model is kept beside it and made anew when it has to be; bad input is
named, and leaves the base operation as it was.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import add_profile, dress, make_job, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import DressupDCM, InputError  # noqa: E402
from recipe import small_job  # noqa: E402

V = FreeCAD.Vector


class Saved(WithDocuments):
    def test_made_anew_when_the_part_changes(self):
        document, job = make_job(pocket_part(), "changes")
        dressup = dress(add_profile(job), VoxelSize=0.5)
        DressupDCM.recompute(dressup)
        before = dressup.Proxy.model.grid.counts
        document.getObject("Part").Shape = Part.makeBox(50, 40, 15)
        document.recompute()
        DressupDCM.recompute(dressup)
        self.assertNotEqual(before, dressup.Proxy.model.grid.counts)

    def test_beside_the_document_and_made_anew(self):
        with tempfile.TemporaryDirectory() as folder:
            document, job = make_job(pocket_part(), "saved")
            dressup = dress(add_profile(job))
            DressupDCM.recompute(dressup)
            name = os.path.join(folder, "part.FCStd")
            document.saveAs(name)
            dressup.VoxelSize = 1.5
            DressupDCM.recompute(dressup)
            file = os.path.join(folder, "part-DressupDCM.voxels")
            self.assertTrue(os.path.exists(file))
            words = [c.toGCode() for c in dressup.Path.Commands if not c.Name.startswith("(")]
            document.save()
            FreeCAD.closeDocument(document.Name)
            del document, job, dressup

            document = FreeCAD.openDocument(name)
            dressup = document.getObject("DressupDCM")
            DressupDCM.recompute(dressup)
            self.assertTrue(dressup.Proxy.model.loaded)
            # the document keeps six decimals of the base's path
            names = [c.Name for c in dressup.Path.Commands if not c.Name.startswith("(")]
            self.assertEqual(names, [w.split()[0] for w in words])
            dressup.VoxelSize = 2.0
            DressupDCM.recompute(dressup)
            self.assertFalse(dressup.Proxy.model.loaded)

    def test_a_folder_that_cannot_be_written(self):
        with tempfile.TemporaryDirectory() as folder:
            document, job = make_job(pocket_part(), "blocked")
            dressup = dress(add_profile(job), VoxelSize=1.25)
            document.saveAs(os.path.join(folder, "part.FCStd"))
            os.mkdir(os.path.join(folder, "part-DressupDCM.voxels"))  # so that not even root can write it
            DressupDCM.recompute(dressup)
            self.assertGreater(dressup.Moves, 100)
            self.assertIn("part-DressupDCM.voxels", dressup.Proxy.model.not_saved)
            os.rmdir(os.path.join(folder, "part-DressupDCM.voxels"))
            DressupDCM.recompute(dressup)
            self.assertEqual(dressup.Proxy.model.not_saved, "")
            self.assertEqual(os.listdir(folder).count("part-DressupDCM.voxels"), 1)

    def test_a_model_in_use_is_kept_beside_a_document_saved_later(self):
        document, job = make_job(pocket_part(), "later")
        dressup = dress(add_profile(job), VoxelSize=1.75)
        DressupDCM.recompute(dressup)
        model = dressup.Proxy.model
        with tempfile.TemporaryDirectory() as folder:
            for name in ("one", "two"):
                document.saveAs(os.path.join(folder, name + ".FCStd"))
                dressup.FeedAtSkin = dressup.FeedAtSkin.Value + 1.0
                DressupDCM.recompute(dressup)
                self.assertIs(dressup.Proxy.model, model)  # not made anew for another feed
                self.assertTrue(os.path.exists(os.path.join(folder, name + "-DressupDCM.voxels")))


class Solids(WithDocuments):
    def test_solids_that_meet_count_as_one(self):
        a = Part.makeBox(10, 10, 10)
        for b in (Part.makeBox(10, 10, 15, V(5, 0, 0)), Part.makeBox(10, 10, 15, V(10, 0, 0))):
            counts = []
            for shape in (Part.makeCompound([a, b]), a.fuse(b)):
                document, job = make_job(shape, "solids")
                dressup = dress(add_profile(job), VoxelSize=0.5)
                DressupDCM.recompute(dressup)
                counts.append(dressup.Proxy.model.grid.counts)
            self.assertEqual(counts[0], counts[1])


class BadInput(WithDocuments):
    def setUp(self):
        self.document, self.job = make_job(pocket_part(), "bad")
        self.operation = add_profile(self.job)
        self.words = [c.toGCode() for c in self.operation.Path.Commands]

    def refused(self, name, dressup):
        with self.assertRaises(InputError) as caught:
            DressupDCM.recompute(dressup)
        self.assertEqual(caught.exception.property, name, caught.exception)
        self.assertTrue(caught.exception.remedy)
        self.assertEqual(len(dressup.Path.Commands), 0)  # nothing old is left to be posted
        self.assertEqual([c.toGCode() for c in self.operation.Path.Commands], self.words)
        print("refused:", caught.exception)

    def test_values(self):
        dressup = dress(self.operation)
        for name, bad in [
            ("VoxelSize", 0.0), ("FeedAtProduct", 0.0), ("MemoryLimit", 0.0), ("FeedInAir", 1.0),
            ("FeedTolerance", 0.0), ("Machine", "none such"), ("Deflection", 0.0),
        ]:  # fmt: skip
            good = getattr(dressup, name)
            setattr(dressup, name, bad)
            self.refused(name, dressup)
            setattr(dressup, name, good)
        dressup.Holder = ["10 20 30"]
        self.refused("Holder", dressup)
        dressup.Holder = []
        DressupDCM.recompute(dressup)

    def test_memory(self):
        dressup = dress(self.operation, VoxelSize=0.02)
        self.refused("VoxelSize", dressup)
        given = patchmill.dcm.input_of(dressup)
        self.assertGreater(patchmill.removal_model.estimate(given.model)["total"], 4 * 2**30)

    def test_part_outside_stock(self):
        self.job.Stock = self.document.addObject("Part::Box", "Small")
        self.document.recompute()
        dressup = dress(self.operation)
        self.words = [c.toGCode() for c in self.operation.Path.Commands]
        self.refused("Model", dressup)

    def test_nothing_to_remove(self):
        stock = self.document.addObject("Part::Feature", "Same")
        stock.Shape = self.job.Model.Group[0].Shape.copy()
        self.job.Stock = stock
        self.document.recompute()
        self.words = [c.toGCode() for c in self.operation.Path.Commands]
        self.refused("Stock", dress(self.operation))

    def test_open_shell(self):
        dressup = dress(self.operation)
        self.document.getObject("Part").Shape = Part.makeShell(pocket_part().Faces[1:])
        self.document.recompute()
        self.words = [c.toGCode() for c in self.operation.Path.Commands]
        self.refused("Model", dressup)

    def test_posture_needs_a_ball_and_rotary_axes(self):
        dressup = dress(self.operation, Controls="Posture")
        self.refused("ToolController", dressup)
        controller = patchmill.host.add_ball_end_controller(self.job, 6.0, 2, 400.0, 6000.0)
        self.operation.ToolController = controller
        self.document.recompute()
        self.words = [c.toGCode() for c in self.operation.Path.Commands]
        self.refused("Machine", dressup)
        dressup.Machine = "linuxcnc-mill"
        self.refused("Machine", dressup)

    def test_a_textures_feed_is_its_timing(self):
        document, job, texture = small_job()
        patchmill.recompute(texture)
        self.words = [c.toGCode() for c in self.operation.Path.Commands]
        dressup = dress(texture)
        self.refused("Base", dressup)
        dressup.Controls, dressup.Machine = "Posture", "table-table-ac"
        self.refused("Base", dressup)  # its axis sets the phase, too


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
