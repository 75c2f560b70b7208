"""A check of gouge and collision without a document: what it is given, what it finds, and the sentences that
say it. checks makes it of operations.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing
from dataclasses import dataclass, field

import _patchmill as core
import numpy as np

from patchmill.geometry.deflection import told_of
from patchmill.system.stops import stoppable

CLEAR, VIOLATED, UNKNOWN = "clear", "violated", "unknown"
MOST_FINDINGS = 1000
DEFLECTION = 0.125  # of the tolerance: of the mesh that stands for the part


@dataclass
class CheckInput:
    """What a check needs of a document, so that the check itself can run in any thread. Lengths in mm."""

    path: core.ToolPath  # with its tool; None: not known, for the reason
    breps: list  # of the job's model; none of a mesh
    tolerance: float
    clearance: float
    plan: typing.Any = None  # the PlannedTexture of a texture
    sink: float = 0.0  # how deep another path was planned to lie below the model
    cutting: bool = True  # the cutting end and flutes are looked at too
    reason: str = ""
    mesh: typing.Any = field(default=None, kw_only=True)  # a _patchmill.TriangleMesh in the place of breps


@dataclass
class Finding:
    """A part of the tool that comes too near on a move: the worst place of it [mm, work frame]."""

    part: str  # ball, cutting end, flute, shank or holder
    move: int  # number of the move in the path, from 0
    place: tuple
    depth: float  # below what is allowed [mm]


@dataclass
class CheckResult:
    """What a check found. `sink`: how deep the path was planned to lie below the model [mm]; `cutting`:
    whether the cutting end and flutes were looked at too."""

    outcome: str  # clear, violated or unknown
    reason: str = ""  # why unknown
    findings: list = field(default_factory=list)
    sections: list = field(default_factory=list)  # of the tool: (part, from, to, radius, radius) [mm]
    tolerance: float = 0.0
    clearance: float = 0.0
    sink: float = 0.0
    triangles: int = 0  # of the model's mesh
    cutting: bool = True

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
        if self.clear and not self.cutting:
            return "Clear: shank and holder stay %.4g mm away from the model." % self.clearance
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
    if finding.part in ("ball", "cutting end", "flute"):
        return "cuts %.4g mm below the model" % (finding.depth + result.tolerance + result.sink)
    if finding.depth > result.clearance:
        return "goes %.4g mm into the model" % (finding.depth - result.clearance)
    return "comes %.4g mm near to the model, allowed are %.4g mm," % (
        result.clearance - finding.depth,
        result.clearance,
    )


def run_check(given, path=None, first_move=0, progress=None):
    """CheckResult of a CheckInput, or of `path` in the place of its own, from move `first_move` on. If
    `progress` (fraction -> bool) returns False the result is unknown. Raises what the core names."""
    stopped = CheckResult(UNKNOWN, "The check was stopped before its end.")
    return _run_check(given, path, first_move, progress) or stopped


def _part_of(given):
    """The _patchmill.PartModel of a CheckInput. Raises InputError naming Model or GougeTolerance."""
    if given.mesh is not None:
        return core.part_model_of_mesh(given.mesh)
    with told_of("GougeTolerance", DEFLECTION):
        return core.part_model(given.breps, DEFLECTION * given.tolerance)


@stoppable
def _run_check(given, path, first_move, progress):
    """CheckResult, or None if it was stopped."""
    tolerance, clearance = given.tolerance, given.clearance
    path = path or given.path
    if path is None:
        return CheckResult(UNKNOWN, given.reason)
    part = _part_of(given)
    sink = _planned_sink(given, part) if part.known else 0.0
    found = core.check_clearance(
        path,
        part,
        tolerance + sink,
        clearance,
        resolution=tolerance / 10.0,
        most_findings=MOST_FINDINGS,
        first_move=first_move,
        cutting=given.cutting,
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
        path.tool.sections,
        tolerance,
        clearance,
        sink,
        part.triangles,
        given.cutting,
    )


def _planned_sink(given, part):
    """How deep the path is meant to lie below the model, at most [mm]: of a texture its planned bottoms, for
    patches in planes and isolated dimples."""
    plan = given.plan
    if plan is None:
        return given.sink
    cut = plan.dimples.states == core.DimpleState.CUT
    if not cut.any():
        return 0.0
    below = plan.dimples.depths[cut] - part.distances(plan.dimples.positions[cut])
    return max(0.0, float(np.max(below)))
