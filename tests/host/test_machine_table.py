"""A machine file as rows of text: nothing is lost on the way to text and back, and a bad text is refused by
its place in the file.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import random
import sys
import unittest

from _patchmill import InputError
from patchmill.machine import machine_table, machines

STRANGE = ["", "0", "-1", "1e99", "fast", "yes", "1, 2", "3, 2", "1, 2, 3", "0 0 1", "null", "{}", "tip", "A"]


def row(data, *place):
    (found,) = [r for r in machine_table.rows(data) if r.place == place]
    return found


class RowsOfText(unittest.TestCase):
    def test_every_file_is_said_again_by_its_rows(self):
        for key in machines.names():
            data = machines.load(key).data
            said = data
            for one in machine_table.rows(data):
                if not one.heading:
                    said = machine_table.with_text(said, one.place, one.text)
            self.assertEqual(said, data, key)

    def test_all_that_a_file_says_has_a_row(self):
        for key in machines.names():
            data = machines.load(key).data
            places = {r.place for r in machine_table.rows(data) if not r.heading}
            for place in leaves(data):
                self.assertTrue(place in places or place[0] in machine_table.HIDDEN, (key, place))

    def test_units_and_words(self):
        data = machines.load("table-table-ac").data
        self.assertEqual(row(data, "linear_axes", "acceleration_mm_s2").unit, "mm/s²")
        self.assertEqual(row(data, "linear_axes", "limits_mm", "X").unit, "mm")
        self.assertEqual(row(data, "rotary_axes", "1", "limits_degrees").text, "-110.0, 30.0")
        self.assertEqual(row(data, "rotary_axes", "0", "side").words, ("table", "head"))
        self.assertEqual(row(data, "controller", "reference").words[0], "")  # need not be said

    def test_values_go_in(self):
        data = machines.load("linuxcnc-mill").data
        for place, text, value in [
            (("linear_axes", "acceleration_mm_s2"), "850", 850),
            (("linear_axes", "jerk_mm_s3"), " 3e4 ", 3e4),
            (("linear_axes", "jerk_mm_s3"), "", None),
            (("spindle_lock",), "no", False),
            (("linear_axes", "limits_mm", "Z"), "[-300, 0]", [-300, 0]),
            (("linear_axes", "limits_mm", "Z"), "-300, 0", [-300, 0]),
            (("name",), "Mill in the corner", "Mill in the corner"),
        ]:
            made = machine_table.with_text(data, place, text)
            self.assertEqual(at(made, place), value)
            machines.checked(json.dumps(made), "mine")

    def test_what_was_not_said_comes_and_goes(self):
        data = machines.load("linuxcnc-mill").data
        place = ("linear_axes", "limits_mm", "X")
        made = machine_table.with_text(data, place, "-200, 150")
        self.assertEqual(made["linear_axes"]["limits_mm"], {"X": [-200, 150]})
        machines.checked(json.dumps(made), "mine")
        self.assertEqual(machine_table.with_text(made, place, ""), data)

    def test_what_cannot_be_read_is_refused_by_its_place(self):
        data = machines.load("table-table-ac").data
        for place, text in [
            (("linear_axes", "velocity_mm_s"), "fast"),
            (("linear_axes", "velocity_mm_s"), "-3"),
            (("rotary_axes", "0", "direction"), "0 0 1"),
            (("rotary_axes", "1", "limits_degrees"), "30, -110"),
            (("servo_period_s",), ""),
        ]:
            made = machine_table.with_text(data, place, text)
            with self.assertRaises(InputError) as caught:
                machines.checked(json.dumps(made), "mine")
            self.assertEqual(caught.exception.property, "Machine file mine: /" + "/".join(place))

    def test_any_text_anywhere_is_taken_or_refused(self):
        generator = random.Random(8)
        outcomes = {True: 0, False: 0}
        for key in machines.names():
            data = machines.load(key).data
            for one in machine_table.rows(data):
                if one.heading:
                    continue
                made = machine_table.with_text(data, one.place, generator.choice(STRANGE))
                try:
                    machines.checked(json.dumps(made), "mine")
                    outcomes[True] += 1
                except InputError:
                    outcomes[False] += 1
        self.assertGreater(min(outcomes.values()), 20)


def leaves(data, place=()):
    if isinstance(data, dict):
        for word, value in data.items():
            yield from leaves(value, place + (word,))
    elif isinstance(data, list) and data and isinstance(data[0], dict):
        for number, value in enumerate(data):
            yield from leaves(value, place + (str(number),))
    else:
        yield place


def at(data, place):
    for word in place:
        data = data[word]
    return data


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2, argv=["test"] + sys.argv[1:]).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
