"""Dynamic contour milling and copy milling.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import _patchmill.path
import _patchmill.voxel

class CopyOptions:
    """What copy_mill needs beside the part. mm, s."""
    def __init__(self, mode: str, tool: _patchmill.path.Tool, spindle: _patchmill.path.Spindle, feed: float, radial_depth: float, axial_depth: float, tolerance: float, allowance: float, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike, clearance: float, overlap: float = 0.0) -> None:
        """`mode`: Scanning, Scanning with undercuts or Contour; `feed` [mm/s], lengths in mm; the stock is the box from `low` to `high`. Raises InputError naming Mode. copy_mill refuses the rest."""
        ...

class FeedField:
    """V_x, V_y, V_z over a VoxelGrid [mm/s]."""
    @property
    def high(self) -> float:
        ...
    @property
    def low(self) -> float:
        ...

class LiveSession:
    """Copy milling made while the tool cuts. mm, s."""
    def __init__(self, part: Solid, grid: VoxelGrid, options: CopyOptions, low: float, high: float, materials: typing.Optional[_patchmill.voxel.VoxelMaterials] = None, factors: list[float] = ...) -> None:
        """V_Lo and V_Hi in mm/s; `factors` on the feed, the stock's own first, as scale_feed's. Raises InputError naming lowest feed or highest feed."""
        ...
    def change(self, radial_depth: typing.Optional[float] = None, axial_depth: typing.Optional[float] = None, low: typing.Optional[float] = None, high: typing.Optional[float] = None) -> None:
        """From the next batch on; what is not given stays. The radial depth from the next line on. Raises InputError naming radial depth of cut, axial depth of cut, lowest feed or highest feed."""
        ...
    @property
    def conditions(self) -> dict[str, typing.Any]:
        ...
    @property
    def done(self) -> bool:
        ...
    @property
    def level(self) -> float:
        ...
    @property
    def line(self) -> float:
        ...
    def next(self, seconds: float) -> _patchmill.path.ToolPath:
        """ToolPath of the next moves, at most `seconds`; without moves when all is cut. Raises InputError naming batch time."""
        ...

class PostureField:
    """Tool axis over a VoxelGrid."""
    @property
    def cancelled(self) -> bool:
        ...
    @property
    def converged(self) -> bool:
        ...
    @property
    def history(self) -> list[float]:
        """Relative residual before the first iteration and after each."""
        ...
    @property
    def iterations(self) -> int:
        ...
    @property
    def residual(self) -> float:
        ...

class Solid:
    """A part or stock as triangles, with a tree over them. mm."""
    def __init__(self, vertices: numpy.typing.ArrayLike, triangles: numpy.typing.ArrayLike, property: str = 'mesh') -> None:
        """(n, 3) corners [mm] and (m, 3) indices; must be closed. Raises InputError naming `property`."""
        ...
    @property
    def bounds(self) -> tuple[typing.Any, ...]:
        ...
    @staticmethod
    def box(low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike) -> Solid:
        """The box between two corners [mm]. Raises InputError naming Box."""
        ...
    def signed_distances(self, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """Of (n, 3) points from the surface [mm], negative inside; the solid must be closed. Raises nothing."""
        ...
    @property
    def triangle_count(self) -> int:
        ...
    @property
    def triangles(self) -> numpy.typing.NDArray[numpy.int32]:
        ...
    @property
    def vertices(self) -> numpy.typing.NDArray[numpy.float64]:
        ...
    @property
    def volume(self) -> float:
        ...

class VoxelGrid:
    """The removal volume: stock less part, in cubes."""
    def arrows(self, posture: PostureField, stride: int = 2) -> tuple[typing.Any, ...]:
        """(places, unit axes), both (n, 3), of every stride-th voxel to be removed. Raises InputError naming PostureField or stride."""
        ...
    @property
    def cells(self) -> numpy.typing.NDArray[numpy.int32]:
        ...
    @property
    def counts(self) -> dict[str, typing.Any]:
        """Stored voxels by kind."""
        ...
    @property
    def memory(self) -> dict[str, typing.Any]:
        """Bytes of the model, its fields and the solver."""
        ...
    @property
    def origin(self) -> numpy.typing.NDArray[numpy.float64]:
        ...
    @property
    def pitch(self) -> float:
        ...
    def section(self, axis: int, place: float, feed: typing.Optional[FeedField] = None, direction: numpy.typing.ArrayLike = ..., posture: typing.Optional[PostureField] = None) -> dict[str, typing.Any]:
        """One layer at right angles to axis 0, 1 or 2: kind (rows, columns), a VoxelKind each, origin, pitch, and feed [mm/s] and unit axis (rows, columns, 3) of the fields given; NaN elsewhere. Raises InputError naming axis, place, FeedField, Direction or PostureField. `place` [mm]."""
        ...

def apply_dcm(path: _patchmill.path.ToolPath, grid: VoxelGrid, feed: FeedField, posture: PostureField, part: typing.Optional[Solid] = None, holder: list[list[list[float]]] = ..., clearance: float = 1.0, lowest: float = 1.5707963267948966, reading: str = 'Smooth', read_at: str = 'Ball centre', feed_tolerance: float = 0.1, axis_tolerance: float = 0.0043633231299858, axis_rate: float = ..., acceleration: float = ...) -> tuple[typing.Any, ...]:
    """(path, number of the given move of each move, places where no axis was clear). `holder`: frusta (from, to, radius from, radius to), heights above the ball centre [mm]. Raises InputError naming FeedField, PostureField, Reading, ReadAt, holder section, height of holder section, radius of holder section, holder clearance, lowest axis, feed tolerance, axis tolerance, axis rate or acceleration."""
    ...
def copy_mill(part: Solid, options: CopyOptions, progress: object = None) -> tuple[_patchmill.path.ToolPath, int]:
    """(ToolPath of a ball end mill over the part, layer by layer from the stock; how many lines cannot be reached from above and were left out). If progress(share) returns False: what was done so far. Raises InputError naming tool radius, feed, radial depth of cut, axial depth of cut, depth of cut, tolerance, allowance, stock, clearance or overlap."""
    ...
def diffuse_feed(grid: VoxelGrid, low: float, high: float, time: float, step: float, diffusivity: float, substep: bool = False, exterior: str = 'Held') -> tuple[FeedField, int]:
    """(FeedField after `time` [s], steps taken); steps beyond the limit are refused or divided. Raises InputError naming lower feed, upper feed, Exterior, diffusion time, time step, number of time steps or diffusion coefficient."""
    ...
def estimate_voxels(stock: Solid, part: Solid, pitch: float, posture_fields: int = 2, materials: bool = False) -> dict[str, typing.Any]:
    """Bytes foreseen, hardly any allocated. `posture_fields`: 2 angles, 3 components or 0; `materials`: whether there are other than the stock's own. Raises InputError naming voxel size or posture_fields."""
    ...
def holder_clearance(part: Solid, holder: list[list[list[float]]], path: _patchmill.path.ToolPath, clearance: float, step: float = 0.5) -> dict[str, typing.Any]:
    """Smallest distance of the holder from the part along the timed moves [mm], where, and how many moves come nearer than `clearance`. Raises InputError naming holder section, height of holder section, radius of holder section, holder clearance or step."""
    ...
def hurry_in_air(path: _patchmill.path.ToolPath, grid: VoxelGrid, feed: float) -> tuple[typing.Any, ...]:
    """(path with moves through emptied voxels at `feed` [mm/s], number of the given move of each). Raises InputError naming feed in air."""
    ...
def joined(paths: list[_patchmill.path.ToolPath]) -> _patchmill.path.ToolPath:
    """Paths one after the other, a rapid between; tool and spindle are the first one's. Raises InputError naming path."""
    ...
def limit_load(path: _patchmill.path.ToolPath, grid: VoxelGrid, specific: float = 2000.0, exponent: float = 0.25, normal: float = 0.3, chip: float = ..., force: float = ..., power: float = ..., acceleration: float = ...) -> tuple[typing.Any, ...]:
    """(path whose moves are divided and slowed down to keep the mean chip thickness [mm], the force [N] and the power [W], and the acceleration [mm/s^2] on the way, number of the given move of each). Raises InputError naming tool radius, spindle speed, flutes, SpecificForce, ForceExponent, NormalForce, ChipLimit, ForceLimit, PowerLimit, acceleration or base operation."""
    ...
def load_along(path: _patchmill.path.ToolPath, grid: VoxelGrid, specific: float = 2000.0, exponent: float = 0.25, normal: float = 0.3) -> dict[str, typing.Any]:
    """The cutting load every quarter of a voxel, arrays of one length: move, at (0 .. 1 on it), length [mm], feed [mm/s], section [mm^2], removal [mm^3/s], chip (mean thickness) [mm], force (largest in a turn) [N] and power [W]. `specific`: k_c1.1 [N/mm^2], `exponent`: m_c, `normal`: force normal to the surface over the cutting force. Raises InputError naming tool radius, spindle speed, flutes, SpecificForce, ForceExponent or NormalForce."""
    ...
def load_voxels(path: str, key: str) -> typing.Any:
    """(grid, posture or None, materials or None), or None if made of other input. Raises nothing."""
    ...
def over_faces(path: _patchmill.path.ToolPath, part: Solid, faces: Solid, options: CopyOptions, progress: object = None) -> _patchmill.path.ToolPath:
    """Of a path that copy_mill made of `part` with `options`, the cuts on which the ball works on `faces`; all else is left out. If progress(share) returns False: what was done so far. Raises nothing."""
    ...
def path_steps(path: _patchmill.path.ToolPath) -> dict[str, typing.Any]:
    """Largest changes from move to move: feed [mm/s], axis [rad], rate [rad/s]. Raises nothing."""
    ...
def save_voxels(path: str, key: str, grid: VoxelGrid, posture: typing.Optional[PostureField] = None, materials: typing.Optional[_patchmill.voxel.VoxelMaterials] = None) -> None:
    """Writes a model to the file `path`; `key` says what it was made from. Raises InputError naming voxel file, PostureField or Materials."""
    ...
def scallop_height(radius: float, cross_feed: float) -> float:
    """Ridge on a flat between passes [mm]; the radius where the ball does not reach between them. Raises InputError naming BallRadius or CrossFeed."""
    ...
def solid_of_brep(brep: str, deflection: float, property: str, closed: bool = True) -> Solid:
    """BREP text as a Solid; `deflection` [mm]. Raises InputError naming `property`, Deflection or property."""
    ...
def steady_feed(grid: VoxelGrid, low: float, high: float, exterior: str = 'Held') -> FeedField:
    """FeedField between V_Lo and V_Hi [mm/s]. Raises InputError naming lower feed, upper feed or Exterior."""
    ...
def steady_posture(grid: VoxelGrid, part: Solid, form: str = 'Angles', exterior: str = 'Held', limit: float = 1.2217304763960306, crease: float = 0.5235987755982988, progress: object = None) -> PostureField:
    """PostureField; `limit` and `crease` [rad]. Raises InputError naming PostureForm, Exterior, posture limit or crease."""
    ...
def voxelise(stock: Solid, part: Solid, pitch: float, memory_limit: float = 4294967296.0, posture_fields: int = 2, materials: bool = False) -> VoxelGrid:
    """VoxelGrid with cubes of side `pitch` [mm]. Raises InputError naming part, voxel size, posture_fields or removal volume."""
    ...
def with_plunge_feed(path: _patchmill.path.ToolPath, vertical: float) -> _patchmill.path.ToolPath:
    """The path with no timed move going down faster than `vertical` [mm/s]. Raises InputError naming VertFeed."""
    ...
