"""A thread's path: what the controller is told, what that is in the work frame, its text, and its verdict.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, field

import _patchmill as core
import numpy as np
from _patchmill import InputError

ALMOST = 1e-6  # of a tooth pass: it is at the move's end
RAPID, CUT = core.MoveKind.RAPID, core.MoveKind.CUT


@dataclass
class Told:
    """A path with the angles [rad] of the rotary axes at its start and at each move's end, (n + 1, 2), as a
    _patchmill.PosturePath has them."""

    path: core.ToolPath
    joints: np.ndarray


@dataclass
class Held:
    """As a _patchmill.Verdict: a straight locked move at one speed has nothing to lose the lock by."""

    speed: float  # revolutions per second
    sentence: str
    holding: str = "holds"
    rms: float = 0.0
    largest: float = 0.0


@dataclass
class ThreadPosture:
    """As a tool_posture.Posture."""

    turning: object
    kinematics: core.Kinematics
    form: core.ProgramForm
    postures: core.Postures
    numbers: np.ndarray  # of the dimple of each tooth pass, NO_DIMPLE where it is off the face
    reference: str = "tip"
    work: Told = None
    told: Told = None
    load: dict = field(default_factory=dict)

    def in_work(self, section):
        """The ToolPath in the work frame of a section of a program that was read with its rotary words."""
        letter = "ABC".index(self.kinematics.letters)
        angles = np.column_stack([section.angles[:, letter], np.zeros(len(section.angles))])
        return in_pieces(self, section.path, angles).path


def told_moves(given, turning):
    """Told of a TextureInput's thread. Raises InputError naming SafeHeight or ClearanceHeight."""
    start, end = turning.start, turning.end
    need = start[2] + given.lift
    for name, height in (("SafeHeight", given.safe_height), ("ClearanceHeight", given.clearance_height)):
        if height < need:
            remedy = "the tool's tip stands at Z %.4g mm: give more." % start[2]
            raise InputError(name, "%g mm" % height, remedy)
    over = lambda point, height: (point[0], point[1], height)  # noqa: E731
    first = over(start, given.clearance_height)
    tips = [over(start, given.safe_height), tuple(start), tuple(end), over(end, given.clearance_height)]
    down = (given.safe_height - start[2]) / given.feed * given.spindle.speed
    path = core.make_path(
        given.tool,
        given.spindle,
        first,
        tips,
        None,
        [RAPID, CUT, CUT, RAPID],
        [np.nan, down, turning.turns, np.nan],
    )
    joints = np.zeros((5, 2))
    joints[3:, 0] = turning.angle
    return Told(path, joints)


def in_pieces(posture, path, joints):
    """Told of a told path in the work frame, where each move on which the table turns is cut into the ways
    from tooth pass to tooth pass. `joints`: (n + 1, 2) [rad]."""
    turning, teeth = posture.turning, posture.turning.teeth
    points = np.vstack([np.array(path.start)[None], path.tips])
    tips, axes, angles, kinds, turns = [], [], [joints[0, 0]], [], []
    numbers: list = []
    for i in range(len(path)):
        share = np.ones(1)
        kind, total, found = path.kinds[i], path.turns[i], [core.NO_DIMPLE]
        if kind == CUT and joints[i, 0] != joints[i + 1, 0]:
            share, found = _tooth_passes(total * teeth, posture.numbers)
        tip, axis = turning.poses(points[i], points[i + 1], joints[i : i + 2, 0], share)
        tips.append(tip)
        axes.append(axis)
        angles.extend(joints[i, 0] + share * (joints[i + 1, 0] - joints[i, 0]))
        kinds.extend([int(kind)] * len(share))
        turns.extend(np.diff(share, prepend=0.0) * total)
        numbers.extend(int(n) for n in found)
    begin, _ = turning.poses(points[0], points[0], joints[:1, 0].repeat(2), np.zeros(1))
    made = core.make_path(
        path.tool, path.spindle, begin[0], np.vstack(tips), np.vstack(axes), kinds, turns
    )
    return Told(core.with_dimples(made, numbers), np.column_stack([angles, np.zeros(len(angles))]))


def _tooth_passes(passes, numbers):
    """(shares of a move of so many tooth passes at which they are, and its end; the dimple of each)."""
    whole = np.arange(1, math.ceil(passes - ALMOST))
    inside = whole[whole < len(numbers)]
    found = np.full(len(whole) + 1, core.NO_DIMPLE)
    found[: len(inside)] = numbers[inside]
    last = round(passes)
    if abs(passes - last) <= ALMOST and last < len(numbers):
        found[-1] = numbers[last]
    return np.append(whole / passes, 1.0), found


class Words(tuple):
    """Texts for Path.Path(), as a _patchmill.PathText has them."""

    def __str__(self):
        return "".join(self)


def text(told, turning, given):
    """Words for Path.Path(), in one part."""
    letter, n = turning.kinematics.letters, given.decimals
    place = lambda p, q: "X%.*f Y%.*f Z%.*f %s%.*f" % (  # noqa: E731
        n, p[0], n, p[1], n, p[2], letter, n, np.degrees(q)
    )  # fmt: skip
    points, angles = np.vstack([np.array(told.path.start)[None], told.path.tips]), told.joints[:, 0]
    rest = [place(point, angle) for point, angle in zip(points, angles)]
    feed = core.posted_feed(given.feed, given.decimals)
    words = (
        "G0 %s\nG0 %s\nG61\nG1 %s F%.9f\nG33 %s K%.6f\nG0 %s\n"
        % (rest[0], rest[1], rest[2], feed, rest[3], turning.lead, rest[4])
    )
    return Words([words])
