"""The texture operations' common base: properties, execution, and what macros call.

PlanarTexture, PyramidTexture and CurvedTexture are FreeCAD Path operations that differ in the surface of
their patches only (Matsuda 2008; Xu & Sasahara 2013, 2016).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import re
from dataclasses import dataclass, fields

import FreeCAD
import Part
import _patchmill as core
from _patchmill import InputError

from patchmill import axis_field, hooks, host, tool_controller
from patchmill.texture_mask import MaskInput, curve_loops
from patchmill.texture_plan import PlannedTexture, TextureInput, plan_texture
from patchmill.texture_properties import PROPERTIES, RESULTS, of_setup_sheet
from patchmill.texture_results import show_results
from patchmill.translate import QT_TRANSLATE_NOOP


@dataclass
class ReadyTexture:
    """A planned texture and the FreeCAD Path commands that are its text."""

    planned: PlannedTexture
    commands: list


def prepare(given, progress=None):
    """ReadyTexture of a TextureInput, without touching a document: for any thread. None if `progress`
    (share -> bool) returned False. Raises InputError naming the property that is wrong."""
    plan = plan_texture(given, progress and (lambda share: progress(0.8 * share)))
    if plan is None:
        return None
    text = plan.pacing.text
    commands = []
    for number in range(len(text)):  # FreeCAD holds Python's lock while it reads a part
        if progress and not progress(0.8 + 0.2 * number / len(text)):
            return None
        commands.extend(host.Path.Path(text[number]).Commands)
    return ReadyTexture(plan, commands if plan.posture else host.begin_upright(commands))


class ObjectTexture(host.PathOp.ObjectOp):
    """An operation's proxy. `planned` is the PlannedTexture of the last good execute, else None;
    `error` the InputError of the last execute, else None. `ready` is a ReadyTexture that was planned
    beforehand, in the background, or None; it is used if the input is still the same. None of them is
    saved. A subclass names its SURFACE, as _patchmill.PatchSurface does, and its OWN_PROPERTIES."""

    SURFACE = None
    CALIBRATING = False
    OWN_PROPERTIES = []
    OWN_RESULTS = []
    planned = None
    error = None
    ready = None
    posture_field = None  # instead of PostureField: (positions, normals) -> (n, 3) axes; not saved

    def opFeatures(self, obj):
        op = host.PathOp
        return op.FeatureTool | op.FeatureHeights | op.FeatureBaseFaces | op.FeatureCoolant

    def isToolSupported(self, obj, tool):
        return host.takes_ball_end(obj, tool)

    def initOperation(self, obj):
        self._add_properties(obj)

    def opOnDocumentRestored(self, obj):
        self._add_properties(obj)  # documents of older versions
        hooks.announce_restored(obj)

    def opSetDefaultValues(self, obj, job):
        for _, name, _, _, default in PROPERTIES + self.OWN_PROPERTIES:
            setattr(obj, name, default[0] if isinstance(default, list) and default else default)

    def _add_properties(self, obj):
        properties = PROPERTIES + self.OWN_PROPERTIES
        if not hasattr(obj, "TypeId"):  # FreeCAD asks what a setup sheet may hold
            properties = of_setup_sheet(properties)
        for kind, name, group, tip, default in properties:
            if not hasattr(obj, name):
                obj.addProperty(kind, name, group, QT_TRANSLATE_NOOP("App::Property", tip))
                setattr(obj, name, default)  # a list sets an enumeration's choices
        if not hasattr(obj, "TypeId"):
            return
        for kind, name, group, tip in RESULTS + self.OWN_RESULTS:
            if not hasattr(obj, name):
                obj.addProperty(kind, name, group, QT_TRANSLATE_NOOP("App::Property", tip))
            obj.setEditorMode(name, 1)

    def execute(self, obj):
        """As ObjectOp.execute, but an operation that fails leaves no old path to be posted."""
        self.planned = None
        self.error = None
        obj.Path = host.Path.Path()
        result = super().execute(obj)
        if self.planned is not None and self.planned.posture is not None:
            obj.Path = host.without_last_rapid(obj.Path)
        return result

    def opExecute(self, obj):
        try:
            ready = self._ready_or_planned(self.texture_input(obj))
        except InputError as error:
            self.error = error
            self.planned = None
            raise
        self.planned = ready.planned
        self.commandlist.extend(ready.commands)
        show_results(obj, self.planned)

    def _ready_or_planned(self, given):
        ready, self.ready = self.ready, None
        return ready if ready and ready.planned.asked == given else prepare(given)

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
        tool = _tool(controller)
        return TextureInput(
            breps=_face_breps(obj),
            tool=tool,
            spindle=core.Spindle(speed / 60.0, tool_controller.sense(controller)),
            feed=controller.HorizFeed.Value,
            surface=self.patch_surface(obj),
            origin=None if obj.AutoOrigin else tuple(obj.Origin),
            mask=_mask(obj),
            calibrating=self.CALIBRATING,
            posture_field=self.posture_field or axis_field.of(obj, tool.radius),
            **_values(obj, PROPERTIES + self.OWN_PROPERTIES),
        )


def _values(obj, properties):
    """The fields of TextureInput that are a property's value, by the property's name in snake_case;
    lengths in mm, angles in degrees."""
    names = {re.sub(r"(?<!^)([A-Z])", r"_\1", name).lower(): name for _, name, _, _, _ in properties}
    names.update(safe_height="SafeHeight", clearance_height="ClearanceHeight")
    for name in ("origin", "posture_field"):
        names.pop(name)
    return {
        field.name: _plain(getattr(obj, names[field.name]))
        for field in fields(TextureInput)
        if field.name in names
    }


def _plain(value):
    if isinstance(value, FreeCAD.Vector):
        return tuple(value)
    return getattr(value, "Value", value)


def _mask(obj):
    """MaskInput of the operation, or None."""
    if obj.MaskUse == "None":
        return None
    return MaskInput(
        use=obj.MaskUse,
        image=obj.MaskImage,
        loops=[] if obj.MaskImage else curve_loops(obj.MaskCurves),
        invert=obj.MaskInvert,
        width=obj.MaskWidth.Value,
        centre=tuple(obj.MaskCentre)[:2],
        threshold=obj.MaskThreshold,
        depth_at_black=obj.DepthAtBlack.Value,
        depth_at_white=obj.DepthAtWhite.Value,
    )


def _face_breps(obj):
    faces = {}  # by object: faces in one text keep the edges that they share, which are no borders
    for base, names in obj.Base:
        for name in names:
            if not name.startswith("Face"):
                raise InputError("Base", name or base.Label, "select faces, nothing else.")
            faces.setdefault(base.Name, []).append(base.Shape.getElement(name))
    if not faces:
        raise InputError("Base", "nothing", "select at least one face of the job's model.")
    return [Part.Compound(found).exportBrepToString() for found in faces.values()]


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


def property_table(obj):
    """The operation's properties that a user sets, as (type, name, group, tip, default)."""
    return PROPERTIES + obj.Proxy.OWN_PROPERTIES


def setup_properties(proxy_class):
    """Names of the properties that a job's setup sheet may hold defaults for."""
    return [row[1] for row in of_setup_sheet(PROPERTIES + proxy_class.OWN_PROPERTIES)]


def create(proxy_class, name, obj, parentJob):
    """A new operation in the active document; `parentJob` is the Job it goes into."""
    if obj is None:
        obj = FreeCAD.ActiveDocument.addObject("Path::FeaturePython", name)
    obj.Proxy = proxy_class(obj, name, parentJob)
    return hooks.announce(obj)


def recompute(obj):
    """Recomputes one operation and returns its PlannedTexture. Raises InputError if it cannot be
    planned; FreeCAD itself would only mark the object."""
    obj.Proxy.planned = obj.Proxy.error = None
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
        raise _refused_by_freecad(obj)
    return proxy.planned


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
