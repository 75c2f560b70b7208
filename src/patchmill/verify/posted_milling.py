"""Copy milling and DCM modifiers read back from a posted program: from the first to the last move that cuts,
every move must be there, in order, with nothing in between, and with the rotary words that the path has.
A program with words that are not read (arcs and cycles of other operations) leaves this unknown, and says so.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re
from dataclasses import dataclass

import FreeCAD
import numpy as np
from _patchmill import InputError

from patchmill.freecad.kinds import COPY_MILLING, DCM, kind_of
from patchmill.verify.posted_program import HALF_LEAD, SAVED_FEED, PostedProgram, other_angles, trimmed

AXES = "XYZABC"
MOVES = {"G0": False, "G00": False, "G1": True, "G01": True}  # whether it cuts
DWELLS = ("G4", "G04")
ARCS = ("G2", "G3", "G02", "G03")
CYCLES = ("G73", "G74", "G81", "G82", "G83", "G85", "G86", "G89")
MODES = CYCLES + ("G91", "G53", "G33", "G18", "G19", "G20", "G92")
NOT_READ = ("G43", "G49", "G61", "G64", "G54", "G55", "G56", "G57", "G58", "G59")  # they move nothing
TCP_ON, TCP_OFF = ("G43.4", "M428"), ("G49", "M429")
SAME_FEED = 5e-6  # of F: our posts repeat one that is off by less where a control has no inverse time


@dataclass
class PostedMilling:
    """One operation or dressup of a posted program."""

    operation: object  # document object
    moves: int = 0  # read back
    unknown: str = ""  # why it was not read back, or ''
    offset: str = ""  # work offset of this copy
    check: object = None  # the checks.CheckResult of gouge and collision, at the first copy of what is ours


def with_those_under(op):
    """An operation or dressup, and what dressups and arrays are on."""
    if not hasattr(op, "Proxy"):
        return
    yield op
    base = getattr(op, "Base", None)
    for under in base if isinstance(base, (list, tuple)) else [base]:
        if hasattr(under, "isDerivedFrom") and under.isDerivedFrom("Path::Feature"):
            yield from with_those_under(under)


def controller_of(op):
    """The tool controller of an operation, or of the one under dressups; None if there is none."""
    parts = (op, *with_those_under(op))
    return next((part.ToolController for part in parts if hasattr(part, "ToolController")), None)


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
    try:
        told = told_by(operation.Path.Commands)
        program = PostedProgram(text, dialect)
    except InputError as error:
        return unknown(operation, UNREADABLE % error)
    return find(operation, told, program, half_unit)[0]


UNREADABLE = "the program cannot be read back (%s)"


def find(operation, told, program, half_unit, after=0):
    """(PostedMilling, posted_program.Run) of what is told of `operation`, in a PostedProgram from its move
    `after` on. Raises InputError naming the operation if it is not there."""
    run = program.find(told, half_unit, after)
    if not run.complete:
        said = "%d of %d moves read back" % (run.found, len(told))
        raise InputError(operation.Label, said, other_angles(program, told, half_unit, after))
    _require_feeds(operation, told, program, run, half_unit)
    return PostedMilling(operation, len(told)), run


def _require_feeds(operation, told, program, run, half_unit):
    """Every move has the F of its path, to the last decimal that the program writes. Where a control has no
    inverse time, F is of the way before its ends were rounded."""
    moves = slice(run.first, run.end)
    read, wanted, inverse = program.feeds[moves], told.feeds[run.owners], told.inverse[run.owners]
    near = program.half_feed + SAVED_FEED + 1e-9 * np.nan_to_num(wanted)
    if program.half_minutes < 0.5 / 60.0:  # some are told their time instead
        near = near + np.where(inverse & program.inverse[moves], program.half_minutes * wanted**2, 0.0)
    replaced = inverse & ~program.inverse[moves]
    if replaced.any():
        way = program.lengths(run.first, run.end)
        with np.errstate(divide="ignore", invalid="ignore"):
            near = np.where(replaced, near + 4.0 * half_unit * wanted + SAME_FEED * way * wanted, near)
            wanted = np.where(replaced, np.where(way > 0.0, way * wanted, np.nan), wanted)
    with np.errstate(invalid="ignore"):
        off = (np.abs(read - wanted) > near) | (program.inverse[moves] & ~inverse & ~np.isnan(wanted))
        off |= np.isnan(read) & ~np.isnan(wanted)
        leads, slants = program.leads(run.first, run.end)
        off |= np.abs(leads - told.leads[run.owners]) > HALF_LEAD * slants
    if off.any():
        move = int(np.flatnonzero(off)[0])
        unit = "1/min" if program.inverse[moves][move] else "mm/min"
        said = "F %.9g %s in line %d" % (read[move], unit, program.line_of(run.first + move))
        remedy = "the operation has F %.9g there: use another post-processor." % wanted[move]
        if not np.isnan(leads[move]):
            said = "a lead of %.6f mm in line %d" % (leads[move], program.line_of(run.first + move))
            remedy = "the operation has another one there: use another post-processor."
        raise InputError(operation.Label, said, remedy)


def require_read(operations, tcp_words):
    """Raises InputError naming an operation whose path cannot be read, as the program was not."""
    for op in operations:
        try:
            told_by(op.Path.Commands, tcp_words)
        except InputError as error:
            raise InputError(op.Label, error.value, error.remedy) from error


def unknown(operation, why):
    """PostedMilling of an operation that was not read back; says so in the report view."""
    FreeCAD.Console.PrintWarning("%s: %s: compare it with the path yourself.\n" % (operation.Label, why))
    return PostedMilling(operation, unknown=why)


def told_by(commands, tcp_words=("", "")):
    """posted_program.Told of Path.Command objects, from the first to the last that takes time; `tcp_words`:
    as of PostedProgram. Raises InputError for what cannot be read."""
    if any(c.Name in ARCS or c.Name in MODES or "G" in c.Parameters for c in commands):
        return _told_by_reading(commands, tcp_words)
    tcp, tcps = False, [False]
    at = dict.fromkeys(AXES[:3], np.nan) | dict.fromkeys(AXES[3:], 0.0)
    feed, inverse = np.nan, False
    rows, cuts, feeds, modes = [list(at.values())], [False], [np.nan], [False]
    for command in commands:
        name = command.Name
        tcp = _tcp_after(name, tcp, tcp_words)
        if name in MOVES or name in DWELLS:
            tcps.append(tcp)
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
    return trimmed(np.array(rows), np.array(cuts), np.array(feeds), np.array(modes), tcp=np.array(tcps))


def _tcp_after(name, tcp, tcp_words):
    """Whether tool-centre-point control is on after a word, if it was before it or not."""
    if name in TCP_ON or name == tcp_words[0]:
        return True
    return tcp and name not in TCP_OFF and name != tcp_words[1]


def _told_by_reading(commands, tcp_words):
    """The same of paths with arcs, cycles and relative moves: as the reader of programs takes them."""
    lines, kinds, tcp = ["G17 G21 G90 G94", "M3 S60"], [None, None], False
    for command in commands:
        before, tcp = tcp, _tcp_after(command.Name, tcp, tcp_words)
        if tcp != before:
            lines.append("G43.4 H1" if tcp else "G49")
            kinds.append(None)
            continue
        beside = ["G%g" % v for k, v in command.Parameters.items() if k == "G"]  # G90 G1 X5, N10 G1 X5
        names = [name for name in [command.Name, *beside] if re.fullmatch(r"G\d+(\.\d)?", name)]
        names = [name for name in names if name not in NOT_READ]
        if names:
            words = [(k, 60.0 * v if k == "F" else v) for k, v in command.Parameters.items() if k != "G"]
            arc = next(filter(ARCS.__contains__, names), None)
            if arc:  # FreeCAD gives three words for a centre, two of them in the plane
                words = [(k, v) for k, v in words if k not in "IJK" or round(v, 6) != 0.0]
            lines.append(" ".join(names) + "".join(" %s%.6f" % word for word in words))
            kinds.append(arc)
    program = PostedProgram("\n".join(lines) + "\n", "linuxcnc")
    if not len(program):
        return trimmed(np.zeros((0, 6)), np.zeros(0, bool))
    line = np.concatenate([s.lines for s in program.sections]) - 1
    arc = np.array([kind in ARCS for kind in kinds])[line]
    leads, _ = program.leads(0, len(program))
    arcs = np.where(arc, line, -1)
    others = (program.inverse, arcs, leads, program.tcp, program.starts)
    return trimmed(program.ends, program.cuts, program.feeds, *others)
