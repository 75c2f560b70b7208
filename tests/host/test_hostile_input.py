"""What others wrote, a document that was damaged, names that are markup, a post-processor that ends the
process, comes out as a sentence and runs nothing.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import re
import sys
import tempfile
import unittest
import zipfile
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
import patchmill  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.reports import report  # noqa: E402
from roof_job import ARGUMENTS, roof_job  # noqa: E402

MARKUP = '<img src=x onerror=alert(1)>"&<script>alert(2)'
ENUMERATION = r'(<Property name="%s" type="App::PropertyEnumeration".*?)<Integer value="\d+"(.*?</Property>)'


class HostileInput(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.program = os.path.join(self.folder, "x.nc")

    def test_a_report_shows_names_and_runs_nothing(self):
        job, (texture,) = roof_job("Constant feed")
        texture.Label = texture.ToolController.Label = job.Label = MARKUP
        (posted,) = patchmill.post(job, self.program, "patchmill_linuxcnc", ARGUMENTS)
        names = report.write_report(posted, patchmill.planned(texture), MARKUP, self.folder)
        page = pathlib.Path(names[1]).read_text(encoding="utf-8")
        self.assertIn("&lt;script&gt;", page)
        for tag in ("<script", "<img src=x"):
            self.assertNotIn(tag, page)

    def test_names_of_posts_import_nothing(self):
        job, _ = roof_job("Constant feed")
        before = set(sys.modules)
        for name in ("../x", "a.b", "os;x", "patchmill_../x", "patchmill_", "", "x" * 300, "\u00e4", "a b"):
            with self.assertRaises(InputError) as caught:
                patchmill.post(job, self.program, name, ARGUMENTS)
            self.assertEqual(caught.exception.property, "PostProcessor", name)
        new = set(sys.modules) - before
        self.assertFalse({m for m in new if m in ("os;x", "x", "a.b") or ".." in m})

    def test_a_post_that_ends_the_process_or_fails(self):
        def ends(*_):
            raise SystemExit(3)

        def recurses(*_):
            return recurses()

        def fails(*_):
            raise ZeroDivisionError("\udcff")

        job, _ = roof_job("Constant feed")
        for wrong in (ends, recurses, fails, lambda *_: None, lambda *_: 5, lambda *_: b"G0"):
            with mock.patch.object(host, "post_parts", side_effect=lambda *_: [wrong()]):
                with self.assertRaises(InputError) as caught:
                    patchmill.post(job, self.program, "linuxcnc", ARGUMENTS)
            self.assertEqual(caught.exception.property, "PostProcessor", wrong)
            str(caught.exception).encode()
        self.assertFalse(os.path.exists(self.program))

    def damaged(self, *changes):
        """The document of a job with a texture, opened with its Document.xml changed by (pattern, text)."""
        job, _ = roof_job("Constant feed")
        file = os.path.join(self.folder, "x.FCStd")
        job.Document.saveAs(file)
        FreeCAD.closeDocument(job.Document.Name)
        with zipfile.ZipFile(file) as archive:
            members = {name: archive.read(name) for name in archive.namelist()}
        text = members["Document.xml"].decode()
        for pattern, new in changes:
            text, count = re.subn(pattern, new, text, flags=re.S)
            self.assertGreater(count, 0, pattern)
        members["Document.xml"] = text.encode()
        with zipfile.ZipFile(file, "w") as archive:
            for name, content in members.items():
                archive.writestr(name, content)
        return FreeCAD.openDocument(file)

    def told(self, document):
        """What posting the job of a document says; None if it is posted."""
        job = next(o for o in document.Objects if hasattr(o, "PostProcessorArgs"))
        try:
            document.recompute()
            patchmill.post(job, self.program, "patchmill_linuxcnc", ARGUMENTS)
        except InputError as error:
            str(error).encode()
            return error
        return None

    def test_choices_that_are_none(self):
        for name in ("Strategy", "Mapping", "CoolantMode", "ProgramForm", "MaskUse"):
            for value in (99, -5, 2**31 - 1):
                document = self.damaged((ENUMERATION % name, r'\g<1><Integer value="%d"\g<2>' % value))
                self.told(document)  # a sentence or a program, no other exception
                FreeCAD.closeDocument(document.Name)

    def test_links_to_what_is_not_there(self):
        link = r'(<Property name="ToolController" type="App::PropertyLink".*?<Link value=")[^"]*(")'
        document = self.damaged((link, r"\1NoSuchThing\2"))
        self.assertIsInstance(self.told(document), InputError)
        FreeCAD.closeDocument(document.Name)
        base = r'(<Property name="Base" type="App::PropertyLinkSub.*?<Link obj=")[^"]*(")'
        document = self.damaged((base, r"\1NoSuchThing\2"))
        self.assertIsInstance(self.told(document), InputError)
        FreeCAD.closeDocument(document.Name)
        face = r'(<Property name="Base" type="App::PropertyLinkSub.*?sub=")[^"]*(")'
        for name in ("Face999", "Edge1", "", "Face-1", "Face99999999999999999999"):
            document = self.damaged((face, r"\g<1>%s\2" % name))
            self.told(document)
            FreeCAD.closeDocument(document.Name)

    def test_an_operation_of_a_module_that_is_not_there(self):
        document = self.damaged((r'module="patchmill[\w.]*"', 'module="nothing_like_it"'))
        self.assertIsNone(self.told(document))  # what is left is a path, posted and read back as one


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
