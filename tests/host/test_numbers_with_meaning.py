"""Numbers of the core that mean something, states of dimples and kinds of moves and voxels, have names in
Python: no source compares them with bare numbers, and the names are those of the core.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import ast
import pathlib
import pickle
import re
import sys
import unittest

import _patchmill as core
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import bound_things as things  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("src/patchmill", "Gui", "src/posts", "examples", "docs")
# what such numbers are called: attributes and functions of the core, and keys of its dicts
MEANT = {"states", "kinds", "kinds_at", "dimples_of_moves", "materials_at"}
KEYS = {"states", "kind", "kinds", "material"}
OF_A_PATH = re.compile(r"(^|[._])path$")  # path.dimples are numbers, or NO_DIMPLE


def is_meant(node, names):
    """Whether an expression is such a number, or an array of them."""
    if isinstance(node, ast.Name):
        return node.id in names
    if isinstance(node, ast.Attribute):
        if node.attr == "dimples":
            return bool(OF_A_PATH.search(ast.unparse(node.value)))
        return node.attr in MEANT
    if isinstance(node, ast.Subscript):
        key = node.slice.value if isinstance(node.slice, ast.Constant) else None
        return key in KEYS or is_meant(node.value, names)
    if isinstance(node, ast.Call):
        function = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        passed = function in ("array", "asarray", "list", "insert", "int", "astype", "zip")
        return function in MEANT or passed and any(
            is_meant(a, names) for a in [*node.args, getattr(node.func, "value", ast.Constant(0))]
        )
    return False


def is_bare(node, constants):
    """Whether an expression is a number, or made of such: 2, -1, (1, 9), or a name of one."""
    if isinstance(node, ast.Name):
        return node.id in constants
    if isinstance(node, ast.UnaryOp):
        return is_bare(node.operand, constants)
    if isinstance(node, (ast.Tuple, ast.List, ast.Set)):
        return any(is_bare(e, constants) for e in node.elts)
    return isinstance(node, ast.Constant) and type(node.value) in (int, float)


def assigned(tree):
    """(name, value) of each assignment, (a, b) = (x, y) and for a, b in zip(x, y) taken apart."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign):
            pairs = [(target, node.value) for target in node.targets]
        elif isinstance(node, (ast.For, ast.comprehension)):
            pairs = [(node.target, node.iter)]
        else:
            continue
        for target, value in pairs:
            if isinstance(value, ast.Call) and getattr(value.func, "id", "") == "zip":
                value = ast.Tuple(value.args)
            if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
                yield from zip(target.elts, value.elts)
            else:
                yield target, value


def bare_comparisons(text):
    """The lines of a module in which such a number is compared with a bare one."""
    tree = ast.parse(text)
    named = [(t.id, v) for t, v in assigned(tree) if isinstance(t, ast.Name)]
    constants = {name for name, value in named if name.isupper() and is_bare(value, ())}
    found = []
    for scope in [tree, *(n for n in ast.walk(tree) if isinstance(n, ast.FunctionDef))]:
        names = set()
        for _ in range(3):  # a name of a name
            names |= {t.id for t, v in assigned(scope) if isinstance(t, ast.Name) and is_meant(v, names)}
        for node in ast.walk(scope):
            if isinstance(node, ast.Compare):
                both = [node.left, *node.comparators]
            elif isinstance(node, ast.Call) and getattr(node.func, "attr", "") in ("isin", "equal"):
                both = node.args
            else:
                continue
            if any(is_meant(n, names) for n in both) and any(is_bare(n, constants) for n in both):
                found.append(node.lineno)
    return sorted(set(found))


class Sources(unittest.TestCase):
    def test_none_compares_with_a_bare_number(self):
        files = [f for folder in FOLDERS for f in (ROOT / folder).rglob("*.py")]
        self.assertGreater(len(files), 150)
        found = ["%s:%d" % (f, line) for f in files for line in bare_comparisons(f.read_text())]
        self.assertEqual(found, [])

    def test_a_bare_number_would_be_found(self):
        for planted in (
            "cut = placed.dimples.states == 0",
            "if sample['states'][0] != 0: pass",
            "CUT = 2\n(path.kinds == CUT).any()",
            "RAPID, CUT = 0, 2\nkinds = np.array(path.kinds)\nturns[kinds == RAPID] = 0",
            "np.isin(dimples.states, (1, 9))",
            "OFF = (1, 9)\nnp.isin(dimples.states, OFF)",
            "for tip, kind in zip(batch.tips, batch.kinds):\n    if kind == 0: pass",
            "timed = s.path.kinds > 0",
            "np.where(core.kinds_at(grid, points) > 1, 0, -1)",
            "np.where(section['kind'] > 1, 1.0, np.nan)",
            "dimples = path.dimples\nends = np.flatnonzero(dimples >= 0)",
            "def f(path):\n    kinds = path.kinds\n    return [k for k in kinds if k == 1]",
            "found['material'] == -1",
        ):
            self.assertTrue(bare_comparisons(planted), planted)

    def test_names_and_counts_are_not_taken_for_it(self):
        for right in (
            "cut = dimples.states == core.DimpleState.CUT\nif cut.sum() > 0: pass",
            "np.isin(kinds, (core.VoxelKind.AIR, core.VoxelKind.PART))",
            "if len(path.kinds) == 0: pass",
            "if plan.dimples == 3: pass",
            "path.dimples != core.NO_DIMPLE",
        ):
            self.assertEqual(bare_comparisons(right), [], right)


class Names(unittest.TestCase):
    def test_states_of_dimples(self):
        names = core.state_names()
        self.assertEqual(len(core.DimpleState), len(names))
        for number, state in enumerate(core.DimpleState):
            self.assertEqual(state, number)
            words = [w for w in names[number].upper().split() if w not in ("THE", "AN")]
            self.assertEqual(state.name, "_".join(words))
        counts = things.dimples.counts()
        for state in core.DimpleState:
            self.assertEqual((things.dimples.states == state).sum(), counts[names[state]])
        off = things.sampler.sample([[1000.0, 0.0], [0.0, 0.0]])["states"]
        self.assertEqual(list(off), [core.DimpleState.OFF_FACE, core.DimpleState.CUT])

    def test_kinds_of_moves(self):
        kinds = list(core.MoveKind)
        tips = np.arange(9.0).reshape(3, 3)
        path = core.make_path(things.tool, things.spindle, (0, 0, 0), tips, None, kinds, [np.nan, 1.0, 1.0])
        self.assertEqual(list(path.kinds), kinds)
        lengths = path.statistics()
        self.assertAlmostEqual(lengths["rapid_length_mm"], np.sqrt(5.0))
        for name in ("link_length_mm", "cut_length_mm"):
            self.assertAlmostEqual(lengths[name], 3.0 * np.sqrt(3.0))
        self.assertEqual(list(path.dimples), [core.NO_DIMPLE] * 3)
        with self.assertRaises(core.InputError):
            kinds[2] = len(core.MoveKind)
            core.make_path(things.tool, things.spindle, (0, 0, 0), tips, None, kinds, [np.nan] * 3)

    def test_kinds_of_voxels(self):
        """A block of 10 x 10 x 6 mm, in which a part of 6 x 6 x 4 mm stands."""
        Kind = core.VoxelKind
        self.assertEqual([k.name.lower() for k in Kind], list(things.grid.counts))
        places = [(-5, 5, 2), (5, 5, 1), (1.25, 1.25, 0.25), (2.25, 5, 1), (5, 5, 4.75)]
        self.assertEqual(
            [Kind(k) for k in core.kinds_at(things.grid, places)],
            [Kind.AIR, Kind.PART, Kind.REMOVAL, Kind.SURFACE, Kind.EXTERIOR],
        )
        numbers = core.materials_at(things.grid, core.materials_of(things.grid, []), places)
        none, stock = core.NO_MATERIAL, core.STOCK_MATERIAL
        self.assertEqual(list(numbers), [none, none, stock, stock, stock])
        layer = things.grid.section(2, 0.25)["kind"]
        self.assertEqual(set(np.unique(layer)) - {k.value for k in Kind}, set())
        self.assertTrue((layer == Kind.SURFACE).any())

    def test_they_are_numbers_and_keep_their_names(self):
        for kind in (core.DimpleState, core.MoveKind, core.VoxelKind):
            for member in kind:
                self.assertIs(pickle.loads(pickle.dumps(member)), member)
                self.assertEqual("%d" % member, str(member.value))
                self.assertIn(member.name, kind.__doc__)


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
