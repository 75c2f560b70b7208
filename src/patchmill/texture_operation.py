"""The texture operations' common base: properties, execution, and what macros call.

PlanarTexture, PyramidTexture and CurvedTexture are FreeCAD Path operations that differ in the surface of
their patches only (Matsuda 2008; Xu & Sasahara 2013, 2016).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

import FreeCAD
import _patchmill as core
from _patchmill import InputError

from patchmill import host, strategies
from patchmill.texture_plan import PlannedTexture, TextureInput, plan_texture
from patchmill.translate import QT_TRANSLATE_NOOP

# type, name, group, tip, default; a list as default is an enumeration, its first value the default
PROPERTIES = [
    ("App::PropertyLength", "Spacing", "Texture", "Distance of neighbouring dimples", 0.5),
    (
        "App::PropertyEnumeration",
        "PatchShape",
        "Texture",
        "Shape of the patches: squares on a square lattice, the others on a triangular one",
        ["Square", "Hexagon", "Triangle"],
    ),
    (
        "App::PropertyInteger",
        "PatchSide",
        "Texture",
        "Dimples along the side of a square or triangle; radius of a hexagon in dimples",
        14,
    ),
    ("App::PropertyInteger", "PatchesX", "Texture", "Patches along X; 0 covers the faces", 0),
    ("App::PropertyInteger", "PatchesY", "Texture", "Patches along Y; 0 covers the faces", 0),
    (
        "App::PropertyEnumeration",
        "HelixOrder",
        "Texture",
        "Mill each patch from its outline inwards, or from its centre outwards",
        ["Inward", "Outward"],
    ),
    (
        "App::PropertyEnumeration",
        "HelixStart",
        "Texture",
        "Begin all patches at the same corner, or at the corner nearest to the patch before",
        ["Same corner", "Nearest corner"],
    ),
    (
        "App::PropertyVector",
        "Direction",
        "Texture",
        "Direction in which the texture is projected on the faces",
        FreeCAD.Vector(0, 0, -1),
    ),
    ("App::PropertyAngle", "Rotation", "Texture", "Rotation of the texture", 0.0),
    ("App::PropertyBool", "AutoOrigin", "Texture", "Centre the texture on the faces", True),
    (
        "App::PropertyVector",
        "Origin",
        "Texture",
        "Centre of the texture, if not automatic",
        FreeCAD.Vector(0, 0, 0),
    ),
    (
        "App::PropertyAngle",
        "SteepestSlope",
        "Limits",
        "Dimples where the face is steeper than this to the projection are left out",
        80.0,
    ),
    (
        "App::PropertyAngle",
        "MinimumTilt",
        "Limits",
        "Dimples where the tool axis is nearer to the normal than this are left out: the tip rubs",
        1.0,
    ),
    (
        "App::PropertyLength",
        "Margin",
        "Limits",
        "Dimples nearer than this to the border of the faces are left out",
        0.0,
    ),
    (
        "App::PropertyInteger",
        "MinimumDimples",
        "Limits",
        "Patches with fewer dimples than this on the faces are left out",
        0,
    ),
    (
        "App::PropertyEnumeration",
        "Strategy",
        "Phase",
        "How the spindle's phase is kept",
        list(strategies.NAMES),
    ),
    ("App::PropertyString", "Machine", "Phase", "Name of the machine file; empty: unknown", ""),
    (
        "App::PropertyBool",
        "PostUnheld",
        "Phase",
        "Post even if the machine cannot hold the phase",
        False,
    ),
    ("App::PropertyLength", "Lift", "Phase", "Clearance of paced paths between rows", 0.1),
    ("App::PropertyBool", "SameFlute", "Phase", "One flute makes all dimples", True),
    ("App::PropertyFloat", "ExtraTurns", "Phase", "Spindle turns added between dimples", 5.0),
    ("App::PropertyAngle", "PhaseStep", "Phase", "Angle added per dimple, for calibration", 0.0),
    (
        "App::PropertyInteger",
        "Decimals",
        "Phase",
        "Decimals of the posted coordinates; must be the post's own",
        3,
    ),
    (
        "App::PropertyAngle",
        "PhaseTolerance",
        "Phase",
        "Greatest phase error of the posted program",
        1.0,
    ),
]
RESULTS = [
    ("App::PropertyInteger", "DimpleCount", "Result", "Dimples that are milled"),
    ("App::PropertyString", "LeftOut", "Result", "Lattice points left out, by reason"),
    ("App::PropertyFloat", "TurnsPerDimple", "Result", "Mean spindle turns from dimple to dimple"),
    ("App::PropertyString", "Verdict", "Result", "Whether the machine can hold the phase"),
    ("App::PropertyFloat", "MachiningTime", "Result", "Time of all moves but rapids, in seconds"),
]


@dataclass
class ReadyTexture:
    """A planned texture and the FreeCAD Path commands that are its text."""

    planned: PlannedTexture
    commands: list


COMMANDS_AT_ONCE = 10000  # FreeCAD holds Python's lock while it reads so many


def prepare(given, progress=None):
    """ReadyTexture of a TextureInput, without touching a document: for any thread. None if `progress`
    (share -> bool) returned False. Raises InputError naming the property that is wrong."""
    plan = plan_texture(given, progress and (lambda share: progress(0.8 * share)))
    if plan is None:
        return None
    lines = plan.pacing.text.splitlines()
    commands = []
    for first in range(0, len(lines), COMMANDS_AT_ONCE):
        if progress and not progress(0.8 + 0.2 * first / len(lines)):
            return None
        commands.extend(
            host.Path.Path("\n".join(lines[first : first + COMMANDS_AT_ONCE])).Commands
        )
    return ReadyTexture(plan, commands)


class ObjectTexture(host.PathOp.ObjectOp):
    """An operation's proxy. `planned` is the PlannedTexture of the last good execute, else None;
    `error` the InputError of the last execute, else None. `ready` is a ReadyTexture that was planned
    beforehand, in the background, or None; it is used if the input is still the same. None of them is
    saved. A subclass names its SURFACE, as _patchmill.PatchSurface does, and its OWN_PROPERTIES."""

    SURFACE = None
    CALIBRATING = False
    OWN_PROPERTIES = []
    planned = None
    error = None
    ready = None

    def opFeatures(self, obj):
        op = host.PathOp
        return op.FeatureTool | op.FeatureHeights | op.FeatureBaseFaces | op.FeatureCoolant

    def isToolSupported(self, obj, tool):
        """Ball end mills, if the job has one. A new operation, which has no controller yet, takes the first
        that fits: FreeCAD would ask with a dialog, and fail where there is no GUI."""
        tools = [c.Tool for c in host.tool_controllers(host.PathUtils.findParentJob(obj))]
        fitting = [t for t in tools if host.tool_kind(t) == "ballend"] or tools
        return tool in (fitting if obj.ToolController else fitting[:1])

    def initOperation(self, obj):
        self._add_properties(obj)

    def opOnDocumentRestored(self, obj):
        self._add_properties(obj)  # documents of older versions

    def opSetDefaultValues(self, obj, job):
        for _, name, _, _, default in PROPERTIES + self.OWN_PROPERTIES:
            setattr(obj, name, default[0] if isinstance(default, list) else default)

    def _add_properties(self, obj):
        for kind, name, group, tip, default in PROPERTIES + self.OWN_PROPERTIES:
            if not hasattr(obj, name):
                obj.addProperty(kind, name, group, QT_TRANSLATE_NOOP("App::Property", tip))
                setattr(obj, name, default)  # a list sets an enumeration's choices
        for kind, name, group, tip in RESULTS:
            if not hasattr(obj, name):
                obj.addProperty(kind, name, group, QT_TRANSLATE_NOOP("App::Property", tip))
            obj.setEditorMode(name, 1)

    def execute(self, obj):
        """As ObjectOp.execute, but an operation that fails leaves no old path to be posted."""
        self.planned = None
        self.error = None
        obj.Path = host.Path.Path()
        return super().execute(obj)

    def opExecute(self, obj):
        try:
            ready = self._ready_or_planned(self.texture_input(obj))
        except InputError as error:
            self.error = error
            self.planned = None
            raise
        self.planned = ready.planned
        self.commandlist.extend(ready.commands)
        self._show_results(obj)

    def _ready_or_planned(self, given):
        ready, self.ready = self.ready, None
        return ready if ready and ready.planned.input == given else prepare(given)

    def _show_results(self, obj):
        counts = self.planned.counts
        statistics = self.planned.path.statistics()
        obj.DimpleCount = counts["cut"]
        obj.LeftOut = ", ".join(
            "%s: %d" % (name, n) for name, n in counts.items() if n and name != "cut"
        )
        verdict = self.planned.pacing.verdict
        obj.Verdict = verdict.sentence if verdict else "Unknown: no machine is named."
        obj.TurnsPerDimple = statistics["cut_turns"] / max(1, counts["cut"])
        obj.MachiningTime = statistics["timed_seconds"]

    def refresh_heights(self, obj):
        """The heights as a recompute would leave them: before the first one FreeCAD's expressions for them
        have not been evaluated, and would refer to a stock at zero."""
        self.updateDepths(obj, ignoreErrors=True)
        for name, expression in obj.ExpressionEngine:
            if name in ("SafeHeight", "ClearanceHeight"):
                setattr(obj, name, obj.evalExpression(expression))

    def patch_surface(self, obj):
        """The _patchmill.PatchSurface of the operation's patches."""
        return core.PatchSurface(self.SURFACE)

    def texture_input(self, obj):
        """TextureInput of the document object. Raises InputError naming the property."""
        controller = obj.ToolController
        speed = controller.SpindleSpeed
        if not math.isfinite(speed) or speed <= 0.0 or speed != int(speed):
            raise InputError(
                "SpindleSpeed",
                "%g rpm" % speed,
                "give a whole number greater than zero: posts write S so.",
            )
        return TextureInput(
            breps=_face_breps(obj),
            tool=_tool(controller),
            spindle=core.Spindle(speed / 60.0, _sense(controller)),
            feed=controller.HorizFeed.Value,
            safe_height=obj.SafeHeight.Value,
            clearance_height=obj.ClearanceHeight.Value,
            surface=self.patch_surface(obj),
            spacing=obj.Spacing.Value,
            patch_shape=obj.PatchShape,
            patch_side=obj.PatchSide,
            patches_x=obj.PatchesX,
            patches_y=obj.PatchesY,
            helix_order=obj.HelixOrder,
            helix_start=obj.HelixStart,
            direction=tuple(obj.Direction),
            rotation=obj.Rotation.Value,
            origin=None if obj.AutoOrigin else tuple(obj.Origin),
            steepest_slope=obj.SteepestSlope.Value,
            minimum_tilt=obj.MinimumTilt.Value,
            margin=obj.Margin.Value,
            minimum_dimples=obj.MinimumDimples,
            same_flute=obj.SameFlute,
            extra_turns=obj.ExtraTurns,
            phase_step=obj.PhaseStep.Value,
            decimals=obj.Decimals,
            strategy=obj.Strategy,
            machine=obj.Machine,
            lift=obj.Lift.Value,
            calibrating=self.CALIBRATING,
        )


def _face_breps(obj):
    breps = []
    for base, names in obj.Base:
        for name in names:
            if not name.startswith("Face"):
                raise InputError("Base", name or base.Label, "select faces, nothing else.")
            breps.append(base.Shape.getElement(name).exportBrepToString())
    if not breps:
        raise InputError("Base", "nothing", "select at least one face of the job's model.")
    return breps


def _tool(controller):
    kind = host.tool_kind(controller.Tool)
    if kind != "ballend":
        raise InputError(
            "ToolController",
            "%s (%s)" % (controller.Label, kind or "unknown kind"),
            "textures are milled with a ball end mill: choose one.",
        )
    flutes = int(getattr(controller.Tool, "Flutes", 0))
    if flutes < 1:
        raise InputError("Flutes", flutes, "set the number of flutes of the tool bit.")
    return core.BallEndMill(float(controller.Tool.Diameter) / 2.0, flutes)


def _sense(controller):
    senses = {"Forward": "M3", "Reverse": "M4"}
    if controller.SpindleDir not in senses:
        raise InputError(
            "SpindleDirection", controller.SpindleDir, "the spindle must turn: Forward or Reverse."
        )
    return senses[controller.SpindleDir]


def setup_properties(proxy_class):
    """Names of the properties that a job's setup sheet may hold defaults for."""
    return [name for _, name, _, _, _ in PROPERTIES + proxy_class.OWN_PROPERTIES]


def create(proxy_class, name, obj, parentJob):
    """A new operation in the active document; `parentJob` is the Job it goes into."""
    if obj is None:
        obj = FreeCAD.ActiveDocument.addObject("Path::FeaturePython", name)
    obj.Proxy = proxy_class(obj, name, parentJob)
    return obj


def recompute(obj):
    """Recomputes one operation and returns its PlannedTexture. Raises InputError if it cannot be
    planned; FreeCAD itself would only mark the object."""
    obj.touch()
    obj.Document.recompute()
    return planned(obj)


def planned(obj):
    """The PlannedTexture of an operation, recomputing it if the document was just opened.
    Raises InputError with the reason if there is none."""
    proxy = obj.Proxy
    if proxy.planned is None and proxy.error is None:
        obj.touch()
        obj.Document.recompute()
    if proxy.error is not None:
        raise proxy.error
    if proxy.planned is None:
        raise InputError(
            obj.Label, "not computed", "FreeCAD refused it: check its job, base faces and tool."
        )
    return proxy.planned
