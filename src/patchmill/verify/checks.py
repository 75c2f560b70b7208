"""Gouge and collision: does ball, flute, shank or holder go where it must not, anywhere on a path?

    result = patchmill.check(op)                     # the planned path against the job's model
    print(result.sentence)
    for finding in result.findings:
        print(finding.part, finding.place, finding.depth)

Ball and flutes may cut `GougeTolerance` deep below the model, and as deep as the texture was planned to lie
below it; shank and holder keep `ToolClearance` away. A model that cannot be meshed gives "unknown", which is
not a pass. Method and limits: docs/checks.md.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, field

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.freecad import host
from patchmill.geometry import shapes
from patchmill.operations.base import planned

CLEAR, VIOLATED, UNKNOWN = "clear", "violated", "unknown"
MOST_FINDINGS = 1000


@dataclass
class Finding:
    """A part of the tool that comes too near on a move: the worst place of it [mm, work frame]."""

    part: str  # ball, flute, shank or holder
    move: int  # number of the move in the path, from 0
    place: tuple
    depth: float  # below what is allowed [mm]


@dataclass
class CheckResult:
    """What a check found. `sink`: how deep the texture was planned to lie below the model [mm]."""

    outcome: str  # clear, violated or unknown
    reason: str = ""  # why unknown
    findings: list = field(default_factory=list)
    sections: list = field(default_factory=list)  # of the tool: (part, from, to, radius, radius) [mm]
    tolerance: float = 0.0
    clearance: float = 0.0
    sink: float = 0.0
    triangles: int = 0  # of the model's mesh

    @property
    def clear(self):
        return self.outcome == CLEAR

    @property
    def worst(self):
        """The deepest Finding, or None."""
        return max(self.findings, key=lambda f: f.depth, default=None)

    @property
    def sentence(self):
        """The result as a sentence."""
        if self.outcome == UNKNOWN:
            return "Unknown: " + (self.reason or "the check did not end.")
        if self.clear:
            return (
                "Clear: ball and flutes go no deeper than %.4g mm below the model, shank and holder stay "
                "%.4g mm away." % (self.tolerance + self.sink, self.clearance)
            )
        worst = self.worst
        more = len(self.findings) - 1
        return "The %s %s at (%.3f, %.3f, %.3f)%s." % (
            worst.part,
            _too_deep(worst, self),
            *worst.place,
            ", and %s%d more places" % ("at least " if more + 1 >= MOST_FINDINGS else "", more)
            if more
            else "",
        )


def _too_deep(finding, result):
    if finding.part in ("ball", "flute"):
        return "cuts %.4g mm below the model" % (finding.depth + result.tolerance + result.sink)
    if finding.depth > result.clearance:
        return "goes %.4g mm into the model" % (finding.depth - result.clearance)
    return "comes %.4g mm near to the model, allowed are %.4g mm," % (
        result.clearance - finding.depth,
        result.clearance,
    )


def tool_sections(operation):
    """The tool above its ball as (part, from, to, radius_from, radius_to), heights above the tip [mm].

    From the tool bit: CuttingEdgeHeight, ShankDiameter and Length, which is how far it stands out of the
    holder, unless the operation's StickOut says otherwise; the holder from the operation's HolderDiameter (0:
    none) and HolderLength. What the bit does not say: edges of 4 R, a shank as thick as the ball, a length of
    20 R. An operation without these properties has no holder. Raises InputError naming StickOut."""
    bit = operation.ToolController.Tool
    radius = float(bit.Diameter) / 2.0
    edge = max(_length(bit, "CuttingEdgeHeight", 4.0 * radius), radius)
    shank = _length(bit, "ShankDiameter", 2.0 * radius) / 2.0
    out = _length(operation, "StickOut", 0.0) or _length(bit, "Length", 20.0 * radius)
    if out <= radius:
        raise InputError("StickOut", "%g mm" % out, "the tool must stand out further than its ball.")
    edge = min(edge, out)
    sections = []
    if edge > radius:
        sections.append(("flute", radius, edge, radius, radius))
    if out > edge and shank > 0.0:
        sections.append(("shank", edge, out, shank, shank))
    holder = _length(operation, "HolderDiameter", 0.0) / 2.0
    height = _length(operation, "HolderLength", 0.0)
    if holder > 0.0 and height > 0.0:
        sections.append(("holder", out, out + height, holder, holder))
    return sections


def _length(obj, name, default):
    """Of a property in mm; the default where there is none, or it is zero."""
    value = float(getattr(obj, name, 0.0) or 0.0)
    return value if value > 0.0 else default


@dataclass
class CheckInput:
    """What a check needs of a document, so that the check itself can run in any thread. Lengths in mm."""

    plan: object  # the PlannedTexture
    breps: list  # of the job's model
    sections: list
    tolerance: float
    clearance: float


def check_input(operation):
    """CheckInput of a texture operation. Raises InputError naming GougeTolerance, StickOut or what a plan
    cannot be made from."""
    plan = planned(operation)
    tolerance = operation.GougeTolerance.Value
    if not tolerance > 0.0:
        raise InputError("GougeTolerance", "%g mm" % tolerance, "give a value greater than zero.")
    job = host.PathUtils.findParentJob(operation)
    return CheckInput(
        plan,
        [shape.exportBrepToString() for shape in shapes.models(job)],
        tool_sections(operation),
        tolerance,
        operation.ToolClearance.Value,
    )


def check(operation, path=None, first_move=0, progress=None):
    """CheckResult of a texture operation's planned path, or of `path`, a ToolPath such as the one of a
    PostedTexture, from its move `first_move` on. `progress` (share -> bool); if it returns False the result
    is unknown.

    Raises InputError naming GougeTolerance, ToolClearance, StickOut or what the core names."""
    return run_check(check_input(operation), path, first_move, progress)


def run_check(given, path=None, first_move=0, progress=None):
    """As check(), of a CheckInput."""
    plan, sections = given.plan, given.sections
    tolerance, clearance = given.tolerance, given.clearance
    part = core.part_model(given.breps, tolerance / 8.0)
    sink = _planned_sink(plan, part) if part.known else 0.0
    found = core.check_clearance(
        path or plan.path,
        sections,
        part,
        tolerance + sink,
        clearance,
        resolution=tolerance / 10.0,
        most_findings=MOST_FINDINGS,
        first_move=first_move,
        progress=progress,
    )
    findings = [
        Finding(name, int(move), tuple(float(c) for c in place), float(depth))
        for name, move, place, depth in zip(
            found["parts"], found["moves"], found["places"], found["depths"]
        )
    ]
    return CheckResult(
        found["outcome"],
        found["reason"],
        findings,
        sections,
        tolerance,
        clearance,
        sink,
        part.triangles,
    )


def _planned_sink(plan, part):
    """How deep the planned bottoms lie below the model, at most [mm]: patches in planes and isolated dimples
    are meant to."""
    cut = plan.dimples.states == core.DimpleState.CUT
    if not cut.any():
        return 0.0
    below = plan.dimples.depths[cut] - part.distances(plan.dimples.positions[cut])
    return max(0.0, float(np.max(below)))


def _top(operation):
    """Height of the highest place of the job's model [mm]."""
    job = host.PathUtils.findParentJob(operation)
    return max(shape.BoundBox.ZMax for shape in shapes.models(job))


def require_clear(operation, path, first_move=0, progress=None, blind=math.inf):
    """CheckResult of a path that is to be posted; `blind`: how low it goes [mm] before X and Y are known.
    Raises InputError naming PostGouging if it cuts or touches what it must not, and if nothing is known,
    unless the operation's PostGouging allows it."""
    result = check(operation, path, first_move, progress)
    if blind < _top(operation) and result.outcome != VIOLATED:
        result.outcome = UNKNOWN
        result.reason = "the tool goes down to Z%.3f before X and Y are known." % blind
    if result.clear or operation.PostGouging:
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
