"""tools/freecad tools/parts_of_others.py: the host tests of textures and of CopyMilling on parts of others,
none of them smaller and none of the textures coarser than the rest, as these tests have them to be short; six
minutes of processor time.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tests" / "host"))

import test_copy_milling  # noqa: E402
import test_real_parts  # noqa: E402

test_copy_milling.LARGEST = math.inf
test_real_parts.FEW.clear()
suite = unittest.defaultTestLoader.loadTestsFromTestCase(test_real_parts.RealParts)
suite.addTest(test_copy_milling.CopyMillingTest("test_parts_of_others"))
result = unittest.TextTestRunner(verbosity=2).run(suite)
sys.exit(0 if result.wasSuccessful() and result.testsRun == 2 else 1)
