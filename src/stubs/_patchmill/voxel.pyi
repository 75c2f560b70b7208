"""What voxels hold: materials, feeds, postures, kinds.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import _patchmill.dcm
import enum

NO_MATERIAL: int
STOCK_MATERIAL: int
class VoxelKind(enum.IntEnum):
    """What a voxel is: AIR, its centre is outside the stock; PART, inside the part, without product surface; REMOVAL, to be removed; SURFACE, with product surface in it; EXTERIOR, to be removed, and the skin of the stock."""
    AIR = 0
    PART = 1
    REMOVAL = 2
    SURFACE = 3
    EXTERIOR = 4

class VoxelMaterials:
    """The number of the material of each voxel."""
    @property
    def count(self) -> int:
        """Voxels stored."""
        ...

def axes_at(grid: _patchmill.dcm.VoxelGrid, posture: _patchmill.dcm.PostureField, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    """Unit axes at (n, 3) points [mm], interpolated; upright in air, zero inside the part. Raises InputError naming PostureField."""
    ...
def feed_at(grid: _patchmill.dcm.VoxelGrid, feed: _patchmill.dcm.FeedField, points: numpy.typing.ArrayLike, direction: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    """Feed [mm/s] in a direction at (n, 3) points [mm], interpolated; NaN inside the part. Raises InputError naming FeedField or Direction."""
    ...
def kinds_at(grid: _patchmill.dcm.VoxelGrid, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.uint8]:
    """The VoxelKind of the voxels that hold (n, 3) points [mm]. Raises nothing."""
    ...
def materials_at(grid: _patchmill.dcm.VoxelGrid, materials: VoxelMaterials, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.int32]:
    """Numbers of the materials of the voxels that hold (n, 3) points [mm]; NO_MATERIAL where there is nothing to remove. Raises InputError naming Materials."""
    ...
def materials_of(grid: _patchmill.dcm.VoxelGrid, bodies: list[tuple[_patchmill.dcm.Solid, float]]) -> VoxelMaterials:
    """VoxelMaterials: STOCK_MATERIAL, 0, the stock's own, else 1 + the number of the last of `bodies`, pairs of Solid and depth below its surface [mm], that holds the voxel's centre. Raises InputError naming Materials."""
    ...
def scale_feed(feed: _patchmill.dcm.FeedField, materials: VoxelMaterials, factors: list[float]) -> _patchmill.dcm.FeedField:
    """The FeedField times the factor of each voxel's material. Raises InputError naming Materials."""
    ...
