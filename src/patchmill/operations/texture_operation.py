"""The texture operations' common base: properties, execution, and what macros call.

PlanarTexture, PyramidTexture and CurvedTexture are FreeCAD Path operations that differ in the surface of
their patches only (Matsuda 2008; Xu & Sasahara 2013, 2016).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, fields

import FreeCAD
import _patchmill as core
from _patchmill import InputError

from patchmill.freecad import host, kinds, made_from, tool_controller
from patchmill.geometry import shapes
from patchmill.operations import patch_comments
from patchmill.operations.base import BallEndOperation
from patchmill.operations.computed import planned, recompute  # noqa: F401  for macros
from patchmill.path.read_text import path_of
from patchmill.properties.property_table import field_of
from patchmill.properties.texture_properties import PROPERTIES
from patchmill.properties.texture_results import RESULTS, show_results
from patchmill.textures.masks import MaskInput, curve_loops
from patchmill.textures.plan import PlannedTexture, TextureInput, plan_texture
from patchmill.voxels import axis_field
from patchmill.system.stops import stoppable


@dataclass
class ReadyTexture:
    """A planned texture and the FreeCAD Path commands that are its text."""

    planned: PlannedTexture
    commands: list


@stoppable
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
        commands.extend(path_of(text[number]).Commands)
    if plan.input.patch_comments or plan.input.patch_stops:
        commands = patch_comments.numbered(plan, commands)
    return ReadyTexture(plan, commands if plan.posture else host.begin_upright(commands))


class ObjectTexture(BallEndOperation):
    """An operation's proxy. `planned` is the PlannedTexture of the last good execute, else None. `ready` is a
    ReadyTexture that was planned beforehand, in the background, or None; it is used if the input is still the
    same. Neither is saved. A subclass names its SURFACE, as _patchmill.PatchSurface does, and its
    OWN_PROPERTIES."""

    RESULT = "planned"
    KIND = kinds.TEXTURE
    SURFACE = ""
    CALIBRATING = False
    OWN_PROPERTIES: list = []
    OWN_RESULTS: list = []
    planned = ready = None  # noqa: F811
    face_texts = None  # a shapes.BrepTexts; not saved
    posture_field = None  # instead of PostureField: (positions, normals) -> (n, 3) axes; not saved

    @classmethod
    def properties(cls):
        return PROPERTIES + cls.OWN_PROPERTIES

    @classmethod
    def results(cls):
        return RESULTS + cls.OWN_RESULTS

    def _compute(self, obj):
        result = super()._compute(obj)
        if self.planned is not None and self.planned.posture is not None:
            obj.Path = host.without_last_rapid(obj.Path)
        return result

    def opExecute(self, obj):
        tool_controller.warn_of_unsaid_flutes(obj.ToolController)
        ready = self._ready_or_planned(self.texture_input(obj))
        self.planned = ready.planned
        self.commandlist.extend(ready.commands)
        show_results(obj, self.planned)

    def _ready_or_planned(self, given):
        ready, self.ready = self.ready, None
        return ready if ready and ready.planned.asked == given else prepare(given)

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
        tool = _tool(controller, obj)
        return TextureInput(
            breps=self._face_breps(obj),
            tool=tool,
            spindle=core.Spindle(speed / 60.0, tool_controller.sense(controller)),
            feed=controller.HorizFeed.Value,
            rapids=tool_controller.rapids(controller),
            heights_follow=_heights_follow(obj),
            surface=self.patch_surface(obj),
            origin=None if obj.AutoOrigin else tuple(obj.Origin),
            mask=_mask(obj),
            calibrating=self.CALIBRATING,
            posture_field=self.posture_field or axis_field.of(obj, tool.radius),
            **_values(obj, self.properties()),
        )

    def _face_breps(self, obj):
        """BREP texts of the faces, those of one object in one: they keep the edges that they share, which are
        no borders."""
        faces: dict = {}  # by object
        job = made_from.job_of(obj)
        for base, names in obj.Base:
            base = shapes.model_of(job, base)
            found = made_from.faces_of(base, names, "select faces, nothing else.")
            faces.setdefault(base.Name, []).extend(found)
        if not faces:
            raise InputError("Base", "nothing", "select at least one face of the job's model.")
        self.face_texts = self.face_texts or shapes.BrepTexts()
        return self.face_texts.of(faces.values())


def _values(obj, properties):
    """The fields of TextureInput that are a property's value, by the property's name in snake_case;
    lengths in mm, angles in degrees."""
    names = {field_of(name): name for _, name, _, _, _ in properties}
    names.update(safe_height="SafeHeight", clearance_height="ClearanceHeight")
    for name in ("origin", "posture_field"):
        names.pop(name)
    return {
        field.name: _plain(getattr(obj, names[field.name]))
        for field in fields(TextureInput)
        if field.name in names
    }


def _heights_follow(obj):
    """Whether the safe height is the setup sheet's expression, not a value or expression of the user's."""
    return any(name == "SafeHeight" and "SetupSheet" in text for name, text in obj.ExpressionEngine)


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
        loops=[] if obj.MaskImage else curve_loops(obj.MaskCurves, shapes.drawn),
        invert=obj.MaskInvert,
        width=obj.MaskWidth.Value,
        centre=tuple(obj.MaskCentre)[:2],
        threshold=obj.MaskThreshold,
        depth_at_black=obj.DepthAtBlack.Value,
        depth_at_white=obj.DepthAtWhite.Value,
    )


def _tool(controller, obj):
    tool_controller.require_ball_end(controller, "textures are milled with a ball end mill: choose one.")
    tool_controller.require_flutes(controller)
    return tool_controller.cutter(controller, obj)
