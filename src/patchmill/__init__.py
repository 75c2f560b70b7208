"""PatchMill: regular dimple textures by ball-end milling, for macros and headless FreeCADCmd.

    import patchmill
    op = patchmill.CurvedTexture.Create("Texture", parentJob=job)
    op.Base = [(job.Model.Group[0], ["Face1"])]
    patchmill.recompute(op)                      # raises patchmill.InputError if it cannot be
    patchmill.post(job, "texture.ngc")           # writes only what was read back and checked

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib

from patchmill._version import __version__  # noqa: F401
from patchmill.install import core_loader

core_loader.load()  # or a stand-in that says why not
from _patchmill import InputError  # noqa: E402,F401

from patchmill import old_names  # noqa: E402

old_names.FINDER.install()

# Names that need FreeCAD's Path module are imported when first used, so that `import patchmill` is cheap.
_LAZY = {
    "PlanarTexture": ("patchmill.operations.planar_texture", None),
    "PyramidTexture": ("patchmill.operations.pyramid_texture", None),
    "CurvedTexture": ("patchmill.operations.curved_texture", None),
    "CalibrationPatch": ("patchmill.operations.calibration_patch", None),
    "DressupDCM": ("patchmill.modifiers.dressup_dcm", None),
    "cutting_load": ("patchmill.modifiers.dressup_dcm", "load_of"),
    "CopyMilling": ("patchmill.operations.copy_milling", None),
    "dcm": ("patchmill.modifiers.dcm", None),
    "live": ("patchmill.verify.live", None),
    "tilted_path": ("patchmill.path.tilted_path", None),
    "removal_model": ("patchmill.voxels.removal_model", None),
    "advisor": ("patchmill.textures.advisor", None),
    "advise": ("patchmill.textures.advisor", "advise"),
    "mark_state": ("patchmill.textures.advisor", "mark_state"),
    "job": ("patchmill.macros.jobs", "job"),
    "texture": ("patchmill.macros.jobs", "texture"),
    "choose_values": ("patchmill.advice.apply", "take_for"),
    "faces": ("patchmill.macros.faces", "faces"),
    "mesh": ("patchmill.geometry.mesh_parts", "mesh"),
    "mesh_region": ("patchmill.geometry.mesh_parts", "mesh_region"),
    "mesh_texture": ("patchmill.macros.meshes", "mesh_texture"),
    "planned": ("patchmill.operations.texture_operation", "planned"),
    "recompute": ("patchmill.operations.texture_operation", "recompute"),
    "best_speed": ("patchmill.verify.best_speed", "best_speed"),
    "post": ("patchmill.posting", "post"),
    "post_files": ("patchmill.posting.several_files", "post_files"),
    "read_back": ("patchmill.posting", "read_back"),
    "resume": ("patchmill.posting", "resume"),
    "simulate": ("patchmill.verify.simulation", "simulate"),
    "simulate_ball": ("patchmill.verify.simulation", "simulate_ball"),
    "simulate_round": ("patchmill.verify.simulation", "simulate_round"),
    "check": ("patchmill.verify.checks", "check"),
    "measured": ("patchmill.surface.files", "load"),
    "measured_texture": ("patchmill.areal.measured_texture", "measured_texture"),
    "areal_parameters": ("patchmill.areal.parameters", "areal_parameters"),
    "dales": ("patchmill.areal.dales", "dales"),
    "write_report": ("patchmill.reports.report", "write_report"),
    "report": ("patchmill.macros.outcome", "report"),
}


def __getattr__(name):
    if name not in _LAZY:
        return old_names.FINDER.attribute(name)
    module, attribute = _LAZY[name]
    found = importlib.import_module(module)
    return getattr(found, attribute) if attribute else found
