"""What operations do where the compiled core cannot be loaded: their path stays as it was saved, until what
it was made from changes. Then it is taken away, since it would be posted as if it were right.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD

from patchmill.freecad import host
from patchmill.install import core_loader


def keeps_path(obj):
    """Whether `obj` cannot be computed for want of a core; says so in one sentence. Its path stays."""
    reason = core_loader.why_absent()
    if reason:
        text = "%s is not computed: %s; %s\n" % (obj.Label, reason, core_loader.REMEDY)
        FreeCAD.Console.PrintError(text)
    return bool(reason)


def drop_path(obj, changed, inputs):
    """Empties the path of `obj` if `changed` is one of `inputs`, names of its properties, and there is no
    core."""
    if core_loader.why_absent() and changed in inputs and "Restore" not in obj.State:
        if obj.Path.Size:
            obj.Path = host.Path.Path()
            text = "%s was changed: its path is taken away until it can be computed\n" % obj.Label
            FreeCAD.Console.PrintWarning(text)
