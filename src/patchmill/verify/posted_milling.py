"""Copy milling and DCM modifiers read back from a posted program: from the first to the last move that cuts,
every move must be there, in order, with nothing in between, and with the rotary words that the path has.
A program with words that are not read (arcs and cycles of other operations) leaves this unknown, and says so.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass

import _patchmill as core
import FreeCAD
import numpy as np
from _patchmill import InputError

from patchmill.freecad.kinds import COPY_MILLING, DCM, kind_of

AXES = "XYZABC"
MOVES = {"G0": False, "G00": False, "G1": True, "G01": True}  # whether it cuts
ROUNDED_TWICE = 1e-6  # mm, degrees: posts that take FreeCAD's text of a path round what has six decimals
UNREAD = ("G2", "G3", "G02", "G03", "G7", "G8")  # arcs; and cycles, which begin so


@dataclass
class PostedMilling:
    """One operation or dressup of a posted program."""

    operation: object  # document object
    moves: int = 0  # read back
    unknown: str = ""  # why it was not read back, or ''


def with_those_under(op):
    """An operation or dressup, and what dressups are on."""
    while hasattr(op, "Proxy"):
        yield op
        op = getattr(op, "Base", None)


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
    told, cuts = _told(operation.Path.Commands)
    if told is None:
        return _unknown(operation, "its arcs and drilling cycles are not read back")
    try:
        sections = core.read_gcode(text, core.BallEndMill(1.0, 2), dialect, rotary=True)  # any tool
    except InputError as error:
        return _unknown(operation, "the program cannot be read back (%s)" % error)
    found = 0
    for section in sections:
        read = np.hstack([section.path.tips, np.degrees(section.angles[1:])])
        found = max(found, _found(told, cuts, read, section.path.kinds > 0, half_unit))
    if found < len(told):
        said = "%d of %d moves read back" % (found, len(told))
        raise InputError(operation.Label, said, "the post-processor changed the path: use another one.")
    return PostedMilling(operation, found)


def _unknown(operation, why):
    FreeCAD.Console.PrintWarning("%s: %s: compare it with the path yourself.\n" % (operation.Label, why))
    return PostedMilling(operation, unknown=why)


def _told(commands):
    """(ends, cuts) of the moves from the first to the last that cuts: an n x 6 array of X Y Z [mm] A B C
    [degrees], nan where no word said it yet; (None, None) if there are words that are not read."""
    at = dict.fromkeys(AXES[:3], np.nan) | dict.fromkeys(AXES[3:], 0.0)
    rows, cuts = [list(at.values())], [False]
    for command in commands:
        if command.Name in MOVES:
            at.update((name, value) for name, value in command.Parameters.items() if name in at)
            rows.append(list(at.values()))
            cuts.append(MOVES[command.Name])
        elif command.Name.startswith(UNREAD) and command.Name != "G80":
            return None, None
    return _trimmed(np.array(rows), np.array(cuts))


def _trimmed(ends, cuts):
    where = np.flatnonzero(cuts)
    run = slice(where[0], where[-1] + 1) if len(where) else slice(0, 0)
    return ends[run], cuts[run]


def _found(told, cuts, read, read_cuts, tolerance):
    """How many of the told moves the text has in one run, from the first on: at best."""
    if not len(told):
        return 0
    near = tolerance + ROUNDED_TWICE
    best = 0
    starts = read_cuts & _same(read, told[0], near)
    for start in np.flatnonzero(starts):
        best = max(best, _run(told, cuts, read[start:], read_cuts[start:], near))
        if best == len(told):
            break
    return best


def _same(read, told, near):
    return np.all(np.isnan(told) | (np.abs(read - told) <= near), axis=-1)


def _run(told, cuts, read, read_cuts, near):
    """Moves of less than a unit of the text may be missing there, for they move nothing."""
    n = min(len(told), len(read))
    if n == len(told) and np.all(_same(read[:n], told, near)) and np.array_equal(read_cuts[:n], cuts):
        return n
    at = 0
    for i, (end, cut) in enumerate(zip(told, cuts)):
        if at < len(read) and read_cuts[at] == cut and _same(read[at], end, near):
            at += 1
        elif at == 0 or not _same(read[at - 1], end, 2.0 * near):
            return i
    return len(told)
