"""Reading back a whole posted job: work offset by work offset, tool by tool, operation by operation, in the
order in which FreeCAD handed them to the post-processor. Every copy of every operation must be there; a feed
move that is of no operation is refused.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re

import numpy as np
from _patchmill import InputError

from patchmill.freecad import host
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.operations.base import planned
from patchmill.verify import posted_milling, posted_texture
from patchmill.verify.posted_program import COMMENT, PostedProgram, offset_number

COOLANT = {"Flood": "M8", "Mist": "M7"}


class _Reading:
    """A program while its operations are looked for, one after the other."""

    def __init__(self, text, dialect, half_unit):
        self.program = PostedProgram(text, dialect)
        self.lines = [COMMENT.sub("", line) for line in text.split("\n")]
        self.dialect, self.half_unit = dialect, half_unit
        self.at = 0  # the move after the last operation
        self.offset = ""

    def texture(self, op):
        plan = planned(op)
        posted, run = posted_texture.find(op, plan, posted_texture.told_by(plan), self.program, self.at)
        return self._found(op, posted, run)

    def other(self, op):
        told = posted_milling.told_by(op.Path.Commands)
        if told is None:
            return posted_milling.unknown(op, posted_milling.CYCLES)
        posted, run = posted_milling.find(op, told, self.program, self.half_unit, self.at)
        return self._found(op, posted, run) if len(told) else posted

    def _found(self, op, posted, run):
        self._nothing_between(run.first)
        self._require_offset(op, run)
        self._require_tool(op, run)
        self._require_coolant(op, run)
        self.at = run.end
        posted.offset = self.offset
        return posted

    def _nothing_between(self, end):
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

    def _require_tool(self, op, run):
        controller = _controller_of(op)
        if controller is None:
            return
        for move in (run.first, run.end - 1):
            section = self.program.sections[self.program.section_of(move)[0]]
            if section.tool_number not in (0, controller.ToolNumber):
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

    def _require_coolant(self, op, run):
        mode = host.coolant_of(op)
        if mode not in COOLANT:
            return
        on = set()
        for line in self.lines[: self.program.line_of(run.first)]:
            for word in re.findall(r"\bM0?([789])\b", line):
                on = on | {"M" + word} if word != "9" else set()
        if COOLANT[mode] not in on:
            remedy = "the program does not switch it on for %s: choose None, or another post-processor."
            raise InputError("CoolantMode", mode, remedy % op.Label)


def read_back(text, objects, dialect, half_unit):
    """What was read back of a program's `objects`, as FreeCAD handed them to the post-processor: a list of
    PostedTexture, and then of PostedMilling. `half_unit`: how far numbers are rounded at most [mm, degrees].
    Raises InputError naming what is not there, or is there otherwise."""
    operations = [o for o in objects if is_operation(o)]
    try:
        reading = _Reading(text, dialect, half_unit)
    except InputError as error:
        if any(kind_of(op) == TEXTURE for op in operations):
            raise
        return [posted_milling.unknown(op, posted_milling.UNREADABLE % error) for op in operations]
    posted = []
    for obj in objects:
        if offset_number(getattr(obj, "Label", "")) and not hasattr(obj, "Proxy"):
            reading.offset = obj.Label
        elif is_operation(obj):
            texture = kind_of(obj) == TEXTURE
            posted.append(reading.texture(obj) if texture else reading.other(obj))
    reading._nothing_between(len(reading.program))
    textures = [one for one in posted if isinstance(one, posted_texture.PostedTexture)]
    return textures + [one for one in posted if not isinstance(one, posted_texture.PostedTexture)]


def _controller_of(op):
    """The tool controller of an operation, or of the one under dressups; None if there is none."""
    parts = posted_milling.with_those_under(op)
    return next((part.ToolController for part in parts if hasattr(part, "ToolController")), None)


def is_operation(obj):
    """Whether one of the objects that a post-processor gets is an operation or dressup that is milled."""
    return hasattr(obj, "Proxy") and hasattr(obj, "Path") and not hasattr(obj, "ToolNumber")
