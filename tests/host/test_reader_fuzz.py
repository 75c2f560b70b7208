"""Files of others that were damaged, by bytes and by values: machine files, recipes and pictures are read or
refused by a sentence, never by another exception. READER_CASES: so many of each (200), READER_SEED: others.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import copy
import json
import os
import pathlib
import random
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import numpy as np  # noqa: E402
from patchmill import InputError  # noqa: E402
from patchmill.batch import recipe  # noqa: E402
from patchmill.batch.problem import BatchError  # noqa: E402
from patchmill.machine import machines  # noqa: E402
from patchmill.textures import masks  # noqa: E402
from recipe import ROOT  # noqa: E402

CASES = int(os.environ.get("READER_CASES", "200"))
SEED = int(os.environ.get("READER_SEED", "23"))
VALUES = [
    None, True, 0, -1, 1e308, -1e308, 1e-320, 10**30, -(10**400), float("nan"), float("inf"), "", "\ud800",
    "\0", "../x", "/etc/passwd", "a" * 5000, "\u202e", [], {}, [[]], {"": {}}, [[[[[[[]]]]]]], "nan", "1e5",
]  # fmt: skip


def damaged_bytes(data, numbers):
    """Some of the bytes changed, doubled, taken away."""
    data = bytearray(data)
    for _ in range(numbers.randint(1, 8)):
        at = numbers.randrange(len(data) + 1)
        kind = numbers.randrange(4)
        if kind == 0 and at < len(data):
            data[at] = numbers.randrange(256)
        elif kind == 1:
            data[at:at] = bytes(numbers.randrange(256) for _ in range(numbers.randint(1, 6)))
        elif kind == 2:
            del data[at:at + numbers.randint(1, 30)]
        else:
            data[at:at] = data[at // 2:at // 2 + numbers.randint(1, 60)]
    return bytes(data)


def damaged_values(data, numbers):
    """JSON data with a value, or a few, replaced by one that nobody expects there."""
    data = copy.deepcopy(data)
    for _ in range(numbers.randint(1, 3)):
        at, value = data, copy.deepcopy(numbers.choice(VALUES))
        while True:
            keys = list(at) if isinstance(at, dict) else list(range(len(at)))
            if not keys:
                break
            key = numbers.choice(keys)
            if isinstance(at[key], (dict, list)) and at[key] and numbers.random() < 0.8:
                at = at[key]
                continue
            if numbers.random() < 0.1 and isinstance(at, dict):
                at["\ud800" if numbers.random() < 0.5 else "more"] = value
            else:
                at[key] = value
            break
    return json.dumps(data).encode()


class Damaged(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.numbers = random.Random(SEED)

    def each(self, file, good, read, refusal, as_json=True):
        """Reads so many damaged files; returns how many were refused."""
        refused = 0
        for number in range(CASES):
            by_value = as_json and number % 2
            damage = damaged_values if by_value else damaged_bytes
            data = damage(json.loads(good) if by_value else good, self.numbers)
            file.write_bytes(data)
            try:
                read()
            except refusal as error:
                refused += 1
                self.assertGreater(len(str(error)), 10)
                str(error).encode()  # can be shown
            except Exception as error:
                self.fail("%s: %s\n%r" % (type(error).__name__, error, data[:2000]))
        return refused

    def test_machine_files(self):
        shipped = ROOT / "Resources" / "machines"
        with mock.patch.dict(os.environ, PATCHMILL_MACHINES=str(self.folder)):
            for name in ("table-table-ac", "nutating-head-bc-45", "linuxcnc-mill"):
                good = (shipped / (name + ".json")).read_bytes()
                file = self.folder / "damaged.json"

                def read():
                    machine = machines.load("damaged")
                    machine.model, machine.kinematics, machine.start_phase, machine.controller

                self.assertGreater(self.each(file, good, read, InputError), 0.5 * CASES, name)

    def test_recipes(self):
        good = (ROOT / "Resources" / "recipes" / "batch" / "mould.json").read_bytes()
        data = json.loads(good)
        (self.folder / "part.brep").write_text("")
        data["parts"] = ["part.brep", "*.brep"]
        file = self.folder / "recipe.json"
        refused = self.each(
            file, json.dumps(data).encode(), lambda: recipe.load(str(file), []).digest, BatchError
        )
        self.assertGreater(refused, 0.3 * CASES)

    def test_pictures(self):
        from matplotlib import image

        file = self.folder / "mask.png"
        image.imsave(str(file), np.linspace(0, 1, 600).reshape(20, 30), cmap="gray")
        good = file.read_bytes()
        refused = self.each(file, good, lambda: masks.read_grey(str(file)), InputError, as_json=False)
        self.assertGreater(refused, 0.3 * CASES)


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
