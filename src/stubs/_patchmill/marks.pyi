"""Marks that a moved cutter leaves, and how they lie.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import _patchmill.machine
import _patchmill.patch
import _patchmill.path
import _patchmill.sync

class TextureMarks:
    """The relief of a texture and the dimples found in it."""
    @property
    def complete(self) -> bool:
        ...
    @property
    def evaluations(self) -> int:
        ...
    @property
    def first(self) -> numpy.typing.NDArray[numpy.float64]:
        """Plane coordinates of cell [0, 0] [mm]."""
        ...
    @property
    def heights(self) -> numpy.typing.NDArray[numpy.float32]:
        """Deviation from the base along its normal [mm], (rows, columns); NaN: no base."""
        ...
    @property
    def passes(self) -> int:
        ...
    @property
    def step(self) -> float:
        ...
    @property
    def stock(self) -> float:
        ...
    def surface(self, base: object, reach: float, row: int, rows: int, column: int, columns: int, stride: int) -> tuple[typing.Any, ...]:
        """(points (r, c, 3) [mm], heights (r, c)) of a block, every `stride`-th cell. Raises InputError naming Base, Reach or Block."""
        ...

class ToolMotion:
    """Where the ball is at every spindle angle."""
    @property
    def runs(self) -> int:
        ...
    @property
    def standing_moves(self) -> int:
        ...
    @property
    def untimed_moves(self) -> int:
        ...

def best_start_phase(path: _patchmill.path.ToolPath, dimples: _patchmill.patch.Dimples, rule: _patchmill.sync.PhaseRule) -> float:
    """Azimuth of flute 0 at the start [rad] that takes the mean phase error away. Raises InputError naming SpindleTurns."""
    ...
def classify_alignment(places: numpy.typing.ArrayLike, feed: numpy.typing.ArrayLike, feed_per_tooth: float, cross_feed: float) -> dict[str, typing.Any]:
    """How marks line up along rows: state, shift, agreement. Raises InputError naming Places, FeedDirection, FeedPerTooth or CrossFeed."""
    ...
def compare_window(marks: TextureMarks, dimples: _patchmill.patch.Dimples, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike, spacing: float) -> dict[str, typing.Any]:
    """The dimples of a window and how they compare with the plan: arrays and figures. Raises InputError naming Window or Spacing."""
    ...
def dales(heights: numpy.typing.ArrayLike, step: numpy.typing.ArrayLike, least_depth: float) -> dict[str, typing.Any]:
    """Dales of (rows, columns) heights [mm] by watershed and Wolf pruning, arrays of one entry each: pits (row * columns + column), bottoms, depths [mm], areas, closed_areas [mm²], volumes [mm³], at_edge. Raises InputError naming Heights, GridStep or LeastDepth."""
    ...
def housing_x(machine: _patchmill.machine.Kinematics, joints: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    """Azimuth 0 of the spindle's housing in the work frame, (n, 3), for (n, 2) angles [rad]. Raises InputError naming Joints."""
    ...
def motion_of_path(path: _patchmill.path.ToolPath, dimples: _patchmill.patch.Dimples, rule: _patchmill.sync.PhaseRule, start_phase: typing.Optional[float] = None, housing: typing.Optional[numpy.typing.ArrayLike] = None) -> ToolMotion:
    """The motion of a path; `start_phase` [rad] of flute 0, or None: right at the first dimple of every run. `housing`: see housing_x; None for an upright tool. Raises InputError naming StartPhase or HousingAxis."""
    ...
def motion_of_samples(time: numpy.typing.ArrayLike, tips: numpy.typing.ArrayLike, spindle_angle: numpy.typing.ArrayLike, spindle: _patchmill.path.Spindle, radius: float, axes: typing.Optional[numpy.typing.ArrayLike] = None) -> ToolMotion:
    """The motion of a recording: [s], (n, 3) [mm], azimuth of flute 0 [rad] unwrapped. Raises InputError naming Samples, Time, Tip, SpindleAngle, BallRadius or Axis."""
    ...
def path_on_machine(path: _patchmill.path.ToolPath, model: _patchmill.machine.MotionModel) -> tuple[typing.Any, ...]:
    """(known, reason why not, the path with the turns that the motion model predicts). Raises nothing."""
    ...
def simulate_texture(motion: ToolMotion, tool: _patchmill.path.Tool, plane: _patchmill.patch.TexturePlane, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike, step: float, stock: float, base: object = None, reach: float = 1.0, helix: float = 0.0, runout: list[float] = ..., least_depth: float = 0.002, halo: float = 1.0, memory_limit: float = 4000000000.0, progress: object = None) -> TextureMarks:
    """The relief over `low` to `high` of the plane [mm] and its dimples; `base`: a ProjectedSurface, Dimples (the planes of patches), or None (the plane). Raises InputError naming Base, Reach, HelixAngle, Runout, LeastDepth, Halo, Memory, GridSize, GridStep or Stock."""
    ...
