"""Tools, spindles and tool paths.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import enum

BallEndMill = Tool

class MoveKind(enum.IntEnum):
    """What a move is for: RAPID, G0, its time is the machine's affair; LINK, timed and clear of the part; CUT, timed and near or in the part."""
    RAPID = 0
    LINK = 1
    CUT = 2

NO_DIMPLE: int
class Spindle:
    """Speed [revolutions per second], > 0, and sense, 'M3' or 'M4'."""
    def __eq__(self, other: object) -> bool:
        """Whether speed and sense are the same. Raises nothing."""
        ...
    def __init__(self, speed: float, sense: str) -> None:
        """Speed [revolutions per second] and sense. Raises InputError naming SpindleSpeed or SpindleDirection."""
        ...
    @property
    def sense(self) -> str:
        ...
    @property
    def sign(self) -> float:
        ...
    @property
    def speed(self) -> float:
        ...

class Tool:
    """A cutter: radius [mm], > 0; flutes, 1 to 32; radius of its corner [mm], 0 (flat) to the radius (a ball, as without one); angle between flank and axis [rad]. Above its end, 0 where it is not known [mm]: the height to which its edges go, the radius of its shank, how far it stands out of its holder; the holder as (from, to, radius_from, radius_to), heights above the tip. Raises InputError naming BallRadius, Flutes, CornerRadius, TaperAngle, CuttingLength, ShankRadius, StickOut or ToolSection."""
    def __eq__(self, other: object) -> bool:
        """Whether all its lengths are the same. Raises nothing."""
        ...
    def __init__(self, radius: float, flutes: int, corner_radius: typing.Optional[float] = None, taper: float = 0.0, cutting_length: float = 0.0, shank_radius: float = 0.0, stick_out: float = 0.0, holder: list[tuple[float, float, float, float]] = ...) -> None:
        """Lengths in mm, `taper` [rad]. Raises InputError naming BallRadius, Flutes, CornerRadius, TaperAngle, CuttingLength, ShankRadius, StickOut or ToolSection."""
        ...
    @property
    def corner_radius(self) -> float:
        """[mm]; so far is the tool's centre above its tip."""
        ...
    @property
    def cutting_length(self) -> float:
        ...
    @property
    def flutes(self) -> int:
        ...
    @property
    def is_ball(self) -> bool:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def radius(self) -> float:
        ...
    def scallop_height(self, cross_feed: float) -> float:
        """Ridge that it leaves on a flat between passes [mm]. Raises InputError naming CrossFeed."""
        ...
    @property
    def sections(self) -> list[tuple[str, float, float, float, float]]:
        """What is above its end, as (part, from, to, radius_from, radius_to), heights above the tip [mm]; part: 'flute', 'shank' or 'holder'."""
        ...
    @property
    def shank_radius(self) -> float:
        ...
    @property
    def stick_out(self) -> float:
        ...
    @property
    def taper(self) -> float:
        ...

class ToolPath:
    """An ordered list of timed moves of the tool tip."""
    def __len__(self) -> int:
        """How many moves it has. Raises nothing."""
        ...
    @property
    def axes(self) -> numpy.typing.NDArray[numpy.float64]:
        """Unit tool axis at the end of each move, (n, 3)."""
        ...
    @property
    def dimples(self) -> numpy.typing.NDArray[numpy.int32]:
        """Number of the dimple on which each move ends, or NO_DIMPLE."""
        ...
    @property
    def kinds(self) -> numpy.typing.NDArray[numpy.uint8]:
        """The MoveKind of each move."""
        ...
    @property
    def spindle(self) -> Spindle:
        ...
    @property
    def start(self) -> numpy.typing.NDArray[numpy.float64]:
        ...
    def statistics(self) -> dict[str, typing.Any]:
        """Lengths [mm], seconds, turns and counts. Raises nothing."""
        ...
    @property
    def tips(self) -> numpy.typing.NDArray[numpy.float64]:
        """End of each move [mm], (n, 3)."""
        ...
    @property
    def tool(self) -> Tool:
        ...
    @property
    def turns(self) -> numpy.typing.NDArray[numpy.float64]:
        """Planned spindle turns of each move; NaN where unknown."""
        ...

def make_path(tool: Tool, spindle: Spindle, start: numpy.typing.ArrayLike, tips: numpy.typing.ArrayLike, axes: typing.Optional[numpy.typing.ArrayLike], kinds: list[int], turns: list[float]) -> ToolPath:
    """ToolPath from arrays as ToolPath gives them: tips [mm], axes of any length or None for an upright tool, a MoveKind for each, spindle turns or NaN. Raises InputError naming path, axes, kind or turns."""
    ...
def with_dimples(path: ToolPath, dimples: list[int]) -> ToolPath:
    """The path with the number of the dimple on which each move ends, or NO_DIMPLE. Raises InputError naming dimples."""
    ...
def with_pacing_of(path: ToolPath, other: ToolPath) -> ToolPath:
    """The path with the pace of moves and the tolerances of corners of another one with as many timed moves. Raises InputError naming other."""
    ...
def with_turns(path: ToolPath, turns: list[float]) -> ToolPath:
    """The path with other turns of the spindle on each move that is no rapid, of which NaN may be given. Raises InputError naming turns."""
    ...
