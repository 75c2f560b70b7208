"""FreeCAD post-processor for Heidenhain TNC in plain text: L blocks, M128. Not tried on a control.

Choose `patchmill_heidenhain` as the job's post-processor. It takes FreeCAD's usual arguments.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.posting.post_dialect import Dialect

DIALECT = Dialect("patchmill_heidenhain", "heidenhain", "Heidenhain TNC", precision=3)
TOOLTIP = DIALECT.tooltip
TOOLTIP_ARGS = DIALECT.arguments_help
UNITS = "G21"
export = DIALECT.export
Patchmill_Heidenhain = DIALECT.processor()
