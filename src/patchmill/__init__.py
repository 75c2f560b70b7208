"""PatchMill: regular dimple textures by ball-end milling, for macros and headless FreeCADCmd.

    import patchmill
    op = patchmill.CurvedTexture.Create("Texture", parentJob=job)
    op.Base = [(job.Model.Group[0], ["Face1"])]
    patchmill.recompute(op)                      # raises patchmill.InputError if it cannot be
    patchmill.post(job, "texture.ngc")           # writes only what was read back and checked

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib

from _patchmill import InputError  # noqa: F401

# Names that need FreeCAD's Path module are imported when first used, so that `import patchmill` is cheap.
_LAZY = {
    "PlanarTexture": ("patchmill.planar_texture", None),
    "PyramidTexture": ("patchmill.pyramid_texture", None),
    "CurvedTexture": ("patchmill.curved_texture", None),
    "CalibrationPatch": ("patchmill.calibration_patch", None),
    "DressupDCM": ("patchmill.dressup_dcm", None),
    "CopyMilling": ("patchmill.copy_milling", None),
    "dcm": ("patchmill.dcm", None),
    "live": ("patchmill.live", None),
    "tilted_path": ("patchmill.tilted_path", None),
    "removal_model": ("patchmill.removal_model", None),
    "advisor": ("patchmill.advisor", None),
    "advise": ("patchmill.advisor", "advise"),
    "mark_state": ("patchmill.advisor", "mark_state"),
    "planned": ("patchmill.texture_operation", "planned"),
    "recompute": ("patchmill.texture_operation", "recompute"),
    "post": ("patchmill.posting", "post"),
    "simulate": ("patchmill.simulation", "simulate"),
    "check": ("patchmill.checks", "check"),
    "write_report": ("patchmill.report", "write_report"),
}


def __getattr__(name):
    if name not in _LAZY:
        raise AttributeError("module 'patchmill' has no attribute %r" % name)
    module, attribute = _LAZY[name]
    found = importlib.import_module(module)
    return getattr(found, attribute) if attribute else found
