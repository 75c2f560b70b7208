"""Calls that tell what there is: machine files and example recipes.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import shutil
from typing import Any

from patchmill.batch import recipe
from patchmill.batch.problem import BatchError


def _resources(folder: str) -> str:
    return os.path.join(os.path.dirname(recipe.schemas_folder()), folder)


def machines(options: Any) -> int:
    """Prints the names of the machine files that are installed."""
    for name in sorted(os.listdir(_resources("machines"))):
        if name.endswith(".json"):
            print(name[:-5])
    return 0


def examples(options: Any) -> int:
    """Prints the names of the examples, or copies one into a folder. Raises BatchError."""
    folder = _resources("recipes")
    names = sorted(n for n in os.listdir(folder) if os.path.isdir(os.path.join(folder, n)))
    if options.name is None:
        print("\n".join(names))
        return 0
    if options.name not in names:
        raise BatchError("examples", options.name, "there are: %s." % ", ".join(names))
    target = options.folder or options.name
    if os.path.lexists(target):
        raise BatchError("examples", target, "it is there already: give another folder.")
    shutil.copytree(
        os.path.join(folder, options.name), target, ignore=shutil.ignore_patterns("__pycache__")
    )
    print(target)
    return 0
