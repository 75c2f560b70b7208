"""Whatever happens while a file is written, the old one or the new one is there, whole, and nothing else.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import pathlib
import re
import resource
import signal
import stat
import subprocess
import tempfile
import threading
import time
import unittest
from unittest import mock

from patchmill import InputError
from patchmill.machine import machines, schema
from patchmill.system import files

OLD, NEW = b"old\n" * 1000, b"new, and longer\n" * 100000


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.name = os.path.join(folder.name, "x.ngc")
        files.write(self.name, OLD)

    def holds(self, *contents):
        """The file is one of these, and alone in its folder."""
        with open(self.name, "rb") as file:
            self.assertIn(file.read(), contents)
        self.assertEqual(os.listdir(self.folder), ["x.ngc"])

    def refused(self, name, function, *arguments):
        with self.assertRaises(InputError) as caught:
            function(*arguments)
        self.assertEqual(caught.exception.property, name, caught.exception)
        return str(caught.exception)

    def test_mode_is_kept_and_a_new_file_follows_the_mask(self):
        os.chmod(self.name, 0o640)
        files.write(self.name, NEW)
        self.assertEqual(stat.S_IMODE(os.stat(self.name).st_mode), 0o640)
        self.holds(NEW)
        before = os.umask(0o027)
        self.addCleanup(os.umask, before)
        os.remove(self.name)
        files.write(self.name, "text with µ")
        self.assertEqual(stat.S_IMODE(os.stat(self.name).st_mode), 0o640)
        self.holds("text with µ".encode())

    def test_a_link_is_written_where_it_points(self):
        with tempfile.TemporaryDirectory() as other:
            target = os.path.join(other, "target")
            os.remove(self.name)
            os.symlink(target, self.name)
            for content in (OLD, NEW):  # at first it points to nothing
                files.write(self.name, content)
                self.assertTrue(os.path.islink(self.name))
                self.holds(content)
                self.assertEqual(os.listdir(other), ["target"])

    def test_a_fixed_name_beside_it_is_not_touched(self):
        with tempfile.TemporaryDirectory() as other:
            victim = os.path.join(other, "victim")
            with open(victim, "wb") as file:
                file.write(OLD)
            os.symlink(victim, self.name + ".part")
            files.write(self.name, NEW)
            with open(victim, "rb") as file:
                self.assertEqual(file.read(), OLD)
            os.remove(self.name + ".part")
        self.holds(NEW)

    def test_what_is_no_file_or_may_not_be_written_is_refused(self):
        os.chmod(self.name, 0o444)
        self.assertIn("read-only", self.refused("filename", files.write, self.name, NEW))
        self.holds(OLD)
        os.remove(self.name)
        os.mkfifo(self.name)
        self.assertIn("pipe", self.refused("filename", files.write, self.name, NEW))
        self.assertTrue(stat.S_ISFIFO(os.stat(self.name).st_mode))
        bad = ["", "/dev/null", self.folder, os.path.join(self.folder, "no", "x"), "a\0b"]
        for name in [*bad, os.path.join(self.folder, "n" * 300), os.path.join(self.folder, "\udc80" * 256)]:
            self.refused("filename", files.write, name, NEW)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_what_never_ends_is_not_read(self):
        """A pipe that nobody writes into, a device, and a number, which would be an open file's."""
        os.remove(self.name)
        os.mkfifo(self.name)
        for name, said in ((self.name, "pipe"), ("/dev/zero", "device"), (0, "name"), (None, "name")):
            self.assertIn(said, self.refused("Program", files.read_text, name, "Program"))
        self.assertIn("directory", self.refused("Program", files.read_text, self.folder, "Program"))
        os.remove(self.name)

    def test_nothing_else_writes_files(self):
        """But batches, into folders that they have made, and the script that draws the pictures of docs/."""
        wanted = {"batch/answer.py", "batch/process.py", "reports/dcm_plots.py"}
        writes = r'open\([^()]*, ?"[rb]*[wax+][^"]*"|write_(text|bytes)\(|savefig\(os|copyfile|truncate\('
        found = set()
        root = pathlib.Path(__file__).resolve().parents[2]
        for folder in (root / "src" / "patchmill", root / "Gui" / "patchmill_gui"):
            for file in folder.rglob("*.py"):
                text = file.read_text(encoding="utf-8").replace("archive.open(", "")
                if re.search(writes, text):
                    found.add(file.relative_to(folder).as_posix())
        self.assertEqual(found, wanted)

    def test_what_is_no_text_is_said_to_be_none(self):
        text = "G0 X1\nM2\n"
        wide = text.encode("utf-16"), text.encode("utf-16-le")
        for content in (*wide, b"\0" * 9 + text.encode(), b"G0\0X1"):
            with open(self.name, "wb") as file:
                file.write(content)
            for other in (None, "latin-1"):
                said = self.refused("Program", files.read_text, self.name, "Program", 1000, other)
                self.assertIn("byte %d is zero" % content.index(0), said)
        files.write(self.name, text.encode("utf-8-sig"))  # a byte order mark is none of the text
        self.assertEqual(files.read_text(self.name), text)

    def test_names_of_every_kind(self):
        for name in (pathlib.Path(self.name), os.fsencode(self.name), self.name + "\udce4"):
            files.write(name, "text")
            self.assertEqual(files.read_text(name), "text")

    def test_a_full_disk_leaves_the_old_one(self):
        for named in (False, True):
            with mock.patch.object(os, "O_TMPFILE", -1 if named else os.O_TMPFILE):
                self.assertEqual(self._in_child(1 << 16), "cannot be written")
            self.holds(OLD)

    def _in_child(self, most_bytes):
        """What a process says whose files cannot be longer."""
        read, write = os.pipe()
        child = os.fork()
        if child == 0:
            said = "written"
            try:
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, most_bytes))
                files.write(self.name, NEW)
            except InputError as error:
                said = "cannot be written" if "cannot be written" in str(error) else str(error)
            finally:
                os.write(write, said.encode())
                os._exit(0)
        os.close(write)
        os.waitpid(child, 0)
        with os.fdopen(read) as pipe:
            return pipe.read()

    def test_an_error_of_the_writer_leaves_the_old_one(self):
        with self.assertRaises(KeyError):
            with files.replacing(self.name) as file:
                file.write(NEW)
                raise KeyError("half way")
        self.holds(OLD)
        for call in ("fsync", "replace"):
            with mock.patch.object(os, call, side_effect=OSError(28, "No space left on device")):
                self.refused("filename", files.write, self.name, NEW)
            self.holds(OLD)

    def test_two_writers_and_a_killed_one(self):
        contents = [bytes([letter]) * 400000 for letter in b"AB"]

        def write_many(content):
            for _ in range(25):
                files.write(self.name, content)

        threads = [threading.Thread(target=write_many, args=(content,)) for content in contents]
        for thread in threads:
            thread.start()
        while any(thread.is_alive() for thread in threads):
            with open(self.name, "rb") as file:
                self.assertIn(file.read(), [OLD, *contents])
        for thread in threads:
            thread.join()
        self.holds(*contents)
        for number in range(8):
            child = os.fork()
            if child == 0:
                while True:
                    files.write(self.name, contents[0])
            time.sleep(0.01 * number)
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            with open(self.name, "rb") as file:
                self.assertIn(file.read(), contents)

    def test_without_a_folder_for_temporary_files(self):
        code = "import os, sys; sys.path[:0] = %r; from patchmill.system import files; files.write(%r, 'new')"
        import sys

        environment = dict(os.environ, TMPDIR="/nowhere")
        subprocess.run([sys.executable or "python3", "-c", code % (sys.path, self.name)], env=environment)
        with mock.patch.object(tempfile, "gettempdir", side_effect=FileNotFoundError):
            files.write(self.name, NEW)
        self.holds(NEW)


class MachineFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.join(folder.name, "machines")
        os.mkdir(self.folder)
        patch = mock.patch.dict(os.environ, PATCHMILL_MACHINES=self.folder)
        patch.start()
        self.addCleanup(patch.stop)
        self.data = machines.load("linuxcnc-mill").data

    def write(self, content):
        with open(os.path.join(self.folder, "own.json"), "wb") as file:
            file.write(content)

    def test_names_lead_nowhere_else(self):
        outside = os.path.join(os.path.dirname(self.folder), "x.json")
        with open(outside, "w") as file:
            json.dump(self.data, file)
        for key in ("../x", outside[:-5], "..", "", "x/../../x", "a\0b", None):
            for function in (machines.load, machines.remove, lambda key: machines.save(key, self.data)):
                with self.assertRaises(InputError, msg=key) as caught:
                    function(key)
                self.assertEqual(caught.exception.property, "Machine")
        self.assertTrue(os.path.exists(outside))

    def test_what_is_no_machine_file_is_named(self):
        text = json.dumps(self.data)
        digits = text.replace('"decimals": 4', '"decimals": ' + "9" * 4000)
        self.assertNotEqual(digits, text)
        wrong = {
            "latin-1": text.replace(self.data["name"], "Fräse").encode("latin-1"),
            "nested": b"[" * 100000,
            "digits": digits.encode(),
            "more digits": digits.replace("9" * 4000, "9" * 9000).encode(),
            "no text": bytes(range(256)),
            "a huge number": text.replace('_phase_degrees": ', '_phase_degrees": 1' + "0" * 400).encode(),
        }
        for how, content in wrong.items():
            self.write(content)
            with self.assertRaises(InputError, msg=how) as caught:
                machines.load("own")
            self.assertLess(len(str(caught.exception)), 600)
            self.assertIn("own", str(caught.exception))
        self.write(b"\xef\xbb\xbf" + text.encode())
        self.assertEqual(machines.load("own").data, self.data)

    def test_saying_a_value_is_short(self):
        place = schema.Place("own").at("x")
        with self.assertRaises(InputError) as caught:
            place.refuse(10**5000, "give less.")
        self.assertIn("a number", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
