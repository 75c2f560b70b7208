"""FreeCAD's own dressups on operations and modifiers of ours: they find tool controller and state there, and
what they make is posted and read back.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib
import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import patchmill  # noqa: E402
from milling_jobs import add_profile, dress, make_job, pocket_part  # noqa: E402
from parts import WithDocuments, saved_and_reopened  # noqa: E402
from patchmill.freecad import host  # noqa: E402


def native_dressup(name, base):
    """FreeCAD's dressup of that name in the place of `base` in its job."""
    folder = ("Path.Dressup.Gui.%s" if host.VERSION >= (0, 21) else "PathScripts.PathDressup%s") % name
    job = host.PathUtils.findParentJob(base)
    made = base.Document.addObject("Path::FeaturePython", "Dressup" + name)
    importlib.import_module(folder).ObjectDressup(made)
    made.Base = base
    job.Proxy.addOperation(made, base, True)
    made.Proxy.setup(made)
    base.Document.recompute()
    return made


@unittest.skipIf(host.VERSION >= (0, 21), "FreeCAD 1.x makes its dressups with a window only")
class NativeDressups(WithDocuments):
    def modifier(self):
        """(job, a modifier on a profile)."""
        _, job = make_job(pocket_part())
        modifier = dress(add_profile(job), VoxelSize=2.0)
        patchmill.recompute(modifier)
        return job, modifier

    def test_that_asks_for_the_state(self):
        job, modifier = self.modifier()
        dressup = native_dressup("RampEntry", modifier)
        self.assertNotIn("Invalid", dressup.State)
        self.assertGreater(dressup.Path.Size, 0.5 * modifier.Path.Size)
        with tempfile.TemporaryDirectory() as folder:
            (posted,) = patchmill.post(job, os.path.join(folder, "x.ngc"), "patchmill_linuxcnc", "")
        self.assertEqual((posted.operation, posted.unknown), (dressup, ""))
        self.assertGreater(posted.moves, 10)

    def test_that_asks_for_the_tool_controller(self):
        """FreeCAD's code for leads then fails on layers of a single cut: what it asks for is there."""
        job, modifier = self.modifier()
        dressup = native_dressup("LeadInOut", modifier)
        self.assertEqual(dressup.Length, 0.75 * modifier.ToolController.Tool.Diameter)

    def test_switched_off_from_above_and_from_below(self):
        _, job = make_job(pocket_part())
        profile = add_profile(job)
        modifier = dress(profile, VoxelSize=2.0)
        patchmill.recompute(modifier)
        self.assertEqual(modifier.ToolController, profile.ToolController)
        size = modifier.Path.Size
        for switch in (modifier, profile):
            switch.Active = False
            self.assertFalse(host.is_active(modifier))
            job.Document.recompute()
            self.assertEqual((profile.Active, modifier.Active), (False, False))
            self.assertLess(modifier.Path.Size, 2)
            switch.Active = True
            job.Document.recompute()
            self.assertEqual((profile.Active, modifier.Active), (True, True))
            self.assertEqual(modifier.Path.Size, size)

    def test_in_a_saved_document(self):
        document, job = make_job(pocket_part())
        modifier = dress(add_profile(job), VoxelSize=2.0)
        patchmill.recompute(modifier)
        modifier.Active = False
        document.recompute()
        with tempfile.TemporaryDirectory() as folder:
            document, job = saved_and_reopened(document, os.path.join(folder, "part.FCStd"))
            (modifier,) = job.Operations.Group
            self.assertFalse(modifier.Active)
            self.assertFalse(modifier.Base.Active)
            self.assertEqual(modifier.ToolController, modifier.Base.ToolController)

    def test_in_a_document_of_an_older_version(self):
        _, job = make_job(pocket_part())
        profile = add_profile(job)
        modifier = dress(profile, VoxelSize=2.0)
        for name in ("Active", "ToolController", "CycleTime"):
            modifier.removeProperty(name)
        modifier.Proxy.onDocumentRestored(modifier)
        self.assertEqual((profile.Active, modifier.Active), (True, True))
        self.assertEqual(modifier.ToolController, profile.ToolController)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
