"""Finds the sentences by which errors tell users what is wrong and what to do, as InputError gets them in the
sources of the core and of the package, made of a value and a remedy; and remarks on what was decided for the
user. {} stands for what is put into them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import ast
import itertools
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[1]
# what is met in macros, at the command line and in files of measurements is told in English only
PACKAGE = ("advice", "collision", "freecad", "geometry", "machine", "modifiers", "operations", "path")
PACKAGE += ("posting", "system", "textures", "verify", "voxels")
PYTHON = ("Gui/patchmill_gui", *("src/patchmill/" + folder for folder in PACKAGE))
CORE = ("src/brep", "src/core/patchmill")
MORE = (  # whose unit, or all, comes by a variable
    "give a value from {} to {} mm.",
    "give a value from {} to {} degrees.",
    "choose a larger ball or a smaller spacing.",
)
FORMATS = re.compile(r"%(?:[-+0 #]*\d*(?:\.\d+)?[diufgeGEsr]|(%))|\{[^{}]*\}")
CPP_ERROR = re.compile(r"\bInputError\s*[({]")
CPP_TEXT = re.compile(r'(?:"(?:[^"\\]|\\.)*"\s*)+')
WORDS = re.compile(r"[A-Za-zäöü]{2,}")
UNITS = {"mm", "min", "rpm", "degrees", "GB", "GiB", "MiB", "to", "of", "in", "and", "from"}
ALONE = {"missing", "empty", "none", "nothing", "invalid", "infinite", "tilted"}  # values of one word


def sentences():
    """All of them, each once, in the order of the alphabet."""
    found = set(MORE)
    for folder in PYTHON:
        for file in (ROOT / folder).rglob("*.py"):
            found |= set(of_python(file.read_text(encoding="utf-8")))
    for folder in CORE:
        for file in itertools.chain(*((ROOT / folder).rglob(kind) for kind in ("*.cpp", "*.h"))):
            found |= set(of_cpp(file.read_text(encoding="utf-8")))
    return sorted(text for text in found if text in ALONE or len(set(WORDS.findall(text)) - UNITS) > 1)


def of_python(source):
    """Of all InputErrors, and all that is appended to `remarks` or `said`, in a Python source."""
    tree = ast.parse(source)
    scopes = [node for node in ast.walk(tree) if isinstance(node, (ast.FunctionDef, ast.Module))]
    for scope in scopes:
        known = _assigned(scope)
        if not isinstance(scope, ast.Module):
            known = {**_assigned(tree), **known}
        for call in _own(scope):
            for argument in _said(call) if isinstance(call, ast.Call) else ():
                yield from _texts(argument, known)


def _said(call):
    """The arguments of a call that are shown to the user."""
    if getattr(call.func, "id", "") == "InputError":
        return call.args[1:3]
    words = ast.unparse(call.func).split(".")
    return call.args[:1] if words[-2:] in (["remarks", "append"], ["said", "append"]) else []


def _own(scope):
    """The nodes of a function or module, without those of functions within."""
    waiting = list(scope.body)
    while waiting:
        node = waiting.pop()
        if not isinstance(node, ast.FunctionDef):
            yield node
            waiting += ast.iter_child_nodes(node)


def _assigned(scope):
    """{name: expressions that it is given} by name = expression, one or several."""
    found = {}
    for node in _own(scope):
        if isinstance(node, ast.Assign):
            for target in node.targets:
                pairs = [(target, node.value)]
                if isinstance(target, ast.Tuple) and isinstance(node.value, ast.Tuple):
                    pairs = zip(target.elts, node.value.elts)
                for one, value in pairs:
                    if isinstance(one, ast.Name):
                        found.setdefault(one.id, []).append(value)
    return found


def _texts(node, known):
    """The sentences that an expression may be."""
    if isinstance(node, ast.Constant):
        return [FORMATS.sub(_place, node.value)] if isinstance(node.value, str) else []
    if isinstance(node, ast.Name):
        return [text for value in known.get(node.id, ()) for text in _texts(value, {})]
    if isinstance(node, ast.IfExp):
        return _texts(node.body, known) + _texts(node.orelse, known)
    if isinstance(node, ast.JoinedStr):
        return ["".join(part.value if isinstance(part, ast.Constant) else "{}" for part in node.values)]
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mod):
        return _texts(node.left, known)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        sides = [_texts(side, known) or ["{}"] for side in (node.left, node.right)]
        return ["".join(pair) for pair in itertools.product(*sides)]
    if isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "format":
        return _texts(node.func.value, known)
    return []


def _place(found):
    return "%" if found.group(1) else "{}"


def of_cpp(source):
    """Of all InputErrors that are made in a C++ source."""
    for start in CPP_ERROR.finditer(source):
        for argument in _arguments(source, start.end())[1:3]:
            pieces = _split(argument.strip(), "+")
            texts = [_cpp_text(piece.strip()) for piece in pieces]
            if any(texts):
                yield "".join(text or "{}" for text in texts)


def _cpp_text(piece):
    """What a literal or a call of fmt::format says; '' for any other expression."""
    call = re.match(r"fmt::format\(", piece)
    literal = CPP_TEXT.match(piece, call.end() if call else 0)
    if not literal or not (call or literal.end() == len(piece)):
        return ""
    parts = re.findall(r'"((?:[^"\\]|\\.)*)"', literal.group(0))
    return re.sub(r"\{[^{}]*\}", "{}", "".join(parts))


def _arguments(source, start):
    """The arguments of a call whose bracket is open at `start`."""
    depth, at = 1, start
    while depth and at < len(source):
        literal = CPP_TEXT.match(source, at)
        if literal:
            at = literal.end()
            continue
        depth += (source[at] in "({[") - (source[at] in ")}]")
        at += 1
    return _split(source[start : at - 1], ",")


def _split(text, sign):
    """`text` at each `sign` that is in no bracket and no literal."""
    parts, depth, at, last = [], 0, 0, 0
    while at < len(text):
        literal = CPP_TEXT.match(text, at)
        if literal:
            at = literal.end()
            continue
        depth += (text[at] in "({[") - (text[at] in ")}]")
        if text[at] == sign and not depth:
            parts.append(text[last:at])
            last = at + 1
        at += 1
    return [*parts, text[last:]]
