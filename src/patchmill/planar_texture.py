"""PlanarTexture: a dimple texture of planar patches (Matsuda 2008): each patch lies in a plane of its own.

    op = patchmill.PlanarTexture.Create("Texture", parentJob=job)
    op.Base = [(job.Model.Group[0], ["Face1"])]
    patchmill.recompute(op)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core

from patchmill import host
from patchmill.texture_operation import ObjectTexture, create, setup_properties


class ObjectPlanarTexture(ObjectTexture):
    """See texture_operation.ObjectTexture."""

    SURFACE = "Planar"
    OWN_PROPERTIES = [
        (
            "App::PropertyEnumeration",
            "PlaneFit",
            "Texture",
            "Each patch's plane fits its dimples on the faces best, or goes through its corners there",
            ["Best fit", "Corners"],
        ),
    ]

    def patch_surface(self, obj):
        return core.PatchSurface(self.SURFACE, fit=obj.PlaneFit)


def SetupProperties():
    """Names of the properties that a job's setup sheet may hold defaults for."""
    return setup_properties(ObjectPlanarTexture)


def Create(name, obj=None, parentJob=None):
    """A new PlanarTexture in the active document; `parentJob` is the Job it goes into."""
    return create(ObjectPlanarTexture, name, obj, parentJob)


host.register_operation("PlanarTexture", Create, SetupProperties)
