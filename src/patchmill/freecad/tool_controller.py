"""What operations take of FreeCAD's tool controller, checked.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
from _patchmill import InputError

from patchmill.freecad import host, tool_bits

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


def flutes(bit):
    """How many a tool bit has; 1 if it does not say, for work that does not depend on them."""
    return max(1, int(getattr(bit, "Flutes", 1)))


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
