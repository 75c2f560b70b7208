"""The mould maker's job posted by every control's post, and by FreeCAD's own where it can, and read back:
every operation at every work offset, with its tool.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import _patchmill as core  # noqa: E402
import patchmill  # noqa: E402
from mould_job import BOTH, CASES, TIMED, locked_machines, mould_job  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError  # noqa: E402

OPERATIONS = ["Locked", "Tilted", "Face", "Pocket", "Drilling", "Profile", "Copy"]


class MouldJob(WithDocuments):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.environ.pop, "PATCHMILL_MACHINES")
        locked_machines(folder.name)

    def post(self, post, machine, strategy, offsets, decimals):
        """(what posting returned, the program)."""
        job, _ = mould_job(machine, strategy, decimals, offsets)
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "mould.nc")
            posted = patchmill.post(job, name, post)
            return posted, pathlib.Path(name).read_text(encoding="ascii")

    def test_every_control(self):
        for case in CASES:
            with self.subTest(case[0]):
                posted, text = self.post(*case)
                found = sorted((one.offset, one.operation.Label) for one in posted)
                wanted = sorted((offset, label) for offset in case[3] for label in OPERATIONS)
                self.assertEqual(found, wanted)
                for one in posted:
                    self.assertFalse(getattr(one, "unknown", ""), one)
                dialect = case[0].replace("patchmill_", "")
                sections = core.read_gcode(text, core.BallEndMill(1.0, 2), dialect, rotary=True)
                tools = [s.tool_number for s in sections]
                order = [t for k, t in enumerate(tools) if k == 0 or tools[k - 1] != t]
                self.assertEqual([t for t in order if t], len(case[3]) * [1, 2, 1, 3])
                rotary = {tuple(s.angles[-1].round(9)) for s in sections if s.tool_number < 3}
                self.assertEqual(rotary, {(0.0, 0.0, 0.0)})  # native operations find the axes at zero
                print("%s: %d blocks, %d operations" % (case[0], text.count("\n"), len(posted)))
            self.tearDown()

    def test_a_stock_post_that_leaves_the_table_turned_is_refused(self):
        with self.assertRaises(InputError) as caught:
            self.post("linuxcnc", "table-table-ac", TIMED, BOTH, 4)
        self.assertEqual(caught.exception.property, "Face")  # of the second work offset
        self.assertIn("bring them back", str(caught.exception))


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
