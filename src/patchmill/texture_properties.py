"""The property table of the texture operations: what panels, setup sheets and documents are made from.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD

from patchmill import strategies, tool_posture

AXIS_PROPERTIES = [
    (
        "App::PropertyEnumeration",
        "ToolAxisMode",
        "Tool axis",
        "Fixed axis, surface normal with lead and tilt, fixed axis but leaned away from the normal, or field",
        list(tool_posture.MODES),
    ),
    (
        "App::PropertyVector",
        "FixedAxis",
        "Tool axis",
        "Direction from the tip to the holder; other than Z it needs rotary axes",
        FreeCAD.Vector(0, 0, 1),
    ),
    ("App::PropertyAngle", "Lead", "Tool axis", "Lean from the normal towards the feed", 15.0),
    ("App::PropertyAngle", "Tilt", "Tool axis", "Lean from the normal to the left of the feed", 0.0),
    (
        "App::PropertyAngle",
        "MinimumLead",
        "Tool axis",
        "Least angle between tool axis and normal, so that the tip does not cut",
        10.0,
    ),
    (
        "App::PropertyVector",
        "LeadTowards",
        "Tool axis",
        "Direction that the lead leans towards instead of the feed; zero: the feed",
        FreeCAD.Vector(0, 0, 0),
    ),
    (
        "App::PropertyLink",
        "PostureField",
        "Tool axis",
        "DCM modifier whose voxel model gives the axes; none: the job's stock less its model",
        None,
    ),
    ("App::PropertyLength", "FieldVoxelSize", "Tool axis", "Side of a voxel if no modifier is named", 2.0),
    (
        "App::PropertyAngle",
        "AxisSmoothing",
        "Tool axis",
        "By how much an axis may be drawn towards its neighbours'",
        0.0,
    ),
    ("App::PropertyAngle", "WidestTilt", "Tool axis", "Greatest angle of the axis to Z", 180.0),
    (
        "App::PropertyAngle",
        "RowTolerance",
        "Tool axis",
        "Spindle-locked rows keep one axis; greatest angle between it and the one asked for (half of it is "
        "used to turn less from row to row)",
        10.0,
    ),
    (
        "App::PropertyEnumeration",
        "ProgramForm",
        "Tool axis",
        "Whether the controller keeps the tool point (TCP), or the program is referred to the pivots",
        list(tool_posture.FORMS),
    ),
    (
        "App::PropertyLength",
        "GaugeLength",
        "Tool axis",
        "Length from the spindle's gauge point to the tip, for tilting heads without TCP",
        0.0,
    ),
]

# type, name, group, tip, default; a list as default is an enumeration, its first value the default
PROPERTIES = [
    (
        "App::PropertyLength",
        "Spacing",
        "Size",
        "Distance of neighbouring dimples; 0: from the other sizes",
        0.5,
    ),
    (
        "App::PropertyEnumeration",
        "TextureKind",
        "Size",
        "Overlapping: the dimples' bottoms are the faces; isolated: the faces stay between dimples",
        ["Overlapping", "Isolated"],
    ),
    ("App::PropertyLength", "Depth", "Size", "Depth of the dimples; 0: from the other sizes", 0.0),
    (
        "App::PropertyLength",
        "DimpleDiameter",
        "Size",
        "Diameter of a dimple's rim; 0: from the other sizes",
        0.0,
    ),
    (
        "App::PropertyFloat",
        "AreaShare",
        "Size",
        "Share of the faces that isolated dimples take up, 0 to 1; 0: from the other sizes",
        0.0,
    ),
    (
        "App::PropertyLength",
        "RidgeHeight",
        "Size",
        "Height of what stays between neighbouring dimples; 0: from the other sizes",
        0.0,
    ),
    (
        "App::PropertyEnumeration",
        "Mapping",
        "Texture",
        "Projected: spacing kept as seen along the projection; on surface: kept along the faces",
        ["Projected", "On surface"],
    ),
    (
        "App::PropertyEnumeration",
        "PatchShape",
        "Texture",
        "Shape of the patches: squares on a square lattice, the others on a triangular one",
        ["Square", "Hexagon", "Triangle"],
    ),
    (
        "App::PropertyInteger",
        "PatchSide",
        "Texture",
        "Dimples along the side of a square or triangle; radius of a hexagon in dimples",
        14,
    ),
    ("App::PropertyInteger", "PatchesX", "Texture", "Patches along X; 0 covers the faces", 0),
    ("App::PropertyInteger", "PatchesY", "Texture", "Patches along Y; 0 covers the faces", 0),
    (
        "App::PropertyEnumeration",
        "HelixOrder",
        "Texture",
        "Mill each patch from its outline inwards, or from its centre outwards",
        ["Inward", "Outward"],
    ),
    (
        "App::PropertyEnumeration",
        "HelixStart",
        "Texture",
        "Begin all patches at the same corner, or at the corner nearest to the patch before",
        ["Same corner", "Nearest corner"],
    ),
    (
        "App::PropertyVector",
        "Direction",
        "Texture",
        "Direction in which the texture is projected on the faces",
        FreeCAD.Vector(0, 0, -1),
    ),
    (
        "App::PropertyBool",
        "AutoDirection",
        "Texture",
        "Project on the faces from the side on which they look largest",
        False,
    ),
    ("App::PropertyAngle", "Rotation", "Texture", "Rotation of the texture", 0.0),
    ("App::PropertyBool", "AutoOrigin", "Texture", "Centre the texture on the faces", True),
    (
        "App::PropertyVector",
        "Origin",
        "Texture",
        "Centre of the texture, if not automatic",
        FreeCAD.Vector(0, 0, 0),
    ),
    (
        "App::PropertyAngle",
        "SteepestSlope",
        "Limits",
        "Dimples where the face is steeper than this to the projection are left out",
        80.0,
    ),
    (
        "App::PropertyAngle",
        "MinimumTilt",
        "Limits",
        "Dimples where the tool axis is nearer to the normal than this are left out: the tip rubs",
        1.0,
    ),
    (
        "App::PropertyBool",
        "AvoidRubbing",
        "Limits",
        "Leave out dimples in which the tip of the ball, which does not cut, would rub",
        False,
    ),
    (
        "App::PropertyLength",
        "Margin",
        "Limits",
        "Dimples nearer than this to the border of the faces are left out",
        0.0,
    ),
    (
        "App::PropertyInteger",
        "MinimumDimples",
        "Limits",
        "Patches with fewer dimples than this on the faces are left out",
        0,
    ),
    (
        "App::PropertyEnumeration",
        "MaskUse",
        "Mask",
        "What a picture or closed curves do: leave dimples out, thin them, or set their depth",
        ["None", "Leave out", "Density", "Depth"],
    ),
    ("App::PropertyFile", "MaskImage", "Mask", "Picture: white is milled, black is not", ""),
    (
        "App::PropertyLinkListGlobal",
        "MaskCurves",
        "Mask",
        "Sketches or wires: inside is milled, outside is not; used if there is no picture",
        [],
    ),
    ("App::PropertyBool", "MaskInvert", "Mask", "Change black for white, inside for outside", False),
    (
        "App::PropertyLength",
        "MaskWidth",
        "Mask",
        "Width of the picture on the texture plane; 0: as large as fits the faces",
        0.0,
    ),
    (
        "App::PropertyVector",
        "MaskCentre",
        "Mask",
        "Centre of the picture from the texture's own, along its X and Y",
        FreeCAD.Vector(0, 0, 0),
    ),
    (
        "App::PropertyFloat",
        "MaskThreshold",
        "Mask",
        "Grey below which dimples are left out, 0 (black) to 1 (white)",
        0.5,
    ),
    ("App::PropertyLength", "DepthAtBlack", "Mask", "Depth of dimples where it is black", 0.0),
    ("App::PropertyLength", "DepthAtWhite", "Mask", "Depth of dimples where it is white", 0.02),
    (
        "App::PropertyEnumeration",
        "Strategy",
        "Phase",
        "How the spindle's phase is kept",
        list(strategies.NAMES),
    ),
    ("App::PropertyString", "Machine", "Phase", "Name of the machine file; empty: unknown", ""),
    (
        "App::PropertyBool",
        "PostUnheld",
        "Phase",
        "Post even if the machine cannot hold the phase",
        False,
    ),
    (
        "App::PropertyLength",
        "GougeTolerance",
        "Checks",
        "Ball and flutes may cut so deep below the model, besides the texture itself",
        0.01,
    ),
    (
        "App::PropertyLength",
        "ToolClearance",
        "Checks",
        "Shank and holder must keep so far away from the model",
        0.1,
    ),
    (
        "App::PropertyLength",
        "StickOut",
        "Checks",
        "How far the tool stands out of its holder; 0: the tool bit's length",
        0.0,
    ),
    (
        "App::PropertyLength",
        "HolderDiameter",
        "Checks",
        "Diameter of the holder, for the collision check; 0: no holder",
        40.0,
    ),
    (
        "App::PropertyLength",
        "HolderLength",
        "Checks",
        "Length of the holder, for the collision check",
        60.0,
    ),
    (
        "App::PropertyBool",
        "PostGouging",
        "Checks",
        "Post even if the tool gouges or collides, or if that is not known",
        False,
    ),
    *AXIS_PROPERTIES,
    ("App::PropertyLength", "Lift", "Phase", "Clearance of paced paths between rows", 0.1),
    ("App::PropertyBool", "SameFlute", "Phase", "One flute makes all dimples", True),
    ("App::PropertyFloat", "ExtraTurns", "Phase", "Spindle turns added between dimples", 5.0),
    ("App::PropertyAngle", "PhaseStep", "Phase", "Angle added per dimple, for calibration", 0.0),
    (
        "App::PropertyInteger",
        "Decimals",
        "Phase",
        "Decimals of the posted coordinates; must be the post's own",
        3,
    ),
    (
        "App::PropertyAngle",
        "PhaseTolerance",
        "Phase",
        "Greatest phase error of the posted program",
        1.0,
    ),
]
# type, name, group, tip; read-only
RESULTS = [
    ("App::PropertyInteger", "DimpleCount", "Result", "Dimples that are milled"),
    ("App::PropertyString", "LeftOut", "Result", "Lattice points left out, by reason"),
    ("App::PropertyFloat", "TurnsPerDimple", "Result", "Mean spindle turns from dimple to dimple"),
    ("App::PropertyString", "Verdict", "Result", "Whether the machine can hold the phase"),
    ("App::PropertyFloat", "MachiningTime", "Result", "Time of all moves but rapids, in seconds"),
    ("App::PropertyLength", "FoundSpacing", "Result", "Distance of neighbouring dimples"),
    ("App::PropertyLength", "FoundDepth", "Result", "Depth of the dimples"),
    ("App::PropertyLength", "FoundDiameter", "Result", "Diameter of a dimple's rim"),
    ("App::PropertyFloat", "FoundAreaShare", "Result", "Share of the faces that is dimple, 0 to 1"),
    ("App::PropertyLength", "FoundRidgeHeight", "Result", "Height of what stays between dimples"),
    ("App::PropertyAngle", "RubbingTilt", "Result", "Tilt below which the tip rubs in a dimple"),
    ("App::PropertyInteger", "RubbingDimples", "Result", "Milled dimples in which the tip rubs"),
    ("App::PropertyLength", "SpacingLeast", "Result", "Least distance of neighbours, measured"),
    ("App::PropertyLength", "SpacingGreatest", "Result", "Greatest distance of neighbours, measured"),
    ("App::PropertyFloat", "SpacingRms", "Result", "Root mean square of distance / spacing - 1"),
    ("App::PropertyAngle", "LatticeAngleLeast", "Result", "Least angle of lattice directions, measured"),
    (
        "App::PropertyAngle",
        "LatticeAngleGreatest",
        "Result",
        "Greatest angle of lattice directions, measured",
    ),
    ("App::PropertyVector", "FoundDirection", "Result", "Direction of the projection"),
]

# What a job's setup sheet can hold defaults for; FreeCAD knows no others there.
_SETUP_KINDS = {
    "App::Property" + kind
    for kind in ("Angle", "Bool", "Distance", "Enumeration", "Float", "Integer", "Length", "String")
}


def of_setup_sheet(properties):
    """Those of a table's rows that a job's setup sheet can hold."""
    return [row for row in properties if row[0] in _SETUP_KINDS]
