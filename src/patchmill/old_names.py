"""The names that modules had before they lay in folders: documents save them, users' scripts import them.

    import patchmill.host                        # is the module patchmill.freecad.host

A module found under its old name is the one of the new name, not a copy. Documents go on saving the old
names, which no folder appears in: both this version and the one before open them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib
import importlib.abc
import importlib.util
import sys

NEW_NAMES = {
    "host": "freecad.host",
    "hooks": "freecad.hooks",
    "preferences": "freecad.preferences",
    "translate": "freecad.translate",
    "tool_controller": "freecad.tool_controller",
    "made_from": "freecad.made_from",
    "post_probe": "freecad.post_probe",
    "machine_schema": "machine.schema",
    "machine_table": "machine.machine_table",
    "machines": "machine.machines",
    "base_path": "path.base_path",
    "tilted_path": "path.tilted_path",
    "texture_input": "textures.input",
    "texture_plan": "textures.plan",
    "texture_division": "textures.division",
    "texture_mask": "textures.masks",
    "free_form": "textures.free_form",
    "strategies": "textures.strategies",
    "tool_posture": "textures.tool_posture",
    "advisor": "textures.advisor",
    "outlines": "textures.outlines",
    "removal_model": "voxels.removal_model",
    "materials": "voxels.materials",
    "axis_field": "voxels.axis_field",
    "voxel_slices": "voxels.voxel_slices",
    "property_table": "properties.property_table",
    "texture_properties": "properties.texture_properties",
    "axis_properties": "properties.axis_properties",
    "texture_results": "properties.texture_results",
    "operation": "operations.base",
    "texture_operation": "operations.texture_operation",
    "planar_texture": "operations.planar_texture",
    "pyramid_texture": "operations.pyramid_texture",
    "curved_texture": "operations.curved_texture",
    "calibration_patch": "operations.calibration_patch",
    "copy_milling": "operations.copy_milling",
    "copy_input": "operations.copy_input",
    "quick_setup": "operations.quick_setup",
    "dcm": "modifiers.dcm",
    "dcm_input": "modifiers.dcm_input",
    "dressup_dcm": "modifiers.dressup_dcm",
    "checks": "verify.checks",
    "simulation": "verify.simulation",
    "simulated_motion": "verify.simulated_motion",
    "simulated_texture": "verify.simulated_texture",
    "live": "verify.live",
    "posted_milling": "verify.posted_milling",
    "post_dialect": "posting.post_dialect",
    "program_header": "posting.program_header",
    "pictures": "reports.pictures",
    "relief_report": "reports.relief_report",
    "relief_pictures": "reports.relief_pictures",
    "dcm_plots": "reports.dcm_plots",
}


class OldNames(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Finds the modules of a package under the old names of a table {old: new}, both below the package."""

    def __init__(self, package, new_names):
        self.package = package
        self.new_names = {package + "." + o: package + "." + n for o, n in new_names.items()}

    def install(self):
        """Asked before files are looked for: those of a version installed here before must not be found."""
        sys.meta_path.insert(0, self)

    def find_spec(self, name, path=None, target=None):
        new = self.new_names.get(name)
        if new is None:
            return None
        # with the place of its file: FreeCAD takes proxies only from modules in its Mod folders
        return importlib.util.spec_from_file_location(name, importlib.util.find_spec(new).origin, loader=self)

    def create_module(self, spec):
        module = importlib.import_module(self.new_names[spec.name])
        spec.loader_state = module.__spec__  # Python is about to replace it
        return module

    def exec_module(self, module):
        module.__spec__ = module.__spec__.loader_state

    def attribute(self, name):
        """The module of an old name as an attribute of its package. Raises AttributeError if it is none."""
        full_name = self.package + "." + name
        if full_name not in self.new_names:
            raise AttributeError("module %r has no attribute %r" % (self.package, name))
        return importlib.import_module(full_name)


FINDER = OldNames("patchmill", NEW_NAMES)
