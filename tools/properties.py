"""Writes docs/properties.md from the property tables of the operations and the modifier:

    tools/freecad tools/properties.py

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib

from patchmill.modifiers import dressup_dcm
from patchmill.operations.copy_milling import ObjectCopyMilling
from patchmill.operations.planar_texture import ObjectPlanarTexture
from patchmill.operations.pyramid_texture import ObjectPyramidTexture
from patchmill.operations.texture_operation import ObjectTexture
from patchmill.properties.property_table import ENUMERATION, UNITS, label_of

PAGE = pathlib.Path(__file__).resolve().parents[1] / "docs" / "properties.md"
HEAD = """# Properties

Made by `tools/properties.py` from the tables that also make the properties, the panels' rows and their tips,
and the setup sheet's defaults. An error names a property as here in the first column; the panel shows it as
in the second, but for the few that stand in front, under Pattern. Numbers have the unit of their column;
FreeCAD shows them in the user's own.
"""
KINDS = {
    "Bool": "yes or no",
    "Integer": "whole number",
    "String": "text",
    "StringList": "lines of text",
    "File": "file",
    "Vector": "vector",
    "Link": "object",
    "LinkListGlobal": "objects",
}


def kind_of(kind, default=None):
    """What a property takes, in words."""
    if kind == ENUMERATION:
        return ", ".join(default) if default else "one of several"
    return UNITS.get(kind) or KINDS.get(kind.replace("App::Property", ""), "number")


def shown(kind, default):
    """A default as the table shows it."""
    if kind == ENUMERATION:
        return default[0]
    if isinstance(default, bool):
        return "yes" if default else "no"
    if default is None or default == [] or default == "":
        return ""
    if kind == "App::PropertyVector":
        return "(%g, %g, %g)" % tuple(default)
    return "%g" % default if isinstance(default, float) else str(default)


def settings(title, rows):
    """The lines of a section with what the user sets."""
    yield from ("", "## " + title, "")
    yield "| property | in the panel | takes | at first | what it does |"
    yield "| --- | --- | --- | --- | --- |"
    for kind, name, group, tip, default in rows:
        cells = (name, "%s: %s" % (group, label_of(name)), kind_of(kind, default), shown(kind, default), tip)
        yield "| %s |" % " | ".join(cell.replace("|", "\\\\|") for cell in cells)


def results(title, rows):
    """The lines of a section with what an operation shows."""
    yield from ("", "## " + title, "", "| property | unit | what it says |", "| --- | --- | --- |")
    for kind, name, _, tip in rows:
        yield "| %s | %s | %s |" % (name, kind_of(kind), tip)


def page():
    """The text of docs/properties.md."""
    lines = [
        *settings("Texture operations", ObjectTexture.properties()),
        *settings("PlanarTexture besides", ObjectPlanarTexture.OWN_PROPERTIES),
        *settings("PyramidTexture besides", ObjectPyramidTexture.OWN_PROPERTIES),
        *results("Results of textures", ObjectTexture.results()),
        *results("Results of PlanarTexture besides", ObjectPlanarTexture.OWN_RESULTS),
        *settings("CopyMilling", ObjectCopyMilling.properties()),
        *results("Results of CopyMilling", ObjectCopyMilling.results()),
        *settings("DCM modifier", dressup_dcm.PROPERTIES),
        *results("Results of the DCM modifier", dressup_dcm.RESULTS),
    ]
    return HEAD + "\n".join(lines) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page())
