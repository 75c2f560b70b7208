"""The path under a dressup is read as the controller reads it, or refused: words that are not understood, and
arcs whose centre is not where their ends say.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import numpy as np  # noqa: E402
from milling_jobs import Path, dress, make_job, native, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import DressupDCM, InputError  # noqa: E402
from patchmill.path import base_path  # noqa: E402

BEGIN = ["G0 X0 Y0 Z25", "G1 X0 Y0 Z10 F5"]


def commands(lines):
    return [Path.Command(line) for line in lines]


class BasePath(WithDocuments):
    def test_arcs_that_are_not_arcs(self):
        for arc in ("G2 X20 Y0 R10 F5", "G2 X20 Y0 F5", "G2 X20 Y0 I3 J0 F5", "G3 X5 Y5 I5 J0 K2 F5"):
            with self.assertRaises(InputError) as caught:
                base_path.read(commands(BEGIN + [arc]), "Custom")
            self.assertEqual(caught.exception.property, "Custom")
            print("refused:", caught.exception)
        arcs = "G2 X20 Y0 I10 J0 F5", "G2 X20 Y0.004 I10 J0 F5", "G3 X0 Y0 I5 J0 F5", "G2 X20 Z5 I10 K0 F5"
        for arc in arcs:
            self.assertGreater(len(base_path.read(commands(BEGIN + [arc])).tips), 10)

    def test_chords_are_half_a_micrometre_from_their_arc(self):
        for radius in (0.4, 10.0, 300.0):
            arc = "G2 X%s Y0 I%s J0 F5" % (2 * radius, radius)
            tips = np.array([(0.0, 0.0, 10.0), *base_path.read(commands([*BEGIN, arc])).tips[-10000:]])
            middle = 0.5 * (tips[1:] + tips[:-1])[1:]
            sagitta = radius - np.hypot(middle[:, 0] - radius, middle[:, 1]).min()
            self.assertLessEqual(sagitta, 0.0005 * (1 + 1e-6))
            self.assertGreater(sagitta, 0.0001)

    def test_a_cut_needs_a_feed(self):
        for lines in (["G0 X0 Y0 Z25", "G1 X5"], ["G0 X0 Y0 Z25", "G1 X5 F0"]):
            with self.assertRaises(InputError) as caught:
                base_path.read(commands(lines), "Custom")
            self.assertEqual(caught.exception.value, "a move without feed")

    def test_words_that_are_not_understood(self):
        strange = "G1 X1 U5 F5", "G1 X1 E5 F5", "M98 P100", "M428", "M30", "G91", "G20", "G18", "G1 X5 A10 F5"
        for line in strange:
            with self.assertRaises(InputError) as caught:
                base_path.read(commands(BEGIN + [line]), "Custom")
            print("refused:", caught.exception)
        for line in ("M8", "M09", "T2", "S500", "G4 P1", "G1 X5 A0 F5"):
            base_path.read(commands(BEGIN + [line]))

    def test_where_a_drilling_cycle_leaves_the_tool(self):
        for word, height in (("G98", 25.0), ("G99", 12.0)):
            drill = ["G0 X0 Y0 Z25", word, "G81 X5 Y5 Z2 R12 F5", "G80", "G1 X10 Y5 F5"]
            base = base_path.read(commands(drill))
            self.assertEqual(base.tips, [(10.0, 5.0, height)])

    def test_what_cannot_be_with_a_tilted_tool(self):
        document, job = make_job(pocket_part(), "drill", ball=True)
        operation = native("Custom").Create("Custom", parentJob=job)
        dressup = dress(operation, Controls="Posture", Machine="table-table-ac")
        for line in ("G81 X5 Y5 Z2 R25 F5", "G94", "G49", "M6"):
            operation.Gcode = BEGIN + [line, "G1 X10 Y5 Z20 F5"]
            with self.assertRaises(InputError) as caught:
                DressupDCM.recompute(dressup)
            self.assertEqual((caught.exception.property, caught.exception.value), ("Base", line.split()[0]))
        operation.Gcode = BEGIN + ["G1 X10 Y5 Z20 F5"]
        DressupDCM.recompute(dressup)

    def test_no_spiral_in_place_of_an_arc_by_its_radius(self):
        document, job = make_job(pocket_part(), "custom")
        operation = native("Custom").Create("Custom", parentJob=job)
        operation.Gcode = BEGIN + ["G2 X20 Y0 R10 F5", "G0 Z25"]
        document.recompute()
        with self.assertRaises(InputError) as caught:
            DressupDCM.recompute(dress(operation))
        self.assertEqual(caught.exception.property, "Custom")


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
