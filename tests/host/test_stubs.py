"""The types of the compiled module in src/stubs are those of the module that is built.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import configparser
import importlib.machinery
import importlib.util
import pathlib
import re
import sys
import unittest

import _patchmill as core
from patchmill.freecad import host

ROOT = pathlib.Path(__file__).resolve().parents[2]


def tool():
    loader = importlib.machinery.SourceFileLoader("stubs", str(ROOT / "tools" / "stubs"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("stubs", loader))
    loader.exec_module(module)
    return module


class Stubs(unittest.TestCase):
    @unittest.skipIf(host.VERSION >= (0, 21), "another pybind11 spells types in another way")
    def test_they_are_current(self):
        folder = ROOT / "src" / "stubs" / "_patchmill"
        made = tool().stubs(core)
        self.assertEqual({f.name for f in folder.glob("*.pyi")}, set(made))
        for name, text in made.items():
            self.assertEqual((folder / name).read_text(), text, "%s: run tools/stubs" % name)

    def test_a_name_of_a_submodule_is_one_of_the_module(self):
        subjects = tool().subject_modules(core)
        self.assertGreater(len(subjects), 8)
        for name, part in subjects.items():
            self.assertEqual(part.__name__, "_patchmill." + name)
            for own, value in vars(part).items():
                if not own.startswith("__"):
                    self.assertIs(getattr(core, own), value)

    def test_types_are_checked_for_the_oldest_python_that_the_package_takes(self):
        settings = configparser.ConfigParser()
        settings.read(ROOT / "mypy.ini")
        taken = re.search(r"<pythonmin>(.*)</pythonmin>", (ROOT / "package.xml").read_text()).group(1)
        self.assertEqual(settings["mypy"]["python_version"], taken)

    def test_only_modules_of_others_may_lack_types(self):
        settings = configparser.ConfigParser()
        settings.read(ROOT / "mypy.ini")
        for section in settings.sections():
            for module in section.split(","):
                self.assertNotRegex(module, r"patchmill|^mypy-\*")

    def test_what_a_class_was_called_before_is_the_same_class(self):
        text = tool().stubs(core)["path.pyi"]
        self.assertIn("\nBallEndMill = Tool\n", text)
        self.assertEqual(text.count("class Tool:"), 1)

    def test_what_a_signature_says(self):
        writer = tool().Writer(core.path, {"ToolPath": "_patchmill.path", "Dimples": "_patchmill.patch"})
        said = writer.signature(
            "f(a: numpy.ndarray[numpy.float64[m, 3]], b: _patchmill.patch.Dimples = None, "
            "c: List[float[2]] = [], d: str = 'x, y') -> Tuple[_patchmill.path.ToolPath, dict]"
        )
        self.assertEqual(
            said,
            "f(a: numpy.typing.ArrayLike, b: typing.Optional[_patchmill.patch.Dimples] = None, "
            "c: list[list[float]] = ..., d: str = 'x, y') -> tuple[ToolPath, dict]",
        )


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
