"""Patches, lattices, masks and sizes of textures.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import _patchmill.brep

class Dimples:
    """All lattice points tried, in milling order."""
    def __len__(self) -> int:
        ...
    def counts(self) -> dict[str, typing.Any]:
        """Number of dimples of each state, by name."""
        ...
    @property
    def depths(self) -> numpy.typing.NDArray[numpy.float64]:
        """How far below the face the bottoms lie [mm]."""
        ...
    @property
    def lattice(self) -> numpy.typing.NDArray[numpy.float64]:
        """Integer lattice coordinates in the first two columns, (n, 3)."""
        ...
    @property
    def normals(self) -> numpy.typing.NDArray[numpy.float64]:
        """Unit normals out of the material, (n, 3)."""
        ...
    @property
    def patches(self) -> numpy.typing.NDArray[numpy.int32]:
        ...
    @property
    def positions(self) -> numpy.typing.NDArray[numpy.float64]:
        """Places on the face [mm], (n, 3)."""
        ...
    @property
    def states(self) -> numpy.typing.NDArray[numpy.uint8]:
        """0 cut; other numbers index state_names()."""
        ...

class Mask:
    """Values from 0 to 1 over the texture plane."""
    def at(self, places: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """Values at (n, 2) places [mm]."""
        ...
    def inverted(self) -> Mask:
        ...

class PatchDivision:
    """Patches in milling order."""
    def __len__(self) -> int:
        ...
    @property
    def anchor(self) -> numpy.typing.NDArray[numpy.float64]:
        """Place of lattice point (0, 0) [mm]."""
        ...
    def lattice_outlines(self) -> list[typing.Any]:
        """Corners of each patch in lattice coordinates, (k, 2)."""
        ...
    def outlines(self) -> list[typing.Any]:
        """Corners of each patch in the texture plane [mm], (k, 2)."""
        ...
    @property
    def pattern(self) -> PatchPattern:
        ...
    def places(self, dimples: Dimples) -> numpy.typing.NDArray[numpy.float64]:
        """Texture-plane coordinates [mm] of each lattice point, (n, 2)."""
        ...

class PatchPattern:
    """Shape, spacing [mm], size and helix of patches."""
    def __init__(self, shape: str, spacing: float, size: int, order: str = 'Inward', start: str = 'Same corner', across: int = 0) -> None:
        """`across` [dimples] is the other side of shapes that have two; 0: as `size`."""
        ...
    @property
    def across(self) -> int:
        ...
    @property
    def cell_area(self) -> float:
        """Area of the plane that one lattice point stands for [mm²]."""
        ...
    @property
    def size(self) -> int:
        ...
    @property
    def spacing(self) -> float:
        ...

class PatchSurface:
    """Planar, pyramid or curved patches."""
    def __eq__(self, other: object) -> bool:
        ...
    def __init__(self, kind: str, fit: str = 'Best fit', height_factor: float = 1.0, apex_lift: float = 0.0) -> None:
        ...
    @property
    def planar(self) -> bool:
        """Whether patches are made of planes."""
        ...

class SurfaceLattice:
    """A lattice laid on the surface."""
    def counted_from(self, flat: numpy.typing.ArrayLike, pattern: PatchPattern) -> SurfaceLattice:
        """The same lattice with the point next to `flat` [mm] as (0, 0)."""
        ...
    def places(self, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """Places in the texture plane [mm] of (n, 2) lattice coordinates; NaN beyond its end."""
        ...

class TexturePlane:
    """Origin, axes and projection direction."""
    @property
    def direction(self) -> numpy.typing.NDArray[numpy.float64]:
        ...
    @property
    def origin(self) -> numpy.typing.NDArray[numpy.float64]:
        ...
    @property
    def x_axis(self) -> numpy.typing.NDArray[numpy.float64]:
        ...
    @property
    def y_axis(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

def cover(pattern: PatchPattern, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike) -> PatchDivision:
    """The patches that overlap the rectangle from `low` to `high` [mm]."""
    ...
def cover_lattice(pattern: PatchPattern, lattice: SurfaceLattice, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike) -> PatchDivision:
    """The patches with lattice points over the rectangle from `low` to `high` [mm]."""
    ...
def curve_mask(loops: list[numpy.typing.ArrayLike]) -> Mask:
    """1 inside closed loops of (n, 2) points [mm], 0 outside and in loops within loops."""
    ...
def drop_slivers(dimples: Dimples, least: int) -> None:
    """Leaves out the dimples of patches that have fewer than `least`."""
    ...
def flattest_row_direction(dimples: Dimples, pattern: PatchPattern) -> int:
    """Which of the lattice's steps bends least over the dimples that are to be cut."""
    ...
def from_patch(dimples: Dimples, first: int) -> Dimples:
    """The dimples from patch `first` (1: all) in milling order on. Raises InputError naming FirstPatch."""
    ...
def image_mask(pixels: numpy.typing.ArrayLike, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike, outside: float = 0.0) -> Mask:
    """Grey rows from the top, 0 to 1, laid on the rectangle from `low` to `high` [mm]."""
    ...
def in_rows(dimples: Dimples, pattern: PatchPattern, direction: int, one_way: bool, whole_face: bool) -> Dimples:
    """The dimples in rows along one of the lattice's steps, those left out last. On the whole face the patches become rows."""
    ...
def keep_where(dimples: Dimples, division: PatchDivision, lattice: SurfaceLattice, mask: Mask, threshold: float = 0.5) -> None:
    """Leaves out dimples where the mask is below it."""
    ...
def lay_lattice(pattern: PatchPattern, sampler: _patchmill.brep.FaceSampler, plane: TexturePlane, start: numpy.typing.ArrayLike, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike, progress: object = None) -> typing.Optional[SurfaceLattice]:
    """The pattern's lattice on the surface over the rectangle from `low` to `high` [mm]: a Chebyshev net for squares, else of low distortion. None if `progress` returned False."""
    ...
def least_patch_side(shape: str) -> int:
    """The smallest side that a patch may have."""
    ...
def milled_patches(dimples: Dimples) -> list[int]:
    """Numbers of the patches that have dimples to be cut, in milling order."""
    ...
def nearest_row_direction(pattern: PatchPattern, direction: numpy.typing.ArrayLike) -> int:
    """Which of the lattice's steps goes nearest to a direction of the texture plane."""
    ...
def nearest_start(wanted: numpy.typing.ArrayLike, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike, sampler: _patchmill.brep.FaceSampler) -> numpy.typing.NDArray[numpy.float64]:
    """The place nearest to `wanted` that can be cut [mm]."""
    ...
def patch_block(pattern: PatchPattern, patches_x: int, patches_y: int) -> PatchDivision:
    """A block of patches centred on the texture plane's origin."""
    ...
def patch_shapes() -> list[str]:
    """The names of all patch shapes, in the order in which they are offered."""
    ...
def row_directions(pattern: PatchPattern) -> int:
    """How many directions rows can have on the pattern's lattice."""
    ...
def row_pitch(shape: str) -> float:
    """Distance of neighbouring rows of dimples over the spacing."""
    ...
def set_depth(dimples: Dimples, division: PatchDivision, lattice: SurfaceLattice, mask: Mask, depth_at_0: float, depth_at_1: float, least: float = 0.0) -> None:
    """Depth linear in the mask [mm]; dimples shallower than `least` are left out."""
    ...
def sink(dimples: Dimples, depth: float) -> None:
    """Puts the bottoms of all dimples `depth` [mm] below the surface."""
    ...
def spacing_spread(dimples: Dimples, pattern: PatchPattern) -> dict[str, typing.Any]:
    """Distances of neighbouring dimples over the spacing: least, greatest, rms of the change, and the least and greatest angle of the lattice [rad]."""
    ...
def state_names() -> list[str]:
    ...
def texture_plane(origin: numpy.typing.ArrayLike, direction: numpy.typing.ArrayLike, x_hint: numpy.typing.ArrayLike, rotation: float = 0.0) -> TexturePlane:
    """A plane at right angles to `direction`, turned by `rotation` [rad]."""
    ...
def texture_size(kind: str, shape: str, ball_radius: float, spacing: typing.Optional[float] = None, depth: typing.Optional[float] = None, diameter: typing.Optional[float] = None, area_share: typing.Optional[float] = None, ridge_height: typing.Optional[float] = None, tilt: typing.Optional[float] = None) -> dict[str, typing.Any]:
    """All sizes of a texture from those that are given [mm, 0 to 1, rad]."""
    ...
def thin_out(dimples: Dimples, division: PatchDivision, lattice: SurfaceLattice, mask: Mask) -> None:
    """Leaves the share of dimples that the mask says."""
    ...
def two_sided(shape: str) -> bool:
    """Whether patches have a side across that may differ from the other."""
    ...
