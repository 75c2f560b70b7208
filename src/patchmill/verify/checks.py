"""Gouge and collision: does ball, flute, shank or holder go where it must not, anywhere on a path?

    result = patchmill.check(op)                     # the planned path against the job's model
    print(result.sentence)
    for finding in result.findings:
        print(finding.part, finding.place, finding.depth)

Cutting end and flutes may cut `GougeTolerance` deep below the model, and as deep as the path was planned to
lie below it; shank and holder keep `ToolClearance` away. A model that cannot be meshed gives "unknown", which
is not a pass. What is checked of which operation: check_input. Method and limits: docs/checks.md.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import _patchmill as core
from _patchmill import InputError

from patchmill.freecad import host, tool_controller
from patchmill.freecad.kinds import COPY_MILLING, DCM, TEXTURE, kind_of
from patchmill.geometry import shapes
from patchmill.operations.computed import made, planned, recompute
from patchmill.path import base_path
from patchmill.collision.clearance_check import CLEAR, UNKNOWN, VIOLATED, CheckInput, run_check  # noqa: F401
from patchmill.verify.posted_milling import posture_of, with_those_under


def check(operation, path=None, first_move=0, progress=None):
    """CheckResult of the path of an operation or dressup, or of `path`, a ToolPath such as the one of a
    PostedTexture, from its move `first_move` on. `progress` (share -> bool); if it returns False the result
    is unknown.

    Raises InputError naming GougeTolerance, ToolClearance, StickOut or what the core names."""
    return run_check(check_input(operation), path, first_move, progress)


def _top(operation):
    """Height of the highest place of the job's model [mm]."""
    job = host.PathUtils.findParentJob(operation)
    return max(shape.BoundBox.ZMax for shape in shapes.models(job))


def require_clear(operation, path=None, first_move=0, progress=None, blind=math.inf):
    """CheckResult of a path that is to be posted, the operation's own if None; `blind`: how low it goes [mm]
    before X and Y are known. Raises InputError naming PostGouging if it cuts or touches what it must not, and
    if nothing is known, unless PostGouging of the operation, or of the one under a dressup, allows it."""
    result = check(operation, path, first_move, progress)
    if blind < math.inf and blind < _top(operation) and result.outcome != VIOLATED:
        result.outcome = UNKNOWN
        result.reason = "the tool goes down to Z%.3f before X and Y are known." % blind
    if result.clear or checked_by(operation).PostGouging:
        return result
    raise InputError(
        "PostGouging",
        "false",
        "%s Nothing is posted; %s Set PostGouging to post it all the same."
        % (
            result.sentence,
            "repair the model so that it is a closed solid."
            if result.outcome == UNKNOWN
            else "change the tool, the tilt or the faces.",
        ),
    )


def check_input(operation):
    """CheckInput of an operation or dressup: of a texture, copy milling or DCM as they were planned; of
    another dressup over those of the path that it has. Where the operation below is none of ours, what
    it cuts is not looked at, but shank and holder are. Raises InputError naming GougeTolerance, StickOut,
    Operation or what a path cannot be made from."""
    owner = checked_by(operation)
    tolerance = owner.GougeTolerance.Value
    if not tolerance > 0.0:
        raise InputError("GougeTolerance", "%g mm" % tolerance, "give a value greater than zero.")
    job = host.PathUtils.findParentJob(operation)
    clearance = owner.ToolClearance if hasattr(owner, "ToolClearance") else owner.HolderClearance
    given = CheckInput(
        None,
        [shape.exportBrepToString() for shape in shapes.models(job)],
        tolerance,
        clearance.Value,
    )
    if kind_of(operation) == TEXTURE:
        given.plan = planned(operation)
        given.path = given.plan.path
        return given
    below = list(with_those_under(operation))
    copied = next((part for part in below if kind_of(part) == COPY_MILLING), None)
    given.cutting = copied is not None
    given.sink = copied.Tolerance.Value if copied is not None else 0.0
    given.path, given.reason = _milled(operation, below)
    return given


def checked_by(operation):
    """The operation or dressup, itself or under it, whose properties say what is allowed. Raises InputError
    naming Operation if there is none."""
    for part in with_those_under(operation):
        if kind_of(part):
            return part
    label = getattr(operation, "Label", repr(operation))
    raise InputError("Operation", label, "choose a texture, copy milling or a DCM modifier.")


def _milled(operation, below):
    """(ToolPath, '') of copy milling or DCM, or of another dressup over them; (None, why) if nobody knows."""
    if kind_of(operation) == COPY_MILLING:
        return _made(operation), ""
    if kind_of(operation) == DCM:
        return _made(operation).path, ""
    if posture_of(operation) is not None:
        return None, "%s changes a path whose tool is tilted already." % operation.Label
    native = next(part for part in below if hasattr(part, "ToolController"))
    controller = native.ToolController
    tool = tool_controller.any_cutter(controller, native)
    spindle = core.Spindle(controller.SpindleSpeed / 60.0, tool_controller.sense(controller))
    return base_path.read(operation.Path.Commands, operation.Label).tool_path(tool, spindle), ""


def _made(operation):
    """What an operation made, after a recompute if the document was just opened."""
    proxy = operation.Proxy
    if getattr(proxy, proxy.RESULT) is None and proxy.error is None:
        return recompute(operation)
    return made(operation)
