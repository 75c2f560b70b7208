"""Where icons and forms are, and FreeCAD's own GUI modules under the names that they have in this version.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib
import os
import typing

import patchmill
from patchmill.freecad import host

# patchmill is a folder of the module; its parent holds Resources, in the build tree and installed
FOLDER = os.path.join(os.path.dirname(os.path.dirname(patchmill.__file__)), "Resources")


def icon(name):
    """File name of an icon of ours."""
    return os.path.join(FOLDER, "icons", name + ".svg")


def path(*parts):
    """File name below Resources."""
    return os.path.join(FOLDER, *parts)


def native(subject: str) -> typing.Any:
    """FreeCAD's GUI module for a subject of host.GUI_MODULES."""
    return importlib.import_module(host.GUI_MODULES[subject])
