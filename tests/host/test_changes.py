"""What becomes of paths when something they were made from changes, fails, is switched off or is deleted: no
old path is left to be posted, and several documents do not mix.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile
import types
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import add_pocket, add_profile, dress, make_job, pocket_part  # noqa: E402
from parts import WithDocuments, job_on, tilted_box  # noqa: E402
from patchmill import CopyMilling, DressupDCM, InputError  # noqa: E402


def copy_milled(job):
    operation = CopyMilling.Create("Copy", parentJob=job)
    CopyMilling.recompute(operation)
    return operation


class Changes(WithDocuments):
    def setUp(self):
        self.document, self.job = make_job(pocket_part(), "changes", ball=True)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = os.path.join(folder.name, "program.ngc")

    def refused(self, name, function, *arguments):
        with self.assertRaises(InputError) as caught:
            function(*arguments)
        self.assertEqual(caught.exception.property, name, caught.exception)
        print("refused:", caught.exception)

    def cut_depths(self):
        with open(self.program, encoding="ascii") as file:
            lines = [line for line in file if line.startswith("G1")]
        return [float(word[1:]) for line in lines for word in line.split() if word[0] == "Z"]

    def test_rapids_stay_above_a_stock_that_grew(self):
        copy = copy_milled(self.job)
        _, texture = job_on(*tilted_box())
        patchmill.recompute(texture)
        for operation, job in ((copy, self.job), (texture, patchmill.host.jobs()[0])):
            job.Stock.ExtZpos = 30.0
            job.Document.recompute()
            self.assertEqual(operation.State, ["Up-to-date"])
            rapids = [c.Parameters["Z"] for c in operation.Path.Commands if c.Name == "G0"]
            self.assertGreater(min(rapids), job.Stock.Shape.BoundBox.ZMax)

    def test_follows_the_part(self):
        copy = copy_milled(self.job)
        dressup = dress(copy, VoxelSize=0.4)
        DressupDCM.recompute(dressup)
        self.document.getObject("Part").Shape = Part.makeBox(60, 40, 8)
        self.document.recompute()
        self.assertEqual(dressup.State, ["Up-to-date"])
        tops = [max(o.Proxy.path.tips[:, 2]) for o in (copy,)] + [dressup.Path.BoundBox.ZMax]
        self.assertLess(max(tops), 15.0)

    def test_a_face_that_is_gone_is_not_the_whole_part(self):
        model = self.job.Model.Group[0]
        last = "Face%d" % len(model.Shape.Faces)
        copy = CopyMilling.Create("Copy", parentJob=self.job)
        copy.Base = [(model, [last])]
        CopyMilling.recompute(copy)
        self.document.getObject("Part").Shape = Part.makeBox(60, 40, 20)
        self.document.recompute()
        self.assertEqual(copy.Path.Size, 0)
        for _ in range(2):
            self.refused("Base", CopyMilling.recompute, copy)
            self.assertEqual([name.lstrip("?") for name in copy.Base[0][1]], [last])  # FreeCAD 1.1 marks it
        self.refused("Base", patchmill.post, self.job, self.program)

    def test_a_stock_that_was_put_in_another_place(self):
        copy = copy_milled(self.job)
        self.job.Stock = self.document.addObject("Part::Box", "Other")
        self.job.Stock.Length, self.job.Stock.Width, self.job.Stock.Height = 60, 40, 50
        CopyMilling.recompute(copy)
        self.job.Stock.Height = 70
        self.document.recompute()
        self.assertGreater(min(c.Parameters["Z"] for c in copy.Path.Commands if c.Name == "G0"), 70.0)

    def test_nothing_old_is_left_on_an_operation_that_fails(self):
        copy = copy_milled(self.job)
        dressup = dress(copy)
        second = dress(dressup)
        DressupDCM.recompute(second)
        copy.RadialDepth = 0.0
        self.document.recompute()
        for path in (copy, dressup, second):
            self.assertEqual(path.Path.Size, 0)
        self.refused("RadialDepth", DressupDCM.recompute, second)
        self.refused("RadialDepth", patchmill.post, self.job, self.program)
        self.assertFalse(os.path.exists(self.program))
        copy.RadialDepth = 3.0
        self.document.recompute()
        self.assertGreater(second.Path.Size, 100)

    def test_nothing_old_is_posted_of_a_native_operation_that_fails(self):
        self.document, self.job = make_job(pocket_part(), "native")
        pocket = add_pocket(self.job)
        dressup = dress(pocket)
        DressupDCM.recompute(dressup)
        pocket.setExpression("StepDown", "none_such.Height")
        self.document.recompute()
        self.assertIn("Invalid", pocket.State)
        self.refused("Pocket", patchmill.post, self.job, self.program)
        self.refused("Base", DressupDCM.recompute, dressup)

    def test_what_was_changed_since_is_posted(self):
        copy = copy_milled(self.job)
        copy.RadialDepth = 4.0
        moves = copy.Moves
        patchmill.post(self.job, self.program)
        self.assertLess(copy.Moves, moves)
        self.assertEqual(len(self.cut_depths()), sum(copy.Proxy.path.kinds > 0))

    def test_an_inactive_operation_under_a_dressup_is_left_out(self):
        self.document, self.job = make_job(pocket_part(), "inactive")
        profile = add_profile(self.job)
        dressup = dress(profile)
        DressupDCM.recompute(dressup)
        add_pocket(self.job)
        profile.Active = False
        self.document.recompute()
        self.assertEqual(dressup.State, ["Up-to-date"])
        self.assertEqual([c.Name for c in dressup.Path.Commands], ["(inactive operation)"])
        patchmill.post(self.job, self.program)
        self.assertGreater(min(self.cut_depths()), 11.0)  # the pocket's, not the profile's
        self.refused("Active", DressupDCM.recompute, dressup)

    def test_a_dressup_whose_operation_is_gone(self):
        profile = copy_milled(self.job)
        dressup = dress(profile)
        DressupDCM.recompute(dressup)
        self.document.removeObject(profile.Name)
        self.document.recompute()
        self.assertEqual(dressup.Path.Size, 0)
        self.refused("Base", patchmill.post, self.job, self.program)

    def test_an_operation_is_dressed_once(self):
        copy = copy_milled(self.job)
        dressup = dress(copy)
        self.refused("Base", DressupDCM.Create, "DressupDCM", copy)
        self.refused("Base", DressupDCM.Create, "DressupDCM", None)
        self.assertEqual([o.Name for o in self.job.Operations.Group], [dressup.Name])

    def test_a_dressup_on_a_texture_is_not_posted(self):
        document, texture = job_on(*tilted_box())
        patchmill.recompute(texture)
        job = patchmill.host.jobs()[0]
        job.PostProcessor = "linuxcnc"
        other = document.addObject("Path::FeaturePython", "DressupOther")
        other.addProperty("App::PropertyLink", "Base")
        other.Proxy = types.SimpleNamespace(dumps=lambda: None)
        other.Base = texture
        job.Proxy.addOperation(other, texture, True)
        self.refused("DressupOther", patchmill.post, job, self.program)

    def test_what_is_missing_is_named(self):
        copy = copy_milled(self.job)
        copy.Active = False
        self.refused("Active", CopyMilling.recompute, copy)
        copy.Active = True
        stock, self.job.Stock = self.job.Stock, None
        self.refused("Stock", CopyMilling.recompute, copy)
        self.job.Stock = stock
        self.document.removeObject(self.job.Model.Group[0].Name)
        self.refused("Model", CopyMilling.recompute, copy)

    def test_a_post_processor_that_fails(self):
        copy_milled(self.job)
        self.refused("PostProcessor", patchmill.post, self.job, self.program, "none_such")
        self.assertFalse(os.path.exists(self.program))

    def test_two_documents_with_jobs_of_the_same_name(self):
        other, other_job = make_job(Part.makeBox(20, 20, 10), "second", ball=True)
        self.assertEqual(self.job.Name, other_job.Name)
        self.assertIs(FreeCAD.ActiveDocument, other)
        copy = copy_milled(self.job)
        dressup = dress(copy)
        self.assertEqual({copy.Document.Name, dressup.Document.Name}, {self.document.Name})
        self.assertEqual(self.job.Operations.Group, [dressup])
        self.assertEqual(other_job.Operations.Group, [])
        self.assertIs(FreeCAD.ActiveDocument, other)
        controller = patchmill.host.add_ball_end_controller(self.job, 4.0, 2, 300.0, 5000.0)
        self.assertIs(controller.Tool.Document, self.document)
        DressupDCM.recompute(dressup)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
