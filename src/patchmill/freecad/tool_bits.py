"""What FreeCAD's library says of a tool bit.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json

PROPOSED_FLUTES = 2  # of a ball end mill that does not say how many it has


def flutes_said(bit):
    """Whether somebody has said how many flutes a tool bit has. FreeCAD 1.1 gives a bit whose library does
    not say it the number of its shape's drawing."""
    try:
        from Path.Tool.camassets import cam_assets
    except ImportError:  # before FreeCAD 1.1, whose bits say what their library says
        return True
    if not getattr(bit, "ToolBitID", ""):
        return True
    if not cam_assets.exists("toolbit://" + bit.ToolBitID):
        return True  # it is in no library
    try:
        bit_of_library = json.loads(cam_assets.get_raw("toolbit://" + bit.ToolBitID))
        drawn = cam_assets.get("toolbitshape://" + bit_of_library["shape"].rsplit(".", 1)[0])
    except (OSError, ValueError, KeyError):
        return True  # a library that FreeCAD itself cannot read says nothing against it
    said = {**bit_of_library.get("parameter", {}), **bit_of_library.get("attribute", {})}
    return "Flutes" in said or bit.Flutes != drawn.get_parameter("Flutes")
