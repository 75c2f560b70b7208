"""What operations take of FreeCAD's tool controller, checked.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError

from patchmill import host

SENSES = {"Forward": "M3", "Reverse": "M4"}


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
