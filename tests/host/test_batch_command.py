"""The command's calls about one program, its progress and its log lines, and its exit status.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import io
import os
import pty
import re
import shutil
import subprocess
import sys
import unittest
from unittest import mock

from batch_calls import (
    MODULE,
    RECIPE,
    STEP,
    WithFolder,
    call,
)  # first: it finds the module

from patchmill.command import progress


class Programs(WithFolder):
    """One part made with its document, then its program looked at by itself."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.made = WithFolder()
        cls.made.setUp()
        shutil.copy(STEP, cls.made.path("a.step"))
        name = cls.made.write(dict(RECIPE, outputs=["document", "report"]))
        status, said = call("run", name, "-o", cls.made.path("out"))
        if status:
            raise AssertionError(said)

    @classmethod
    def tearDownClass(cls):
        cls.made.doCleanups()
        super().tearDownClass()

    def setUp(self):
        super().setUp()
        shutil.copytree(self.made.path("out", "parts", "a"), self.path("a"))
        self.program = self.path("a", "program.ngc")

    def test_the_report_of_a_run(self):
        status, said = call("report", self.made.path("out"))
        self.assertEqual((status, said), (0, "a: done: 64 dimples\n"))
        self.assertTrue(os.path.isfile(self.path("a", "report.html")))

    def test_check(self):
        status, said = call("check", self.program)
        self.assertEqual(status, 0, said)
        self.assertRegex(
            said, r"^G54 Texture1: 64 dimples, \d+ min \d\d s, phase error at most 0\.\d+°.*Clear"
        )
        self.assertEqual(call("check", self.path("a", "part.FCStd"), self.program), (status, said))

    def test_check_of_a_changed_program(self):
        with open(self.program, encoding="ascii") as file:
            lines = file.read().split("\n")
        number = max(k for k, line in enumerate(lines) if re.match("G0?1 .*X", line))
        lines[number] = re.sub(r"X-?[\d.]+", "X0.123", lines[number])
        with open(self.program, "w", encoding="ascii") as file:
            file.write("\n".join(lines))
        status, said = call("check", self.program)
        self.assertEqual(status, 1, said)
        self.assertIn("failed: Texture1", said)

    def test_simulate_and_report(self):
        status, said = call("simulate", self.program, "-o", self.path("relief"))
        self.assertEqual(status, 0, said)
        self.assertRegex(said, r"found +64, missing 0")
        self.assertIn("report.html", os.listdir(self.path("relief")))
        status, said = call("report", self.program)
        self.assertEqual(status, 0, said)
        self.assertIn("report.json", os.listdir(self.path("a", "program-report")))

    def test_wrong_calls(self):
        for arguments, word in (
            (("check", self.path("none.ngc")), "no such file"),
            (("check", self.program, "-d", self.path("none.FCStd")), "no such file"),
            (("check", self.program, "--job", "Other"), "--job"),
            (("check", self.program, "-d", self.program), "cannot be opened"),
            (("simulate", self.program, "-o", self.program), "program.ngc"),
        ):
            status, said = call(*arguments)
            self.assertEqual(status, 2, said)
            self.assertIn(word, said)
        os.unlink(self.path("a", "part.FCStd"))
        status, said = call("check", self.program)
        self.assertEqual(status, 2, said)
        self.assertIn("name the one with its job", said)


class Told(WithFolder):
    """Progress on a terminal and elsewhere; log lines only when asked for."""

    def progress(self, clock, verbose=False):
        with mock.patch.object(progress.time, "monotonic", side_effect=clock):
            told = progress.Progress(self, verbose)
            for number, made in ((1, False), (2, True), (3, True)):
                told(number, 4, "p%d" % number, {"status": "done"}, made)

    def part_folder(self, name):
        return self.path(name)

    def test_time_left_is_of_the_parts_that_were_made(self):
        said = io.StringIO()
        with mock.patch.object(sys, "stdout", said):
            self.progress([0.0, 30.0, 80.0])
        self.assertEqual(
            said.getvalue().splitlines(),
            [
                "1 of 4: p1: done earlier",
                "2 of 4, 1 min 00 s left: p2: done",
                "3 of 4, 0 min 40 s left: p3: done",
            ],
        )

    def run_command(self, *arguments, **how):
        environment = dict(os.environ, PYTHONPATH=MODULE)
        return subprocess.Popen(
            [sys.executable, "-m", "patchmill", *arguments], env=environment, **how
        )

    def broken(self):
        with open(self.path("broken.step"), "w") as file:
            file.write("no part\n")
        return self.write(dict(RECIPE, parts=["broken.step"]))

    def test_one_line_on_a_terminal(self):
        own, other = pty.openpty()
        process = self.run_command(
            "run", self.broken(), "-o", self.path("out"), stdout=other
        )
        os.close(other)
        said = b""
        while True:
            try:
                more = os.read(own, 1000)
            except OSError:  # the other side is closed
                break
            said += more
        os.close(own)
        self.assertEqual(process.wait(), 1)
        self.assertIn(b"\r\x1b[K1 of 1, 0 min 00 s left: broken: refused", said)

    def test_log_lines(self):
        name = self.broken()
        for words in ([], ["-v"]):
            pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
            process = self.run_command(
                "run", name, "-o", self.path("out"), *words, **pipes
            )
            out, log = process.communicate()
            self.assertEqual(process.returncode, 1)
            self.assertEqual(
                out.splitlines()[0], "1 of 1, 0 min 00 s left: broken: refused"
            )
            if words:
                self.assertRegex(
                    log, r"(?m)^\d{4}-\d\d-\d\d .* patchmill\.run: PatchMill \d"
                )
                self.assertIn("patchmill.run: broken: ", log)
            else:
                self.assertEqual(log, "")

    def test_all_calls_have_help(self):
        for name in (
            "run",
            "check",
            "simulate",
            "report",
            "compare",
            "machines",
            "examples",
            "doctor",
        ):
            status, said = call(name, "--help")
            self.assertEqual(status, 0)
            self.assertIn("usage: patchmill %s" % name, said)


if __name__ == "__main__":
    unittest.main()
