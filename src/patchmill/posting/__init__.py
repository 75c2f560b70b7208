"""Posting through FreeCAD's post-processors, with the text read back and checked before it is kept.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re
from dataclasses import dataclass
from typing import Any

from _patchmill import InputError

from patchmill.system import files
from patchmill.freecad import host
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.operations.computed import planned
from patchmill.operations.copy_input import UNDERCUTS
from patchmill.posting import (
    control_match,
    job_words,
    kept_words,
    program_header,
    requirements,
    rest_of_job,
)
from patchmill.posting.control_match import own_dialect
from patchmill.verify import checks, posted_job, posted_milling
from patchmill.verify.posted_texture import PostedTexture
from patchmill.system.stops import stoppable


@stoppable
def post(job, filename, post_name=None, arguments=None, progress=None):
    """Posts `job` to `filename` and returns a list: a PostedTexture for each texture operation, and then a
    PostedMilling for each other operation; under several work offsets one for each copy.

    `post_name` and `arguments` default to the job's own; the folder of `filename` must be there. The text is
    read back, offset by offset and operation by operation, compared with the plans and their phase measured;
    only then does the file appear, whole. None, and no file, if `progress` (share -> bool) returned False.
    Raises InputError, leaving no file and an existing one untouched, if an operation is invalid, if the text
    does not hold the plan, or if the tool would gouge or collide (docs/checks.md)."""
    files.require_place(filename)  # before the work, not after it
    made = text_of(job, post_name, arguments, progress=progress)
    if made is None:
        return None
    text, posted = made
    write(filename, text)
    return posted


def text_of(job, post_name=None, arguments=None, most=0.0, progress=None):
    """(the program of a job, what post() returns). Where it has more than `most` characters (0: any number),
    it is not read back, and the second is None. None if `progress` returned False. Raises InputError as
    post() does."""
    progress = progress or (lambda share: True)
    ready = _ready(job, post_name, arguments)
    if not progress(0.1):
        return None
    text = _single_text(job, ready.post_name, ready.arguments)
    if most and len(text) > most:
        return text, None
    posted = _read_back(ready, text, progress) if progress(0.3) else None
    return None if posted is None else (text, posted)


def read_back(job, filename, post_name=None, arguments=None):
    """What post() returns, of a program that is there: whether the file holds every operation of `job` as it
    is now, with nothing beside. Raises InputError naming what is not there or otherwise, and Program if it
    cannot be read."""
    ready = _ready(job, post_name, arguments)
    text = files.read_text(filename, "Program", other="latin-1")
    if not text.strip():
        raise InputError("Program", repr(str(filename)), "it is empty: give the program of this job.")
    return _read_back(ready, text, lambda _: True)


@dataclass
class _Ready:
    """A job that can be posted: what its program is made of and compared with."""

    job: Any
    post_name: str
    arguments: str
    operations: list
    own: Any  # post_dialect.Dialect of a post of ours, else None
    decimals: int


def _ready(job, post_name, arguments):
    """_Ready of a job. Raises InputError if an operation is invalid, or cannot be posted so."""
    post_name = post_name or job.PostProcessor
    arguments = job.PostProcessorArgs if arguments is None else arguments
    words = requirements.split_arguments(arguments)
    requirements.check_preamble(words)
    requirements.check_offsets(job.Fixtures)
    job_words.require_lines([op for op in job.Operations.Group if host.is_active(op)])
    operations = _active_operations(job)
    control_match.require_one_machine(operations)
    requirements.require_memory(operations, job.Fixtures)
    requirements.check_tools(operations)
    textures = [op for op in operations if kind_of(op) == TEXTURE]
    plans = [planned(op) for op in textures]
    post_name = post_name or control_match.post_for(plans)
    if not re.fullmatch(r"\w+", post_name, re.ASCII):
        raise InputError("PostProcessor", repr(post_name), "give the name of a post-processor.")
    machine = program_header.machine_of(operations)
    for op, plan in zip(textures, plans):
        requirements.check_verdict(op, plan)
        requirements.check_calibration(plan)
        requirements.check_arguments(post_name, plan, words, machine)
    own = own_dialect(post_name)
    job_words.require_own(operations, job.Fixtures, own)
    decimals = requirements.decimals_of(post_name, words, machine)
    control_match.require(post_name, own.dialect if own else "", decimals, plans)
    tilted = [dressup for op in operations if (dressup := posted_milling.posture_of(op)) is not None]
    if tilted:
        requirements.require_millimetres(tilted[0].Label, words)
    requirements.check_post(post_name, plans, tilted)
    return _Ready(job, post_name, arguments, operations, own, decimals)


def require_holds(text, objects, post_name, arguments):
    """Raises InputError if a program of `objects`, as FreeCAD hands them to one of PatchMill's own posts,
    does not hold their job, or could not be posted by post()."""
    job = next(filter(None, map(host.PathUtils.findParentJob, filter(_in_document, objects))), None)
    if job is None:
        raise InputError("Job", "none", "post the operations of a job.")
    active = [o for o in objects if host.is_active(o)]
    _read_back(_ready(job, post_name, arguments), text, lambda _: True, active)


def _in_document(obj):
    return hasattr(obj, "Proxy")


def _read_back(ready, text, progress, objects=None):
    """What a program holds of a job, or of those `objects` of it that FreeCAD puts into one file; None if
    `progress` returned False. Raises InputError naming what it does not, or what gouges."""
    own, arguments = ready.own, ready.arguments
    if own is None:
        kept_words.require_labels(ready.post_name, ready.operations, text)
        kept_words.require(ready.post_name, ready.operations, text)
    half_unit = 0.5 * 10.0**-ready.decimals
    if "--inches" in requirements.split_arguments(arguments):
        half_unit *= 25.4
    if objects is None:
        (objects,) = host.post_objects(ready.job, ready.post_name)
        _require_all(ready.operations, objects)
    dialect = own.dialect if own else "linuxcnc"
    machine = program_header.machine_of(objects)
    posted = posted_job.read_back(
        text,
        objects,
        dialect,
        half_unit,
        kept_words.of_machine(machine, arguments),
        own is not None,
        kept_words.tcp_words(machine, dialect),
        length=own is not None and own.options(arguments).tlo,
        retract=own.retract_lines(arguments, machine) if own else [],
    )
    to_check = _to_check(posted)
    for number, one in enumerate(to_check):
        asked = _Share(progress, number, len(to_check))
        texture = isinstance(one, PostedTexture)
        how = (one.path, one.unplaced, asked, one.blind) if texture else (None, 0, asked)
        try:
            one.check = checks.require_clear(one.operation, *how)
        except InputError:  # what was stopped is unknown, too
            if not asked.stopped:
                raise
        if asked.stopped:
            return None
    return posted


def _require_all(operations, objects):
    """Raises InputError naming an operation that FreeCAD does not hand to the post-processor."""
    for op in operations:
        if op not in objects and any(c.Name[:1] in "GM" for c in op.Path.Commands):
            remedy = "FreeCAD posts what has ToolController and Active: take it out of the job."
            raise InputError(op.Label, "not in the program", remedy)


def _to_check(posted):
    """Those that are checked for gouges: each copy of a texture, milling of ours once."""
    chosen: list = []
    milled: list = []
    for one in posted:
        if isinstance(one, PostedTexture):
            chosen.append(one)
        elif one.operation not in milled and posted_milling.is_milling(one.operation):
            milled.append(one.operation)
            chosen.append(one)
    return chosen


class _Share:
    """Progress of one check of several, that remembers whether it was told to stop."""

    def __init__(self, progress, number, count):
        self.progress, self.number, self.count = progress, number, count
        self.stopped = False

    def __call__(self, share):
        self.stopped = self.stopped or not self.progress(0.4 + 0.6 * (self.number + share) / self.count)
        return not self.stopped


def _active_operations(job):
    """The job's active operations and dressups, as they are now. Raises InputError if one of them, or what is
    under a dressup, could not be computed: FreeCAD would post its last path."""
    job.Document.recompute()  # what was changed since
    operations = [op for op in job.Operations.Group if host.is_active(op)]
    for op in operations:
        requirements.check_path(op)
        requirements.check_fixture(op)
        requirements.check_placement(op)
        for part in posted_milling.with_those_under(op):
            error = getattr(part.Proxy, "error", None)
            if error is not None:
                raise error
            if "Invalid" in part.State:
                raise InputError(part.Label, "invalid", "repair the operation before posting.")
            if part is not op and kind_of(part) == TEXTURE:
                remedy = "it would change a texture's path, which is its timing: take it away."
                raise InputError(op.Label, part.Label, remedy)
            if getattr(part, "Mode", "") == UNDERCUTS and posted_milling.posture_of(op) is None:
                remedy = "an upright shank would cut the overhang: put a DCM modifier with posture on %s."
                raise InputError("Mode", UNDERCUTS, remedy % part.Label)
    if not operations:
        raise InputError("Operations", "none", "the job has no active operation.")
    return operations


def _single_text(job, post_name, arguments):
    own = own_dialect(post_name) is not None
    before = job.PostProcessorArgs
    try:
        parts = host.post_parts(job, post_name, arguments + " --no-compare" * own)
    except InputError:  # our own posts say what it is
        raise
    except SystemExit as error:  # argparse's, which has told the standard error why
        remedy = "it does not take the arguments %r: change them, or use another post-processor." % arguments
        raise InputError("PostProcessor", post_name, remedy) from error
    except Exception as error:  # somebody's program: it may fail in any way
        why = ("%s: %s" % (type(error).__name__, error)).encode("ascii", "backslashreplace").decode()
        remedy = "it failed (%s): use another post-processor." % why
        raise InputError("PostProcessor", post_name, remedy) from error
    finally:
        if own and job.PostProcessorArgs != before:  # FreeCAD 1.x takes them from the job
            job.PostProcessorArgs = arguments
    if len(parts) != 1:
        remedy = "the job makes %d files: post them with post_files()." % len(parts)
        raise InputError("OrderOutputBy", job.OrderOutputBy, remedy)
    if not isinstance(parts[0], str) or not parts[0].strip():
        raise InputError("PostProcessor", post_name, "it wrote nothing: use another post-processor.")
    return parts[0]


def tool_of(op):
    """Number of the tool of an operation or dressup; 0 if it has none."""
    controller = posted_milling.controller_of(op)
    return 0 if controller is None else controller.ToolNumber


def write(filename, text):
    """Writes the program: the old file or the new one is there, whole."""
    try:
        files.write(filename, text.encode("ascii"))
    except UnicodeEncodeError as error:
        raise InputError(
            "Label", repr(error.object[error.start : error.end]), "use ASCII letters in labels and comments."
        ) from error


def resume(job, patch, filename, operation=None, offset=None, post_name=None, arguments=None):
    """Posts what is left of `job` from patch number `patch` of a texture on to `filename`: that texture from
    there, locked to the spindle anew, and the operations after it. Patches are counted from 1 in milling
    order, as in the comments of PatchComments. Returns what post() does. The document stays as it is.

    `operation`: the texture, if the job has more than one; `offset`: the work offset of the copy that was
    stopped, if there is more than one; the copies after it are programs of their own.
    Raises InputError naming Operation, Fixtures, FirstPatch, or what post() names."""
    with rest_of_job.left(job, patch, operation, offset):
        return post(job, filename, post_name, arguments)
