"""Parts of a job as programs of their own: what is left of one that was stopped, from a patch of one of its
textures on, and any other.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib

import FreeCAD
from _patchmill import InputError

from patchmill.freecad import host
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.operations.computed import planned
from patchmill.textures import strategies

UNLOCKED = "the phase of what is milled now is not that of the patches before: nothing follows the spindle."


@contextlib.contextmanager
def left(job, patch, operation=None, offset=None):
    """The job as what is left of it from patch number `patch` of a texture on, and afterwards as it was:
    see patchmill.posting.resume. Raises InputError naming Operation, Fixtures or FirstPatch."""
    texture = operation or _only(job)
    if kind_of(texture) != TEXTURE or texture not in job.Operations.Group:
        raise InputError("Operation", getattr(texture, "Label", texture), "give a texture of the job.")
    if not host.is_active(texture):
        raise InputError("Operation", texture.Label, "it is switched off.")
    if type(patch) is not int:
        raise InputError("FirstPatch", repr(patch), "give a whole number, from 1.")
    offset = offset or _only_offset(job)
    if offset not in job.Fixtures:
        raise InputError("Fixtures", offset, "the job has %s." % ", ".join(job.Fixtures))
    if patch > 1 and planned(texture).input.strategy != strategies.LOCKED:
        FreeCAD.Console.PrintWarning("%s: %s\n" % (texture.Label, UNLOCKED))
    group = list(job.Operations.Group)
    try:
        with part(job, group[group.index(texture) :], [offset], {texture: (patch, texture.LastPatch)}):
            yield
    finally:
        job.Document.recompute()


def _only(job):
    textures = [op for op in job.Operations.Group if kind_of(op) == TEXTURE and host.is_active(op)]
    if len(textures) != 1:
        raise InputError("Operation", "%d textures" % len(textures), "say which of the job's goes on.")
    return textures[0]


def _only_offset(job):
    if len(job.Fixtures) != 1:
        raise InputError("Fixtures", ", ".join(job.Fixtures), "say which copy goes on.")
    return job.Fixtures[0]


@contextlib.contextmanager
def part(job, operations, offsets, patches):
    """The job as if it had these operations and work offsets alone, and of textures the patches from first to
    last; then as it was, but not yet recomputed. `patches`: {texture: (first, last)}."""
    fixtures, ranges = list(job.Fixtures), [(op, op.FirstPatch, op.LastPatch) for op in patches]
    others = [_switch_of(op) for op in job.Operations.Group if op not in operations]
    switched = [op for op in others if op is not None and op.Active]
    try:
        job.Fixtures = offsets
        for op, (first, last) in patches.items():
            op.FirstPatch, op.LastPatch = first, last
        for op in switched:
            op.Active = False
        yield
    finally:
        job.Fixtures = fixtures
        for op, first, last in ranges:
            op.FirstPatch, op.LastPatch = first, last
        for op in switched:
            op.Active = True


def _switch_of(op):
    """The operation that switches `op`, itself or under dressups, on and off; None if there is none."""
    while not hasattr(op, "Active"):
        op = getattr(op, "Base", None)
        if op is None:
            return None
    return op
