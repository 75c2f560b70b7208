"""A job as several programs: by work offset, tool or operation as the job's SplitOutput says, and so that
none has more patches, or is larger, than is given. Each is a program of its own, with its tool and offset; a
texture that goes on in the next file begins there with a run-in, locked to the spindle anew. Each is read
back and checked like any other; a table says what is in which.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib
import csv
import io
import os
from dataclasses import dataclass, field, replace

from _patchmill import InputError

from patchmill import posting
from patchmill.freecad import host
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.machine import machining_time
from patchmill.operations.computed import planned
from patchmill.posting import rest_of_job
from patchmill.system import files

COLUMNS = ("file", "work offsets", "tools", "operations", "patches", "dimples", "blocks", "kB", "time")


@dataclass
class PostedFile:
    """One of several programs. `posted`: what patchmill.post() returns; `row`: its line of the table."""

    filename: str
    posted: list
    row: dict
    text: str = field(repr=False, default="")


@dataclass
class _Piece:
    """Operations under work offsets, with the patches of textures that are not taken whole."""

    offsets: list
    operations: list
    patches: dict = field(default_factory=dict)  # texture: (first, last)

    def range_of(self, op):
        """First and last patch of a texture that are milled; None of what cannot be divided."""
        if kind_of(op) != TEXTURE:
            return None
        plan = planned(op)
        if plan.free is not None:
            return None
        return self.patches.get(op, (op.FirstPatch, op.LastPatch or plan.patches))

    def halves(self):
        """Two pieces that are this one, or none."""
        for name in ("offsets", "operations"):
            things = getattr(self, name)
            if len(things) > 1:
                middle = len(things) // 2
                return [replace(self, **{name: part}) for part in (things[:middle], things[middle:])]
        first, last = self.range_of(self.operations[0]) or (1, 1)
        if first == last:
            return []
        middle = (first + last) // 2
        return [_Piece(self.offsets, self.operations, {self.operations[0]: ends})
                for ends in ((first, middle), (middle + 1, last))]  # fmt: skip


def post_files(job, filename, patches=0, kilobytes=0.0, post_name=None, arguments=None):
    """Posts `job` as several programs; "mould.ngc" becomes mould-01.ngc and so on, in the order in which they
    are run, and a table of them mould-files.csv. Returns a list of PostedFile. All are read back and checked
    before the first is written.

    The job's SplitOutput and OrderOutputBy say whether each work offset, tool or operation has a file of its
    own. `patches`: how many patches of textures a file has at most; `kilobytes`: how large it is at most; 0:
    any. `post_name` and `arguments`: as in patchmill.post().
    Raises InputError as post() does, and naming Patches, Kilobytes or filename: a file of an earlier posting
    that would be taken for one of these is named."""
    filename = files.name_of(filename)
    files.require_place(filename)
    for name, value in (("Patches", patches), ("Kilobytes", kilobytes)):
        if not value >= 0:
            raise InputError(name, repr(value), "give how many a file has at most, or 0.")
    job.Document.recompute()
    pieces = [piece for group in _groups(job) for piece in _divided(group, patches)]
    if not pieces:
        raise InputError("Operations", "none", "the job has no active operation.")
    with _in_one_file(job):
        made = [one for piece in pieces for one in _posted(job, piece, kilobytes, post_name, arguments)]
    _name(made, filename)
    for one in made:
        posting.write(one.filename, one.text)
    table = _table(made).encode("utf-8", "surrogateescape")  # a file's name may be in any encoding
    files.write(_stem(filename) + "-files.csv", table)
    return made


def _stem(filename):
    return os.path.splitext(filename)[0]


@contextlib.contextmanager
def _in_one_file(job):
    """The job without FreeCAD's own division into files, and then as it was, recomputed."""
    split = job.SplitOutput
    try:
        job.SplitOutput = False
        yield
    finally:
        job.SplitOutput = split
        job.Document.recompute()


def _groups(job):
    """_Pieces that the job itself asks to have in files of their own."""
    offsets = list(job.Fixtures)
    operations = [op for op in job.Operations.Group if host.is_active(op)]
    if not job.SplitOutput or not operations:
        return [_Piece(offsets, operations)] if operations else []
    if job.OrderOutputBy == "Fixture":
        return [_Piece([offset], operations) for offset in offsets]
    runs: list = []
    for op in operations:
        tool = posting.tool_of(op)
        if job.OrderOutputBy == "Operation" or not runs or runs[-1][0] != tool:
            runs.append((tool, []))
        runs[-1][1].append(op)
    return [_Piece(offsets, run) for _, run in runs]


def _divided(group, most):
    """The _Pieces of one with at most so many patches each, under one work offset each; 0: any number."""
    if not most:
        return [group]
    pieces = []
    for offset in group.offsets:
        room = 0
        for op in group.operations:
            first, last = group.range_of(op) or (1, 1)
            needed = last - first + 1 if kind_of(op) == TEXTURE else 0
            if needed > most:
                for begin in range(first, last + 1, most):
                    pieces.append(_Piece([offset], [op], {op: (begin, min(begin + most - 1, last))}))
                room = 0
                continue
            if not pieces or pieces[-1].offsets != [offset] or pieces[-1].patches or needed > room:
                pieces.append(_Piece([offset], []))
                room = most
            pieces[-1].operations.append(op)
            room -= needed
    return pieces


def _posted(job, piece, kilobytes, post_name, arguments):
    """PostedFiles, without their names, of a _Piece: one if it is small enough."""
    with rest_of_job.part(job, piece.operations, piece.offsets, piece.patches):
        text, posted = posting.text_of(job, post_name, arguments, 1000.0 * kilobytes)
        if posted is not None:
            return [PostedFile("", posted, _row(piece, posted, text), text)]
    halves = piece.halves()
    if not halves:
        labels = ", ".join(op.Label for op in piece.operations)
        remedy = "%s of %s has %.1f: no smaller piece is made of it." % (
            labels, ", ".join(piece.offsets), len(text) / 1000.0)  # fmt: skip
        raise InputError("Kilobytes", "%g" % kilobytes, remedy)
    return [one for half in halves for one in _posted(job, half, kilobytes, post_name, arguments)]


def _row(piece, posted, text):
    ranges = {op: piece.range_of(op) for op in piece.operations}
    textures = [op for op in piece.operations if kind_of(op) == TEXTURE]
    times = [machining_seconds(op) for op in piece.operations]
    said = ["%s %d-%d" % (op.Label, *ends) for op, ends in ranges.items() if ends]
    dimples = sum(planned(op).counts["cut"] for op in textures)
    known = None not in times
    return {
        "work offsets": " ".join(piece.offsets),
        "tools": " ".join("T%d" % n for n in dict.fromkeys(map(posting.tool_of, piece.operations))),
        "operations": ", ".join(op.Label for op in piece.operations),
        "patches": ", ".join(said),
        "dimples": dimples * len(piece.offsets),
        "blocks": text.count("\n"),
        "kB": "%.1f" % (len(text) / 1000.0),
        "time": machining_time.clock(sum(times) * len(piece.offsets)) if known else "",
    }


def machining_seconds(op):
    """Time of an operation or dressup [s]: ours, or what FreeCAD says; None if nothing is known."""
    if hasattr(op, "MachiningTime"):
        return op.MachiningTime
    parts = str(getattr(op, "CycleTime", "")).split(":")
    if len(parts) == 3 and all(part.isdigit() for part in parts):
        return float(sum(int(part) * unit for part, unit in zip(parts, (3600, 60, 1))))
    return machining_seconds(op.Base) if hasattr(getattr(op, "Base", None), "Path") else None


def _name(made, filename):
    """Gives the files their names. Raises InputError if there is one more, of an earlier posting."""
    stem, ending = os.path.splitext(filename)
    width = max(2, len(str(len(made))))
    for number, one in enumerate(made, 1):
        one.filename = "%s-%0*d%s" % (stem, width, number, ending)
        one.row = {"file": os.path.basename(one.filename)} | one.row
        files.require_place(one.filename)
    following = "%s-%0*d%s" % (stem, width, len(made) + 1, ending)
    if os.path.lexists(following):
        remedy = "it is of an earlier posting, and would be run after these: take it away."
        raise InputError("filename", repr(following), remedy)


def _table(made):
    out = io.StringIO()
    writer = csv.DictWriter(out, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(one.row for one in made)
    return out.getvalue()
