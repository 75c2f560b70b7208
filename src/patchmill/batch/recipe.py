"""Recipes: a JSON file that names parts, faces, operations, tool, machine, outputs and limits.

A recipe is checked against Resources/schemas/recipe.schema.json before anything else is done. It runs no
code, and reads only files in its own folder: names that are absolute, that have "..", or that are links
out of the folder are refused. Keys that begin with "//" are comments.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import glob
import hashlib
import json
import os
import re
from dataclasses import dataclass
from typing import Any, Dict, List

from _patchmill import InputError

from patchmill.batch.problem import BatchError
from patchmill.system import files as whole_files

ENDINGS = (".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".fcstd")
MAX_BYTES = 10_000_000
MAX_NESTING = 50


@dataclass(frozen=True)
class PartFile:
    """One part of a run: `name` is its folder's in the output, `file` its absolute path."""

    name: str
    file: str


@dataclass
class Recipe:
    """A recipe that fits the schema: `data` without its comments, `folder` that its names are relative
    to."""

    data: Dict[str, Any]
    folder: str
    parts: List[PartFile]

    @property
    def digest(self) -> str:
        """SHA-256 of what decides about a part's program: all but the list of parts and the limits."""
        kept = {k: v for k, v in self.data.items() if k not in ("parts", "limits", "name")}
        masks = [digest_of(self.inside(name)) for name in mask_images(self.data)]
        text = json.dumps([kept, masks], sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(text.encode()).hexdigest()

    def inside(self, name: str) -> str:
        """Absolute path of a file of the recipe's folder."""
        return inside(self.folder, name, "recipe")


def schemas_folder() -> str:
    """Where the published schemas are: Resources/schemas of this installation. Raises BatchError."""
    here = os.path.dirname(os.path.realpath(__file__))
    for up in (os.path.join(here, "..", ".."), os.path.join(here, "..", "..", "..")):
        folder = os.path.join(up, "Resources", "schemas")
        if os.path.isdir(folder):
            return os.path.realpath(folder)
    raise BatchError("installation", "Resources/schemas is missing", "install PatchMill again.")


def load(filename: str, parts: List[str]) -> Recipe:
    """The Recipe of a file. `parts`: files that the caller names instead of the recipe's own, or none.
    Raises BatchError naming the position in the file that is wrong."""
    data = checked(text_of(filename, "recipe", MAX_BYTES), filename)
    folder = os.path.dirname(os.path.abspath(filename))
    for name in mask_images(data):
        inside(folder, name, "%s: /operations/MaskImage" % filename)
    found = (
        [os.path.abspath(p) for p in parts] if parts else _named_parts(data["parts"], folder, filename)
    )
    for file in found:
        if not os.path.isfile(file):
            raise BatchError("part", file, "there is no such file.")
    return Recipe(data, folder, _with_names(found, folder))


def checked(text: str, filename: str) -> Dict[str, Any]:
    """The data of a recipe's text without its comments. Raises BatchError naming the position in it."""
    import jsonschema

    depth = max_nesting(text)
    if depth > MAX_NESTING:
        raise BatchError(
            filename, "nested %d deep" % depth, "a recipe is at most %d deep." % MAX_NESTING
        )
    try:
        data = json.loads(text, parse_constant=_refuse_constant)
    except (ValueError, RecursionError) as error:
        raise BatchError(filename, "no JSON", "%s." % error) from error
    with open(os.path.join(schemas_folder(), "recipe.schema.json"), encoding="utf-8") as file:
        validator = jsonschema.Draft7Validator(json.load(file))
    found = sorted(validator.iter_errors(data), key=lambda e: (list(map(str, e.path)), e.message))
    for wrong in found:
        where = "%s: /%s" % (filename, "/".join(str(p) for p in wrong.path))
        remedy = "it does not fit the schema: %s." % _short(wrong.message)
        raise BatchError(where, _short(wrong.instance), remedy)
    return dict(without_comments(data))


def max_nesting(text: str) -> int:
    """How deep brackets are nested in a JSON text, those in its strings apart."""
    deepest = depth = 0
    for bracket in re.sub(r'"(?:[^"\\]|\\.)*"', "", text):
        if bracket in "[{":
            depth += 1
            deepest = max(deepest, depth)
        elif bracket in "]}":
            depth -= 1
    return deepest


def _short(value: Any) -> str:
    text = value if isinstance(value, str) else json.dumps(value, ensure_ascii=True)
    return text if len(text) <= 120 else text[:117] + "..."


def _refuse_constant(name: str) -> None:
    raise ValueError("%s is no number of a recipe" % name)


def without_comments(data: Any) -> Any:
    """A recipe's data without the keys that begin with "//"."""
    if isinstance(data, dict):
        return {k: without_comments(v) for k, v in data.items() if not k.startswith("//")}
    if isinstance(data, list):
        return [without_comments(v) for v in data]
    return data


def mask_images(data: Dict[str, Any]) -> List[str]:
    """Names of the pictures that a recipe's operations read."""
    named = [op.get("properties", {}).get("MaskImage", "") for op in data["operations"]]
    return [name for name in named if isinstance(name, str) and name]


def digest_of(filename: str) -> str:
    """SHA-256 of a file's bytes. Raises BatchError if it cannot be read, or is a device or a pipe."""
    digest = hashlib.sha256()
    try:
        with whole_files.opened(filename) as file:
            for block in iter(lambda: file.read(1 << 20), b""):
                digest.update(block)
    except InputError as error:
        raise BatchError("file", filename, error.remedy) from error
    return digest.hexdigest()


def text_of(filename: str, where: str, most: int) -> str:
    """The text of a file of at most so many bytes. Raises BatchError naming `where` if it cannot be read, is
    a device or a pipe, or no UTF-8."""
    try:
        return str(whole_files.read_text(filename, where, most))
    except InputError as error:
        raise BatchError(where, filename, error.remedy) from error


def inside(folder: str, name: str, where: str) -> str:
    """Absolute path of `name` in `folder`. Raises BatchError if it is none that lies in it, links
    followed."""
    if "\0" in name or os.path.isabs(name) or ".." in name.replace("\\", "/").split("/"):
        raise BatchError(where, name, "give a name in the recipe's own folder, without '..'.")
    try:
        os.fsencode(name)
    except UnicodeEncodeError as error:  # half a character
        raise BatchError(where, name, "no file can have such a name.") from error
    path = os.path.join(folder, name)
    home = os.path.realpath(folder)
    if os.path.commonpath([home, os.path.realpath(path)]) != home:
        raise BatchError(where, name, "it is a link out of the recipe's folder.")
    return path


def _named_parts(names: List[str], folder: str, filename: str) -> List[str]:
    found: List[str] = []
    for number, name in enumerate(names):
        where = "%s: /parts/%d" % (filename, number)
        path = inside(folder, name, where)
        if os.path.isfile(path):
            files = [path]
        elif os.path.isdir(path):
            files = [os.path.join(path, f) for f in os.listdir(path) if f.lower().endswith(ENDINGS)]
        else:
            files = [f for f in glob.glob(path, recursive=True) if os.path.isfile(f)]
        if not files and not glob.has_magic(name):  # "*.step", "*.stp": a folder may have one of them
            raise BatchError(where, name, "there is no such file, or no part in that folder.")
        for file in files:
            inside(folder, os.path.relpath(file, folder), where)
        found += [f for f in sorted(files) if f not in found]
    if not found:
        raise BatchError("%s: /parts" % filename, ", ".join(names), "nothing here has such a name.")
    return found


def _with_names(files: List[str], folder: str) -> List[PartFile]:
    """Each file with a name that no other has: its own, with its folders where two are the same."""
    stems = [os.path.splitext(os.path.basename(f))[0] for f in files]
    named = []
    for file, stem in zip(files, stems):
        name = re.sub(r"[^A-Za-z0-9._-]", "_", stem).lstrip(".") or "part"
        if sum(s.lower() == stem.lower() for s in stems) > 1 or name != stem:
            relative = os.path.relpath(file, folder)
            name = "%s-%s" % (name[:80], hashlib.sha256(relative.encode()).hexdigest()[:8])
        named.append(PartFile(name[:100], file))
    return sorted(named, key=lambda p: p.name)
