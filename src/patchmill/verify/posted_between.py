"""Words of a posted program that stand between the operations of its job: each must be a word of the
operations on both sides, of the tool controllers and work offsets between them, or one that the control
needs to come from one to the other.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re
from collections import defaultdict
from dataclasses import dataclass
from typing import Any

from _patchmill import InputError

from patchmill.freecad.kinds import kind_of
from patchmill.verify.posted_milling import TCP_OFF, TCP_ON

STATES = (0, 17, 40, 43, 43.4, 49, 61, 64, 80, 90, 91.1, 94, 98, 99)  # of the common tongue
REFERENCE = (28, 30)  # how posts of others go to the machine's zero: by words that are zero
STOPS = (5, 9, 428, 429)
ENDS = (2, 30)
COMPARED = (0, 1, 2, 3, 17, 18, 19, 73, 80, 81, 82, 83, 85, 89, 90, 98, 99)  # by the moves that they make
OTHER_WORDS = r"M(?!0?[26]$|30$)\d+|G(4|04|10|28|30|43|53|92)(\.\d)?"  # that belong to an operation alone
ROTARY = "ABC"
LENGTHS = "XYZUVWIJKR"
PRESETS = {("G", 4.0), ("G", 10.0), ("G", 92.0)}  # whose X, Y, Z are no moves
COOLANT = {"Flood": 8.0, "Mist": 7.0}


@dataclass
class Post:
    """What is known of a program beside its operations. `known`, `own`: see Allowed; `tcp_words`: see
    posted_program.PostedProgram; `length`: whether each tool's length is called by G43; `retract`: see
    Retracts."""

    known: Any
    own: bool
    tcp_words: tuple
    length: bool = False
    retract: Any = ()


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


def require_tcp_off(op, words, own_word):
    """Raises InputError naming the last operation, which had TCP on, if no word of the stretch to the end of
    the program, as of require(), switches it off. `own_word`: the machine's own for that, or ''."""
    off = {"G49", "M429", "M129", own_word}
    if not any("%s%g" % word in off for _, block in words for word in block):
        remedy = "the program ends with it: use another post-processor."
        raise InputError(op.Label, "TCP is on", remedy)


def changes(modes):
    """Modes without those that are in force already."""
    return [mode for number, mode in enumerate(modes) if number == 0 or mode != modes[number - 1]]


def require_in_order(op, found, wanted, near):
    """The modes found, without repetitions, are the last ones wanted: those before the first move are not
    looked at."""
    found, wanted = changes(found), changes(wanted)
    for mode, right in zip(reversed(found), reversed(wanted)):
        if mode.keys() != right.keys() or any(abs(mode[k] - right[k]) > near for k in mode):
            said = " ".join("%s%g" % word for word in mode.items())
            remedy = "the operation has %s there: use another post-processor."
            raise InputError(op.Label, said, remedy % " ".join("%s%g" % word for word in right.items()))
    if len(found) > len(wanted):
        raise InputError(op.Label, "other words G61 and G64", "use another post-processor.")


def has_other_words(command, tcp_words=("", ""), tool=None):
    """Whether a command of a path has words that comparing its moves does not look at. `tool`: the tool
    controller, or None; `tcp_words`: see Post."""
    number = getattr(tool, "ToolNumber", 0)
    if command.Name in TCP_ON + TCP_OFF + tcp_words and command.Parameters.get("H", number) == number:
        return False  # at each move it is looked at whether TCP is on
    beside = set(command.Parameters) - set("XYZABCIJKFPQRLDHST")
    if beside == {"G"} and re.fullmatch(r"G\d+", command.Name):
        return not {float(command.Name[1:]), command.Parameters["G"]} <= set(COMPARED)
    return bool(command.Name[:1] == "G" and beside) or re.fullmatch(OTHER_WORDS, command.Name) is not None


def holds(words, wanted, near):
    """Whether a block has all the words, given as (letter, value)."""
    return all(any(w[0] == k and abs(w[1] - v) <= near + 1e-6 for w in words) for k, v in wanted)


def added(plain, more):
    """The lines that the second of two programs has in one place beside those of the first."""
    plain, more = [bare(line) for line in plain], [bare(line) for line in more]
    pairs = zip(plain, more)
    first = next((k for k, (one, other) in enumerate(pairs) if one != other), len(plain))
    return more[first : first + len(more) - len(plain)]


def bare(line):
    """A block without its number and blanks, its numbers as short as they can be."""
    code = re.sub(r"^\s*(N\d+|\d+ )", "", line).replace(" ", "")
    return re.sub(r"[+-]?(\d+\.?\d*|\.\d+)", lambda number: "%g" % float(number.group()), code)


class Retracts:
    """Where a program has come clear of everything by `retract`, the lines that its post writes for that, as
    of bare(); none: nothing is looked for. `words`: of core.program_lines(); `lines`: the program's."""

    def __init__(self, retract, words, lines):
        self.retract, self.words, self.count = list(retract), words, len(retract)
        lines = [bare(line) for line in lines]
        ends = range(self.count, len(lines) + 1)
        self.ends = {k for k in ends if lines[k - self.count : k] == self.retract}
        blocks: dict = defaultdict(set)
        for number, block in words:
            blocks[number] |= set(block)
        self.clear, clear = set(), False  # numbers of the lines before which nothing has moved since
        for number in range(1, len(lines) + 1):
            if clear:
                self.clear.add(number)
            moves = set("XYZ") & {letter for letter, _ in blocks[number]} and not PRESETS & blocks[number]
            clear = number in self.ends or (clear and not moves)

    def require(self, program, stretches, line, known):
        """Raises InputError naming Program if a tool is changed, rotary axes turn or the program ends without
        a retract before it. `program`: posted_program.PostedProgram; `stretches`: what stands between
        operations, (words as of require(), the objects on both sides); `line`: the last one that cuts;
        `known`: words of the user's own [(letter, value)], who knows where the tool is."""
        self.require_end(line)
        if ("M", 6.0) not in known:
            self.require_changes()
        self.require_turns(program, stretches, known)

    def require_turns(self, program, stretches, known):
        """Rotary axes that turn by themselves between operations; those that one of others turns are its."""
        upright = {line for s in program.sections for line, tcp in zip(s.lines, s.tcp) if not tcp}
        for stretch, objects in stretches if self.count else ():
            paths = [known] + [words_of(o.Path.Commands) for o in objects if not kind_of(o)]
            theirs = {(letter, round(value, 3)) for words in paths for letter, value in words}
            for number, block in stretch:
                turns = {(letter, round(value, 3)) for letter, value in block if letter in ROTARY}
                moves = any(letter in LENGTHS for letter, _ in block)
                if turns and not moves and not turns <= theirs and number in upright - self.clear:
                    remedy = "the table or head turns in line %d without it: use another post-processor."
                    raise InputError("Program", self._said(), remedy % number)

    def require_changes(self):
        """Raises InputError naming Program if a tool is changed without a retract before it."""
        for number, block in self.words:
            if self.count and ("M", 6.0) in block and number not in self.clear:
                remedy = "the tool is changed in line %d without it: use another post-processor."
                raise InputError("Program", self._said(), remedy % number)

    def require_end(self, line):
        """Raises InputError naming Program if there is no retract after a line, the last one that cuts."""
        if self.count and max(self.ends, default=0) <= line:
            remedy = "the program ends without it: use another post-processor."
            raise InputError("Program", self._said(), remedy)

    def _said(self):
        return "no " + " ".join(self.retract)
