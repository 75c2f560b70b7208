"""FreeCAD post-processor for Haas mills: tool-centre-point control by G234, no spindle lock. Not tried on a
control.

Choose `patchmill_haas` as the job's post-processor. It takes FreeCAD's usual arguments.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.posting.post_dialect import Dialect

DIALECT = Dialect("patchmill_haas", "haas", "Haas", precision=3)
TOOLTIP = DIALECT.tooltip
TOOLTIP_ARGS = DIALECT.arguments_help
UNITS = "G21"
export = DIALECT.export
Patchmill_Haas = DIALECT.processor()
