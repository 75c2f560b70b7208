"""The user's settings, kept by FreeCAD: defaults of new operations, and the limit of threads.

    User parameter:BaseApp/Preferences/Mod/PatchMill

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
from dataclasses import dataclass

import FreeCAD

PATH = "User parameter:BaseApp/Preferences/Mod/PatchMill"


@dataclass
class Tool:
    """The ball end mill of a new job: diameter [mm], flutes, feed [mm/min], speed [rpm]."""

    diameter: float = 2.0
    flutes: int = 2
    feed: float = 450.0
    speed: float = 1000.0


def _group():
    return FreeCAD.ParamGet(PATH)


def tool():
    """The Tool of new jobs."""
    group, default = _group(), Tool()
    return Tool(
        group.GetFloat("ToolDiameter", default.diameter),
        group.GetInt("ToolFlutes", default.flutes),
        group.GetFloat("ToolFeed", default.feed),
        float(group.GetInt("SpindleSpeed", int(default.speed))),
    )


def operation_defaults():
    """Values that new texture operations get instead of their own defaults, by property."""
    group = _group()
    return {
        "Spacing": group.GetFloat("Spacing", 0.5),
        "Machine": group.GetString("Machine", ""),
        "Decimals": group.GetInt("Decimals", 3),
    }


def post():
    """FreeCAD post-processor of new jobs."""
    return _group().GetString("Post", "linuxcnc")


def program_folder():
    """Where the last program went; at first the user's home."""
    return _group().GetString("ProgramFolder", os.path.expanduser("~"))


def remember(**values):
    """Keeps texts for the next time: ProgramFolder, Machine."""
    for name, value in values.items():
        _group().SetString(name, value)


def remember_machine(key):
    """The first machine that is chosen for an operation is that of all to come."""
    if key and not operation_defaults()["Machine"]:
        remember(Machine=key)


def threads():
    """How many threads a computation may use; 0: all of the machine's."""
    return _group().GetInt("Threads", 0)
