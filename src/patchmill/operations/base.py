"""What PatchMill's operations have in common as FreeCAD operations: a ball end mill, properties from a table,
an error that is kept for whoever asks, and no old path after a failure.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError

from patchmill.freecad import absent_core, hooks, host, made_from, tool_controller
from patchmill.machine import machining_time
from patchmill.operations.computed import made, planned, recompute  # noqa: F401  for macros
from patchmill.properties import property_table
from patchmill.system.stops import to_its_end


class BallEndOperation(host.PathOp.ObjectOp):
    """An operation's proxy. `error`: the InputError of the last execute, else None; not saved. A subclass
    gives its tables (see property_table) and `opExecute`, and names in RESULT its attribute that a failed
    execute leaves None."""

    RESULT = ""
    error = None
    _inputs: dict = {}  # see absent_core

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
        made_from.add(obj)

    def opOnDocumentRestored(self, obj):
        property_table.add(obj, self.properties(), self.results())  # documents of older versions
        made_from.add(obj)
        names = [row[1] for row in self.properties()]
        names += ["Base", "ToolController", "SafeHeight", "ClearanceHeight"]
        self._inputs = absent_core.inputs_of(obj, names)
        hooks.announce_restored(obj)

    def onChanged(self, obj, prop):
        super().onChanged(obj, prop)
        absent_core.drop_path(obj, prop, self._inputs)

    def opSetDefaultValues(self, obj, job):
        property_table.set_defaults(obj, self.properties())

    def execute(self, obj):
        """As ObjectOp.execute, but an operation that fails leaves no old path to be posted, neither its own
        nor that of a dressup on it, which FreeCAD does not recompute then."""
        self.forget()
        if absent_core.keeps_path(obj):
            return None
        return to_its_end(self._compute)(obj)

    def _compute(self, obj):
        obj.Path = host.Path.Path()
        try:
            if obj.Active:
                made_from.job_of(obj)
                tool_controller.require_tool(obj.ToolController)
            result = super().execute(obj)
            self._tell_cycle_time(obj)
            return result
        except InputError as error:
            self.error = error
            forget_dressups(obj)
            raise

    def _tell_cycle_time(self, obj):
        """FreeCAD's own estimate knows neither inverse time nor the spindle's lock: the time is ours."""
        if getattr(self, self.RESULT) is not None:
            obj.CycleTime = machining_time.clock(obj.MachiningTime)
            self.job.Proxy.getCycleTime()

    def refresh_heights(self, obj):
        """The heights as a recompute would leave them: before the first one FreeCAD's expressions for them
        have not been evaluated, and would refer to a stock at zero."""
        self.updateDepths(obj, ignoreErrors=True)
        for name, expression in obj.ExpressionEngine:
            if name in ("SafeHeight", "ClearanceHeight"):
                setattr(obj, name, obj.evalExpression(expression))

    def updateDepths(self, obj, ignoreErrors=False):
        """As ObjectOp.updateDepths for operations without depths of their own; but that one looks every face
        up in its shape, in a time that grows with the square of their number. The box of a shape holds those
        of its faces."""
        if not self._setBaseAndStock(obj, ignoreErrors):
            return
        box = self.stock.Shape.BoundBox
        obj.OpStockZMin, obj.OpStockZMax = box.ZMin, box.ZMax
        start = max([box.ZMax] + [base.Shape.BoundBox.ZMax for base, _ in obj.Base])
        if obj.StartDepth.Value != start:
            obj.StartDepth = start
        self.opUpdateDepths(obj)

    def sanitizeBase(self, obj):
        """Called by ObjectOp.execute, whose own would clear Base if one of its faces is gone, and go on: an
        operation that then takes all of the part would mill what nobody chose."""
        for base, names in obj.Base:
            name = made_from.first_gone(base.Shape, names)
            if name is not None:
                remedy = "it is gone: choose the faces again."
                raise InputError("Base", "%s of %s" % (name, base.Label), remedy)
        return False

    def forget(self):
        """As if it had never been executed."""
        self.error = None
        setattr(self, self.RESULT, None)


def forget_dressups(obj):
    """Takes the paths of our dressups on `obj`, directly or over others, away: what they were made of is
    gone."""
    for other in obj.InListRecursive:
        if hasattr(getattr(other, "Proxy", None), "forget_path"):
            other.Proxy.forget_path(other)


def create(proxy_class, name, obj, parentJob):
    """A new operation in the document of `parentJob`, the Job it goes into; without one in the active
    document's job."""
    with host.active_document(parentJob and parentJob.Document) as document:
        if obj is None:
            obj = document.addObject("Path::FeaturePython", name)
        obj.Proxy = proxy_class(obj, name, parentJob)
        if hasattr(obj, "InList"):  # else it is the prototype of a setup sheet
            made_from.follow(obj, host.PathUtils.findParentJob(obj))
        return hooks.announce(obj)


def setup_properties(proxy_class):
    """Names of the properties that a job's setup sheet may hold defaults for."""
    return property_table.setup_names(proxy_class.properties())
