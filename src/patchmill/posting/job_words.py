"""Words in operations of others, such as FreeCAD's Custom, that belong to the job or to a tool controller
(work offsets, spindle, tools), what FreeCAD would misread in their lines, and states that they leave to the
next one.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re

from _patchmill import InputError

from patchmill.freecad import host
from patchmill.freecad.kinds import kind_of
from patchmill.verify import posted_between, posted_milling

LINE = re.compile(r"\s*(\([^()]*\)|([A-Za-z]\s*[+-]?(\d+\.?\d*|\.\d+)\s*)*)\s*")
LETTERS = re.compile(r"[A-Za-z]")
OFFSET = re.compile(r"G(5[4-9](\.\d)?)")
SENSES = {"Forward": 3, "Reverse": 4}
COOLANT = {7: "M7", 8: "M8"}


def require_lines(operations):
    """Raises InputError naming an operation whose lines FreeCAD reads as something else: a parameter or an
    expression as its digits, a decimal comma not at all."""
    for op in operations:
        for line in getattr(op, "Gcode", None) or [] if _has_lines(op) else []:
            letters = [letter.upper() for letter in LETTERS.findall(line) if letter.upper() not in "GM"]
            twice = not line.lstrip().startswith("(") and len(letters) > len(set(letters))
            if twice or LINE.fullmatch(line) is None:
                remedy = "FreeCAD would read it otherwise: write words of a letter and a number, each letter"
                remedy += " once, and comments on lines of their own."
                raise InputError(op.Label, line.strip(), remedy)


def _has_lines(op):
    return not kind_of(op) and getattr(op, "Source", "Text") == "Text"


def require_own(operations, offsets, own):
    """Raises InputError naming an operation with a word that is not its own, or that leaves the next one a
    spindle, or with posts other than ours (`own` is None) coolant, as it does not want it."""
    for number, op in enumerate(operations):
        if kind_of(op):
            continue
        words = list(posted_between.words_of(op.Path.Commands))
        _require_offset(op, offsets)
        _require_tool(op, words)
        controller = posted_milling.controller_of(op)
        behind = operations[number + 1 :] + (operations[:number] if len(offsets) > 1 else [])
        if controller is not None and controller.SpindleDir in SENSES and controller.SpindleSpeed > 0.0:
            same = any(posted_milling.controller_of(other) is controller for other in behind)
            _require_spindle(op, words, controller, same)
        if behind and leaves_coolant(op) and not any(letter in "XYZ" for letter, _ in words):
            remedy = "choose the coolant in the operations that want it: their Coolant says Flood or Mist."
            raise InputError(op.Label, leaves_coolant(op), remedy)
        if own is None and behind and leaves_coolant(op) and host.coolant_of(behind[0]) == "None":
            remedy = "the post leaves it on for %s, whose coolant is None: end the operation by M9."
            raise InputError(op.Label, leaves_coolant(op), remedy % behind[0].Label)


def leaves_coolant(op):
    """The word, M7 or M8, by which a path leaves the coolant on; '' if it does not."""
    said = [value for letter, value in posted_between.words_of(op.Path.Commands) if letter == "M"]
    last = next((value for value in reversed(said) if value in (7, 8, 9)), 9)
    return COOLANT.get(int(last), "")


def _require_offset(op, offsets):
    for command in op.Path.Commands:
        beside = "G%g" % command.Parameters["G"] if "G" in command.Parameters else ""
        word = next(filter(OFFSET.fullmatch, (command.Name, beside)), None)
        if word is not None and [word] != [name.strip().upper() for name in offsets]:
            remedy = "work offsets are the job's: choose it in the job's setup, and take it out here."
            raise InputError(op.Label, word, remedy)


def _require_tool(op, words):
    if ("M", 6.0) in words:
        tool = next((" T%d" % value for letter, value in words if letter == "T"), "")
        remedy = "tools are changed by tool controllers: give the operation that of the tool, and take the"
        raise InputError(op.Label, "M6" + tool, remedy + " word out.")


def _require_spindle(op, words, controller, same):
    """`same`: an operation with this tool controller comes after it."""
    for letter, value in words:
        if letter == "S" and abs(value - controller.SpindleSpeed) > 0.5:
            remedy = "%s turns at %g rpm: take the word out, and give the operation"
            remedy += " a tool controller of %g rpm."
            said = controller.Label, controller.SpindleSpeed, value
            raise InputError(op.Label, "S%g" % value, remedy % said)
    wanted = SENSES[controller.SpindleDir]
    turned = [int(value) for letter, value in words if letter == "M" and value in (3, 4, 5)]
    if same and turned and turned[-1] != wanted:
        remedy = "the next operation with %s would find the spindle so: end this one by M%d."
        raise InputError(op.Label, "M%d" % turned[-1], remedy % (controller.Label, wanted))
