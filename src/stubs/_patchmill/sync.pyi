"""Phases of the spindle, free forms, postures of the tool.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import _patchmill.machine
import _patchmill.patch
import _patchmill.path

class FreePatch:
    """Matsuda's free form: side, cross-feed, f_z [mm]."""
    def __init__(self, shape: str, side: float, cross_feed: float, feed_per_tooth: float) -> None:
        """Lengths in mm. Raises InputError naming PatchShape, PatchSide, CrossFeed or FeedPerTooth."""
        ...
    @property
    def cross_feed(self) -> float:
        ...
    def drift_per_lap(self) -> float:
        """By how much marks shift from lap to lap [teeth]. Raises nothing."""
        ...
    @property
    def feed_per_tooth(self) -> float:
        ...
    @property
    def side(self) -> float:
        ...
    def size(self, ball_radius: float) -> dict[str, typing.Any]:
        """As texture_size(). Raises InputError naming BallRadius or Spacing."""
        ...
    def stands(self) -> _patchmill.patch.PatchPattern:
        """The lattice that patches stand on, as a PatchPattern. Raises nothing."""
        ...
    def state(self) -> str:
        """The array that its marks make, in one sentence. Raises nothing."""
        ...

class FreeTexture:
    """Patches in free form, each in its plane."""
    def __len__(self) -> int:
        """How many patches there are. Raises nothing."""
        ...
    @property
    def marks_per_patch(self) -> int:
        ...
    def outlines(self) -> list[typing.Any]:
        """Corners of each patch in space [mm], (k, 3); NaN if off the faces. Raises nothing."""
        ...
    @property
    def patch(self) -> FreePatch:
        ...

class MarkWish:
    """What the user wants of Matsuda's free form."""
    def __init__(self, tool: _patchmill.path.Tool, spindle_speed: float, shape: str, side: float, array: str = 'Square', feed_per_tooth: typing.Optional[float] = None, ridge_height: typing.Optional[float] = None, cross_feed: typing.Optional[float] = None) -> None:
        """Lengths in mm, speed in revolutions per second. Raises InputError naming PatchShape or MarkArray. state() and advise() refuse the rest."""
        ...
    def state(self) -> str:
        """The array that the wish itself gives, in one sentence. Raises InputError naming Lattice, SpindleSpeed, PatchSide, CrossFeed, FeedPerTooth or RidgeHeight."""
        ...

class PhaseRule:
    """Flute choice, extra turns and step per dimple [rad]."""
    def __init__(self, same_flute: bool = False, extra_turns: float = 0.0, step: float = 0.0) -> None:
        """`extra_turns` between dimples, `step` [rad] per dimple. Raises nothing: constant_feed_path refuses ExtraTurns and PhaseStep."""
        ...
    @property
    def extra_turns(self) -> float:
        ...

class Postures:
    """How the rotary axes stand at each dimple."""
    @property
    def axes(self) -> numpy.typing.NDArray[numpy.float64]:
        ...
    @property
    def azimuths(self) -> numpy.typing.NDArray[numpy.float64]:
        ...
    @property
    def joints(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

def advise(wish: MarkWish) -> list[typing.Any]:
    """Aligned patches next to the wish, the one that changes least first: a list of dicts. Raises InputError naming Lattice, SpindleSpeed, PatchSide, CrossFeed, FeedPerTooth or RidgeHeight."""
    ...
def axes_by_row(dimples: _patchmill.patch.Dimples, axes: numpy.typing.ArrayLike, tolerance: float) -> numpy.typing.NDArray[numpy.float64]:
    """Axes that stay the same along each row, as spindle-locked paths need them. Raises InputError naming ToolAxis, axes or RowTolerance."""
    ...
def constant_feed_path(dimples: _patchmill.patch.Dimples, tool: _patchmill.path.Tool, spindle: _patchmill.path.Spindle, feed: float, rule: PhaseRule, safe_height: float, clearance_height: float, decimals: int) -> _patchmill.path.ToolPath:
    """The constant-feed path of Xu & Sasahara 2016; `feed` [mm/s], heights [mm]. Raises InputError naming Feed, ExtraTurns, PhaseStep, SafeHeight, ClearanceHeight or Decimals."""
    ...
def free_form_path(texture: FreeTexture, dimples: _patchmill.patch.Dimples, tool: _patchmill.path.Tool, spindle: _patchmill.path.Spindle, feed: float, safe_height: float, clearance_height: float, decimals: int) -> _patchmill.path.ToolPath:
    """Straight on along the helix; `feed` [mm/s]. Raises InputError naming Dimples, Feed, FeedPerTooth, SafeHeight, ClearanceHeight or Decimals."""
    ...
def free_form_phases(path: _patchmill.path.ToolPath, texture: FreeTexture, dimples: _patchmill.patch.Dimples, patch: int) -> dict[str, typing.Any]:
    """Phase differences [teeth] of neighbouring passes of one patch: measured on the path, and predicted. Raises InputError naming Dimples or Patch."""
    ...
def freecad_rotary_text(told: _patchmill.machine.PosturePath, letters: str, model: _patchmill.machine.MotionModel, decimals: int, before: str = '', after: str = '', as_set: bool = False) -> _patchmill.machine.PathText:
    """A programmed path with its rotary words as text for Path.Path(text). Raises InputError naming letters or Decimals."""
    ...
def mark_tool_tip(dimples: _patchmill.patch.Dimples, axis: numpy.typing.ArrayLike, least_tilt: float) -> None:
    """Leaves out dimples whose normal is nearer to the tool axis than `least_tilt` [rad]. Raises InputError naming ToolAxis or MinimumTilt."""
    ...
def mark_tool_tip_along(dimples: _patchmill.patch.Dimples, axes: numpy.typing.ArrayLike, least_tilt: float) -> None:
    """As mark_tool_tip with an axis for each dimple. Raises InputError naming ToolAxis, axes or MinimumTilt."""
    ...
def phase_errors(path: _patchmill.path.ToolPath, dimples: _patchmill.patch.Dimples, rule: PhaseRule) -> dict[str, typing.Any]:
    """Spindle angle against contact azimuth at each dimple of the path: arrays and a summary. Raises nothing."""
    ...
def place_free(patch: FreePatch, outward: bool, stands: _patchmill.patch.PatchDivision, lattice: _patchmill.patch.SurfaceLattice, plane: _patchmill.patch.TexturePlane, sampler: _patchmill.patch.ProjectedSurface, corners_fit: bool, progress: object = None) -> typing.Any:
    """(FreeTexture, Dimples), or None if `progress` returned False. Raises nothing."""
    ...
def plan_postures(machine: _patchmill.machine.Kinematics, dimples: _patchmill.patch.Dimples, axes: numpy.typing.ArrayLike, decimals: int) -> Postures:
    """Postures for the dimples to be cut. Raises InputError naming ToolAxis, axes or Decimals."""
    ...
def posted_feed(feed: float, decimals: int) -> float:
    """The feed [mm/s] as it is posted in mm/min. Raises InputError naming Feed or Decimals."""
    ...
def section_in_work(section: _patchmill.machine.ProgramSection, machine: _patchmill.machine.Kinematics, form: _patchmill.machine.ProgramForm) -> _patchmill.path.ToolPath:
    """Tool tips in the work frame of a section that was read with its rotary words. Raises InputError naming Section."""
    ...
def tilts(dimples: _patchmill.patch.Dimples, axis: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    """Angle of each dimple's normal to the axis [rad]. Raises InputError naming axis."""
    ...
def tool_axes(dimples: _patchmill.patch.Dimples, mode: str, axis: numpy.typing.ArrayLike = ..., lead: float = 0.0, tilt: float = 0.0, least_lead: float = 0.0, towards: numpy.typing.ArrayLike = ..., field: object = None, smoothing: float = 0.0, widest: float = 3.141592653589793) -> numpy.typing.NDArray[numpy.float64]:
    """One unit tool axis for each dimple, (n, 3); `field`: (n, 3) for mode 'Field'. Raises InputError naming ToolAxisMode, FixedAxis, Lead, Tilt, MinimumLead, LeanTowards, PostureField, AxisSmoothing or WidestTilt. Angles in rad."""
    ...
def turning_seconds(machine: _patchmill.machine.Kinematics, dimples: _patchmill.patch.Dimples, postures: Postures, tool: _patchmill.path.Tool, model: _patchmill.machine.MotionModel, form: _patchmill.machine.ProgramForm) -> list[float]:
    """Seconds that the rotary axes take from each dimple to the next. Raises InputError naming Postures."""
    ...
def with_azimuths(rule: PhaseRule, postures: Postures) -> PhaseRule:
    """A phase rule that counts the azimuths which the rotary axes make. Raises nothing."""
    ...
def with_postures(vertical: _patchmill.path.ToolPath, postures: Postures, machine: _patchmill.machine.Kinematics, decimals: int) -> _patchmill.machine.PosturePath:
    """A planned path with its tool axes and angles; the ball centre keeps its way. Raises InputError naming Decimals."""
    ...
