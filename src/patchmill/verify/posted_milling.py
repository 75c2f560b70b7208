"""Copy milling and DCM modifiers read back from a posted program: from the first to the last move that cuts,
every move must be there, in order, with nothing in between, and with the rotary words that the path has.
A program with words that are not read (arcs and cycles of other operations) leaves this unknown, and says so.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass

import FreeCAD
import numpy as np
from _patchmill import InputError

from patchmill.freecad.kinds import COPY_MILLING, DCM, kind_of
from patchmill.verify.posted_program import PostedProgram, other_angles, trimmed

AXES = "XYZABC"
MOVES = {"G0": False, "G00": False, "G1": True, "G01": True}  # whether it cuts
DWELLS = ("G4", "G04")
UNREAD = ("G2", "G3", "G02", "G03", "G7", "G8")  # arcs; and cycles, which begin so
SAME_FEED = 1e-3  # of F, or half a mm/min: what a post with few decimals may make of it


@dataclass
class PostedMilling:
    """One operation or dressup of a posted program."""

    operation: object  # document object
    moves: int = 0  # read back
    unknown: str = ""  # why it was not read back, or ''
    offset: str = ""  # work offset of this copy


def with_those_under(op):
    """An operation or dressup, and what dressups and arrays are on."""
    if not hasattr(op, "Proxy"):
        return
    yield op
    base = getattr(op, "Base", None)
    for under in base if isinstance(base, (list, tuple)) else [base]:
        if hasattr(under, "isDerivedFrom") and under.isDerivedFrom("Path::Feature"):
            yield from with_those_under(under)


def is_milling(op):
    """Whether an operation or dressup of a job is read back here: it or what is under it is ours."""
    return any(kind_of(part) in (COPY_MILLING, DCM) for part in with_those_under(op))


def posture_of(op):
    """The DressupDCM that tilts the tool, `op` or under it; None for an upright path."""
    found = (part for part in with_those_under(op) if kind_of(part) == DCM)
    return next((dressup for dressup in found if dressup.Controls != "Feed"), None)


def angles_in(op):
    """The rotary words of its path [degrees]."""
    words = (command.Parameters.items() for command in op.Path.Commands)
    return np.array([value for pairs in words for name, value in pairs if name in "ABC"] or [0.0])


def read_back(operation, text, dialect, half_unit):
    """PostedMilling of `operation`, posted as part of `text`, whose numbers are rounded by `half_unit` [mm,
    degrees] at most. Raises InputError naming the operation if the text has another path."""
    told = told_by(operation.Path.Commands)
    if told is None:
        return unknown(operation, CYCLES)
    try:
        program = PostedProgram(text, dialect)
    except InputError as error:
        return unknown(operation, UNREADABLE % error)
    return find(operation, told, program, half_unit)[0]


CYCLES = "its arcs and drilling cycles are not read back"
UNREADABLE = "the program cannot be read back (%s)"


def find(operation, told, program, half_unit, after=0):
    """(PostedMilling, posted_program.Run) of what is told of `operation`, in a PostedProgram from its move
    `after` on. Raises InputError naming the operation if it is not there."""
    run = program.find(told, half_unit, after)
    if not run.complete:
        said = "%d of %d moves read back" % (run.found, len(told))
        raise InputError(operation.Label, said, other_angles(program, told, half_unit, after))
    _require_feeds(operation, told, program, run)
    return PostedMilling(operation, len(told)), run


def _require_feeds(operation, told, program, run):
    """Every move takes the time that its F says; not looked at where moves that move nothing are missing."""
    if run.end - run.first != len(told):
        return
    minutes = program.minutes(run.first, run.end)
    before = program.ends[max(run.first - 1, 0) : run.end]
    way = np.linalg.norm(np.diff(before[:, :3], axis=0), axis=1)
    if run.first == 0:
        way = np.concatenate([[np.nan], way])
    with np.errstate(divide="ignore", invalid="ignore"):
        read = np.where(told.inverse, 1.0 / minutes, np.where(way > 0.0, way / minutes, np.nan))
    off = np.abs(read - told.feeds) > np.maximum(SAME_FEED * told.feeds, np.where(told.inverse, 2e-3, 0.51))
    if off.any():
        move = int(np.flatnonzero(off)[0])
        unit = "1/min" if told.inverse[move] else "mm/min"
        said = "F %.4g %s in line %d" % (read[move], unit, program.line_of(run.first + move))
        remedy = "the operation has F %.4g there: use another post-processor." % told.feeds[move]
        raise InputError(operation.Label, said, remedy)


def unknown(operation, why):
    """PostedMilling of an operation that was not read back; says so in the report view."""
    FreeCAD.Console.PrintWarning("%s: %s: compare it with the path yourself.\n" % (operation.Label, why))
    return PostedMilling(operation, unknown=why)


def told_by(commands):
    """posted_program.Told of Path.Command objects, from the first to the last that takes time; None if there
    are words that are not read."""
    at = dict.fromkeys(AXES[:3], np.nan) | dict.fromkeys(AXES[3:], 0.0)
    feed, inverse = np.nan, False
    rows, cuts, feeds, modes = [list(at.values())], [False], [np.nan], [False]
    for command in commands:
        name = command.Name
        if name in MOVES or name in DWELLS:
            words = command.Parameters
            dwell = name in DWELLS
            if not dwell:
                at.update((axis, value) for axis, value in words.items() if axis in at)
                feed = 60.0 * words["F"] if "F" in words else feed
            rows.append(list(at.values()))
            cuts.append(dwell or MOVES[name])
            feeds.append(np.nan if dwell or not cuts[-1] else feed)
            modes.append(inverse)
        elif name in ("G93", "G94"):
            inverse, feed = name == "G93", np.nan
        elif name.startswith(UNREAD) and name != "G80":
            return None
    return trimmed(np.array(rows), np.array(cuts), np.array(feeds), np.array(modes))
