"""Words in operations of others, such as FreeCAD's Custom, that belong to the job or to a tool controller
(work offsets, spindle, tools), what FreeCAD would misread in their lines, and states that they leave to the
next one.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re

from _patchmill import InputError

from patchmill.freecad import host
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.posting import kept_words
from patchmill.verify import posted_between, posted_milling

LINE = re.compile(r"\s*(\([^()]*\)|([A-Za-z]\s*[+-]?(\d+\.?\d*|\.\d+)\s*)*)\s*")
LETTERS = re.compile(r"[A-Za-z]")
OFFSET = re.compile(r"G(5[4-9](\.\d)?)")
SENSES = {"Forward": 3, "Reverse": 4}
COOLANT = {7: "M7", 8: "M8"}
CUTS = re.compile(r"G0?[123]|G(73|8[1-359])")
MILLS = ("G1", "G01", "G2", "G02", "G3", "G03")
TURNED = (3, 4, 5, 19)  # M words after which the spindle turns, or stands


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
    spindle, or with posts other than ours (`own` is None) a state, as it does not want it."""
    for number, op in enumerate(operations):
        if kind_of(op):
            continue
        words = list(posted_between.words_of(op.Path.Commands))
        _require_no_end(op, words)
        _require_offset(op, offsets)
        _require_tool(op, words)
        _require_feeds(op)
        if any(kind_of(other) == TEXTURE for other in operations):
            _require_known_axes(op, words)
        controller = posted_milling.controller_of(op)
        behind = operations[number + 1 :] + (operations[:number] if len(offsets) > 1 else [])
        if controller is not None and controller.SpindleDir in SENSES and controller.SpindleSpeed > 0.0:
            same = any(posted_milling.controller_of(other) is controller for other in behind)
            _require_spindle(op, words, controller, same)
        if behind and leaves_coolant(op) and not any(letter in "XYZ" for letter, _ in words):
            remedy = "choose the coolant in the operations that want it: their Coolant says Flood or Mist."
            raise InputError(op.Label, leaves_coolant(op), remedy)
        if own is None and behind and kept_words.left_by(words):
            word, remedy = kept_words.left_by(words), "the post leaves it on for %s: end the operation by %s."
            raise InputError(op.Label, word, remedy % (behind[0].Label, kept_words.ENDED_BY[word]))
        if own is None and _tcp_left(op):
            word, number = _tcp_left(op), getattr(controller, "ToolNumber", 0)
            off = "M429" if word == "M428" else "G49 and G43 H%d" % number
            remedy = "the post leaves TCP on for what comes after it: end the operation by %s."
            raise InputError(op.Label, word, remedy % off)
        if own is None and behind and leaves_coolant(op) and host.coolant_of(behind[0]) == "None":
            remedy = "the post leaves it on for %s, whose coolant is None: end the operation by M9."
            raise InputError(op.Label, leaves_coolant(op), remedy % behind[0].Label)


def leaves_coolant(op):
    """The word, M7 or M8, by which a path leaves the coolant on; '' if it does not."""
    said = [value for letter, value in posted_between.words_of(op.Path.Commands) if letter == "M"]
    last = next((value for value in reversed(said) if value in (7, 8, 9)), 9)
    return COOLANT.get(int(last), "")


def _require_no_end(op, words):
    for letter, value in words:
        if letter == "M" and value in (2, 30):
            remedy = "it would end the program, which the post does: take it out."
            raise InputError(op.Label, "M%d" % value, remedy)
        if letter == "G" and value == 20:
            raise InputError(op.Label, "G20", "FreeCAD's paths are in millimetres: take it out.")


def _tcp_left(op):
    """The word by which a path leaves TCP on; '' if it does not."""
    left = ""
    for command in op.Path.Commands:
        if command.Name in posted_milling.TCP_ON:
            left = command.Name
        elif command.Name in posted_milling.TCP_OFF:
            left = ""
    return left


def _require_offset(op, offsets):
    for command in op.Path.Commands:
        beside = "G%g" % command.Parameters["G"] if "G" in command.Parameters else ""
        word = next(filter(OFFSET.fullmatch, (command.Name, beside)), None)
        if word is not None and [word] != [name.strip().upper() for name in offsets]:
            remedy = "work offsets are the job's: choose it in the job's setup, and take it out here."
            raise InputError(op.Label, word, remedy)


def _require_tool(op, words):
    for word, letter in (("M6", "T"), ("M61", "Q")):
        if ("M", float(word[1:])) in words:
            tool = next((" %s%d" % (letter, value) for name, value in words if name == letter), "")
            remedy = "tools are changed by tool controllers: give the operation that of the tool, and take"
            raise InputError(op.Label, word + tool, remedy + " the word out.")


def _require_feeds(op):
    """Cuts have a feed greater than zero. FreeCAD leaves out one of zero, and the cut would go at that of the
    cuts before it, of whatever operation they are."""
    controller = posted_milling.controller_of(op)
    remedy = "a cut needs a feed greater than zero: give it one here"
    if controller is not None:
        remedy += ", or the horizontal and vertical feed of %s" % controller.Label
    said = False
    for command in op.Path.Commands:
        feed = command.Parameters.get("F")
        cuts = CUTS.fullmatch(command.Name) or CUTS.fullmatch("G%g" % command.Parameters.get("G", -1))
        if command.Name[:1] == "F" or (feed is not None and feed > 0.0):
            said = True
        elif cuts and (feed is not None or not said):
            raise InputError(op.Label, command.toGCode().strip(), remedy + ".")
    for name in _feeds_used(op) if controller is not None and not hasattr(op, "Gcode") else ():
        value = float(getattr(controller, name))
        if not value > 0.0:
            why = "%s is milled with it: give the tool controller %s one." % (op.Label, controller.Label)
            raise InputError(name, "%g" % value, why)


def _feeds_used(op):
    """Which feeds of its tool controller a path needs: HorizFeed, VertFeed."""
    at: dict = {}
    used = set()
    for command in op.Path.Commands:
        moved = {axis for axis in "XYZ" if command.Parameters.get(axis, at.get(axis)) != at.get(axis)}
        if CUTS.fullmatch(command.Name) and moved:
            sideways = not moved.isdisjoint("XY") and command.Name in MILLS
            used.add("HorizFeed" if sideways else "VertFeed")
        at.update((axis, value) for axis, value in command.Parameters.items() if axis in "XYZ")
    return sorted(used)


def _require_known_axes(op, words):
    """Nobody knows where U, V and W move the tool: a job with a texture is read back, and has none."""
    for letter, value in words:
        if letter in "UVW":
            remedy = "where that moves the tool is not known here: post the operation in a job of its own."
            raise InputError(op.Label, "%s%g" % (letter, value), remedy)


def _require_spindle(op, words, controller, same):
    """`same`: an operation with this tool controller comes after it."""
    for letter, value in words:
        if letter == "S" and abs(value - controller.SpindleSpeed) > 0.5:
            remedy = "%s turns at %g rpm: take the word out, and give the operation"
            remedy += " a tool controller of %g rpm."
            said = controller.Label, controller.SpindleSpeed, value
            raise InputError(op.Label, "S%g" % value, remedy % said)
    wanted = SENSES[controller.SpindleDir]
    turned = [int(value) for letter, value in words if letter == "M" and value in TURNED]
    if same and turned and turned[-1] != wanted:
        remedy = "the next operation with %s would find the spindle so: end this one by M%d."
        raise InputError(op.Label, "M%d" % turned[-1], remedy % (controller.Label, wanted))
