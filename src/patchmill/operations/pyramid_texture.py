"""PyramidTexture: a dimple texture of pyramid patches (Xu & Sasahara 2013).

A flat facet goes from each side of a patch's outline to an apex over its middle.

    op = patchmill.PyramidTexture.Create("Texture", parentJob=job)
    op.Base = [(job.Model.Group[0], ["Face1"])]
    patchmill.recompute(op)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core

from patchmill.freecad import host
from patchmill.operations.base import create, setup_properties
from patchmill.operations.texture_operation import ObjectTexture


class ObjectPyramidTexture(ObjectTexture):
    """See texture_operation.ObjectTexture."""

    __module__ = "patchmill.pyramid_texture"  # what documents save

    SURFACE = "Pyramid"
    OWN_PROPERTIES = [
        (
            "App::PropertyFloat",
            "HeightFactor",
            "Texture",
            "1: corners and apex on the faces; 0: flat; other values exaggerate or invert the pyramid",
            1.0,
        ),
        (
            "App::PropertyDistance",
            "ApexLift",
            "Texture",
            "Added to the height of each apex",
            0.0,
        ),
    ]

    def patch_surface(self, obj):
        return core.PatchSurface(
            self.SURFACE, height_factor=obj.HeightFactor, apex_lift=obj.ApexLift.Value
        )


def SetupProperties():
    """Names of the properties that a job's setup sheet may hold defaults for."""
    return setup_properties(ObjectPyramidTexture)


def Create(name, obj=None, parentJob=None):
    """A new PyramidTexture in the active document; `parentJob` is the Job it goes into."""
    return create(ObjectPyramidTexture, name, obj, parentJob)


host.register_operation("PyramidTexture", Create, SetupProperties)
