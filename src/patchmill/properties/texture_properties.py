"""The property table of the texture operations (see property_table for what its rows are).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
import FreeCAD

from patchmill.properties.axis_properties import AXIS_PROPERTIES
from patchmill.properties.ball_properties import BALL_PROPERTIES
from patchmill.properties.check_properties import CHECK_PROPERTIES
from patchmill.properties.row_properties import ROW_PROPERTIES
from patchmill.textures import strategies

try:
    SHAPES = core.patch_shapes()
except core.InputError:  # there is no core: a document's own list stays as it is
    SHAPES = ["Square"]

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
        "Projected: spacing kept as seen along the projection; on surface: kept along the faces; ball: a "
        "lattice that is a sphere's own",
        ["Projected", "On surface", "Ball"],
    ),
    *BALL_PROPERTIES,
    (
        "App::PropertyEnumeration",
        "PatchShape",
        "Texture",
        "Shape of the patches: squares and rectangles on a square lattice, the others on a triangular one",
        SHAPES,
    ),
    (
        "App::PropertyInteger",
        "PatchSide",
        "Texture",
        "Dimples along the side of a square or triangle; radius of a hexagon in dimples",
        14,
    ),
    (
        "App::PropertyInteger",
        "PatchSideAcross",
        "Texture",
        "Dimples along the other side of a patch whose sides may differ; 0: as the first side",
        0,
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
    *ROW_PROPERTIES,
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
    *CHECK_PROPERTIES,
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
