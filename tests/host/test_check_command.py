"""`patchmill check`: a program and a document from the command line.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import patchmill  # noqa: E402
from parts import WithDocuments  # noqa: E402
from roof_job import custom, roof_job  # noqa: E402

COMMAND = pathlib.Path(__file__).resolve().parents[2] / "tools" / "patchmill"
POST = "patchmill_linuxcnc"


class CheckCommand(WithDocuments):
    def check(self, *arguments):
        done = subprocess.run([COMMAND, "check", *arguments], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def test_a_program_and_a_document(self):
        job, _ = roof_job("Constant feed")
        custom(job, ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G1 X46", "G0 Z30"])
        job.Fixtures = ["G54", "G55"]
        with tempfile.TemporaryDirectory() as folder:
            document, program = (os.path.join(folder, name) for name in ("roof.FCStd", "roof.ngc"))
            job.PostProcessor = POST
            patchmill.post(job, program, POST)
            job.Document.saveAs(document)
            status, said = self.check(document, program, "--post", POST)
            self.assertEqual(status, 0, said)
            for line in ("G54 Texture", "G55 Texture", "G54 Custom: 2 moves", "G55 Custom: 2 moves"):
                self.assertIn(line, said)
            text = pathlib.Path(program).read_text()
            at = text.rindex("X46.000")
            pathlib.Path(program).write_text(text[:at] + "X46.001" + text[at + 7 :])
            status, said = self.check(document, program, "--post", POST)
            self.assertEqual(status, 1, said)
            self.assertIn("Custom", said)
            self.assertEqual(self.check(document, program + "x")[0], 2)
            wide = text.encode("utf-16")
            for content, why in ((b"", "empty"), (wide, "UTF-16"), (b"\0M2\n", "zero")):
                pathlib.Path(program).write_bytes(content)
                status, said = self.check(document, program, "--post", POST)
                self.assertGreater(status, 0)
                self.assertIn(why, said)
            self.assertEqual(self.check(document, program, "--job", "none")[0], 2)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
