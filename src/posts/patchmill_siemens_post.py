"""FreeCAD post-processor for Siemens 840D: TRAORI, CYCLE832, G93 where rotary axes move. Not tried
on a control.

Choose `patchmill_siemens` as the job's post-processor. It takes FreeCAD's usual arguments.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.posting.post_dialect import Dialect

DIALECT = Dialect("patchmill_siemens", "siemens", "Siemens 840D", precision=3, modal=True, line_numbers=True)
TOOLTIP = DIALECT.tooltip
TOOLTIP_ARGS = DIALECT.arguments_help
UNITS = "G21"
export = DIALECT.export
Patchmill_Siemens = DIALECT.processor()
