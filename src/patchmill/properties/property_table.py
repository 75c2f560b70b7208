"""Tables of FreeCAD properties: what documents, panels, setup sheets and docs/properties.md are made from,
and what a property is called in each of them.

A row is (type, name, group, tip, default); that of a result, which only shows, has no default. The default of
an enumeration is the list of its choices, of which the first is taken.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re

from patchmill.freecad.translate import QT_TRANSLATE_NOOP

ENUMERATION = "App::PropertyEnumeration"
# FreeCAD's own unit of those types that a number with a unit is typed in for
UNITS = {
    "App::PropertyLength": "mm",
    "App::PropertyDistance": "mm",
    "App::PropertyAngle": "deg",
    "App::PropertySpeed": "mm/s",
    "App::PropertyFloat": "",
}
# What a job's setup sheet can hold defaults for; FreeCAD knows no others there.
_SETUP_KINDS = {
    "App::Property" + kind
    for kind in ("Angle", "Bool", "Distance", "Enumeration", "Float", "Integer", "Length", "String")
}


def label_of(name):
    """What a panel calls a property: 'PatchSide' -> 'Patch side'."""
    words = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
    return words[:1] + words[1:].lower() if not words.endswith(("X", "Y")) else words


def field_of(name):
    """What the field of a dataclass is called that holds a property's value: 'PatchSide' -> 'patch_side'."""
    return re.sub(r"(?<!^)([A-Z])", r"_\1", name).lower()


def property_of(field):
    """The inverse of field_of."""
    return "".join(word.capitalize() for word in field.split("_"))


def add(obj, properties, results=()):
    """Adds those that `obj` lacks: to a new object all, to one of an older version's document the new ones,
    and new choices.
    To the prototype that FreeCAD asks what a setup sheet may hold, only what that can be, and without a
    value: it has none until the user gives one."""
    prototype = not hasattr(obj, "TypeId")
    for kind, name, group, tip, default in of_setup_sheet(properties) if prototype else properties:
        if not hasattr(obj, name):
            obj.addProperty(kind, name, group, QT_TRANSLATE_NOOP("App::Property", tip))
            if not prototype or kind == ENUMERATION:
                setattr(obj, name, default)  # a list sets an enumeration's choices
        elif not prototype and kind == ENUMERATION:
            _complete(obj, name, default)
    for kind, name, group, tip in () if prototype else results:
        if not hasattr(obj, name):
            obj.addProperty(kind, name, group, QT_TRANSLATE_NOOP("App::Property", tip))
        obj.setEditorMode(name, 1)  # read-only


def _complete(obj, name, choices):
    """Gives an enumeration of an older version's document the choices that are new; its value stays."""
    value = getattr(obj, name)
    if value in choices and list(obj.getEnumerationsOfProperty(name)) != list(choices):
        setattr(obj, name, choices)
        setattr(obj, name, value)


def set_defaults(obj, properties):
    """Gives an object's properties the table's defaults."""
    for kind, name, _, _, default in properties:
        setattr(obj, name, default[0] if kind == ENUMERATION else default)


def of_setup_sheet(properties):
    """Those of a table's rows that a job's setup sheet can hold."""
    return [row for row in properties if row[0] in _SETUP_KINDS]


def setup_names(properties):
    """Their names, as FreeCAD's operations give them."""
    return [row[1] for row in of_setup_sheet(properties)]
