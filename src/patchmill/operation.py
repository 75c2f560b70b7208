"""What PatchMill's operations have in common as FreeCAD operations: a ball end mill, properties from a table,
an error that is kept for whoever asks, and no old path after a failure.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
from _patchmill import InputError

from patchmill import hooks, host, property_table


class BallEndOperation(host.PathOp.ObjectOp):
    """An operation's proxy. `error`: the InputError of the last execute, else None; not saved. A subclass
    gives its tables (see property_table) and `opExecute`, and names in RESULT its attribute that a failed
    execute leaves None."""

    RESULT = ""
    error = None

    @classmethod
    def properties(cls):
        """The table of the properties that a user sets."""
        raise NotImplementedError

    @classmethod
    def results(cls):
        """The table of those that show what was computed."""
        raise NotImplementedError

    def opFeatures(self, obj):
        op = host.PathOp
        return op.FeatureTool | op.FeatureHeights | op.FeatureBaseFaces | op.FeatureCoolant

    def isToolSupported(self, obj, tool):
        return host.takes_ball_end(obj, tool)

    def initOperation(self, obj):
        property_table.add(obj, self.properties(), self.results())

    def opOnDocumentRestored(self, obj):
        property_table.add(obj, self.properties(), self.results())  # documents of older versions
        hooks.announce_restored(obj)

    def opSetDefaultValues(self, obj, job):
        property_table.set_defaults(obj, self.properties())

    def execute(self, obj):
        """As ObjectOp.execute, but an operation that fails leaves no old path to be posted."""
        self.forget()
        obj.Path = host.Path.Path()
        return super().execute(obj)

    def forget(self):
        """As if it had never been executed."""
        self.error = None
        setattr(self, self.RESULT, None)


def create(proxy_class, name, obj, parentJob):
    """A new operation in the active document; `parentJob` is the Job it goes into."""
    if obj is None:
        obj = FreeCAD.ActiveDocument.addObject("Path::FeaturePython", name)
    obj.Proxy = proxy_class(obj, name, parentJob)
    return hooks.announce(obj)


def setup_properties(proxy_class):
    """Names of the properties that a job's setup sheet may hold defaults for."""
    return property_table.setup_names(proxy_class.properties())


def recompute(obj):
    """Recomputes one operation and returns what it made: a PlannedTexture, or copy milling's ToolPath. Raises
    InputError with the reason if there is nothing; FreeCAD itself would only mark the object."""
    obj.Proxy.forget()
    obj.touch()
    obj.Document.recompute()
    return made(obj)


def made(obj):
    """What the last execute of an operation made. Raises InputError with the reason if there is nothing."""
    if obj.Proxy.error is not None:
        raise obj.Proxy.error
    result = getattr(obj.Proxy, obj.Proxy.RESULT)
    if result is None:
        raise _refused_by_freecad(obj)
    return result


def _refused_by_freecad(obj):
    """The InputError for an operation that FreeCAD did not execute."""
    broken = [name for name in obj.PropertiesList if "Invalid" in _state_of(getattr(obj, name))]
    if broken:
        other = getattr(obj, broken[0]).Label
        return InputError(broken[0], other, "it has an error, so that nothing after it is computed: mend it.")
    return InputError(
        obj.Label, "not computed", "FreeCAD refused it: check its job, base faces and tool."
    )


def _state_of(value):
    """What FreeCAD says of a linked object; nothing for other values."""
    return value.State if hasattr(value, "TypeId") and hasattr(value, "State") else []
