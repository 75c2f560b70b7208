"""The names that the GUI's modules had before they lay in folders (patchmill.old_names): documents save those
of view providers.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.old_names import OldNames

NEW_NAMES = {
    "startup": "app.startup",
    "workbench": "app.workbench",
    "commands": "app.commands",
    "command_base": "app.command_base",
    "examples": "app.examples",
    "operation_views": "app.operation_views",
    "tool_paths": "app.tool_paths",
    "resources": "forms.resources",
    "widgets": "forms.widgets",
    "property_rows": "forms.property_rows",
    "property_form": "forms.property_form",
    "choice_rows": "forms.choice_rows",
    "idle_properties": "forms.idle_properties",
    "texture_summary": "forms.texture_summary",
    "machine_editor": "forms.machine_editor",
    "advisor_box": "forms.advisor_box",
    "background": "work.background",
    "computing": "work.computing",
    "work_panel": "work.work_panel",
    "texture_scene": "views.texture_scene",
    "path_view": "views.path_view",
    "tool_node": "views.tool_node",
    "legend": "views.legend",
    "operation_base": "panels.operation_base",
    "texture_panel": "panels.texture_panel",
    "texture_view": "panels.texture_view",
    "copy_panel": "panels.copy_panel",
    "dcm_panel": "panels.dcm_panel",
    "check_panel": "panels.check_panel",
    "report_panel": "panels.report_panel",
    "simulate_panel": "panels.simulate_panel",
    "player": "panels.player",
}

FINDER = OldNames("patchmill_gui", NEW_NAMES)
