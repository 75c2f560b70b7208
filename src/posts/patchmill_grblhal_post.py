"""FreeCAD post-processor for grblHAL: NIST RS-274 without tool-centre-point control and spindle lock. Not
tried on a control.

Choose `patchmill_grblhal` as the job's post-processor. It takes FreeCAD's usual arguments.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.posting.post_dialect import Dialect

DIALECT = Dialect("patchmill_grblhal", "grblhal", "grblHAL", precision=3)
TOOLTIP = DIALECT.tooltip
TOOLTIP_ARGS = DIALECT.arguments_help
UNITS = "G21"
export = DIALECT.export
Patchmill_Grblhal = DIALECT.processor()
