"""What copy milling will take is foreseen from slices of the stock, and refused before it is taken, with a
value that takes less.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import re
import sys
import time
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import make_job, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError  # noqa: E402
from patchmill.operations import copy_input, copy_milling  # noqa: E402
from patchmill.system import memory  # noqa: E402

UNDERCUTS = "Scanning with undercuts"
# properties of jobs that can be made whole, beside what is foreseen of them
MADE = [
    {"RadialDepth": 0.2},
    {"RadialDepth": 4.0, "AxialDepth": 0.05},
    {"RadialDepth": 4.0, "Tolerance": 1e-3},
    {"RadialDepth": 2.0, "FinishingRadialDepth": 0.2, "Allowance": 0.3},
    {"Mode": "Contour", "RadialDepth": 0.3, "AxialDepth": 5.0},
    {"Mode": "Contour", "AxialDepth": 5.0, "Tolerance": 4e-3},
    {"Mode": UNDERCUTS, "RadialDepth": 8.0, "AxialDepth": 0.2},
    {"Mode": UNDERCUTS, "RadialDepth": 10.0, "Tolerance": 5e-3},
]
# properties that take more than there is: the one that is named, and its value
REFUSED = [
    ({"RadialDepth": 1e-3}, "RadialDepth"),
    ({"RadialDepth": 1e-6}, "RadialDepth"),
    ({"RadialDepth": 1e-30}, "RadialDepth"),
    ({"AxialDepth": 1e-4}, "AxialDepth"),
    ({"FinishingRadialDepth": 1e-4}, "FinishingRadialDepth"),
    ({"Mode": "Contour", "RadialDepth": 1e-4}, "RadialDepth"),
    ({"Mode": "Contour", "AxialDepth": 1e-5}, "AxialDepth"),
    ({"Mode": UNDERCUTS, "RadialDepth": 1e-4}, "RadialDepth"),
]
FREE = 4e9  # bytes


class CopyForecast(WithDocuments):
    def setUp(self):
        _, job = make_job(pocket_part().fuse(Part.makeSphere(6, FreeCAD.Vector(12, 10, 20))), ball=True)
        self.op = patchmill.CopyMilling.Create("Copy", parentJob=job)
        patchmill.recompute(self.op)
        self.given = {name: getattr(self.op, name) for name in ("Mode", "RadialDepth", "AxialDepth")}
        for name in ("FinishingRadialDepth", "Allowance", "Tolerance"):
            self.given[name] = getattr(self.op, name)

    def input(self, **properties):
        for name, value in dict(self.given, **properties).items():
            setattr(self.op, name, value)
        return copy_input.input_of(self.op)

    def test_as_many_moves_as_are_made(self):
        for properties in MADE:
            with self.subTest(**properties):
                given = self.input(**properties)
                stock, part, _ = copy_milling.solids(given)
                low, high = copy_milling.to_cut(stock, part)
                will = copy_milling.foreseen_bytes(given, part, low, high) / copy_milling.BYTES_PER_MOVE
                made = len(copy_milling.mill(given).path)
                print("%s: %d moves, %.2f of them foreseen" % (properties, made, will / made))
                self.assertLess(max(will / made, made / will), 1.5)

    def test_what_takes_too_much_is_refused_before_it_is_made(self):
        for properties, name in REFUSED:
            with self.subTest(**properties), mock.patch.object(memory, "available", return_value=FREE):
                given = self.input(**properties)
                begun = time.process_time()
                with self.assertRaises(InputError) as caught:
                    copy_milling.mill(given, lambda share: share == 0.0)  # ends what should not be begun
                print("%s: %.2f s, %s" % (properties, time.process_time() - begun, caught.exception))
                self.assertEqual(caught.exception.property, name)
                self.assertEqual(caught.exception.value, "%g mm" % properties[name])
                said = re.search(r"take (\S+) GB of memory, and 4 GB are free: .* (\S+) mm\.$",
                                 caught.exception.remedy)  # fmt: skip
                self.assertGreater(float(said.group(1)), 4.0)
                # what is proposed does take less
                given = self.input(**dict(properties, **{name: float(said.group(2))}))
                stock, part, _ = copy_milling.solids(given)
                room = copy_milling.to_cut(stock, part)
                self.assertLessEqual(copy_milling.foreseen_bytes(given, part, *room), FREE)


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)
