"""A posted program as the moves that a control makes of it, so that every operation of a job is found in it,
in the order in which it was posted: which moves are its own, with which tool, under which work offset.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import re
from dataclasses import dataclass, replace

import _patchmill as core
import numpy as np

ROUNDED_TWICE = 1e-6  # mm, degrees: posts that take FreeCAD's text of a path round what has six decimals
HALF_LEAD = 0.51e-6  # mm: K has six decimals
SAVED_FEED = 3.1e-5  # mm/min, 1/min: FreeCAD's text has F in mm/s, 1/s with six decimals
CHORD_ERROR = 1e-3  # mm, of arcs as they are read
COMMENT = re.compile(r"\([^)]*\)|;.*")


def any_tool():
    """A tool for reading what does not depend on it. Not a constant: there may be no core to make it."""
    return core.BallEndMill(1.0, 2)


@dataclass
class Told:
    """The moves of an operation from the first to the last that takes time. `ends`: (n, 6) of X Y Z [mm] and
    A B C [degrees], nan where no word said it yet; `cuts`: whether each is a feed move or a dwell; `feeds`:
    [mm/min, or 1/min where `inverse`], nan where nothing is to be compared; `arcs`: moves that follow each
    other with the same number, of 0 or more, are chords of an arc, which others may cut into other chords;
    `leads`: of moves that follow the spindle [mm per turn], nan of others; `tcp`: whether tool-centre-point
    control is on; `start`: X Y Z before the first of them, nan where no word said it yet."""

    ends: np.ndarray
    cuts: np.ndarray
    feeds: np.ndarray
    inverse: np.ndarray
    arcs: np.ndarray
    leads: np.ndarray
    tcp: np.ndarray
    start: np.ndarray

    def __len__(self):
        return len(self.cuts)


@dataclass
class Run:
    """Where an operation was found: moves `first` to before `end`; `found` of its moves are there at best,
    all of them if `complete`. `owners`: for each move of the text the move told that it is, or is of."""

    found: int = 0
    first: int = 0
    end: int = 0
    complete: bool = False
    owners: np.ndarray = None


class PostedProgram:
    """The moves of a program, all sections in one; `tcp_words`: the machine's own M words that switch TCP on
    and off, or ''. Raises InputError for words that are not read."""

    def __init__(self, text, dialect, tcp_words=("", "")):
        self.text, self.dialect = text, dialect
        self.sections = core.read_gcode(text, any_tool(), dialect, True, *tcp_words)
        self.begins = np.cumsum([0] + [len(s.path) for s in self.sections])
        self.ends = _stacked([np.hstack([s.path.tips, np.degrees(s.angles[1:])]) for s in self.sections], 6)
        self.starts = _stacked([_starts(s) for s in self.sections], 3)
        timed = [s.path.kinds != core.MoveKind.RAPID for s in self.sections]
        self.cuts = np.concatenate(timed or [np.zeros(0, bool)])
        kinds = [s.path.kinds for s in self.sections]
        self.moving = np.concatenate(kinds or [np.zeros(0, int)]) == core.MoveKind.CUT  # without dwells
        self.feeds = np.concatenate([s.feeds for s in self.sections] or [np.zeros(0)])
        self.inverse = np.concatenate([s.inverse for s in self.sections] or [np.zeros(0, bool)])
        self.tcp = np.concatenate([s.tcp for s in self.sections] or [np.zeros(0, bool)])
        code = COMMENT.sub("", text)
        self.unit = 25.4 if re.search(r"\bG20\b", code) else 1.0  # mm per unit of lengths
        self.half_feed = self.unit * _half_last(r"F\+?\d+\.?(\d*)", code)  # rounding of F words
        self.half_minutes = _half_last(r"FT\d+\.?(\d*)", code) / 60.0  # of moves that are told their time

    def __len__(self):
        return len(self.cuts)

    def find(self, told, half_unit, after=0):
        """Run of the moves told, in one piece, from move `after` on: the first that is complete, else the
        longest. Moves that move nothing may be missing in the text."""
        best = Run()
        if not len(told):
            return Run(complete=True, first=after, end=after)
        near = half_unit + ROUNDED_TWICE
        starts = (self.cuts[after:] == told.cuts[0]) & _same(self.ends[after:], told.ends[0], near)
        for first in after + np.flatnonzero(starts):
            found, owners = _run(told, self.ends[first:], self.cuts[first:], near)
            if found > best.found:
                best = Run(found, int(first), int(first + len(owners)), found == len(told), owners)
            if best.complete:
                break
        return best

    def section_of(self, move):
        """(number of the section of a move, number of the move in it)."""
        number = int(np.searchsorted(self.begins, move, side="right")) - 1
        return number, int(move - self.begins[number])

    def part(self, first, end, tool):
        """_patchmill.ProgramSection of the moves `first` to before `end`, cut by `tool`; those of it that are
        in the section of the last one."""
        number, last = self.section_of(end - 1)
        begin = max(0, first - int(self.begins[number]))
        return self.sections[number].part(begin, last + 1, tool)

    def line_of(self, move):
        number, index = self.section_of(move)
        return int(self.sections[number].lines[index])

    def lowest_blind(self, lines):
        """The lowest Z [mm] that blocks of these lines name before X and Y were both named in them; infinite
        if none."""
        wanted, known, lowest = set(lines), set(), math.inf
        for number, words in core.program_lines(self.text, self.dialect) if wanted else ():
            if number not in wanted:
                continue
            named = dict(words)
            known |= named.keys() & {"X", "Y"}
            if "Z" in named and len(known) < 2:
                lowest = min(lowest, named["Z"])
        return lowest

    def offset_at(self, move):
        """Number of the work offset in force (1: G54), None where the text has said none."""
        said = self.sections[self.section_of(move)[0]].offset
        return offset_number(said) if said else None

    def leads(self, first, end):
        """(leads [mm per turn] of moves that follow the spindle, nan of others; how many times as long the
        way of each is as its part along the axis that moves most, which some controls go by)."""
        turns = np.concatenate([s.path.turns for s in self.sections])[first:end]
        steps = np.diff(self.ends[max(first - 1, 0) : end, :3], axis=0)
        steps = np.vstack([np.full((1, 3), np.nan), steps]) if first == 0 else steps
        way, longest = np.linalg.norm(steps, axis=1), np.abs(steps).max(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            locked = self.cuts[first:end] & np.isnan(self.feeds[first:end]) & (way > 0.0)
            return np.where(locked, way / turns, np.nan), way / longest

    def lengths(self, first, end):
        """The way of X Y Z that each move goes [mm], nan where its start is not known."""
        points = self.ends[max(first - 1, 0) : end, :3]
        way = np.linalg.norm(np.diff(points, axis=0), axis=1)
        return np.concatenate([[np.nan], way]) if first == 0 else way


def _half_last(pattern, code):
    """Half a unit of the last decimal of words of a pattern whose group is the decimals."""
    return 0.5 * 10.0 ** -max((len(decimals) for decimals in re.findall(pattern, code)), default=0)


def offset_number(name):
    """Number of a work offset from its name: G54 to G59, G59.1 and on, a Fanuc's G54.1 P1, a Siemens' G505
    and on, a Heidenhain's preset; 0 for other names."""
    further = re.fullmatch(r"(?:G54\.1 P|G59\.)(\d+)", name)
    if further:
        return 6 + int(further.group(1))
    plain = re.fullmatch(r"G5([4-9])", name)
    if plain:
        return int(plain.group(1)) - 3
    other = re.fullmatch(r"(?:G5|preset )(\d\d?)", name)
    return int(other.group(1)) if other else 0


def work_offset(obj):
    """Name of the work offset that an object handed to the post-processor stands for; '' of others.
    It is the label in FreeCAD 0.20, the command of the path from 1.0 on."""
    if hasattr(obj, "Proxy"):
        return ""
    path = getattr(obj, "Path", None)
    names = [getattr(obj, "Label", ""), *(command.Name for command in (path.Commands if path else ()))]
    return next((name for name in names if offset_number(name)), "")


def _starts(section):
    """X Y Z where each move of a section begins, nan where nobody knows."""
    starts = np.vstack([np.array(section.path.start)[None], section.path.tips])[:-1]
    starts[: section.unplaced] = np.nan
    return starts


def _stacked(arrays, columns):
    return np.vstack(arrays) if arrays else np.zeros((0, columns))


def _same(read, told, near):
    return np.all(np.isnan(told) | (np.abs(read - told) <= near), axis=-1)


def _run(told, read, read_cuts, near):
    """(how many of the told moves are at the beginning of what was read, which of them each read move is)."""
    n = min(len(told), len(read))
    alike = n == len(told) and np.array_equal(read_cuts[:n], told.cuts)
    if alike and np.all(_same(read[:n], told.ends, near)):
        return n, np.arange(n)
    owners: list[int] = []
    i = 0
    while i < len(told):
        at = len(owners)
        if told.arcs[i] >= 0:
            last = i + int(np.argmax(np.append(told.arcs[i:] != told.arcs[i], True)))
            along = told.ends[max(i - 1, 0) : last, :3]
            chords = _along_arc(along, read[at:, :3], read_cuts[at:], near)
            if not chords and at and np.abs(along - read[at - 1, :3]).max() <= 3.0 * near:
                i = last  # all of it is where the tool stands
                continue
            if not chords:
                return i, np.array(owners, int)
            owners += [last - 1] * chords
            i = last
            continue
        if at < len(read) and read_cuts[at] == told.cuts[i] and _same(read[at], told.ends[i], near):
            owners.append(i)
        elif at == 0 or not _same(read[at - 1], told.ends[i], 2.0 * near):
            return i, np.array(owners, int)
        i += 1
    return i, np.array(owners, int)


def _along_arc(chords, read, read_cuts, near):
    """How many of the read moves go along the chords, from their first point to their last; 0 if they do
    not."""
    off = 4.0 * near + 2.5 * CHORD_ERROR
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(chords, axis=0), axis=1))])
    at, gone = chords[0], 0.0
    for number, (point, cut) in enumerate(zip(read, read_cuts), 1):
        gone += float(np.linalg.norm(point - at))
        at = point
        there = [np.interp(gone, way, chords[:, axis]) for axis in range(3)]
        if not cut or np.linalg.norm(point - there) > off or gone > way[-1] + off:
            return 0
        if gone >= way[-1] - off and np.abs(point - chords[-1]).max() <= near:
            return number
    return 0


def trimmed(ends, cuts, feeds=None, inverse=None, arcs=None, leads=None, tcp=None, starts=None):
    """Told of moves, from the first to the last that takes time."""
    where = np.flatnonzero(cuts)
    run = slice(where[0], where[-1] + 1) if len(where) else slice(0, 0)
    feeds = np.full(len(cuts), np.nan) if feeds is None else feeds
    inverse = np.zeros(len(cuts), bool) if inverse is None else inverse
    arcs = np.full(len(cuts), -1) if arcs is None else arcs
    leads = np.full(len(cuts), np.nan) if leads is None else leads
    tcp = np.zeros(len(cuts), bool) if tcp is None else tcp
    if starts is None:
        starts = np.vstack([np.full((1, 3), np.nan), ends[:-1, :3]]) if len(ends) else ends[:, :3]
    start = starts[run.start] if len(where) else np.full(3, np.nan)
    return Told(ends[run], cuts[run], feeds[run], inverse[run], arcs[run], leads[run], tcp[run], start)


def other_angles(program, told, half_unit, after):
    """What helps for a path that is not there; where it is but for the rotary axes, those are named."""
    anywhere = replace(told, ends=told.ends.copy())
    anywhere.ends[:, 3:] = np.nan
    run = program.find(anywhere, half_unit, after)
    if not run.complete:
        return "the post-processor changed the path: use another one."
    a, b, c = program.ends[run.first][3:]
    return "the rotary axes stand at A%.3f B%.3f C%.3f there: bring them back before it." % (a, b, c)
