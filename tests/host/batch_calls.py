"""A recipe, a folder of its own for each test, and calls of the command, for the tests of batches.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib
import io
import json
import os
import shutil
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MODULE = os.path.join(os.environ.get("PATCHMILL_BUILD", os.path.join(ROOT, "build")), "Mod", "PatchMill")
sys.path.insert(0, MODULE)

from patchmill.__main__ import main  # noqa: E402

STEP = os.path.join(ROOT, "Resources", "recipes", "xu2016", "block.step")
RECIPE = {
    "recipe": 1,
    "//": "a comment",
    "name": "three",
    "parts": ["*.step"],
    "tool": {"diameter": 2.0, "flutes": 2, "speed": 1000, "feed": 434.413},
    "operations": [
        {
            "texture": "Curved",
            "faces": "largest free-form",
            "properties": {"Spacing": 0.5, "PatchSide": 4, "PatchesX": 2, "PatchesY": 2, "Rotation": 10},
        }
    ],
    "outputs": ["picture"],
    "limits": {"seconds": 300, "memory_mib": 4000},
}


def call(*arguments):
    """(exit status, output) of the command."""
    said = io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        try:
            status = main(list(arguments))
        except SystemExit as ended:
            status = ended.code
    return status, said.getvalue()


class WithFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="batch-")
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, data, name="recipe.json"):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(data if isinstance(data, str) else json.dumps(data))
        return self.path(name)
