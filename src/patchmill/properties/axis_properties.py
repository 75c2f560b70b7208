"""The properties of the texture operations that say how the tool axis stands, and how machines with rotary
axes are told (see property_table for what the rows are).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD

from patchmill.textures import tool_posture

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
