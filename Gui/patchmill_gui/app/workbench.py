"""What the workbench shows: toolbar, menus, preferences.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import functools

import FreeCADGui
from patchmill.freecad import host

from patchmill_gui.app import commands, examples
from patchmill_gui.forms.resources import native, path

SEPARATOR = "Separator"


def toolbar():
    """Names of the toolbar's commands, in order."""
    textures = [c.NAME for c in commands.TEXTURES]
    return (
        [host.NATIVE_COMMANDS["job"]]
        + textures
        + ["PatchMill_CalibrationPatch", "PatchMill_CopyMilling", "PatchMill_DressupDcm", SEPARATOR]
        + ["PatchMill_Play", "PatchMill_Simulate"]
        + ["PatchMill_Check", "PatchMill_Post", "PatchMill_Report", SEPARATOR]
        + ["PatchMill_Machines", "PatchMill_Examples"]
    )


def menu():
    """As the toolbar."""
    return toolbar()


@functools.lru_cache(maxsize=None)
def start():
    """Once, when the workbench or FreeCAD's CAM workbench is first shown."""
    import PathGui  # noqa: F401  FreeCAD's icons and forms, without its workbench being shown

    native("startup").Startup()
    FreeCADGui.addIconPath(path("icons"))
    FreeCADGui.addLanguagePath(path("translations"))
    FreeCADGui.updateLocale()  # those of the language that FreeCAD speaks are loaded
    commands.register()
    examples.register()
    FreeCADGui.addPreferencePage(path("ui", "preferences.ui"), "PatchMill")
