"""What FreeCAD's library says of a tool bit, and what a bit and its operation say of shank and holder.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json

from _patchmill import InputError

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


def shaft(bit, operation=None, corner=0.0):
    """Edges, shank and holder of a tool bit as keywords of _patchmill.Tool, lengths above the tip [mm].

    From the bit: CuttingEdgeHeight, ShankDiameter and Length, which is how far it stands out of the holder
    unless the operation's StickOut says otherwise; from the operation HolderDiameter (0: none) and
    HolderLength. What the bit does not say: edges of 4 R, a shank as thick as the cutter, a length of 20 R.
    Without an operation, or one without these properties, there is no holder. `corner`: height of the cutting
    end. Raises InputError naming StickOut, or Length where the bit says it."""
    radius = float(bit.Diameter) / 2.0
    asked = _length(operation, "StickOut", 0.0)
    out = asked or _length(bit, "Length", 20.0 * radius)
    if out <= corner:
        name = "StickOut" if hasattr(operation, "StickOut") else "Length"
        raise InputError(name, "%g mm" % out, "the tool must stand out further than its cutting end.")
    holder = _length(operation, "HolderDiameter", 0.0) / 2.0
    height = _length(operation, "HolderLength", 0.0)
    there = holder > 0.0 and height > 0.0
    return {
        "cutting_length": min(max(_length(bit, "CuttingEdgeHeight", 4.0 * radius), corner), out),
        "shank_radius": _length(bit, "ShankDiameter", 2.0 * radius) / 2.0,
        "stick_out": out,
        "holder": [(out, out + height, holder, holder)] if there else [],
    }


def _length(obj, name, default):
    """Of a property in mm; the default where there is none, or it is zero."""
    value = float(getattr(obj, name, 0.0) or 0.0)
    return value if value > 0.0 else default
