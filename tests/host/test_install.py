"""A core that cannot be loaded is said in one sentence, and a document opened meanwhile keeps all it has.

Each case runs in a FreeCAD of its own, on a copy of the module in which the core is replaced.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib.machinery
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import FreeCAD  # noqa: E402
import patchmill  # noqa: E402
from parts import job_on, tilted_box  # noqa: E402
from patchmill.install import core_loader, wheels  # noqa: E402

ROOT = core_loader.module_root()
SUFFIX = importlib.machinery.EXTENSION_SUFFIXES[0]
PROGRAM = os.environ.get("FREECADCMD", "freecadcmd")
OPENED = """
import FreeCAD
document = FreeCAD.openDocument(%(file)r)
op = document.getObject(%(name)r)
print("path", op.Path.Size, type(op.Proxy).__name__)
op.touch()
document.recompute()
print("computed", op.Path.Size)
import patchmill
try:
    patchmill.recompute(op)
except patchmill.InputError as error:
    print("refused", error)
document.saveAs(%(saved)r)
op.Spacing = 0.75
print("changed", op.Path.Size)
"""


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.module = os.path.join(self.folder, "PatchMill")
        os.makedirs(self.module)
        for name in os.listdir(ROOT):
            if not name.startswith(("_patchmill.", "core", ".", "build")):
                os.symlink(os.path.realpath(os.path.join(ROOT, name)), os.path.join(self.module, name))

    def run_script(self, text):
        """(exit status, output) of a script in a FreeCAD with the copy of the module."""
        script = os.path.join(self.folder, "script.py")
        with open(script, "w", encoding="utf-8") as file:
            file.write(text)
        done = subprocess.run(
            [PROGRAM, "-c", "exec(open(%r).read())" % script, "-M", self.module],
            env=dict(os.environ, FREECAD_USER_HOME=os.path.join(self.folder, "home")),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=300,
        )
        return done.returncode, done.stdout

    def reason(self, name=None, content=None):
        """What is said with a file `name` in the core's place."""
        if name:
            with open(os.path.join(self.module, name), "wb") as file:
                file.write(content)
        status, text = self.run_script(
            "from patchmill.install import core_loader\nprint('why:', core_loader.load())"
        )
        self.assertEqual(status, 0, text)
        self.assertNotIn("Traceback", text)
        return re.search("why: (.*)", text).group(1)


class Core(Case):
    def test_no_core(self):
        python = "%d.%d" % sys.version_info[:2]
        self.assertEqual(self.reason(), "the compiled core for Python %s is not installed" % python)

    def test_core_of_another_python(self):
        said = self.reason("_patchmill.cpython-36m-x86_64-linux-gnu.so", b"")
        self.assertRegex(said, r"is built for Python 3\.6, and this FreeCAD has Python 3\.\d+$")

    def test_broken_core(self):
        self.assertIn("is broken", self.reason("_patchmill" + SUFFIX, b"\x7fELF and no more"))

    def test_core_without_its_libraries(self):
        missing = {"libTKernel.so.1.2": "needs another OpenCASCADE", "libodd.so.9": "the library"}
        for library, said in missing.items():
            self.assertIn(said, self.reason("_patchmill" + SUFFIX, needing(library)))
            self.assertIn(library, self.reason())

    def test_core_of_a_wheel_without_one_of_its_own_libraries(self):
        folder = os.path.join(self.module, "core", core_loader.tag())
        os.makedirs(folder)
        with open(os.path.join(folder, "_patchmill" + SUFFIX), "wb") as file:
            file.write(needing("libTKernel-patchmill-0a1b2c3d.so.7.6"))
        said = self.reason()
        self.assertEqual(
            said, "the compiled core is not whole: its libTKernel-patchmill-0a1b2c3d.so.7.6 is missing"
        )

    def test_core_of_another_version(self):
        for version, said in (("0.1.0", "is of version 0.1.0"), ("", "is of an older version")):
            with open(os.path.join(self.module, "_patchmill.py"), "w", encoding="utf-8") as file:
                file.write("__version__ = %r\n" % version if version else "InputError = ValueError\n")
            self.assertEqual(
                self.reason(), "the compiled core %s, and PatchMill is %s" % (said, patchmill.__version__)
            )
            shutil.rmtree(os.path.join(self.module, "__pycache__"), ignore_errors=True)


def needing(library):
    """The bytes of a core that wants a library that nobody has: an ELF-64 file with nothing in it but that
    wish (System V ABI, chapter 5), so that no compiler is needed here."""
    names = b"\0" + library.encode("ascii") + b"\0"
    dynamic, symbols, strings = 232, 328, 352  # offsets, which are addresses too
    wish = [(1, 1), (5, strings), (6, symbols), (10, len(names)), (11, 24), (0, 0)]
    with open("/proc/self/exe", "rb") as file:
        head = file.read(20)  # of this machine: class, byte order, processor
    size = strings + len(names)
    parts = [
        head[:16] + struct.pack("<H2sIQQQIHHHHHH", 3, head[18:20], 1, 0, 64, 0, 0, 64, 56, 3, 0, 0, 0),
        struct.pack("<IIQQQQQQ", 1, 6, 0, 0, 0, size, size, 0x1000),  # all of it is loaded
        struct.pack("<IIQQQQQQ", 2, 6, dynamic, dynamic, dynamic, 96, 96, 8),
        struct.pack("<IIQQQQQQ", 0x6474E551, 6, 0, 0, 0, 0, 0, 16),  # a stack without code
        *(struct.pack("<QQ", *entry) for entry in wish),
        bytes(24) + names,
    ]
    return b"".join(parts)


class Wheels(unittest.TestCase):
    def test_a_wheel_that_lies_near_and_does_not_fit_is_told(self):
        with tempfile.TemporaryDirectory() as home:
            os.mkdir(os.path.join(home, "Downloads"))
            name = "patchmill_core-%s-cp36-cp36-linux_x86_64.whl" % core_loader.version()
            # no pip is run here
            no_pip = mock.patch.object(wheels, "interpreter", str)
            root = mock.patch.object(core_loader, "module_root", lambda: home)
            with mock.patch.dict(os.environ, HOME=home), root, no_pip:
                with self.assertRaisesRegex(wheels.InstallError, "interpreter to run pip with.$"):
                    wheels.fetch()
                open(os.path.join(home, "Downloads", name), "w").close()
                said = "%s cannot be used: it is for Python 3.6, and this FreeCAD has Python 3" % name
                with self.assertRaisesRegex(wheels.InstallError, said):
                    wheels.fetch()


class Modules(Case):
    def test_all_that_documents_name_are_imported_without_the_core(self):
        status, text = self.run_script(
            "import importlib\nfrom patchmill.old_names import NEW_NAMES\n"
            "for name in NEW_NAMES.values():\n    importlib.import_module('patchmill.' + name)\n"
            "print('imported', len(NEW_NAMES))"
        )
        self.assertEqual(status, 0, text)
        self.assertRegex(text, "imported [1-9]")


class Documents(Case):
    def test_a_document_opened_without_the_core_keeps_everything(self):
        document, op = job_on(*tilted_box())
        patchmill.recompute(op)
        size, before = op.Path.Size, op.Path.toGCode()
        self.assertGreater(size, 100)
        file = os.path.join(self.folder, "a.FCStd")
        document.saveAs(file)
        name, saved = op.Name, os.path.join(self.folder, "b.FCStd")
        FreeCAD.closeDocument(document.Name)

        status, text = self.run_script(OPENED % dict(file=file, name=name, saved=saved))
        self.assertEqual(status, 0, text)
        self.assertNotIn("Traceback", text)
        self.assertIn("path %d Object" % size, text)
        self.assertIn("computed %d" % size, text)
        self.assertRegex(text, "is not computed: the compiled core for Python .* is not installed; ")
        self.assertIn("refused PatchMill's core = not loaded: the compiled core", text)
        self.assertIn("changed 0", text)  # what it was made from is another now

        document = FreeCAD.openDocument(saved)
        op = document.getObject(name)
        self.assertEqual(op.Path.toGCode(), before)
        patchmill.recompute(op)
        self.assertEqual(op.Path.toGCode(), before)
        FreeCAD.closeDocument(document.Name)


class Version(unittest.TestCase):
    def test_all_files_say_the_same_version(self):
        source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
        with open(os.path.join(source, "CMakeLists.txt"), encoding="utf-8") as file:
            built = re.search(r"project\(PatchMill VERSION (\S+)", file.read()).group(1)
        tree = xml.etree.ElementTree.parse(os.path.join(source, "package.xml"))
        package = next(e.text for e in tree.iter() if e.tag.split("}")[-1] == "version")
        self.assertEqual([built, package], [patchmill.__version__] * 2)
        self.assertEqual(core_loader.why_absent(), "")


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
