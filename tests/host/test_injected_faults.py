"""Of words changed at random in posted programs every one is found by reading back, or cannot matter.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from injected_faults import cases, not_found  # noqa: E402
from parts import WithDocuments  # noqa: E402

EACH, SEED = 8, 5  # of eight programs: 64 faults


class InjectedFaults(WithDocuments):
    def test_every_one_is_found(self):
        count = 0
        for case in cases():
            count += 1
            with self.subTest(case.name):
                self.assertTrue(case.words)
                case.read(case.lines)  # as it was posted
                self.assertEqual(not_found(case, EACH, SEED), [])
        self.assertEqual(count, 8)


if __name__ == "__main__":
    unittest.main()
