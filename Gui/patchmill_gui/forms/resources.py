"""Where icons and forms are, and FreeCAD's own GUI modules under the names that they have in this version.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib
import os
import typing

from patchmill.freecad import host
from patchmill.install import core_loader

FOLDER = os.path.join(core_loader.module_root(), "Resources")


def icon(name):
    """File name of an icon of ours."""
    return os.path.join(FOLDER, "icons", name + ".svg")


def path(*parts):
    """File name below Resources."""
    return os.path.join(FOLDER, *parts)


def native(subject: str) -> typing.Any:
    """FreeCAD's GUI module for a subject of host.GUI_MODULES."""
    return importlib.import_module(host.GUI_MODULES[subject])
