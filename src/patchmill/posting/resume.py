"""Going on with a job that was stopped: what is left of it from a patch of one of its textures on.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib

import FreeCAD
from _patchmill import InputError

from patchmill import posting
from patchmill.freecad import host
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.operations.base import planned
from patchmill.textures import strategies

UNLOCKED = "the phase of what is milled now is not that of the patches before: nothing follows the spindle."


def resume(job, patch, filename, operation=None, offset=None, post_name=None, arguments=None):
    """Posts what is left of `job` from patch number `patch` of a texture on to `filename`: that texture from
    there, locked to the spindle anew, and the operations after it. Patches are counted from 1 in milling
    order, as in the comments of PatchComments. Returns what post() does. The document stays as it is.

    `operation`: the texture, if the job has more than one; `offset`: the work offset of the copy that was
    stopped, if there is more than one; the copies after it are programs of their own.
    Raises InputError naming Operation, Fixtures, FirstPatch, or what post() names."""
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
    with _as_left(job, texture, patch, offset):
        return posting.post(job, filename, post_name, arguments)


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
def _as_left(job, texture, patch, offset):
    """The job as it is to be posted, and then as it was."""
    group = list(job.Operations.Group)
    before = group[: group.index(texture)]
    first, fixtures = texture.FirstPatch, list(job.Fixtures)
    switched = [op for op in map(_switch_of, before) if op is not None and op.Active]
    try:
        texture.FirstPatch, job.Fixtures = patch, [offset]
        for op in switched:
            op.Active = False
        yield
    finally:
        texture.FirstPatch, job.Fixtures = first, fixtures
        for op in switched:
            op.Active = True
        job.Document.recompute()


def _switch_of(op):
    """The operation that switches `op`, itself or under dressups, on and off; None if there is none."""
    while not hasattr(op, "Active"):
        op = getattr(op, "Base", None)
        if op is None:
            return None
    return op
