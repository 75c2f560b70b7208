"""Which of a texture's properties mean nothing while others are as they are: a panel hides their rows.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill import strategies

MASK = {
    "MaskImage",
    "MaskCurves",
    "MaskInvert",
    "MaskWidth",
    "MaskCentre",
    "MaskThreshold",
    "DepthAtBlack",
    "DepthAtWhite",
}
POLYGONS = (strategies.CONSTANT, strategies.FITTED)


def _mask(obj):
    if obj.MaskUse == "None":
        return MASK
    idle = set()
    if obj.MaskImage:
        idle.add("MaskCurves")
    else:
        idle |= {"MaskWidth", "MaskCentre"}
    if obj.MaskUse != "Leave out" or not obj.MaskImage:
        idle.add("MaskThreshold")
    if obj.MaskUse != "Depth":
        idle |= {"DepthAtBlack", "DepthAtWhite"}
    return idle


def idle_properties(obj):
    """Names of the properties of the texture operation `obj` that have no effect now."""
    idle = _mask(obj)
    if obj.AutoOrigin:
        idle.add("Origin")
    if obj.AutoDirection:
        idle.add("Direction")
    if obj.TextureKind == "Overlapping":
        idle.add("AreaShare")
    idle.add("ExtraTurns" if obj.Strategy not in POLYGONS else "Lift")
    return idle
