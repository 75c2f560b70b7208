"""What operations take of FreeCAD's tool controller, checked.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import _patchmill as core
import FreeCAD
from _patchmill import InputError

from patchmill.freecad import host, tool_bits

CONES = ("v-bit", "vbit", "chamfer")  # FreeCAD's kinds of conical end mills
SENSES = {"Forward": "M3", "Reverse": "M4"}


def require_tool(controller):
    """Raises InputError naming ToolController or Diameter if there is no tool to work with."""
    if controller is None or controller.Tool is None:
        raise InputError("ToolController", "none", "give the operation a tool controller with a tool.")
    if not float(getattr(controller.Tool, "Diameter", 0.0)) > 0.0:
        raise InputError(
            "Diameter",
            "0 mm",
            "the tool of %s needs a diameter greater than zero." % controller.Label,
        )


def require_ball_end(controller, remedy):
    """Raises InputError naming ToolController, with `remedy`, if the tool is no ball end mill."""
    kind = host.tool_kind(controller.Tool)
    if kind != "ballend":
        raise InputError("ToolController", "%s (%s)" % (controller.Label, kind or "unknown kind"), remedy)


def cutter(controller, operation=None):
    """The _patchmill.Tool of a controller: ball, bull nose, flat, tapered ball or conical end mill, with its
    shank, and the holder and stick-out that `operation` says (tool_bits.shaft). Raises InputError naming
    ToolController if the bit is none of them, StickOut, or what its bit says wrongly."""
    require_tool(controller)
    bit, kind = controller.Tool, host.tool_kind(controller.Tool)
    radius, corner, taper = float(bit.Diameter) / 2.0, None, 0.0
    if kind in ("bullnose", "torus"):
        corner = _corner_radius(bit, radius)
    elif kind == "endmill":
        corner = 0.0
    elif kind == "taperedballnose":
        taper = 0.5 * math.radians(float(bit.TaperAngle))  # FreeCAD's is between the flanks
    elif kind in CONES:
        radius, corner, taper = _tip_radius(bit), 0.0, _half_angle(bit)
    elif kind != "ballend":
        remedy = "choose a ball, bull nose, flat, tapered ball or conical end mill."
        raise InputError("ToolController", "%s (%s)" % (controller.Label, kind or "unknown kind"), remedy)
    end = radius if corner is None else corner
    return core.Tool(radius, flutes(bit), corner, taper, **tool_bits.shaft(bit, operation, end))


def any_cutter(controller, operation=None):
    """As cutter(); of a bit of another kind a flat end: what is known of it is its tip."""
    require_tool(controller)
    bit = controller.Tool
    if is_known(bit):
        return cutter(controller, operation)
    return core.Tool(float(bit.Diameter) / 2.0, flutes(bit), 0.0, **tool_bits.shaft(bit, operation))


def with_holder(tool, frusta):
    """A _patchmill.Tool with these (from, to, radius, radius), heights above the tip [mm], in the place of
    its holder; its shank ends where the lowest of them begins. What is beside its cutting end counts as that:
    frusta begin at the diameter's height, as for the posture."""
    lowest = 2.0 * tool.radius
    holder = [cut for frustum in frusta if (cut := above(frustum, lowest)) is not None]
    own = {name: getattr(tool, name) for name in ("cutting_length", "shank_radius", "stick_out")}
    if holder:
        own["stick_out"] = min(frustum[0] for frustum in holder)
    return core.Tool(tool.radius, tool.flutes, tool.corner_radius, tool.taper, **own, holder=holder)


def above(frustum, height):
    """The part of a (from, to, radius, radius) above a height; None if there is none."""
    low, high, r_low, r_high = frustum
    if high <= height:
        return None
    start = max(low, height)
    return start, high, r_low + (start - low) / (high - low) * (r_high - r_low), r_high


def set_ball(controller, diameter_mm, edges_mm):
    """Gives the ball end mill of a tool controller another diameter, and the height to which it has edges."""
    bit, named = controller.Tool, "Ball end mill %g mm"
    ours = controller.Label == named % float(bit.Diameter)
    bit.Diameter = diameter_mm
    if hasattr(bit, "CuttingEdgeHeight"):
        bit.CuttingEdgeHeight = edges_mm
    if ours:
        controller.Label = named % diameter_mm


def is_known(bit):
    """Whether the shape of a tool bit's cutting end is known: of a cone without a tip it is not."""
    kind = host.tool_kind(bit)
    if kind in CONES:
        return float(getattr(bit, "TipDiameter", 0.0)) > 0.0
    return kind in ("ballend", "bullnose", "torus", "endmill", "taperedballnose")


def _tip_radius(bit):
    """[mm], of the flat tip of a cone: no cone is ground to a point."""
    tip = float(getattr(bit, "TipDiameter", 0.0))
    if not tip > 0.0:
        remedy = "give %s the width of its flat tip, more than 0." % bit.Label
        raise InputError("TipDiameter", "%g mm" % tip, remedy)
    return tip / 2.0


def _half_angle(bit):
    """Between the flank of a cone and its axis [rad]; FreeCAD's is between the flanks."""
    angle = float(bit.CuttingEdgeAngle)
    if not 0.0 < angle <= 120.0:
        remedy = "the angle between the flanks of %s is more than 0 and at most 120 degrees." % bit.Label
        raise InputError("CuttingEdgeAngle", "%g degrees" % angle, remedy)
    return 0.5 * math.radians(angle)


def _corner_radius(bit, radius):
    """[mm], of a bull nose: its bit says it, or (FlatRadius) how wide its flat bottom is."""
    said = float(getattr(bit, "CornerRadius", 0.0) or 0.0)
    if said > 0.0:
        return said
    flat = float(getattr(bit, "FlatRadius", 0.0) or 0.0)
    if not 0.0 <= flat <= radius:
        remedy = "the flat bottom of %s is within its radius, %g mm." % (bit.Label, radius)
        raise InputError("FlatRadius", "%g mm" % flat, remedy)
    return radius - flat


def rapids(controller):
    """Its rapids across, and up or down [mm/s]."""
    return controller.HorizRapid.Value, controller.VertRapid.Value


def flutes(bit):
    """How many a tool bit has; 1 if it does not say, for work that does not depend on them."""
    return max(1, int(getattr(bit, "Flutes", 1)))


def require_flutes(controller):
    """Raises InputError naming Flutes, with what is proposed, if the tool bit does not say how many it has:
    those of FreeCAD's own library do not."""
    bit = controller.Tool
    said = int(getattr(bit, "Flutes", 0))
    if said < 1:
        remedy = "set Flutes of %s to what the tool has; proposed: %d, as most ball end mills have."
        raise InputError("Flutes", said, remedy % (bit.Label, tool_bits.PROPOSED_FLUTES))


def warn_of_unsaid_flutes(controller):
    """Says so in the report view if the number of flutes is nobody's: every dimple depends on it."""
    bit = controller.Tool
    if not tool_bits.flutes_said(bit):
        FreeCAD.Console.PrintWarning(
            "Flutes = %d: nobody has said how many %s has; FreeCAD's drawing of its kind has so many. Set "
            "Flutes of the tool bit in its library.\n" % (bit.Flutes, bit.Label)
        )


def sense(controller):
    """"M3" or "M4", as it will be posted. Raises InputError naming SpindleDirection if the spindle stands, or
    if FreeCAD posts the tool bit's own direction (1.1 does) and that is another."""
    asked, posted = controller.SpindleDir, host.posted_direction(controller)
    if asked not in SENSES:
        raise InputError("SpindleDirection", asked, "the spindle must turn: Forward or Reverse.")
    if posted != asked:
        raise InputError(
            "SpindleDirection",
            "%s in %s, %s in its tool bit" % (asked, controller.Label, posted),
            "this FreeCAD posts the tool bit's: set both alike.",
        )
    return SENSES[asked]
