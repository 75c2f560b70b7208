"""CurvedTexture: a dimple texture of curved patches (Xu & Sasahara 2016): each dimple lies on the faces.

    op = patchmill.CurvedTexture.Create("Texture", parentJob=job)
    op.Base = [(job.Model.Group[0], ["Face1"])]
    patchmill.recompute(op)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.freecad import host
from patchmill.operations.base import create, setup_properties
from patchmill.operations.texture_operation import ObjectTexture


class ObjectCurvedTexture(ObjectTexture):
    """See texture_operation.ObjectTexture."""

    __module__ = "patchmill.curved_texture"  # what documents save

    SURFACE = "Curved"


def SetupProperties():
    """Names of the properties that a job's setup sheet may hold defaults for."""
    return setup_properties(ObjectCurvedTexture)


def Create(name, obj=None, parentJob=None):
    """A new CurvedTexture in the active document; `parentJob` is the Job it goes into."""
    return create(ObjectCurvedTexture, name, obj, parentJob)


host.register_operation("CurvedTexture", Create, SetupProperties)
