"""PlanarTexture: a dimple texture of planar patches (Matsuda 2008): each patch lies in a plane of its own.

    op = patchmill.PlanarTexture.Create("Texture", parentJob=job)
    op.Base = [(job.Model.Group[0], ["Face1"])]
    patchmill.recompute(op)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core

from patchmill.freecad import host
from patchmill.operations.base import create, setup_properties
from patchmill.operations.texture_operation import ObjectTexture
from patchmill.properties.texture_results import FREE_FORM_RESULTS


class ObjectPlanarTexture(ObjectTexture):
    """See texture_operation.ObjectTexture."""

    __module__ = "patchmill.planar_texture"  # what documents save

    SURFACE = "Planar"
    OWN_PROPERTIES = [
        (
            "App::PropertyEnumeration",
            "PlaneFit",
            "Texture",
            "Each patch's plane fits its dimples on the faces best, or goes through its corners there",
            ["Best fit", "Corners"],
        ),
        (
            "App::PropertyEnumeration",
            "Form",
            "Free form",
            "Lattice: dimples are placed; free: marks fall as side, cross-feed and feed make them",
            ["Lattice", "Free"],
        ),
        ("App::PropertyLength", "FreeSide", "Free form", "Side of the patches", 7.0),
        ("App::PropertyLength", "CrossFeed", "Free form", "Distance of neighbouring passes", 0.5),
        (
            "App::PropertyLength",
            "FeedPerTooth",
            "Free form",
            "Distance of marks along the path; 0: from the tool controller's feed and spindle speed",
            0.0,
        ),
    ]
    OWN_RESULTS = FREE_FORM_RESULTS

    def patch_surface(self, obj):
        return core.PatchSurface(self.SURFACE, fit=obj.PlaneFit)


def SetupProperties():
    """Names of the properties that a job's setup sheet may hold defaults for."""
    return setup_properties(ObjectPlanarTexture)


def Create(name, obj=None, parentJob=None):
    """A new PlanarTexture in the active document; `parentJob` is the Job it goes into."""
    return create(ObjectPlanarTexture, name, obj, parentJob)


host.register_operation("PlanarTexture", Create, SetupProperties)
