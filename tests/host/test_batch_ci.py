"""The workflow files and the Slurm script that users copy: their steps are run here as they stand, where a
step needs neither a network nor a container. Two parts at a time, and six runs at once over one user folder,
give the same bytes as one by one.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import shutil
import subprocess
import unittest

from batch_calls import MODULE, RECIPE, ROOT, STEP, WithFolder, call  # first: it finds the module

import yaml
from patchmill.batch import compare, index


class WithCommand(WithFolder):
    """A folder with parts, a small recipe, and the command on PATH."""

    def setUp(self):
        super().setUp()
        self.assertEqual(call("examples", "ci", self.path("ci"))[0], 0)
        shutil.copy(STEP, self.path("ci", "block.step"))
        self.write(dict(RECIPE, outputs=[]), os.path.join("ci", "mould.json"))
        os.makedirs(self.path("bin"))
        os.symlink(os.path.join(ROOT, "tools", "patchmill"), self.path("bin", "patchmill"))
        path = self.path("bin") + os.pathsep + os.environ["PATH"]
        build = os.path.dirname(os.path.dirname(MODULE))
        self.environment = dict(os.environ, PATH=path, PATCHMILL_BUILD=build)

    def start(self, script, **more):
        return subprocess.Popen(
            ["bash", "-euo", "pipefail", "-c", script],
            cwd=self.path("ci"),
            env=dict(self.environment, **more),
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )

    def step(self, script, **more):
        """(exit status, output) of one step's script."""
        process = self.start(script, **more)
        said, _ = process.communicate()
        return process.returncode, said

    def workflow(self, name):
        with open(self.path("ci", name), encoding="utf-8") as file:
            return yaml.safe_load(file)

    def index(self, *names):
        return index.without_times(compare.load(self.path("ci", *names)))


class Workflows(WithCommand):
    def passes_then_fails(self, script):
        """A part as before passes; changed, it fails with the reason."""
        status, said = self.step("patchmill run mould.json -o expected")
        self.assertEqual(status, 0, said)
        status, said = self.step(script)
        self.assertEqual(status, 0, said)
        with open(self.path("ci", "block.step"), "a", encoding="ascii") as file:
            file.write("/* changed */")
        with open(self.path("ci", "expected", "index.json"), encoding="utf-8") as file:
            expected = json.load(file)
        expected["parts"][0]["dimples"] += 1
        with open(self.path("ci", "expected", "index.json"), "w", encoding="utf-8") as file:
            json.dump(expected, file)
        status, said = self.step(script)
        self.assertEqual(status, 1, said)
        self.assertIn("changed: block: dimples 65 before, 64 now", said)

    def test_github(self):
        steps = self.workflow("github.yml")["jobs"]["textures"]["steps"]
        scripts = [s["run"] for s in steps if "run" in s]
        self.assertEqual([s.split()[1] for s in scripts], ["doctor", "run"])
        self.assertEqual(self.step(scripts[0])[0], 0)
        self.passes_then_fails(scripts[1])

    def test_gitlab(self):
        scripts = self.workflow("gitlab-ci.yml")["textures"]["script"]
        github = self.workflow("github.yml")["jobs"]["textures"]["steps"]
        self.assertEqual(scripts, [s["run"] for s in github if "run" in s])  # which are run above

    def test_matrix_and_slurm(self):
        shutil.copy(STEP, self.path("ci", "lid.step"))
        job = self.workflow("github-matrix.yml")["jobs"]["textures"]
        script = next(s["run"] for s in job["steps"] if "run" in s)
        for number, part in enumerate(job["strategy"]["matrix"]["part"]):
            status, said = self.step(script, PART=part)
            self.assertEqual(status, 0, said)
            status, said = self.step("./slurm.sh", SLURM_ARRAY_TASK_ID=str(number + 1))
            self.assertEqual(status, 0, said)
            one = self.index("out-" + part, "index.json")
            self.assertEqual(one, self.index("out", part, "index.json"))
            self.assertEqual([p["name"] for p in one["parts"]], [part])


class SideBySide(WithCommand):
    def programs(self, out):
        found = {}
        for name in sorted(os.listdir(self.path("ci", out, "parts"))):
            with open(self.path("ci", out, "parts", name, "program.ngc"), "rb") as file:
                found[name] = file.read()
        return found

    def test_two_at_a_time_as_one_by_one(self):
        for name in ("lid", "base"):
            shutil.copy(STEP, self.path("ci", name + ".step"))
        for jobs in ("1", "2"):
            status, said = self.step("patchmill run mould.json -o j%s -j %s" % (jobs, jobs))
            self.assertEqual(status, 0, said)
        self.assertEqual(self.index("j1", "index.json"), self.index("j2", "index.json"))
        self.assertEqual(self.programs("j1"), self.programs("j2"))

    def test_six_runs_over_one_user_folder(self):
        home = self.path("home")
        os.makedirs(home)
        runs = [
            self.start("patchmill run mould.json -o six%d" % k, FREECAD_USER_HOME=home, HOME=home)
            for k in range(6)
        ]
        for process in runs:
            said, _ = process.communicate()
            self.assertEqual(process.returncode, 0, said)
        first = self.index("six0", "index.json"), self.programs("six0")
        for k in range(1, 6):
            self.assertEqual((self.index("six%d" % k, "index.json"), self.programs("six%d" % k)), first)


if __name__ == "__main__":
    unittest.main()
