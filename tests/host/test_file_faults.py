"""Faults while files are written, of every kind that PatchMill writes: the old file or the new one is there,
whole, nothing else is left, and what could not be written is said in a sentence.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib
import os
import pathlib
import resource
import signal
import stat
import sys
import tempfile
import time
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
from file_writers import writers  # noqa: E402
from patchmill import InputError  # noqa: E402
from patchmill.system import files  # noqa: E402

NOBODY = 65534
IN_MEMORY = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None  # syncing is quick there
STEPS = ["fchmod", "fsync", "link", "replace", "unlink"]  # of writing: it is killed before and after each


def said(write, path, version):
    """What a writer says: '' if it wrote its file."""
    try:
        return write(str(path), version) or ""
    except InputError as error:
        return str(error)


def in_child(call):
    """What `call` returns, in a process of its own, and how that ended."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        text = "nothing"
        try:
            text = call()
        except BaseException as error:  # must not go on as a second FreeCAD
            text = "%s: %s" % (type(error).__name__, error)
        finally:
            os.write(write, text.encode())
            os._exit(0)
    os.close(write)
    with os.fdopen(read) as pipe:
        text = pipe.read()
    return text, os.WTERMSIG(os.waitpid(child, 0)[1])


@contextlib.contextmanager
def longest(size):
    """No file can be longer than `size` bytes: as on a disk that is full."""
    before, limits = signal.signal(signal.SIGXFSZ, signal.SIG_IGN), resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        signal.signal(signal.SIGXFSZ, before)


class Faults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.writers = writers()

    @classmethod
    def tearDownClass(cls):
        for document in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(document)

    def each(self, check):
        """`check(function, old content, new content)` for each kind of file; self.path is the old one's."""
        for kind, (name, write) in self.writers.items():
            with self.subTest(kind), tempfile.TemporaryDirectory(dir=IN_MEMORY) as folder:
                self.path = pathlib.Path(folder, "there", name)
                self.path.parent.mkdir()
                contents = []
                for version in (1, 0):
                    self.assertEqual(said(write, self.path, version), "")
                    contents.append(self.path.read_bytes())
                new, old = contents
                self.assertNotEqual(old, new)
                self.names = set(os.listdir(self.path.parent))
                check(write, old, new)

    def holds(self, *contents):
        """The file is one of these, and nothing is beside it but what was."""
        self.assertIn(self.path.read_bytes(), contents)
        self.assertEqual(set(os.listdir(self.path.parent)), self.names)

    def sentence(self, text, why="written"):
        """One sentence, and the file or the reason in it."""
        self.assertRegex(text, r"^[^\n]{20,400}\.$")
        self.assertTrue(why in text or "could not be written" in text, text)

    def test_a_full_disk(self):
        def check(write, old, new):
            for named in (False, True):
                for share in (0.0, 0.5, 1.0):
                    with mock.patch.object(os, "O_TMPFILE", -1 if named else os.O_TMPFILE):
                        with longest(max(0, int(share * len(new)) - 1)):
                            self.sentence(said(write, self.path, 1))
                    self.holds(old)

        self.each(check)

    def test_killed_at_any_step(self):
        def check(write, old, new):
            for step in STEPS:
                for after in (False, True):
                    for named in (False, True):
                        self.killed(write, step, after, named)
                        self.assertIn(self.path.read_bytes(), (old, new), step)
                        for name in os.listdir(self.path.parent):
                            long_ago = time.time() - 2.0 * files.OLD
                            os.utime(self.path.parent / name, (long_ago, long_ago))
                        self.assertEqual(said(write, self.path, 0), "")
                        self.holds(old)

        self.each(check)

    def killed(self, write, step, after, named):
        """Writes the new version in a process that kills itself at a step, if it comes to that."""
        real = getattr(os, step)

        def die(*arguments, **named):
            if after:
                real(*arguments, **named)
            os.kill(os.getpid(), signal.SIGKILL)

        def call():
            with mock.patch.object(os, "O_TMPFILE", -1 if named else os.O_TMPFILE):
                with mock.patch.object(os, step, die):
                    return said(write, self.path, 1)

        text, ended = in_child(call)
        if step != "unlink" and not (named and step == "link"):
            self.assertEqual((text, ended), ("", signal.SIGKILL), (step, named))

    def test_a_slow_writer_keeps_its_file(self):
        with tempfile.TemporaryDirectory(dir=IN_MEMORY) as folder:
            slow, quick = os.path.join(folder, "slow"), os.path.join(folder, "quick")
            with mock.patch.object(os, "O_TMPFILE", -1), files.replacing(slow) as file:
                file.write(b"begun, ")
                os.utime(file.name, (0.0, 0.0))  # long ago
                files.write(quick, "meanwhile")
                file.write(b"ended")
            self.assertEqual(pathlib.Path(slow).read_bytes(), b"begun, ended")
            self.assertEqual(sorted(os.listdir(folder)), ["quick", "slow"])

    def test_two_writers(self):
        def check(write, old, new):
            children = []
            for version in (0, 1):
                child = os.fork()
                if child == 0:
                    for _ in range(6):
                        said(write, self.path, version)
                    os._exit(0)
                children.append(child)
            while children:
                self.assertIn(self.path.read_bytes(), (old, new))
                if os.waitpid(children[0], os.WNOHANG)[0]:
                    children.pop(0)
            self.holds(old, new)

        self.each(check)

    def test_read_only(self):
        def check(write, old, new):
            self.path.chmod(0o444)
            self.sentence(said(write, self.path, 1), "read-only")
            self.holds(old)
            self.path.chmod(0o644)

        self.each(check)

    def test_a_folder_that_is_read_only(self):
        def check(write, old, new):
            for folder in (self.path.parent, *self.path.parents[1:2]):
                folder.chmod(0o755)
            self.path.chmod(0o666)
            self.path.parent.chmod(0o555)

            def call():
                if os.geteuid() == 0:  # may write everywhere
                    os.setresuid(NOBODY, NOBODY, NOBODY)
                return said(write, self.path, 1)

            self.sentence(in_child(call)[0], "written to")
            self.holds(old)
            self.path.parent.chmod(0o755)

        self.each(check)

    def test_no_folder_for_temporary_files(self):
        def check(write, old, new):
            nowhere = mock.patch.dict(os.environ, TMPDIR="/nowhere", TEMP="/nowhere", TMP="/nowhere")
            with nowhere, mock.patch.object(tempfile, "tempdir", None):
                with mock.patch.object(tempfile, "_candidate_tempdir_list", return_value=["/nowhere"]):
                    self.assertEqual(said(write, self.path, 1), "")
            self.holds(new)

        self.each(check)

    def test_links(self):
        def check(write, old, new):
            there = self.path.parent.parent / "elsewhere"
            there.mkdir()
            os.replace(self.path, there / "target")
            self.path.symlink_to(there / "target")
            self.assertEqual(said(write, self.path, 1), "")
            self.assertTrue(self.path.is_symlink())
            self.assertEqual(os.listdir(there), ["target"])
            self.holds(new)
            self.path.unlink()
            self.path.symlink_to(self.path.name)  # to itself
            self.sentence(said(write, self.path, 1), "no such file")

        self.each(check)

    def test_pipes_and_devices(self):
        def check(write, old, new):
            self.path.unlink()
            os.mkfifo(self.path)
            self.sentence(said(write, self.path, 1), "pipe")
            self.assertTrue(stat.S_ISFIFO(self.path.stat().st_mode))
            self.path.unlink()
            self.path.symlink_to("/dev/full")
            self.sentence(said(write, self.path, 1), "device")
            self.assertEqual(set(os.listdir(self.path.parent)), self.names)

        self.each(check)


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
