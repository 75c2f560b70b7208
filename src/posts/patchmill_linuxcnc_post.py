"""FreeCAD post-processor for LinuxCNC that keeps the words which spindle-locked paths need: K of
G33, P of G64 with six decimals, and an F on every G1. FreeCAD's own linuxcnc post drops K.

Choose `patchmill_linuxcnc` as the job's post-processor. It takes FreeCAD's usual arguments.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.posting.post_dialect import Dialect

DIALECT = Dialect("patchmill_linuxcnc", "linuxcnc", "LinuxCNC", precision=4)
TOOLTIP = DIALECT.tooltip
TOOLTIP_ARGS = DIALECT.arguments_help
UNITS = "G21"
export = DIALECT.export
Patchmill_Linuxcnc = DIALECT.processor()
