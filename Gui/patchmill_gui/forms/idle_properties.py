"""Which properties of a texture or DCM modifier mean nothing while others are as they are: a panel hides
their rows.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core

from patchmill.properties.axis_properties import AXIS_PROPERTIES
from patchmill.properties.texture_properties import PROPERTIES
from patchmill.textures import strategies, tool_posture
from patchmill.textures.ball import laying as balls
from patchmill.textures.order import rows

MASK = {row[1] for row in PROPERTIES if row[2] == "Mask"} - {"MaskUse"}


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


def _axis(obj):
    fixed, normal, minimum, field = tool_posture.MODES
    used = {
        fixed: {"FixedAxis"},
        normal: {"Lead", "Tilt", "LeadTowards", "AxisSmoothing"},
        minimum: {"FixedAxis", "MinimumLead", "LeadTowards", "AxisSmoothing"},
        field: {"AxisSmoothing", "MinimumLead", "LeadTowards", "PostureField", "FieldVoxelSize"},
    }[obj.ToolAxisMode]
    if obj.PostureField is not None:
        used.discard("FieldVoxelSize")
    always = {"ToolAxisMode", "WidestTilt", "RowTolerance", "ProgramForm", "GaugeLength"}
    if obj.ToolAxisMode == fixed:
        always -= {"WidestTilt", "RowTolerance"}
    if not strategies.of(obj.Strategy).locked:
        always.discard("RowTolerance")
    return {row[1] for row in AXIS_PROPERTIES} - used - always


def _form(obj):
    if not hasattr(obj, "Form"):
        return set()
    if obj.Form == "Free":
        sizes = {"Spacing", "Depth", "DimpleDiameter", "RidgeHeight", "TextureKind"}
        return sizes | {"PatchSide", "PatchSideAcross"}
    return {"FreeSide", "CrossFeed", "FeedPerTooth"}


def _thread(obj):
    """A thread is one move round a cylinder: what divides, borders or orders other textures it has not."""
    if obj.Order != rows.THREAD:
        return set()
    idle = {"Margin", "Mapping", "Rotation", "AutoOrigin", "Origin", "MinimumTilt", "AvoidRubbing", "Lift"}
    idle |= {"PatchSide", "PatchSideAcross", "HelixOrder", "HelixStart", "MinimumDimples", "PatchComments"}
    idle |= {"RowExtent", "RowDirection", "RowsOneWay", "RowTolerance", "AxisSmoothing", "WidestTilt"}
    return idle | {"ProgramForm", "GaugeLength"}


def _ball(obj):
    """A ball's lattice is its own: no rows, shapes or directions of one that is laid in a plane."""
    own = {"BallLattice", "BallDimples", "BallSetups"}
    if obj.Mapping != balls.MAPPING or obj.Order == rows.THREAD:
        return own
    idle = {"PatchShape", "PatchSide", "PatchSideAcross", "PatchesX", "PatchesY", "HelixOrder", "HelixStart"}
    idle |= {"Rotation", "AutoOrigin", "Origin", "AreaShare", "RidgeHeight", "MaskUse"} | MASK
    if obj.BallDimples:
        idle.add("Spacing")
    return idle | ({"SteepestSlope"} if obj.BallSetups == balls.TWO else set())


def idle_properties(obj):
    """Names of the properties of the texture operation `obj` that have no effect now."""
    idle = _mask(obj) | _axis(obj) | _form(obj) | _thread(obj) | _ball(obj)
    if not core.two_sided(obj.PatchShape):
        idle.add("PatchSideAcross")
    if obj.AutoOrigin:
        idle.add("Origin")
    if obj.AutoDirection:
        idle.add("Direction")
    if obj.TextureKind == "Overlapping":
        idle.add("AreaShare")
    idle.add("ExtraTurns" if not strategies.of(obj.Strategy).polygons else "Lift")
    return idle


FEED = {
    "FeedAtProduct",
    "FeedAtSkin",
    "KeepPlunges",
    "Materials",
    "Diffusion",
    "FeedTolerance",
    "ForceLimit",
    "PowerLimit",
    "ChipLimit",
}
TRANSIENT = {"DiffusionTime", "TimeStep", "Diffusivity", "SubSteps"}
POSTURE = {"PostureForm", "TiltLimit", "AxisTolerance"}


def idle_dcm_properties(obj):
    """Names of the properties of the DressupDCM `obj` that have no effect now."""
    idle = set()
    if obj.Controls == "Feed":
        idle |= POSTURE
    if obj.Controls == "Posture":
        idle |= FEED | TRANSIENT
    if obj.Diffusion == "Steady":
        idle |= TRANSIENT
    return idle
