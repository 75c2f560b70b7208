"""Comments in a texture's path that number its patches, so that a program that was stopped can go on, and
optional stops before them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import numpy as np
from _patchmill import InputError

from patchmill.freecad import host
from patchmill.textures import strategies

MOVES = ("G0", "G1", "G33")


def numbered(plan, commands):
    """`commands`, a PlannedTexture's as Path.Command, with a comment before the first move of each patch,
    where the tool leaves the patch before, or at the beginning; with PatchStops an M1 before those that are
    not the first. Raises InputError naming PatchStops for a path that follows the spindle."""
    if plan.input.patch_stops and strategies.of(plan.input.strategy).locked:
        remedy = "a stop would end the spindle's lock: post each patch as a file of its own (patches=1)."
        raise InputError("PatchStops", "true", remedy)
    moves = [None, *_moving(plan)]  # the first command goes to the path's start
    begins = _first_moves(plan, moves[1:])
    out, count = [], 0
    for command in commands:
        if command.Name in MOVES:
            if count < len(moves) and moves[count] in begins:
                if plan.input.patch_stops and count:
                    out.append(host.Path.Command("M1"))
                if plan.input.patch_comments:
                    number = begins[moves[count]], plan.patches
                    out.append(host.Path.Command("(Patch %d of %d)" % number))
            count += 1
        out.append(command)
    if count != len(moves):
        raise RuntimeError("%d moves in the text, %d in the path" % (count, len(moves)))
    return out


def _told(plan):
    return plan.path if plan.posture is None else plan.posture.told.path


def _moving(plan):
    """Numbers of the moves that have a command: those that go or turn."""
    path = _told(plan)
    way = np.diff(np.vstack([np.array(path.start)[None], path.tips]), axis=0)
    goes = np.any(way != 0.0, axis=1)
    if plan.posture is not None:
        goes |= np.any(np.diff(plan.posture.told.joints, axis=0) != 0.0, axis=1)
    return np.flatnonzero(goes).tolist()


def _first_moves(plan, moves):
    """{number of a move of `moves`, or None: number of the patch that begins with it}."""
    dimples = _told(plan).dimples
    ends = np.flatnonzero(dimples >= 0)
    patches = plan.dimples.patches[dimples[ends]]
    first = plan.input.first_patch
    begins = {None: first}
    for number, k in enumerate(np.flatnonzero(np.diff(patches)) + 1, 1):
        begins[moves[np.searchsorted(moves, ends[k - 1], side="right")]] = first + number
    return begins
