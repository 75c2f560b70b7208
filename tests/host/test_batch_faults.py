"""Faults while the folder of a run is written, and files that never end where one is read: each part is there
whole, as it was or as it is now, with its document and its program; nothing else is left, and what went wrong
is one sentence.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import errno
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

from batch_calls import MODULE, RECIPE, STEP, WithFolder, call  # first: it finds the module

from patchmill.batch import compare, recipe
from patchmill.batch.outputs import OutputFolder
from patchmill.batch.problem import BatchError

FILES = ("part.FCStd", "program.ngc")
NOBODY = 65534
SECONDS = 60  # of waiting for a pipe


class Folder(WithFolder):
    """A part of a run that is made again."""

    def setUp(self):
        super().setUp()
        os.chmod(self.folder, 0o755)
        self.out = self.path("out")
        self.make("old")

    def make(self, version):
        """Makes the part, as a run does."""
        with OutputFolder(self.out) as out:
            working = out.working_folder("part")
            for name in FILES:
                with open(os.path.join(working, name), "w", encoding="ascii") as file:
                    file.write(version)
            out.keep("part", working, {"key": version, "files": list(FILES)})
            out.write("index.json", version)

    def holds(self, *versions, beside=()):
        """One of these versions is there, whole, and nothing is beside it but names that begin so."""
        with OutputFolder(self.out) as out:
            self.assertEqual(sum(out.known("part", version) is not None for version in versions), 1)
        part = self.path("out", "parts", "part")
        contents = set()
        for name in FILES:
            with open(os.path.join(part, name), encoding="ascii") as file:
                contents.add(file.read())
        self.assertEqual(len(contents), 1)
        self.assertIn(contents.pop(), versions)
        self.assertEqual(sorted(os.listdir(part)), sorted((*FILES, "result.json")))
        names = [name for name in os.listdir(self.out) if not name.startswith(tuple(beside))]
        self.assertEqual(sorted(names), ["index.json", "parts"])
        self.assertEqual(os.listdir(self.path("out", "parts")), ["part"])

    def killed(self, step, after):
        """Makes the new version in a process that kills itself at a step; how that ended."""
        real = getattr(os, step)

        def die(*arguments, **named):
            if after:
                real(*arguments, **named)
            os.kill(os.getpid(), signal.SIGKILL)

        child = os.fork()
        if child == 0:
            with mock.patch.object(os, step, die):
                self.make("new")
            os._exit(0)
        return os.WTERMSIG(os.waitpid(child, 0)[1])

    def test_killed_at_any_step(self):
        for step in ("fsync", "rename", "replace"):
            for after in (False, True):
                with self.subTest(step, after=after):
                    self.assertEqual(self.killed(step, after), signal.SIGKILL)
                    self.holds("old", "new", beside=[".patchmill-"])
                    for name in os.listdir(self.out):
                        os.utime(self.path("out", name), (0.0, 0.0))  # long ago
                    self.make("old")
                    self.holds("old")

    def test_killed_between_the_old_one_and_the_new_one(self):
        real, moved = os.rename, []

        def rename(*names):
            if moved:
                os.kill(os.getpid(), signal.SIGKILL)
            moved.append(real(*names))

        child = os.fork()
        if child == 0:
            with mock.patch.object(os, "rename", rename):
                self.make("new")
            os._exit(0)
        self.assertEqual(os.WTERMSIG(os.waitpid(child, 0)[1]), signal.SIGKILL)
        self.assertEqual(os.listdir(self.path("out", "parts")), [])
        self.holds("old")

    def test_a_move_that_fails(self):
        for failing in (1, 2):
            real, moves = os.rename, []

            def rename(*names, real=real, moves=moves, failing=failing):
                moves.append(names)
                if len(moves) == failing:
                    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
                return real(*names)

            with self.assertRaises(BatchError) as caught, mock.patch.object(os, "rename", rename):
                self.make("new")
            self.assertIn("No space left", str(caught.exception))
            self.holds("old")

    def test_a_full_disk(self):
        before = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        limits = resource.getrlimit(resource.RLIMIT_FSIZE)
        try:
            with self.assertRaises(BatchError) as caught, OutputFolder(self.out) as out:
                working = out.working_folder("part")
                resource.setrlimit(resource.RLIMIT_FSIZE, (10, limits[1]))
                out.keep("part", working, {"key": "new", "files": []})
            self.assertRegex(str(caught.exception), r"^[^\n]+\.$")
            with self.assertRaises(BatchError), OutputFolder(self.out) as out:
                out.write("index.json", 100 * "new")
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)
            signal.signal(signal.SIGXFSZ, before)
        self.holds("old")

    def test_a_folder_that_is_read_only(self):
        read, write = os.pipe()
        child = os.fork()
        if child == 0:
            for folder in (self.out, self.path("out", "parts")):
                os.chmod(folder, 0o555)
            if os.geteuid() == 0:  # may write everywhere
                os.setresuid(NOBODY, NOBODY, NOBODY)
            try:
                self.make("new")
            except BatchError as error:
                os.write(write, str(error).encode())
            os._exit(0)
        os.close(write)
        with os.fdopen(read) as pipe:
            self.assertRegex(pipe.read(), r"^output folder: [^\n]+Permission denied\.$")
        os.waitpid(child, 0)
        for folder in (self.out, self.path("out", "parts")):
            os.chmod(folder, 0o755)
        self.holds("old")

    def test_two_writers(self):
        with OutputFolder(self.out):
            with self.assertRaises(BatchError) as caught:
                self.make("new")
        self.assertIn("another run", str(caught.exception))
        self.holds("old")

    def test_a_link_in_the_place_of_the_part(self):
        shutil.move(self.path("out", "parts", "part"), self.path("elsewhere"))
        os.symlink(self.path("elsewhere"), self.path("out", "parts", "part"))
        with self.assertRaises(BatchError) as caught:
            self.make("new")
        self.assertIn("link", str(caught.exception))
        with open(self.path("elsewhere", FILES[0]), encoding="ascii") as file:
            self.assertEqual(file.read(), "old")

    def test_a_pipe_in_the_place_of_a_result(self):
        name = self.path("out", "parts", "part", "result.json")
        os.unlink(name)
        os.mkfifo(name)
        with OutputFolder(self.out) as out:
            self.assertIsNone(out.known("part", "old"))
        self.make("new")
        self.holds("new")


class Pipes(WithFolder):
    """What is read and might never end is refused at once; a call that waited would be ended by its time."""

    def refused(self, *arguments):
        ended = subprocess.run(
            [sys.executable, "-m", "patchmill", *arguments],
            env=dict(os.environ, PYTHONPATH=MODULE),
            capture_output=True,
            text=True,
            timeout=SECONDS,
        )
        self.assertEqual(ended.returncode, 2, ended)
        self.assertRegex(ended.stderr, r"^patchmill: [^\n]+ a device or a pipe[^\n]*\.\n$")

    def test_are_refused(self):
        shutil.copy(STEP, self.path("a.step"))
        os.mkfifo(self.path("pipe"))
        good, out = self.write(RECIPE), self.path("out")
        masked = json.loads(json.dumps(RECIPE))
        masked["operations"][0]["properties"]["MaskImage"] = "pipe"
        for name in (self.path("pipe"), "/dev/zero"):
            self.refused("run", name, "-o", out)
            self.refused("run", good, "-o", out, "--compare", name)
            self.refused("compare", name, name)
        self.refused("run", self.write(masked, "masked.json"), "-o", out)
        os.makedirs(out)
        os.rename(self.path("pipe"), self.path("out", "index.json"))
        self.refused("report", out)

    def test_directories_are_no_files(self):
        for call_of in (lambda: recipe.load(self.folder, []), lambda: compare.load(self.folder)):
            with self.assertRaises(BatchError) as caught:
                call_of()
            self.assertIn("directory", str(caught.exception))


class Temporary(WithFolder):
    def test_no_folder_for_temporary_files(self):
        """A run needs one for FreeCAD's home, and says so."""
        shutil.copy(STEP, self.path("a.step"))
        nowhere = mock.patch.object(tempfile, "tempdir", self.path("none"))
        with nowhere:
            status, said = call("run", self.write(RECIPE), "-o", self.path("out"))
        self.assertEqual(status, 1, said)
        self.assertRegex(said, r"^patchmill: [^\n]+: No such file or directory\.\n$")


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
