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


def inputs_of(obj, names):
    """What the path of an object of a document that was opened without a core is made from: {property:
    value}; empty where there is a core."""
    if not core_loader.why_absent():
        return {}
    return {name: _plain(getattr(obj, name, None)) for name in names}


def drop_path(obj, name, inputs):
    """Empties the path of `obj` if its property `name` is not as in `inputs` any more. FreeCAD sets many
    again to what they are."""
    if name in inputs and "Restore" not in obj.State and _plain(getattr(obj, name)) != inputs[name]:
        if obj.Path.Size:
            obj.Path = host.Path.Path()
            text = "%s: %s was changed, and the path is taken away until it can be computed\n"
            FreeCAD.Console.PrintWarning(text % (obj.Label, name))


def _plain(value):
    """A value that can be compared later: document objects by their names."""
    if isinstance(value, (list, tuple)):
        return [_plain(v) for v in value]
    if isinstance(value, float):
        return round(value, 9)
    return str(getattr(value, "Name", getattr(value, "UserString", value)))
