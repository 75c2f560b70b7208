"""The layers of CONTRIBUTING.md: an include or import may point only downwards.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

CPP_LAYERS = ["core", "brep", "scene", "bindings"]
# The prefix of a layer's headers in an include: the core has one that collides with nothing in /usr/include.
PREFIX = {"core": "patchmill"}
LAYER_OF = {PREFIX.get(layer, layer): layer for layer in CPP_LAYERS}
VOCABULARY = ("geometry", "path", "tool")  # subjects whose names stay in patchmill itself
# What a layer may include besides its own files: other layers, and prefixes of foreign headers.
CPP_MAY_USE = {"core": {"core"}, "brep": {"core", "brep"}, "scene": {"core", "scene"}}
CPP_MAY_USE["bindings"] = set(CPP_LAYERS)
OPENCASCADE = re.compile(r".*\.hxx$|^(gp_|Standard|BRep|Geom|TopoDS)")
PYTHON = re.compile(r"^(Python\.h|pybind11/)")
HOST = re.compile(r"^(App|Base|Gui|Mod)/|FreeCAD")
COIN = re.compile(r"^Inventor/")
FOREIGN = {
    "core": [OPENCASCADE, PYTHON, HOST, COIN],
    "brep": [PYTHON, HOST, COIN],
    "scene": [OPENCASCADE, PYTHON, HOST, COIN],
    "bindings": [HOST, COIN],
}
PYTHON_FORBIDDEN = re.compile(
    r"^\s*(?:from|import)\s+(FreeCADGui|PySide\w*|PyQt\w*|pivy|patchmill_gui|Gui|Path\w*Gui\w*)\b"
)
# host.py; what maps one version's documents to another's; and what has to work where host.py does not
KNOWS_VERSIONS = {("freecad", "host.py"), ("freecad", "old_documents.py"), ("install", "doctor.py"),
                  ("freecad", "tool_bits.py")}
VERSION_KNOWLEDGE = re.compile(r"PathScripts|FreeCAD\.Version|import Path\b|Path\.(Main|Op|Tool|Post)\.")


def cpp_violations(root):
    """Lines of src/ whose includes point the wrong way: a list of texts."""
    found = []
    for layer in CPP_LAYERS:
        for file in sorted((root / "src" / layer).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            for number, line in enumerate(file.read_text().splitlines(), 1):
                include = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
                if not include:
                    continue
                name = include.group(2)
                used = LAYER_OF.get(name.split("/")[0])
                wrong = any(f.match(name) for f in FOREIGN[layer])
                wrong = wrong or name.startswith("core/")  # by its prefix only
                wrong = wrong or (used is not None and used not in CPP_MAY_USE[layer])
                if wrong:
                    found.append("%s:%d: %s" % (file.relative_to(root), number, line.strip()))
    return found


def subject_cycles(root):
    """Folders of src/core/patchmill that lead back to themselves by their includes: a list of texts."""
    uses = {}
    subjects = root / "src" / "core" / "patchmill"
    for file in sorted(f for f in subjects.rglob("*") if f.suffix in (".h", ".cpp")):
        subject = file.relative_to(subjects).parts[0]
        used = re.findall(r'#\s*include\s*"patchmill/(\w+)/', file.read_text())
        uses.setdefault(subject, set()).update(set(used) - {subject})
    ordered = set()  # those that need only what is in here already
    while True:
        more = {subject for subject, used in uses.items() if used <= ordered} - ordered
        if not more:
            left = sorted(set(uses) - ordered)
            return ["%s uses %s" % (s, ", ".join(sorted(uses[s] - ordered))) for s in left]
        ordered |= more


def foreign_namespaces(root):
    """Files of src/core/patchmill that open another namespace than their subject's: a list of texts."""
    found = []
    subjects = root / "src" / "core" / "patchmill"
    for file in sorted(f for f in subjects.rglob("*") if f.suffix in (".h", ".cpp")):
        subject = file.relative_to(subjects).parts[0]
        own = "patchmill" if subject in VOCABULARY else "patchmill::" + subject
        opened = re.findall(r"^namespace (patchmill[\w:]*) \{", file.read_text(), re.M)
        if any(n != own and not n.startswith(own + "::PATCHMILL_") for n in opened):
            found.append("%s opens %s" % (file.relative_to(root), ", ".join(opened)))
    return found


def python_violations(root):
    """Lines of src/patchmill that import a GUI, and that know FreeCAD's versions outside host.py."""
    found = []
    for file in sorted((root / "src" / "patchmill").rglob("*.py")):
        for number, line in enumerate(file.read_text().splitlines(), 1):
            knows = VERSION_KNOWLEDGE.search(line) and file.parts[-2:] not in KNOWS_VERSIONS
            if PYTHON_FORBIDDEN.match(line) or knows:
                found.append("%s:%d: %s" % (file.relative_to(root), number, line.strip()))
    return found


class Layers(unittest.TestCase):
    def test_includes_point_downwards(self):
        self.assertEqual(cpp_violations(ROOT), [])

    def test_the_cores_subjects_form_no_cycle(self):
        self.assertEqual(subject_cycles(ROOT), [])

    def test_each_subject_has_its_namespace(self):
        self.assertEqual(foreign_namespaces(ROOT), [])

    def test_package_has_no_gui_and_one_file_of_versions(self):
        self.assertEqual(python_violations(ROOT), [])

    def test_the_checks_find_what_they_look_for(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for layer, text in {
                "core": '#include <gp_Pnt.hxx>\n#include <Python.h>\n#include "brep/x.h"\n'
                "#include <pybind11/pybind11.h>\n#include <App/Document.h>\n",
                "brep": '#include "bindings/x.h"\n#include <TopoDS_Face.hxx>\n#include "core/x.h"\n',
            }.items():
                (root / "src" / layer).mkdir(parents=True)
                (root / "src" / layer / "bad.h").write_text(text)
            (root / "src" / "patchmill").mkdir()
            (root / "src" / "patchmill" / "bad.py").write_text(
                "import FreeCADGui\nfrom PySide import QtCore\nimport patchmill_gui\n"
                "import PathScripts.PathUtils\nimport numpy\nimport _patchmill\n"
            )
            for subject, used in (("a", "b"), ("b", "c"), ("c", "b"), ("d", "d")):
                folder = root / "src" / "core" / "patchmill" / subject
                folder.mkdir(parents=True)
                text = '#include "patchmill/%s/y.h"\nnamespace patchmill::%s {\n'
                (folder / "x.h").write_text(text % (used, subject if subject == "a" else "other"))
            self.assertEqual(len(foreign_namespaces(root)), 3)
            self.assertEqual(len(subject_cycles(root)), 3)  # of the cycle, and of a that needs it
            self.assertEqual(len(cpp_violations(root)), 7)
            self.assertEqual(len(python_violations(root)), 4)

    def test_top_level_names(self):
        stage = (ROOT / "cmake" / "StageModule.cmake").read_text()
        staged = set(re.findall(r"CREATE_LINK \S+ \$\{STAGE\}/(\w+)", stage))
        self.assertLessEqual(staged, {"patchmill", "patchmill_gui", "Resources", "TestPatchMill"})
        posts = [file.name for file in (ROOT / "src" / "posts").glob("*.py")]
        self.assertTrue(posts and all(name.startswith("patchmill_") for name in posts))


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
