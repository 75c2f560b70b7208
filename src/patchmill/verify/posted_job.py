"""Reading back a whole posted job: work offset by work offset, tool by tool, operation by operation, in the
order in which FreeCAD handed them to the post-processor. Every copy of every operation must be there; a feed
move that is of no operation is refused.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import re

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.freecad import host
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.operations.computed import planned
from patchmill.verify import posted_between, posted_milling, posted_texture
from patchmill.verify.posted_milling import controller_of
from patchmill.verify.posted_program import COMMENT, ROUNDED_TWICE, PostedProgram, offset_number, work_offset

ALWAYS = (0, 1, 2, 3, 4, 17, 43.4, 49, 61, 64, 80, 90, 90.1, 91.1, 93, 94, 98, 99)  # of common tongue
CUTS = ("G1", "G01", "G2", "G02", "G3", "G03", "G33")
HALF_ROUNDING = 0.51e-6  # mm: P of G64 has six decimals
OTHER_POST = ": use one of PatchMill's own posts."
BESIDE = "STHDE"  # letters that no move has
COOLANT = {"Flood": "M8", "Mist": "M7"}
LENGTH_WITH_TOOL = ("heidenhain", "siemens")  # they have no word for it
LENGTHS = {("G", 43.0), ("G", 43.4), ("G", 49.0), ("M", 6.0)}


class _Reading:
    """A program while its operations are looked for, one after the other."""

    def __init__(self, text, dialect, half_unit, post):
        self.program = PostedProgram(text, dialect, post.tcp_words)
        self.known, self.own, self.post = post.known, post.own, post
        self.before = None  # the last operation
        self.between = []  # other objects with paths since then
        self.end_line = 0  # of the last operation
        self.lines = [COMMENT.sub("", line) for line in text.split("\n")]
        self.dialect, self.half_unit = dialect, half_unit
        self.at = 0  # the move after the last operation
        self.offset = ""
        self.words = core.program_lines(text, dialect)
        self.due = []  # (operation, first line, its words) that are looked for up to the next operation
        self.tcp = False  # after the last operation
        self.stretches = []  # between operations: (words, the objects on both sides)

    def texture(self, op):
        plan = planned(op)
        told = posted_texture.told_by(plan)
        posted, run = posted_texture.find(op, plan, told, self.program, self.at)
        return self._found(op, posted, run, told)

    def other(self, op):
        commands, behind = op.Path.Commands, self.end_line + 1  # its words may come before its first move
        told = posted_milling.told_by(commands, self.post.tcp_words)
        posted, run = posted_milling.find(op, told, self.program, self.half_unit, self.at)
        if len(told):
            posted = self._found(op, posted, run, told)
        else:
            self.between.append(op)
        if not kind_of(op):
            tool, words = controller_of(op), self.post.tcp_words
            other = (c for c in commands if posted_between.has_other_words(c, words, tool))
            self.due += [(op, behind, c) for c in other]
        return posted

    def words_until(self, line):
        """Words of operations that move nothing are there before the next operation's first move."""
        for op, first, command in self.due:
            wanted = {(command.Name[0], float(command.Name[1:])), *command.Parameters.items()}
            wanted = {word for word in wanted if word[0] != "F"}  # those of moves are compared with them
            between = [words for number, words in self.words if first <= number < line]
            if {"G", "M", "S"} & set(command.Parameters):  # a control may want a block for each word
                between = [[word for words in between for word in words]]
            if not any(posted_between.holds(words, wanted, self.half_unit) for words in between):
                said = command.toGCode().strip()
                remedy = "the program does not have it: use a post-processor that keeps it, or leave it out."
                raise InputError(op.Label, said, remedy)
        self.due = []

    def words_between(self, op, line):
        """The words from the last operation to `op`, which begins in a line, or to the end, are theirs."""
        objects = [o for o in (self.before, *self.between, op) if o is not None]
        after = [o for o in (*self.between, op) if o is not None and is_operation(o)]
        every = [o for o in objects if is_operation(o)]
        allowed = posted_between.Allowed(
            objects,
            [(c.ToolNumber, c.SpindleSpeed) for c in map(controller_of, every) if c is not None],
            [host.coolant_of(o) for o in after],
            self.known,
            self.own,
            self.before is None,
            op is None,
        )
        stretch = [one for one in self.words if self.end_line < one[0] < line]
        self.stretches.append((stretch, objects))
        posted_between.require(stretch, allowed, self.half_unit, self.program.unit, self.lines)
        if op is None and self.tcp:
            posted_between.require_tcp_off(self.before, stretch, self.post.tcp_words[1])
        self.before, self.between = op, []

    def _found(self, op, posted, run, told):
        self.nothing_between(run.first)
        self.words_until(self.program.line_of(run.first))
        self.words_between(op, self.program.line_of(run.first))
        self.end_line, self.tcp = self.program.line_of(run.end - 1), bool(told.tcp[-1])
        self._require_offset(op, run)
        self._require_start(op, run, told)
        self._require_tcp(op, run, told)
        self._require_tool(op, run)
        self._require_length(op, run)
        self._require_coolant(op, run)
        self._require_modes(op, run)
        self.at = run.end
        posted.offset = self.offset
        return posted

    def nothing_between(self, end):
        between = np.flatnonzero(self.program.cuts[self.at : end])
        if len(between):
            line = self.program.line_of(self.at + between[0])
            said = "%r in line %d" % (self.lines[line - 1].strip(), line)
            raise InputError("Program", said, "this feed move is of no operation: take it out of the post.")

    def _require_offset(self, op, run):
        wanted = offset_number(self.offset)
        said = {self.program.offset_at(move) for move in (run.first, run.end - 1)}
        if not wanted or said == {wanted}:
            return
        if said == {None} and wanted == 1:
            return  # what a control has in force by itself
        names = ", ".join(sorted("none" if n is None else "number %d" % n for n in said))
        remedy = "the program has %s in force where %s begins: use another post-processor."
        raise InputError("Fixtures", self.offset, remedy % (names, op.Label))

    def _require_start(self, op, run, told):
        """The rapids before it leave the tool where its first cut begins, which may name its end alone."""
        start = self.program.starts[run.first]
        if (np.abs(start - told.start) > self.half_unit + ROUNDED_TWICE).any():
            line = self.program.line_of(run.first)
            said = "line %d begins at X%.3f Y%.3f Z%.3f" % (line, *start)
            remedy = "the operation begins at X%.3f Y%.3f Z%.3f: use another post-processor."
            raise InputError(op.Label, said, remedy % tuple(told.start))

    def _require_tcp(self, op, run, told):
        other = np.flatnonzero(self.program.tcp[run.first : run.end] != told.tcp[run.owners])
        if len(other):
            move = run.first + int(other[0])
            on = bool(self.program.tcp[move])
            said = "TCP is %s in line %d" % ("on" if on else "off", self.program.line_of(move))
            remedy = "the operation is milled with TCP %s: use another post-processor."
            raise InputError(op.Label, said, remedy % ("off" if on else "on"))

    def _require_tool(self, op, run):
        controller = controller_of(op)
        if controller is None:
            return
        first, last = (self.program.section_of(move)[0] for move in (run.first, run.end - 1))
        for section in self.program.sections[first : last + 1]:
            missing = section.tool_number == 0 and not self.own  # some posts of others change no tools
            if section.tool_number != controller.ToolNumber and not missing:
                remedy = "the program has T%d in the spindle where %s is milled."
                raise InputError(
                    "ToolNumber", controller.ToolNumber, remedy % (section.tool_number, op.Label)
                )
            spindle = section.path.spindle
            turning = controller.SpindleDir in ("Forward", "Reverse") and controller.SpindleSpeed > 0.0
            if turning and abs(60.0 * spindle.speed - controller.SpindleSpeed) > 0.5000001:
                said = "%g rpm" % controller.SpindleSpeed
                remedy = "the posted text turns the spindle at %g rpm where %s is milled."
                raise InputError("SpindleSpeed", said, remedy % (60.0 * spindle.speed, op.Label))

    def _require_length(self, op, run):
        """What another operation has said of the tool's length is not in force where this one begins."""
        controller = controller_of(op)
        said_itself = any(c.Name in ("G43", "G49") for c in op.Path.Commands)
        moving = self.program.moving[run.first : run.end]
        if controller is None or said_itself or self.dialect in LENGTH_WITH_TOOL or not moving.any():
            return
        line = self.program.line_of(run.first + int(np.argmax(moving)))
        said = [words for number, words in self.words if number < line and LENGTHS & set(words)]
        since = max((k for k, words in enumerate(said) if ("M", 6.0) in words), default=-1)
        said = said[since + 1 :]  # of this tool
        if not any({("G", 43.0), ("G", 43.4)} & set(words) for words in said):
            if self.post.length:
                remedy = "the program does not call the tool's length: use another post-processor."
                raise InputError(op.Label, "no G43 H%d" % controller.ToolNumber, remedy)
            return
        numbers = {value for letter, value in said[-1] if letter == "H"}
        if ("G", 49.0) in said[-1] or numbers - {controller.ToolNumber}:
            words = " ".join("%s%g" % word for word in said[-1] if word[0] in "GH")
            remedy = "another operation leaves this, not its tool's length: end that one by G43 H%d."
            raise InputError(op.Label, words, remedy % controller.ToolNumber)

    def _require_modes(self, op, run):
        """No other G or M words stand between an operation's moves than in its path; on LinuxCNC the words
        for the rounding of corners are those of the path, in order."""
        lines = range(self.program.line_of(run.first), self.program.line_of(run.end - 1) + 1)
        commands = op.Path.Commands
        own = {(c.Name[0], float(c.Name[1:])) for c in commands if re.fullmatch(r"[GM][\d.]+", c.Name)}
        own |= {(letter, value) for c in commands for letter, value in c.Parameters.items() if letter in "GM"}
        own |= {("G", float(number)) for number in ALWAYS}
        rounding = self._mode_before(commands, lines.start)
        beside = {(k, round(v, 3)) for c in commands for k, v in c.Parameters.items() if k in BESIDE}
        controller = controller_of(op)
        beside |= {("S", round(controller.SpindleSpeed, 3))} if controller else set()
        stops = 0
        for number, words in self.words:
            if number not in lines:
                continue
            other = [word for word in words if word[0] in "GM" and (word[0], round(word[1], 1)) not in own]
            other += [w for w in words if w[0] in BESIDE and (w[0], round(w[1], 3)) not in beside]
            if other:
                said = "%s%g in line %d" % (*other[0], number)
                remedy = "the operation has no such word: use another post-processor."
                raise InputError(op.Label, said, remedy)
            stops += ("M", 1.0) in words
            if ("G", 64.0) in words or ("G", 61.0) in words:
                rounding.append({k: v for k, v in words if k in "GPQ"})
        asked = sum(c.Name in ("M1", "M01") for c in commands)
        if kind_of(op) == TEXTURE and stops != asked:
            remedy = "the operation has %d: use another post-processor." % asked
            raise InputError(op.Label, "%d stops between patches" % stops, remedy)
        wanted = [{"G": float(c.Name[1:])} | c.Parameters for c in commands if c.Name in ("G61", "G64")]
        if self.dialect == "linuxcnc" and kind_of(op) and rounding:
            near = HALF_ROUNDING if self.own else self.half_unit + 1e-6
            posted_between.require_in_order(op, rounding, wanted, near)

    def _mode_before(self, commands, line):
        """The path mode that is in force before a line, if the operation has said it before its first cut."""
        names = [c.Name for c in commands]
        cut = next((k for k, name in enumerate(names) if name in CUTS), len(names))
        if not {"G61", "G64"} & set(names[:cut]):
            return []
        said = (dict(w) for n, w in self.words if n < line and {("G", 61.0), ("G", 64.0)} & set(w))
        return [{k: v for k, v in words.items() if k in "GPQ"} for words in said][-1:]

    def _require_coolant(self, op, run):
        mode = host.coolant_of(op)
        itself = {7.0, 8.0, 9.0} & {v for k, v in posted_between.words_of(op.Path.Commands) if k == "M"}
        on: set[str] = set()
        for line in self.lines[: self.program.line_of(run.first)]:
            for word in re.findall(r"\bM0?([789])\b", line):
                on = on | {"M" + word} if word != "9" else set()
        if mode == "None" and on and not itself:
            remedy = "the program has it on where %s begins: end the operation before by M9."
            raise InputError("CoolantMode", "None", remedy % op.Label)
        if mode in COOLANT and COOLANT[mode] not in on and not itself:
            remedy = "the program does not switch it on for %s: choose None, or another post-processor."
            raise InputError("CoolantMode", mode, remedy % op.Label)


def read_back(text, objects, dialect, half_unit, known=(), own=True, tcp_words=("", ""), **more):
    """What was read back of a program's `objects`, as FreeCAD handed them to the post-processor: a list of
    PostedTexture, and then of PostedMilling. `half_unit`: how far numbers are rounded at most [mm, degrees];
    `known`, `own`, `tcp_words` and more of the program: see posted_between.Post. Raises InputError naming
    what is not there, or is there otherwise."""
    operations = [o for o in objects if is_operation(o)]
    try:
        post = posted_between.Post(known, own, tcp_words, **more)
        reading = _Reading(text, dialect, half_unit, post)
    except InputError as error:
        if any(kind_of(op) == TEXTURE for op in operations):
            posted_milling.require_read(operations, tcp_words)
            remedy = error.remedy if own else error.remedy.rstrip(".") + OTHER_POST
            raise InputError(error.property, error.value, remedy) from error
        return [posted_milling.unknown(op, posted_milling.UNREADABLE % error) for op in operations]
    posted = []
    for obj in objects:
        if work_offset(obj):
            reading.offset = work_offset(obj)
        elif is_operation(obj):
            texture = kind_of(obj) == TEXTURE
            posted.append(reading.texture(obj) if texture else reading.other(obj))
        if hasattr(obj, "Path") and not is_operation(obj):
            reading.between.append(obj)
    reading.nothing_between(len(reading.program))
    reading.words_until(math.inf)
    reading.words_between(None, math.inf)
    retracts = posted_between.Retracts(reading.post.retract, reading.words, text.split("\n"))
    retracts.require(reading.program, reading.stretches, reading.end_line, known)
    textures = [one for one in posted if isinstance(one, posted_texture.PostedTexture)]
    return textures + [one for one in posted if not isinstance(one, posted_texture.PostedTexture)]


def is_operation(obj):
    """Whether one of the objects that a post-processor gets is an operation or dressup that is milled, or a
    link to one, which has no Proxy; work offsets are no document objects."""
    return hasattr(obj, "TypeId") and hasattr(obj, "Path") and not hasattr(obj, "ToolNumber")
