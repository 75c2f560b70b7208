"""Recipes and runs as a user of the command meets them: refusals by name, three parts of which one is
broken and one takes too long, a run that is killed and goes on.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time
import unittest

from batch_calls import MODULE, RECIPE, STEP, WithFolder, call  # first: it finds the module

import jsonschema
from patchmill.batch import compare, index, recipe
from patchmill.batch.problem import BatchError


class Refusals(WithFolder):
    """Each refused by name, and nothing written."""

    def refused(self, data, word):
        with self.assertRaises(BatchError) as caught:
            recipe.load(self.write(data), [])
        self.assertIn(word, str(caught.exception))

    def test_names_outside_the_folder(self):
        shutil.copy(STEP, self.path("a.step"))
        os.symlink("/etc/hostname", self.path("link.step"))
        os.mkdir(self.path("sub"))
        os.symlink("/etc", self.path("sub", "etc"))
        for name in (
            "../a.step",
            "/etc/hostname",
            "link.step",
            "sub/etc/hostname",
            "sub/../../a.step",
            "..",
            "sub\\..\\x",
        ):
            self.refused(dict(RECIPE, parts=[name]), name.replace("\\", "\\"))
        mask = json.loads(json.dumps(RECIPE))
        mask["operations"][0]["properties"]["MaskImage"] = "../secret.png"
        self.refused(mask, "../secret.png")

    def test_what_does_not_fit_the_schema(self):
        for change, word in (
            ({"parts": []}, "/parts"),
            ({"recipe": 2}, "/recipe"),
            ({"tool": {"diameter": -1}}, "/tool/diameter"),
            ({"machine": "../m"}, "/machine"),
            ({"post": "os; import x"}, "/post"),
            ({"offset": "G53"}, "/offset"),
            ({"operations": [{"texture": "Curved", "faces": "Face0"}]}, "/operations/0/faces"),
            ({"surprise": 1}, "surprise"),
        ):
            self.refused(dict(RECIPE, **change), word)

    def test_no_json_at_all(self):
        for text in (
            "",
            "[",
            "[" * 100000,
            "\x00",
            "NaN",
            '{"recipe": NaN}',
            '{"recipe": 1e999}',
            "1" * 5000,
        ):
            with self.assertRaises(BatchError):
                recipe.load(self.write(text), [])
        with open(self.path("latin.json"), "wb") as file:
            file.write(b'{"name": "\xe4"}')
        with self.assertRaises(BatchError):
            recipe.load(self.path("latin.json"), [])

    def test_mutated_recipes_are_refused_or_read(self):
        shutil.copy(STEP, self.path("a.step"))
        before = sorted(os.listdir(self.folder) + ["recipe.json"])
        text, chance = json.dumps(RECIPE), random.Random(1)
        for _ in range(10000):
            letters = list(text)
            for _ in range(chance.randint(1, 4)):
                k = chance.randrange(len(letters))
                letters[k] = chance.choice(
                    ['"', "{", "}", "[", "]", ",", ".", "/", "\\", "0", "-", "é", "\x00", ""]
                )
            try:
                found = recipe.load(self.write("".join(letters)), [])
            except BatchError:
                continue
            for part in found.parts:
                self.assertEqual(os.path.dirname(part.file), self.folder)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_links_in_the_output_folder(self):
        shutil.copy(STEP, self.path("a.step"))
        name = self.write(RECIPE)
        for link in ("parts", ".work", "parts/a", "index.json"):
            out, elsewhere = self.path("out"), self.path("elsewhere")
            os.makedirs(os.path.join(out, os.path.dirname(link)))
            os.makedirs(elsewhere)
            os.symlink(elsewhere, os.path.join(out, link))
            status, said = call("run", name, "-o", out)
            self.assertEqual((status, os.listdir(elsewhere)), (2, []), said)
            self.assertIn("link", said)
            shutil.rmtree(out)
            shutil.rmtree(elsewhere)

    def test_wrong_calls(self):
        name = self.write(RECIPE)
        self.assertEqual(call("run", name)[0], 2)
        self.assertEqual(call("run", name, "-o", self.path("out"), "-j", "0")[0], 2)
        self.assertEqual(call("run", self.path("none.json"), "-o", self.path("out"))[0], 2)
        self.assertEqual(call("frob")[0], 2)


class Names(WithFolder):
    def test_a_pattern_may_be_of_nothing_but_not_all(self):
        name = self.write(dict(RECIPE, parts=["*.step", "*.stp"]))
        with self.assertRaises(BatchError) as caught:
            recipe.load(name, [])
        self.assertIn("*.step, *.stp", str(caught.exception))
        shutil.copy(STEP, self.path("a.step"))
        self.assertEqual([p.name for p in recipe.load(name, []).parts], ["a"])
        with self.assertRaises(BatchError):
            recipe.load(self.write(dict(RECIPE, parts=["*.step", "b.step"])), [])

    def test_equal_names_in_two_folders_stay_apart(self):
        for sub in ("a", "b"):
            os.mkdir(self.path(sub))
            shutil.copy(STEP, self.path(sub, "x.step"))
        found = recipe.load(self.write(dict(RECIPE, parts=["a", "b"])), [])
        self.assertEqual(len({p.name for p in found.parts}), 2)

    def test_the_digest_is_of_what_decides_about_the_program(self):
        shutil.copy(STEP, self.path("a.step"))
        one = recipe.load(self.write(RECIPE), []).digest
        limits = recipe.load(self.write(dict(RECIPE, limits={"seconds": 1})), []).digest
        tool = recipe.load(self.write(dict(RECIPE, tool={"diameter": 3.0})), []).digest
        self.assertEqual(one, limits)
        self.assertNotEqual(one, tool)


class Runs(WithFolder):
    """One part that can be milled twice over, a broken one, and one whose time is up."""

    def setUp(self):
        super().setUp()
        shutil.copy(STEP, self.path("a.step"))
        with open(self.path("broken.step"), "w") as file:
            file.write("ISO-10303-21;\nthis is no part\n")
        self.recipe = self.write(RECIPE)

    def index(self, out):
        found = compare.load(self.path(out, "index.json"))
        with open(os.path.join(recipe.schemas_folder(), "index.schema.json"), encoding="utf-8") as file:
            jsonschema.Draft7Validator(json.load(file)).validate(found)
        return index.without_times(found)

    def test_killed_and_resumed_is_as_left_alone(self):
        status, said = call("run", self.recipe, "-o", self.path("whole"), "-j", "2")
        self.assertEqual(status, 1, said)
        self.assertIn("failed: broken", said)
        whole = self.index("whole")
        self.assertEqual(
            [(p["name"], p["status"]) for p in whole["parts"]], [("a", "done"), ("broken", "refused")]
        )
        self.assertEqual(whole["parts"][0]["dimples"], 64)
        self.assertEqual(sorted(os.listdir(self.path("whole"))), ["index.html", "index.json", "parts"])
        for seconds in (1.0, 4.0):
            self.killed_after(seconds)
        status, said = call("run", self.recipe, "-o", self.path("killed"), "--resume")
        self.assertEqual((status, self.index("killed")), (1, whole), said)
        status, said = call(
            "run",
            self.recipe,
            "-o",
            self.path("killed"),
            "--resume",
            "--compare",
            self.path("whole", "index.json"),
        )
        self.assertNotIn("changed", said)
        self.assertEqual(
            call("compare", self.path("whole", "index.json"), self.path("killed", "index.json"))[0], 0
        )

    def killed_after(self, seconds):
        environment = dict(os.environ, PYTHONPATH=MODULE)
        arguments = ["-m", "patchmill", "run", self.recipe, "-o", self.path("killed"), "--resume"]
        process = subprocess.Popen(
            [sys.executable] + arguments, env=environment, stdout=subprocess.DEVNULL
        )
        time.sleep(seconds)
        process.send_signal(signal.SIGKILL)
        process.wait()

    def test_over_the_limits(self):
        os.unlink(self.path("broken.step"))
        for limits, status in (({"seconds": 0.5}, "time"), ({"memory_mib": 64}, "memory")):
            name = self.write(dict(RECIPE, limits=limits))
            self.assertEqual(call("run", name, "-o", self.path(status))[0], 1)
            part = self.index(status)["parts"][0]
            self.assertEqual(part["status"], status)
            self.assertIn("limit", part["reason"])
        changed = call("compare", self.path("time", "index.json"), self.path("memory", "index.json"))
        self.assertEqual((changed[0], changed[1].count("changed: a")), (1, 1))


if __name__ == "__main__":
    unittest.main()
