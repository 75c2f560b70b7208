"""A FreeCAD path as a ToolPath, and back: what a dressup needs to change the feed moves of any operation and
to leave everything else as it was.

Arcs become chords that are within 0.5 um of them, and arcs again where the feed allows. Words that are not
understood are refused, never dropped.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import re
from dataclasses import dataclass, field

import _patchmill as core
import numpy as np
from _patchmill import InputError, MoveKind

CHORD_ERROR = 0.0005  # mm
NO_MOVE = {"G17", "G21", "G40", "G49", "G54", "G80", "G90", "G94", "G98", "G99", "G4", "G04"}
CYCLES = {"G73", "G74", "G76", "G81", "G82", "G83", "G84", "G85", "G86", "G88", "G89"}
PACED = {"G33", "G61", "G64", "G93", "G95"}
MOVES = {"G0", "G00", "G1", "G01", "G2", "G02", "G3", "G03"}
MOVE_WORDS = set("XYZFIJKABC")
MACHINE_WORDS = re.compile(r"M0?[0-9]|[TS]\d*")  # of M words those that move nothing
ARC_ERROR = 0.005  # mm by which the ends of an arc may differ in their distance from its centre


@dataclass
class BasePath:
    """`commands` of the base operation; for each move of the path the command it comes from."""

    commands: list
    start: tuple = (0.0, 0.0, 0.0)
    tips: list = field(default_factory=list)
    kinds: list = field(default_factory=list)
    feeds: list = field(default_factory=list)  # mm/s
    source: list = field(default_factory=list)  # number of the command of each move
    centres: dict = field(default_factory=dict)  # number of an arc's command -> (x, y) of its centre

    def tool_path(self, tool, spindle):
        """The moves as _patchmill.ToolPath with an upright tool."""
        tips = np.array(self.tips, dtype=float).reshape(-1, 3)
        before = np.vstack([self.start, tips[:-1]]) if len(tips) else tips
        length = np.linalg.norm(tips - before, axis=1)
        feeds = np.array(self.feeds)
        with np.errstate(divide="ignore", invalid="ignore"):
            turns = np.where(feeds > 0.0, spindle.speed * length / feeds, np.nan)
        kinds = np.array(self.kinds, dtype=np.uint8)
        turns[kinds == MoveKind.RAPID] = np.nan
        return core.make_path(tool, spindle, self.start, tips, None, list(kinds), list(turns))


def read(commands, label="Base"):
    """BasePath of a list of Path.Command. Raises InputError naming `label` for paths whose feed is a timing,
    that turn rotary axes, or that are relative."""
    base = BasePath(list(commands))
    at = [None, None, None]
    feed, retract = 0.0, False
    for number, command in enumerate(base.commands):
        name, p = command.Name, command.Parameters
        feed = p.get("F", feed)
        if name in ("G98", "G99"):
            retract = name == "G99"
        if name.startswith("(") or name in NO_MOVE or MACHINE_WORDS.fullmatch(name):
            continue
        _refuse(label, name, p)
        target = [p.get(axis, old) for axis, old in zip("XYZ", at)]
        if name in CYCLES:
            # G98: back to where it was, G99: to the height R
            at = target[:2] + [p.get("R", at[2]) if retract else at[2]]
            continue
        known = None not in at
        if known:
            _add(base, number, name, p, at, target, feed, label)
        elif None not in target:
            base.start = tuple(target)
        at = target
    return base


def _refuse(label, name, parameters):
    if name in PACED:
        raise InputError(label, name, "its feed is a timing, which must not change.")
    if any(parameters.get(axis) for axis in "ABC"):
        raise InputError(label, "rotary words", "its tool is tilted already: choose an upright path.")
    strange = set(parameters) - MOVE_WORDS if name in MOVES else ()
    if name not in CYCLES and name not in MOVES or strange:
        words = " ".join([name, *sorted(strange)])
        raise InputError(label, words, "this word is not understood: choose another operation.")


def _add(base, number, name, parameters, start, end, feed, label):
    if name in ("G0", "G00"):
        points, kind = [end], MoveKind.RAPID
    elif name in ("G1", "G01"):
        points, kind = [end], MoveKind.CUT
    else:
        centre = _centre(label, name, parameters, start, end)
        base.centres[number] = centre
        points, kind = arc_points(start, end, centre, name in ("G2", "G02")), MoveKind.CUT
    if kind == MoveKind.CUT and not feed > 0.0:
        raise InputError(label, "a move without feed", "set the feeds of its tool controller.")
    for point in points:
        if kind == MoveKind.RAPID or math.dist(point, base.tips[-1] if base.tips else base.start) > 1e-9:
            base.tips.append(tuple(point))
            base.kinds.append(kind)
            base.feeds.append(feed)
            base.source.append(number)


def _centre(label, name, parameters, start, end):
    """(x, y) of an arc's centre, which its I and J say from its start."""
    beside = abs(parameters.get("K", 0.0)) > 1e-6  # mm; FreeCAD's ramps have K of 1e-17
    if beside or not (parameters.get("I") or parameters.get("J")):
        raise InputError(label, name, "an arc needs its centre by I and J, in the XY plane.")
    centre = (start[0] + parameters.get("I", 0.0), start[1] + parameters.get("J", 0.0))
    off = abs(math.dist(start[:2], centre) - math.dist(end[:2], centre))
    if off > ARC_ERROR:
        remedy = "its ends are not on one circle, by %.3f mm: choose another operation." % off
        raise InputError(label, name, remedy)
    return centre


def arc_points(start, end, centre, clockwise):
    """Points after `start` up to `end` on an arc or helix about +Z; equal ends make a full circle."""
    a0 = math.atan2(start[1] - centre[1], start[0] - centre[0])
    a1 = math.atan2(end[1] - centre[1], end[0] - centre[0])
    sweep = (a0 - a1 if clockwise else a1 - a0) % (2.0 * math.pi)
    if sweep < 1e-9:
        sweep = 2.0 * math.pi
    r0 = math.dist(start[:2], centre)
    r1 = math.dist(end[:2], centre)
    step = 2.0 * math.acos(max(0.0, 1.0 - CHORD_ERROR / max(r0, r1, CHORD_ERROR)))
    n = max(1, math.ceil(sweep / min(step, 0.5)))
    points = []
    for i in range(1, n):
        t = i / n
        a = a0 + (-sweep if clockwise else sweep) * t
        r = r0 + t * (r1 - r0)
        z = start[2] + t * (end[2] - start[2])
        points.append((centre[0] + r * math.cos(a), centre[1] + r * math.sin(a), z))
    return points + [tuple(end)]


def write(base, path, source, feed_tolerance, make_command):
    """The commands of `base` with the feed moves of `path` in place of their own. `source`: number of the
    base's move for each move of the path; `make_command(name, parameters)` makes a Path.Command."""
    tips, kinds = path.tips, path.kinds
    start = np.vstack([np.array(path.start)[None], tips])[: len(tips)]
    length = np.linalg.norm(tips - start, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        feeds = np.where(path.turns > 0.0, length * path.spindle.speed / path.turns, 0.0)
    command_of = np.array(base.source, dtype=int)[source] if len(source) else np.array([], dtype=int)
    out, done = [], 0
    for number, command in enumerate(base.commands):
        last = done + int(np.searchsorted(command_of[done:], number, side="right"))
        if last == done:
            out.append(command)
        elif kinds[done] == MoveKind.RAPID:
            out.append(command)
        else:
            pieces = _runs(start, tips, feeds, done, last, feed_tolerance, base.centres.get(number))
            out.extend(make_command(*piece) for piece in _words(command, pieces, base.centres.get(number)))
        done = last
    return out


def _runs(start, tips, feeds, first, last, tolerance, centre):
    """Stretches of equal feed, as (start, end, feed): chords of an arc become one, up to half a circle."""
    runs: list = []
    for i in range(first, last):
        joins = False
        if runs and centre is not None:
            begin, _, feed, turned = runs[-1]
            more = _turn(start[i], tips[i], centre)
            joins = abs(feeds[i] - feed) <= tolerance and turned + more < math.pi
        if joins:
            runs[-1] = (begin, tips[i], feed, turned + more)
        else:
            runs.append((start[i], tips[i], feeds[i], _turn(start[i], tips[i], centre) if centre else 0.0))
    return [run[:3] for run in runs]


def _turn(a, b, centre):
    u, v = np.array(a[:2]) - centre, np.array(b[:2]) - centre
    return abs(math.atan2(u[0] * v[1] - u[1] * v[0], float(u @ v)))


def _words(command, pieces, centre):
    for start, end, feed in pieces:
        words = {"X": end[0], "Y": end[1], "Z": end[2], "F": feed}
        if centre is None:
            yield "G1", words
        else:
            words.update(I=centre[0] - start[0], J=centre[1] - start[1])
            yield command.Name, words
