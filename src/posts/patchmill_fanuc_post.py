"""FreeCAD post-processor for Fanuc controls: G43.4 for tool-centre-point control, G93 where rotary
axes move. Not tried on a control.

Choose `patchmill_fanuc` as the job's post-processor. It takes FreeCAD's usual arguments.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.posting.post_dialect import Dialect

DIALECT = Dialect("patchmill_fanuc", "fanuc", "Fanuc", precision=3, modal=True)
TOOLTIP = DIALECT.tooltip
TOOLTIP_ARGS = DIALECT.arguments_help
UNITS = "G21"
export = DIALECT.export
Patchmill_Fanuc = DIALECT.processor()
