"""DressupDCM: feed, tool posture or both of any operation, taken from the voxel model of what is still to be
removed (Kobayashi & Shirase 2014; docs/dcm-fields.md).

    dressup = patchmill.DressupDCM.Create("DressupDCM", op)       # op: an operation of the job
    dressup.VoxelSize, dressup.FeedAtProduct, dressup.FeedAtSkin = 1.0, "400 mm/min", "800 mm/min"
    patchmill.DressupDCM.recompute(dressup)                       # raises patchmill.InputError

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
from _patchmill import InputError

from patchmill.freecad import absent_core, hooks, host, kinds, made_from
from patchmill.freecad.translate import QT_TRANSLATE_NOOP
from patchmill.modifiers import cutting_load, dcm, dcm_input, like_operation
from patchmill.operations.base import forget_dressups
from patchmill.operations.computed import not_computed
from patchmill.properties import property_table
from patchmill.properties.check_properties import POST_GOUGING, gouge_tolerance
from patchmill.voxels import removal_model
from patchmill.system.stops import stoppable, to_its_end

CONTROLS = ["Feed", "Posture", "Feed and posture"]
PROPERTIES = [
    ("App::PropertyEnumeration", "Controls", "DCM", "What is taken from the voxel model", CONTROLS),
    ("App::PropertyLength", "VoxelSize", "DCM", "Side of a voxel", 2.0),
    ("App::PropertySpeed", "FeedAtProduct", "DCM", "Feed at the product's surface, V_Lo", 400.0 / 60.0),
    ("App::PropertySpeed", "FeedAtSkin", "DCM", "Feed at the skin of the stock, V_Hi", 800.0 / 60.0),
    ("App::PropertySpeed", "FeedInAir", "DCM", "Feed where nothing is left to cut; 0: as elsewhere", 0.0),
    ("App::PropertyBool", "KeepPlunges", "DCM", "Moves that go down steeply never get faster", True),
    (
        "App::PropertyStringList",
        "Materials",
        "DCM",
        "Other materials in the stock: 'name factor where', a factor on the feed, and a depth in mm below "
        "the stock's surface or the name of a solid",
        [],
    ),
    (
        "App::PropertyEnumeration",
        "Exterior",
        "DCM",
        "Whether the values at the skin of the stock are held, or are only where diffusion begins",
        ["Held", "Free"],
    ),
    (
        "App::PropertyEnumeration",
        "Diffusion",
        "DCM",
        "Of the feed: to its steady state, or for a time as in the paper",
        ["Steady", "Transient"],
    ),
    ("App::PropertyFloat", "DiffusionTime", "DCM", "Of a transient diffusion, in seconds", 100.0),
    ("App::PropertyFloat", "TimeStep", "DCM", "Of a transient diffusion, in seconds", 0.1),
    ("App::PropertyFloat", "Diffusivity", "DCM", "Of a transient diffusion, in mm^2/s", 40.0),
    ("App::PropertyBool", "SubSteps", "DCM", "Divide a time step that is too long for the voxels", False),
    (
        "App::PropertyEnumeration",
        "PostureForm",
        "DCM",
        "Diffuse the two angles (as in the paper) or the unit vector of the axis",
        ["Angles", "Unit vector"],
    ),
    ("App::PropertyAngle", "TiltLimit", "DCM", "Greatest angle of the posture about X and about Y", 70.0),
    (
        "App::PropertyEnumeration",
        "Reading",
        "DCM",
        "Interpolate between voxels, or take each voxel's value (the paper's staircase)",
        ["Smooth", "Staircase"],
    ),
    ("App::PropertyEnumeration", "ReadAt", "DCM", "Where the voxels are read", ["Ball centre", "Tip"]),
    *cutting_load.LIMITS,
    *cutting_load.RESISTANCE,
    ("App::PropertySpeed", "FeedTolerance", "Limits", "Of a move's feed from the field's", 0.1),
    ("App::PropertyAngle", "AxisTolerance", "Limits", "Of the axis along a move", 0.25),
    ("App::PropertyString", "Machine", "Limits", "Name of the machine file; empty: no limits", ""),
    (
        "App::PropertyStringList",
        "Holder",
        "Limits",
        "Frusta of shank and holder: 'from to diameter diameter', heights above the tip in mm",
        [],
    ),
    ("App::PropertyLength", "HolderClearance", "Limits", "That is kept between holder and part", 1.0),
    gouge_tolerance("the tolerance of copy milling under it"),
    POST_GOUGING,
    ("App::PropertyLength", "Deflection", "Limits", "Of the triangles that stand for the shapes", 0.05),
    ("App::PropertyFloat", "MemoryLimit", "Limits", "For the voxel model and its fields, in MiB", 4096.0),
]
RESULTS = [
    ("App::PropertyInteger", "Moves", "Result", "Timed moves"),
    ("App::PropertyFloat", "MachiningTime", "Result", "Time of all moves, rapids too, in seconds"),
    ("App::PropertyFloat", "BaseTime", "Result", "The base operation's, in seconds"),
    ("App::PropertyFloat", "LargestFeedStep", "Result", "Between moves that go straight on, in mm/min"),
    ("App::PropertyFloat", "LargestAxisStep", "Result", "Within a move, in degrees"),
    ("App::PropertyInteger", "Voxels", "Result", "That are stored"),
    ("App::PropertyInteger", "NotClear", "Result", "Places where no axis keeps the holder clear"),
    *cutting_load.RESULTS,
]


class DressupDCM:
    """Proxy. `model` is the RemovalModel and `result` the dcm.Result of the last good execute, else None;
    `error` the InputError of the last execute, else None. `ready`: (model, result) made beforehand of what
    the dressup has now; the next execute takes it. None is saved."""

    __module__ = "patchmill.dressup_dcm"  # what documents save

    RESULT = "result"
    KIND = kinds.DCM
    model = result = error = ready = None
    _inputs: dict = {}  # see absent_core

    def __init__(self, obj, base):
        obj.addProperty(
            "App::PropertyLink", "Base", "Base", QT_TRANSLATE_NOOP("App::Property", "Path to modify")
        )
        obj.Base = base
        property_table.add(obj, PROPERTIES, RESULTS)
        made_from.add(obj)
        like_operation.add(obj)

    def dumps(self):
        return None

    def loads(self, state):
        return None

    def __getstate__(self):
        return None

    def __setstate__(self, state):
        return None

    def onDocumentRestored(self, obj):
        property_table.add(obj, PROPERTIES, RESULTS)
        made_from.add(obj)
        like_operation.add(obj)
        self._inputs = absent_core.inputs_of(obj, [row[1] for row in PROPERTIES] + ["Base"])
        hooks.announce_restored(obj)

    def onDelete(self, obj, args=None):
        """Puts the base operation back in the job; called before the dressup goes."""
        if obj.Base:
            job = host.PathUtils.findParentJob(obj)
            if job:
                job.Proxy.addOperation(obj.Base, obj)
            if obj.Base.ViewObject:
                obj.Base.ViewObject.Visibility = True
            obj.Base = None
        return True

    def forget(self):
        """As for operations: nothing is left of the last execute but the model, which may do for the next."""
        self.result = self.error = None

    def forget_path(self, obj):
        """As if it had never been executed: nothing old is left to be posted."""
        self.model = self.result = self.error = None
        obj.Path = host.Path.Path()

    def onChanged(self, obj, prop):
        absent_core.drop_path(obj, prop, self._inputs)
        like_operation.pass_on(obj, prop)

    def execute(self, obj):
        if absent_core.keeps_path(obj):
            return
        self._compute(obj)

    @to_its_end
    def _compute(self, obj):
        before = self.model  # its voxels may do for the new one, while it is there
        self.forget_path(obj)
        try:
            if not obj.Base:
                raise InputError("Base", "none", "the operation under it is gone: delete the dressup.")
            like_operation.follow(obj)
            if not host.is_active(obj):
                obj.Path = host.Path.Path("(inactive operation)")
                return
            self.model, self.result = self._ready_or_made(obj, dcm.input_of(obj))
        except InputError as error:
            self.error = error
            forget_dressups(obj)
            raise
        finally:
            del before
        if self.model.not_saved:
            FreeCAD.Console.PrintWarning("%s: %s\n" % (obj.Label, self.model.not_saved))
        obj.Path = host.Path.Path(self.result.commands)
        show_results(obj, self.model, self.result)
        like_operation.tell_cycle_time(obj, self.result.seconds)

    def _ready_or_made(self, obj, given):
        ready, self.ready = self.ready, None
        if ready is not None and ready[1].asked == given:
            return ready
        return compute(given, removal_model.file_beside(obj.Document, obj.Name))


@stoppable
def compute(given, file, progress=None):
    """(RemovalModel, dcm.Result) of a DcmInput, without touching a document: for any thread. `file`: where
    the model is kept, or ''. None if `progress` (share -> bool) returned False. Raises InputError."""
    model = removal_model.make(given.model, file, progress)
    return model and (model, dcm.apply(given, model))


def show_results(obj, model, result):
    counts = model.grid.counts
    obj.Moves = result.steps["moves"]
    obj.MachiningTime = result.seconds
    obj.BaseTime = result.base_seconds
    obj.LargestFeedStep = 60.0 * result.steps["feed"]
    obj.LargestAxisStep = result.axis_step_degrees
    obj.Voxels = counts["removal"] + counts["surface"] + counts["exterior"]
    obj.NotClear = result.not_clear
    load = result.load
    obj.LargestForce = load.force.max() if load else 0.0
    obj.LargestPower = load.power.max() if load else 0.0
    obj.LargestChip = load.chip.max() if load else 0.0


def Create(name, base):
    """A new DressupDCM in the place of `base`, an operation or dressup of a job. Raises InputError naming
    Base."""
    if not _is_path(base):
        label = getattr(base, "Label", repr(base))
        raise InputError("Base", label, "choose an operation or a dressup of a job.")
    job = host.PathUtils.findParentJob(base)
    if job is None:
        raise InputError("Base", base.Label, "it belongs to no job: choose one that does.")
    if base not in job.Operations.Group:
        over = next((o.Label for o in base.InList if getattr(o, "Base", None) is base), job.Label)
        remedy = "%s has taken its place in the job: choose that." % over
        raise InputError("Base", base.Label, remedy)
    # FreeCAD knows a dressup by its name
    obj = base.Document.addObject("Path::FeaturePython", name if "Dressup" in name else "Dressup" + name)
    obj.Label = name
    obj.Proxy = DressupDCM(obj, base)
    job.Proxy.addOperation(obj, base, True)  # takes the base's place among the operations
    made_from.follow(obj, job)
    return hooks.announce(obj)


def _is_path(thing):
    kind = getattr(thing, "isDerivedFrom", lambda _: False)
    return kind("Path::Feature") and not kind("Path::FeatureCompoundPython")


def recompute(obj):
    """Recomputes a dressup and returns its dcm.Result. Raises InputError with the reason if there is none;
    FreeCAD itself would only mark the object."""
    before = obj.Proxy.model  # see execute
    obj.Proxy.forget_path(obj)
    obj.Proxy.model = before
    obj.touch()
    obj.Document.recompute()
    return made(obj)


def load_of(obj):
    """cutting_load.LoadAlong of the path of the last execute, whether it has limits or not, in the stock that
    the properties say. Raises InputError with the reason if there is no path, or naming Flutes or a property
    of the group Load."""
    result = made(obj)
    dcm_input.require_known_load(obj, obj.ToolController)
    return cutting_load.along(result.path, obj.Proxy.model.grid, cutting_load.resistance_of(obj))


def made(obj):
    """The dcm.Result of the last execute. Raises InputError with the reason if there is none."""
    if obj.Proxy.error is not None:
        raise obj.Proxy.error
    if obj.Proxy.result is None:
        raise not_computed(obj)
    return obj.Proxy.result
