"""The folders of the Python package and of the GUI: how many files each has, and that imports form no circle.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import ast
import functools
import pathlib
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGES = {"patchmill": ROOT / "src" / "patchmill", "patchmill_gui": ROOT / "Gui" / "patchmill_gui"}
MOST_FILES = 12
MOST_FLOORS = 6  # of src/patchmill: modules over each other, each importing the one below


def modules_of(package, folder):
    """{module name: file} of a package's folder."""
    names = {}
    for file in sorted(folder.rglob("*.py")):
        parts = file.relative_to(folder).with_suffix("").parts
        names[".".join((package,) + tuple(p for p in parts if p != "__init__"))] = file
    return names


def imports(package, folder):
    """{module name: names of the package's modules that it imports}, also those imported in functions."""
    modules = modules_of(package, folder)
    used = {}
    for name, file in modules.items():
        found = set()
        for node in ast.walk(ast.parse(file.read_text())):
            if isinstance(node, ast.ImportFrom) and node.module:
                below = [node.module + "." + each.name for each in node.names]
                found.update(m if m in modules else node.module for m in below)
            elif isinstance(node, ast.Import):
                found.update(each.name for each in node.names)
        used[name] = found & set(modules) - {name}
    return used


def folder_imports(package, used):
    """{folder: folders that its modules import from}: the package's own modules are the folder ''."""
    folders = {}
    for name, others in used.items():
        here = _folder(package, name, used)
        folders.setdefault(here, set()).update(_folder(package, o, used) for o in others)
    return {folder: others - {folder, ""} for folder, others in folders.items() if folder}


def _folder(package, name, modules):
    parts = name.split(".")
    is_folder = any(m.startswith(name + ".") for m in modules)
    return parts[1] if len(parts) > 2 or (is_folder and len(parts) == 2) else ""


def circle(used):
    """Names that lead back to themselves, or need one that does: sorted, empty if there is no circle."""
    ordered = set()
    while True:
        more = {name for name, others in used.items() if others <= ordered} - ordered
        if not more:
            return sorted(set(used) - ordered)
        ordered |= more


def floors(used):
    """How many modules stand over each other at most, a module alone being one. There must be no circle."""

    @functools.lru_cache(None)
    def height(name):
        return 1 + max((height(other) for other in used[name]), default=0)

    return max(map(height, used))


def full_folders(root, most=MOST_FILES):
    """Folders with more Python or C++ files than `most`: a list of texts."""
    found = []
    for folder in [root, *sorted(p for p in root.rglob("*") if p.is_dir())]:
        files = [f for f in folder.iterdir() if f.suffix in (".py", ".cpp", ".h")]
        if len(files) > most:
            found.append("%s: %d files" % (folder.name, len(files)))
    return found


class Folders(unittest.TestCase):
    def test_at_most_a_dozen_files_a_folder(self):
        for folder in [*PACKAGES.values(), ROOT / "src" / "bindings"]:
            self.assertEqual(full_folders(folder), [])

    def test_modules_form_no_circle(self):
        for package, folder in PACKAGES.items():
            self.assertEqual(circle(imports(package, folder)), [])

    def test_at_most_six_floors(self):
        self.assertLessEqual(floors(imports("patchmill", PACKAGES["patchmill"])), MOST_FLOORS)

    def test_folders_form_no_circle(self):
        for package, folder in PACKAGES.items():
            self.assertEqual(circle(folder_imports(package, imports(package, folder))), [])

    def test_no_module_is_imported_under_its_old_name(self):
        for package, folder in PACKAGES.items():
            text = (folder / "old_names.py").read_text()
            old = set(re.findall(r'^    "(\w+)": "[\w.]+",$', text, re.M))
            self.assertGreater(len(old), 20)
            for other in PACKAGES.values():
                for file in other.rglob("*.py"):
                    for module in re.findall(r"^\s*from (%s\.\w+) import" % package, file.read_text(), re.M):
                        self.assertNotIn(module.split(".")[1], old, file)

    def test_the_checks_find_what_they_look_for(self):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            for folder, text in (("a", "def f():\n    from p.b import x\n"), ("b", "from p.a import x\n")):
                (root / folder).mkdir()
                (root / folder / "__init__.py").write_text("")
                (root / folder / "x.py").write_text(text)
            (root / "free.py").write_text("import p.a.x\n")
            used = imports("p", root)
            self.assertEqual(circle(used), ["p.a.x", "p.b.x", "p.free"])
            self.assertEqual(circle(folder_imports("p", used)), ["a", "b"])
            self.assertEqual(floors({"a": set(), "b": {"a"}, "c": {"b", "a"}}), 3)
            self.assertEqual(full_folders(root, 1), ["a: 2 files", "b: 2 files"])


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
