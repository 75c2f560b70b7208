"""Documents and scripts of the version before modules lay in folders: they open, recompute, can be edited,
are saved and opened again; what is saved now names modules as that version does.
old_documents/before_folders.FCStd was saved by it, with its GUI, in FreeCAD 0.20; later FreeCADs find its
job, tools and stock by patchmill.freecad.old_documents.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib
import importlib.util
import pathlib
import re
import sys
import tempfile
import unittest
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import FreeCAD  # noqa: E402
import patchmill  # noqa: E402
from parts import WithDocuments, saved_and_reopened  # noqa: E402
from patchmill import old_names  # noqa: E402
from patchmill.freecad import host  # noqa: E402

SAVED = HERE / "old_documents" / "before_folders.FCStd"
PROXIES = {
    "PlanarTexture": "patchmill.planar_texture",
    "PyramidTexture": "patchmill.pyramid_texture",
    "CurvedTexture": "patchmill.curved_texture",
    "CalibrationPatch": "patchmill.calibration_patch",
    "CopyMilling": "patchmill.copy_milling",
    "DressupDCM": "patchmill.dressup_dcm",
}


def saved_modules(file):
    """{object: module of its proxy} as a document file says."""
    with zipfile.ZipFile(file) as archive:
        text = archive.read("Document.xml").decode()
    found = {}
    for name, data in re.findall(r'<Object name="(\w+)"[^>]*>(.*?)</Object>', text, re.S):
        for module in re.findall(r'<Python[^>]* module="(patchmill[\w.]*)"', data):
            found[name] = module
    return found


class OldNames(unittest.TestCase):
    def test_a_module_found_under_its_old_name_is_the_same_object(self):
        for old, new in old_names.NEW_NAMES.items():
            module = importlib.import_module("patchmill." + new)
            spec = module.__spec__
            self.assertIs(importlib.import_module("patchmill." + old), module, old)
            self.assertIs(module.__spec__, spec)
            self.assertEqual(module.__name__, "patchmill." + new)

    def test_it_can_be_asked_for_as_before(self):
        from patchmill import host as from_package
        from patchmill.host import VERSION

        self.assertIs(from_package, host)
        self.assertIs(VERSION, host.VERSION)
        self.assertIs(patchmill.quick_setup, importlib.import_module("patchmill.operations.quick_setup"))
        # this one is a folder now; `report` is no module any more: patchmill.write_report is what it was for
        self.assertTrue(callable(importlib.import_module("patchmill.posting").post))

    def test_freecad_is_told_the_file(self):
        # FreeCAD 1.x restores proxies only from modules in a Mod folder
        for name in sorted(PROXIES.values()):
            spec = importlib.util.find_spec(name)
            self.assertTrue(spec.has_location and spec.origin.endswith(name.split(".")[1] + ".py"), spec)

    def test_there_is_nothing_else(self):
        with self.assertRaises(ModuleNotFoundError):
            importlib.import_module("patchmill.no_such_module")
        with self.assertRaises(AttributeError):
            patchmill.no_such_module


class SavedNow(WithDocuments):
    def test_names_of_the_version_before(self):
        document = FreeCAD.newDocument("now")
        part = document.addObject("Part::Box", "Part")
        document.recompute()
        job = host.create_job("Job", [part])
        host.add_ball_end_controller(job, 2.0, 2, 600.0, 1000.0)
        for kind in list(PROXIES)[:-1]:
            operation = getattr(patchmill, kind).Create(kind, parentJob=job)
        patchmill.DressupDCM.Create("DressupDCM", operation)
        with tempfile.TemporaryDirectory() as folder:
            document.saveAs(folder + "/now.FCStd")
            self.assertEqual(saved_modules(folder + "/now.FCStd"), PROXIES)


class SavedBefore(WithDocuments):
    def setUp(self):
        self.assertEqual(saved_modules(SAVED), PROXIES)
        self.document = FreeCAD.openDocument(str(SAVED))

    def test_it_opens_with_its_proxies(self):
        for name in PROXIES:
            operation = self.document.getObject(name)
            cls = type(operation.Proxy)
            self.assertIs(getattr(sys.modules[cls.__module__], cls.__name__), cls)
            self.assertEqual(operation.State, ["Up-to-date"], name)

    def test_it_recomputes_to_the_same_path(self):
        for name in PROXIES:
            operation = self.document.getObject(name)
            before = [c.toGCode() for c in operation.Path.Commands]
            self.assertGreater(len(before), 10)
            operation.touch()
            self.document.recompute()
            self.assertEqual([c.toGCode() for c in operation.Path.Commands], before, name)

    def test_it_can_be_edited(self):
        for name in ("PlanarTexture", "PyramidTexture", "CurvedTexture"):
            operation = self.document.getObject(name)
            before = len(patchmill.planned(operation).dimples.positions)
            operation.PatchSide = 3
            self.assertLess(len(patchmill.recompute(operation).dimples.positions), before)
        copied, dressup = self.document.getObject("CopyMilling"), self.document.getObject("DressupDCM")
        moves = copied.Moves
        copied.RadialDepth = 1.5
        self.document.recompute()
        self.assertGreater(copied.Moves, moves)
        self.assertEqual(dressup.State, ["Up-to-date"])

    def test_it_is_saved_and_opened_again(self):
        paths = {name: self.document.getObject(name).Path.toGCode() for name in PROXIES}
        with tempfile.TemporaryDirectory() as folder:
            reopened, job = saved_and_reopened(self.document, folder + "/again.FCStd")
            self.assertEqual(saved_modules(folder + "/again.FCStd"), PROXIES)
        (controller, *_) = host.tool_controllers(job)
        for obj in (job, job.Stock, job.SetupSheet, controller, controller.Tool):
            self.assertNotIn(obj.Proxy, (None, 0, 1), obj.Name)
        for name, path in paths.items():
            operation = reopened.getObject(name)
            self.assertIs(host.PathUtils.findParentJob(operation), job)
            self.assertEqual(operation.Path.toGCode(), path, name)
        texture = reopened.getObject("CurvedTexture")
        texture.PatchSide = 3
        self.assertGreater(len(patchmill.recompute(texture).dimples.positions), 0)


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
