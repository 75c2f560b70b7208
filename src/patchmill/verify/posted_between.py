"""Words of a posted program that stand between the operations of its job: each must be a word of the
operations on both sides, of the tool controllers and work offsets between them, or one that the control
needs to come from one to the other.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re

from _patchmill import InputError

STATES = (0, 17, 40, 43, 43.4, 49, 61, 64, 80, 90, 91.1, 94, 98, 99)  # of the common tongue
REFERENCE = (28, 30)  # how posts of others go to the machine's zero: by words that are zero
STOPS = (5, 9, 428, 429)
ENDS = (2, 30)
ROTARY = "ABC"
LENGTHS = "XYZUVWIJKR"
COOLANT = {"Flood": 8.0, "Mist": 7.0}


def words_of(commands):
    """Words of a path as (letter, value): those of the commands' names and beside them; no F, no comments."""
    for command in commands:
        if re.fullmatch(r"[GMST]\d+(\.\d+)?", command.Name):
            yield command.Name[0], float(command.Name[1:])
        yield from ((k, v) for k, v in command.Parameters.items() if k != "F")


class Allowed:
    """The words that may stand in one stretch between operations. `objects`: the operation before, what
    FreeCAD hands to the post after it, and the operation behind; `tools`, `coolants`: (tool number, spindle
    speed) and coolants of those that are operations; `known`: words [(letter, value)] of the machine's file
    and of the post's arguments; `own`: the post is one of ours, which has no words beside."""

    def __init__(self, objects, tools, coolants, known, own, first, last):
        self.values, self.own = {}, own
        for letter, value in known:
            self._add(letter, value)
        for obj in objects:
            for letter, value in words_of(obj.Path.Commands):
                self._add(letter, value)
                if letter == "R":  # cycles may be written as moves
                    self._add("Z", value)
        for number in STATES + (() if own else REFERENCE + (20, 53)) + ((21, 54) if first or last else ()):
            self._add("G", number)
        for number in STOPS + (ENDS if last else ()):
            self._add("M", number)
        for letter in ROTARY if own else ROTARY + LENGTHS:
            self._add(letter, 0.0)
        if not own:
            self._add("T", 0.0)
        for tool, speed in tools:
            self._add("H", tool)
            self._add("D", tool)
            self._add("S", round(speed, 3))  # beside an M3 of the path, which has none
        for coolant in coolants:
            if coolant in COOLANT:
                self._add("M", COOLANT[coolant])

    def _add(self, letter, value):
        self.values.setdefault(letter, []).append(float(value))

    def has(self, letter, value, near, unit):
        """Whether a word may be there. `unit`: mm per unit of the program's lengths."""
        scale = unit if letter in LENGTHS else 1.0
        rounded = letter in LENGTHS + ROTARY or (letter in "PQE" and not self.own)
        off = near if rounded else 1e-6
        if letter == "S" and not self.own:  # others write whole ones
            off = 0.5000001
        return letter == "F" or any(abs(scale * value - v) <= off for v in self.values.get(letter, ()))


def require(words, allowed, near, unit, text_lines):
    """Raises InputError naming Program if one of the words of a stretch, [(line, [(letter, value)])], is not
    an allowed one."""
    for line, block in words:
        for letter, value in block:
            if not allowed.has(letter, value, near, unit):
                said = "%s%g in line %d, %r" % (letter, value, line, text_lines[line - 1].strip())
                remedy = "no operation, tool or work offset there has this word: take it out of the post."
                raise InputError("Program", said, remedy)
