"""Posting through FreeCAD's post-processors, with the text read back and checked before it is kept.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import functools
import importlib
import math
import os
import re
import shlex
from dataclasses import dataclass

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.freecad import host, post_probe
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.operations.base import planned
from patchmill.operations.copy_input import UNDERCUTS
from patchmill.posting import control_match, kept_words
from patchmill.textures import strategies, tool_posture
from patchmill.verify import checks, posted_milling


@dataclass
class PostedTexture:
    """One texture of a posted program, as read back from its text."""

    operation: object  # document object
    path: core.ToolPath
    match: core.PlanMatch
    errors: dict  # of _patchmill.phase_errors
    unplaced: int = 0  # moves at the beginning of the path that start nobody knows where
    check: checks.CheckResult = None  # of gouge and collision


def post(job, filename, post_name=None, arguments=None):
    """Posts `job` to `filename` and returns a list: a PostedTexture for each texture operation, and then a
    PostedMilling for each copy milling and DCM modifier.

    `post_name` and `arguments` default to the job's own; the folder of `filename` must be there. The text is
    read back, compared with the plan and its phase measured; only then does the file appear, whole.
    Raises InputError, leaving no file and an existing one untouched, if an operation is invalid, if the text
    does not hold the plan, or if the tool would gouge or collide (docs/checks.md)."""
    _require_place(filename)
    post_name = post_name or job.PostProcessor
    arguments = job.PostProcessorArgs if arguments is None else arguments
    operations = _active_operations(job)
    textures = [op for op in operations if kind_of(op) == TEXTURE]
    plans = [planned(op) for op in textures]
    post_name = post_name or control_match.post_for(plans)
    for op, plan in zip(textures, plans):
        _check_verdict(op, plan)
        _check_arguments(post_name, plan, shlex.split(arguments))
    own = own_dialect(post_name)
    decimals = _decimals(post_name, shlex.split(arguments), plans)
    control_match.require(post_name, own.dialect if own else "", decimals, plans)
    tilted = [dressup for op in operations if (dressup := posted_milling.posture_of(op)) is not None]
    if tilted:
        require_millimetres(tilted[0].Label, shlex.split(arguments))
    _check_post(post_name, plans, tilted)
    text = _single_text(job, post_name, arguments)
    if own is None:
        kept_words.require(post_name, operations, text)
    dialect = own.dialect if own else "linuxcnc"
    posted = _read_back(text, textures, plans, dialect)
    for one in posted:
        one.check = checks.require_clear(one.operation, one.path, one.unplaced)
    milled = [op for op in operations if posted_milling.is_milling(op)]
    half_unit = 0.5 * 10.0**-decimals
    if "--inches" in shlex.split(arguments):
        half_unit *= 25.4
    posted += [posted_milling.read_back(op, text, dialect, half_unit) for op in milled]
    _write(filename, text)
    return posted


def _require_place(filename):
    """Raises InputError unless a file of that name can be made: before the work, not after it."""
    name = os.fspath(filename)
    if not name or os.path.isdir(name) or not os.access(os.path.dirname(name) or ".", os.W_OK):
        raise InputError("filename", repr(name), "name a file in a folder that can be written to.")


def _active_operations(job):
    """The job's active operations and dressups, as they are now. Raises InputError if one of them, or what is
    under a dressup, could not be computed: FreeCAD would post its last path."""
    job.Document.recompute()  # what was changed since
    operations = [op for op in job.Operations.Group if host.is_active(op)]
    for op in operations:
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


def _check_verdict(op, plan):
    """A plan that the machine cannot hold is not posted, unless the user says so. Where no machine is
    named nothing is known; the report says that."""
    verdict = plan.pacing.verdict
    if verdict is None or op.PostUnheld or verdict.holding in ("holds", "unknown"):
        return
    raise InputError(
        "SpindleSpeed",
        "%g rpm" % (60.0 * plan.input.spindle.speed),
        verdict.sentence + " Set PostUnheld to post it all the same.",
    )


def require_millimetres(what, arguments):
    """Posts scale the F of inverse time, which are no lengths, and what is read back is in millimetres."""
    if "--inches" in arguments:
        raise InputError("PostProcessorArgs", "--inches", "%s is posted in millimetres." % what)


def _check_arguments(post_name, plan, arguments):
    require_millimetres("a texture", arguments)
    precision = _decimals(post_name, arguments, [plan])
    if precision != plan.input.decimals:
        raise InputError(
            "Decimals",
            plan.input.decimals,
            "the post writes %d decimals: give --precision=%d or change Decimals."
            % (precision, plan.input.decimals),
        )


def _decimals(post_name, arguments, plans):
    own = own_dialect(post_name)
    machine = next((plan.machine for plan in plans if plan.machine is not None), None)
    precision = own.precision(shlex.join(arguments), machine) if own else 3
    for i, argument in enumerate(arguments):
        if argument.startswith("--precision="):
            precision = int(argument.split("=", 1)[1])
        elif argument == "--precision" and i + 1 < len(arguments):
            precision = int(arguments[i + 1])
    return precision


def _check_post(post_name, plans, tilted):
    """A post that would lose words which the paths need is refused before it gets them. It is tried, once in
    a session; the program that it posts is read back all the same."""
    if own_dialect(post_name):
        return
    angles = [np.degrees(p.posture.work.joints) for p in plans if p.posture is not None]
    angles += [posted_milling.angles_in(dressup) for dressup in tilted]
    needs = {
        "rotary": bool(angles),
        "turning_far": any(np.abs(a).max() > 360.0 for a in angles),
        "locked": any(p.input.strategy == strategies.LOCKED for p in plans),
        "inverse": any("G93" in str(p.pacing.text) for p in plans if p.posture is not None)
        or bool(tilted),
    }
    if not any(needs.values()):
        return
    missing = post_probe.missing(_probed(post_name), **needs)
    if missing:
        remedy = "%s: use one of PatchMill's own posts." % "; ".join(missing)
        raise InputError("PostProcessor", post_name, remedy)


@functools.lru_cache(maxsize=None)
def _probed(post_name):
    return post_probe.probe(host, post_name)


def own_dialect(post_name):
    """The post_dialect.Dialect of one of PatchMill's own posts, None for any other post."""
    if not post_name.startswith("patchmill_"):
        return None
    try:
        return importlib.import_module(post_name + "_post").DIALECT
    except ImportError as error:
        raise InputError("PostProcessor", post_name, "there is no such post-processor.") from error


def _single_text(job, post_name, arguments):
    try:
        parts = host.post_parts(job, post_name, arguments)
    except InputError:  # our own posts say what it is
        raise
    except (Exception, SystemExit) as error:  # somebody's program: it may fail in any way
        remedy = "it failed (%s: %s): use another post-processor." % (type(error).__name__, error)
        raise InputError("PostProcessor", post_name, remedy) from error
    if len(parts) != 1:
        raise InputError(
            "OrderOutputBy", job.OrderOutputBy, "the job makes %d files; one is posted here." % len(parts)
        )
    if not parts[0].strip():
        raise InputError("PostProcessor", post_name, "the post-processor wrote nothing.")
    return parts[0]


def _read_back(text, operations, plans, dialect):
    posted = []
    for op, plan in zip(operations, plans):
        candidates = []
        half_unit = 0.5 * 10.0**-plan.input.decimals
        for section in core.read_gcode(text, plan.input.tool, dialect, rotary=plan.posture is not None):
            if plan.posture is not None:
                complete, match, path = tool_posture.read_back(
                    section, plan.posture, plan.machine, half_unit
                )
            else:
                path = section.path
                match = core.match_plan(path, plan.path, half_unit)
                complete = match.complete
            candidates.append((complete, match.found, section, match, path))
        best = max(candidates, key=lambda c: c[:2], default=None)
        if best is None or not best[0]:
            raise InputError(
                op.Label,
                "%d of %d dimples read back" % (best[1] if best else 0, plan.counts["cut"]),
                "the post-processor changed the path: use another one.",
            )
        section, match, path = best[2:]
        _check_spindle(op, plan, path)
        if plan.input.strategy == strategies.CONSTANT:
            errors = plan.phase_errors(path)
        else:
            _check_paces(op, plan, path)
            errors = plan.predicted_errors()
            posted.append(PostedTexture(op, path, match, errors, section.unplaced))
            continue
        largest = math.degrees(errors["largest"])
        if not largest <= op.PhaseTolerance.Value or errors["runs"] != 1:
            raise InputError(
                "PhaseTolerance",
                "%.4g degrees" % op.PhaseTolerance.Value,
                "the posted text has a phase error of %.4g degrees in %d runs: post more decimals."
                % (largest, errors["runs"]),
            )
        posted.append(PostedTexture(op, path, match, errors, section.unplaced))
    return posted


def _check_paces(op, plan, path):
    """Every timed move of the text takes the turns that the planned words say: K and F are whole."""
    spindle = plan.input.spindle
    head = "%s S%d\n" % (spindle.sense, round(60.0 * spindle.speed))
    words = re.sub(
        r"F([0-9.]+)", lambda f: "F%.6f" % (60.0 * float(f.group(1))), str(plan.pacing.text)
    )
    rotary = plan.posture is not None
    planned_path = core.read_gcode(head + words, plan.input.tool, rotary=rotary)[-1].path
    core.match_plan(planned_path, plan.posture.told.path if rotary else plan.path, 1e-6)
    timed = [p.turns[p.kinds > 0] for p in (planned_path, path)]
    if len(timed[0]) == len(timed[1]):
        both_unknown = np.isnan(timed[0]) & np.isnan(timed[1])
        off = np.where(both_unknown, 0.0, np.abs(timed[0] - timed[1]) / np.maximum(timed[0], 1e-3))
        if np.nanmax(off) < 1e-4 and not np.isnan(off).any():
            return
    raise InputError(
        op.Label,
        "other K or F words",
        "the post-processor does not keep them: use patchmill_linuxcnc.",
    )


def _check_spindle(op, plan, path):
    want, have = plan.input.spindle, path.spindle
    if have.sense != want.sense or abs(have.speed - want.speed) > 1e-9:
        raise InputError(
            "SpindleSpeed",
            "%g rpm %s" % (60.0 * want.speed, want.sense),
            "the posted text turns the spindle at %g rpm %s." % (60.0 * have.speed, have.sense),
        )


def _write(filename, text):
    """Writes beside, then renames: there is never half a file."""
    part = "%s.part" % filename
    try:
        with open(part, "w", encoding="ascii", newline="\n") as file:
            file.write(text)
        os.replace(part, filename)
    except OSError as error:
        remedy = "it cannot be written (%s): give another file." % error.strerror
        raise InputError("filename", repr(str(filename)), remedy) from error
    except UnicodeEncodeError as error:
        raise InputError(
            "Label", repr(error.object[error.start : error.end]), "use ASCII letters in labels."
        ) from error
    finally:
        if os.path.exists(part):
            os.unlink(part)
