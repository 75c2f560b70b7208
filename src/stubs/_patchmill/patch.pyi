"""Patches, lattices, masks and sizes of textures.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import enum

class DimpleState(enum.IntEnum):
    """What became of a lattice point: CUT will be milled, all others are left out. OFF_FACE: no face there; TOO_STEEP: the face is steeper than the limit; TOOL_TIP: its normal is so near to the tool axis that the tip would rub; UNDERCUT: the face looks away; NEAR_EDGE: within the margin; SLIVER: its patch has too few; MASKED: by an image or a curve; NO_FACET: its planar patch would stand along the projection; OFF_NET: the lattice does not reach so far; CROWDED: too near to another. state_names() has them as phrases, in this order."""
    CUT = 0
    OFF_FACE = 1
    TOO_STEEP = 2
    TOOL_TIP = 3
    UNDERCUT = 4
    NEAR_EDGE = 5
    SLIVER = 6
    MASKED = 7
    NO_FACET = 8
    OFF_NET = 9
    CROWDED = 10

class Dimples:
    """All lattice points tried, in milling order."""
    def __len__(self) -> int:
        """How many lattice points were tried. Raises nothing."""
        ...
    def counts(self) -> dict[str, typing.Any]:
        """Number of dimples of each state, by name. Raises nothing."""
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
        """The DimpleState of each."""
        ...

class Mask:
    """Values from 0 to 1 over the texture plane."""
    def at(self, places: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """Values at (n, 2) places [mm]. Raises nothing."""
        ...
    def inverted(self) -> Mask:
        """The mask with 1 less each value. Raises nothing."""
        ...

class MeshSampler(ProjectedSurface):
    """Projects points of a texture plane on a mesh along its direction."""
    def __init__(self, surface: MeshSurface, plane: TexturePlane, steepest: float) -> None:
        """`steepest` [rad]: greatest angle of normal and -direction. Raises InputError naming SteepestSlope."""
        ...

class MeshSurface:
    """A mesh with smoothed normals and a tree over it, to be projected on."""
    def __init__(self, mesh: TriangleMesh, crease: float) -> None:
        """Normals are smoothed over edges whose triangles lie within `crease` [rad] of each other. Raises InputError naming Mesh or Crease."""
        ...
    @property
    def chord_height(self) -> float:
        """How far a smooth surface with these normals rises over the edges at most [mm]."""
        ...
    def keep_off_border(self, dimples: Dimples, margin: float) -> None:
        """Leaves out dimples nearer than `margin` [mm] to an edge that has one triangle only. Raises InputError naming Margin."""
        ...
    @property
    def normal_deviation(self) -> float:
        """Greatest angle between a triangle's own normal and a smoothed one [rad]."""
        ...
    def seen_best(self, preferred: numpy.typing.ArrayLike) -> tuple[numpy.typing.NDArray[numpy.float64], bool]:
        """The direction along which it looks largest, and whether it looks to all sides alike, so that `preferred` or an axis was chosen. Raises InputError naming Direction."""
        ...
    @property
    def triangle_count(self) -> int:
        ...

class PatchDivision:
    """Patches in milling order."""
    def __len__(self) -> int:
        """How many patches there are. Raises nothing."""
        ...
    @property
    def anchor(self) -> numpy.typing.NDArray[numpy.float64]:
        """Place of lattice point (0, 0) [mm]."""
        ...
    def lattice_outlines(self) -> list[typing.Any]:
        """Corners of each patch in lattice coordinates, (k, 2). Raises nothing."""
        ...
    def outlines(self) -> list[typing.Any]:
        """Corners of each patch in the texture plane [mm], (k, 2). Raises nothing."""
        ...
    @property
    def pattern(self) -> PatchPattern:
        ...
    def places(self, dimples: Dimples) -> numpy.typing.NDArray[numpy.float64]:
        """Texture-plane coordinates [mm] of each lattice point, (n, 2). Raises nothing."""
        ...

class PatchPattern:
    """Shape, spacing [mm], size and helix of patches."""
    def __init__(self, shape: str, spacing: float, size: int, order: str = 'Inward', start: str = 'Same corner', across: int = 0) -> None:
        """`across` [dimples] is the other side of shapes that have two; 0: as `size`. Raises InputError naming PatchShape, Spacing, PatchSide, HelixOrder or HelixStart."""
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
        """Whether kind, fit, factor and lift are the same. Raises nothing."""
        ...
    def __init__(self, kind: str, fit: str = 'Best fit', height_factor: float = 1.0, apex_lift: float = 0.0) -> None:
        """`kind`: Planar, Pyramid or Curved; `fit`: Best fit or Corners; `apex_lift` [mm]. Raises InputError naming SurfaceKind or PlaneFit. ProjectedSurface.place refuses its HeightFactor or ApexLift."""
        ...
    @property
    def planar(self) -> bool:
        """Whether patches are made of planes."""
        ...

class ProjectedSurface:
    """What places of a texture plane are projected on along its direction: see FaceSampler and MeshSampler."""
    def extent(self) -> tuple[typing.Any, ...]:
        """((x, y) least, (x, y) greatest) that it covers in the texture plane [mm]. Raises nothing."""
        ...
    def place(self, division: PatchDivision, plane: TexturePlane, surface: PatchSurface, lattice: typing.Optional[SurfaceLattice] = None, progress: object = None) -> typing.Any:
        """Dimples of the division on it, projected or on a lattice laid on it, or None if `progress` returned False. Raises InputError naming HeightFactor or ApexLift."""
        ...
    def sample(self, points: numpy.typing.ArrayLike) -> dict[str, typing.Any]:
        """Projects (n, 2) points; a dict of arrays positions, normals, states (a DimpleState each: CUT, OFF_FACE, TOO_STEEP or UNDERCUT). Raises nothing."""
        ...

class SurfaceLattice:
    """A lattice laid on the surface."""
    def counted_from(self, flat: numpy.typing.ArrayLike, pattern: PatchPattern) -> SurfaceLattice:
        """The same lattice with the point next to `flat` [mm] as (0, 0). Raises InputError naming Start."""
        ...
    def places(self, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """Places in the texture plane [mm] of (n, 2) lattice coordinates; NaN beyond its end. Raises nothing."""
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

class TriangleMesh:
    """Triangles over shared vertices, open or closed."""
    def __init__(self, vertices: numpy.typing.ArrayLike, triangles: numpy.typing.ArrayLike) -> None:
        """(n, 3) vertices [mm] and (m, 3) corners, indices of vertices, anticlockwise seen from outside; vertices of equal coordinates are made one. Raises InputError naming Mesh."""
        ...
    def __len__(self) -> int:
        """Number of triangles. Raises nothing."""
        ...
    def nearest(self, point: numpy.typing.ArrayLike) -> int:
        """Number of the triangle nearest to a point [mm]. Raises InputError naming Point."""
        ...
    def part(self, triangles: numpy.typing.ArrayLike) -> TriangleMesh:
        """The mesh of some of its triangles, by number. Raises InputError naming Triangles."""
        ...
    def region(self, seed: int, angle: float) -> list[int]:
        """Numbers of the triangles that are reached from triangle `seed` over edges whose two triangles have normals within `angle` [rad]. Raises InputError naming Seed or Angle."""
        ...
    @property
    def triangles(self) -> numpy.typing.NDArray[numpy.int32]:
        """Indices into vertices, (m, 3)."""
        ...
    @property
    def vertices(self) -> numpy.typing.NDArray[numpy.float64]:
        """[mm], (n, 3)."""
        ...

def cover(pattern: PatchPattern, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike) -> PatchDivision:
    """The patches that overlap the rectangle from `low` to `high` [mm]. Raises InputError naming Area or Spacing."""
    ...
def cover_lattice(pattern: PatchPattern, lattice: SurfaceLattice, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike) -> PatchDivision:
    """The patches with lattice points over the rectangle from `low` to `high` [mm]. Raises InputError naming Area."""
    ...
def curve_mask(loops: list[numpy.typing.ArrayLike]) -> Mask:
    """1 inside closed loops of (n, 2) points [mm], 0 outside and in loops within loops. Raises InputError naming Curves."""
    ...
def dimples_at(positions: numpy.typing.ArrayLike, normals: numpy.typing.ArrayLike, lattice: numpy.typing.ArrayLike, patches: list[int], states: list[int]) -> Dimples:
    """Dimples in milling order at (n, 3) positions [mm] with normals of any length out of the material, (n, 2) whole lattice coordinates, the number of each one's patch, from 0, and its DimpleState. Raises InputError naming positions, normals, lattice, patches or states."""
    ...
def drop_slivers(dimples: Dimples, least: int) -> None:
    """Leaves out the dimples of patches that have fewer than `least`. Raises InputError naming MinimumDimples."""
    ...
def flattest_row_direction(dimples: Dimples, pattern: PatchPattern) -> int:
    """Which of the lattice's steps bends least over the dimples that are to be cut. Raises nothing."""
    ...
def from_patch(dimples: Dimples, first: int) -> Dimples:
    """The dimples from patch `first` (1: all) in milling order on. Raises InputError naming FirstPatch."""
    ...
def image_mask(pixels: numpy.typing.ArrayLike, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike, outside: float = 0.0) -> Mask:
    """Grey rows from the top, 0 to 1, laid on the rectangle from `low` to `high` [mm]. Raises InputError naming Image, MaskImage, MaskOutside or MaskArea."""
    ...
def in_rows(dimples: Dimples, pattern: PatchPattern, direction: int, one_way: bool, whole_face: bool) -> Dimples:
    """The dimples in rows along one of the lattice's steps, those left out last. On the whole face the patches become rows. Raises InputError naming RowDirection."""
    ...
def keep_where(dimples: Dimples, division: PatchDivision, lattice: SurfaceLattice, mask: Mask, threshold: float = 0.5) -> None:
    """Leaves out dimples where the mask is below it. Raises InputError naming Threshold."""
    ...
def lay_lattice(pattern: PatchPattern, sampler: ProjectedSurface, plane: TexturePlane, start: numpy.typing.ArrayLike, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike, progress: object = None) -> typing.Optional[SurfaceLattice]:
    """The pattern's lattice on the surface over the rectangle from `low` to `high` [mm]: a Chebyshev net for squares, else of low distortion. None if `progress` returned False. Raises InputError naming Start, Area or Spacing."""
    ...
def least_patch_side(shape: str) -> int:
    """The smallest side that a patch may have. Raises InputError naming PatchShape."""
    ...
def milled_patches(dimples: Dimples) -> list[int]:
    """Numbers of the patches that have dimples to be cut, in milling order. Raises nothing."""
    ...
def nearest_row_direction(pattern: PatchPattern, direction: numpy.typing.ArrayLike) -> int:
    """Which of the lattice's steps goes nearest to a direction of the texture plane. Raises InputError naming Direction."""
    ...
def nearest_start(wanted: numpy.typing.ArrayLike, low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike, sampler: ProjectedSurface) -> numpy.typing.NDArray[numpy.float64]:
    """The place nearest to `wanted` that can be cut [mm]. Raises InputError naming Start or Area."""
    ...
def patch_block(pattern: PatchPattern, patches_x: int, patches_y: int) -> PatchDivision:
    """A block of patches centred on the texture plane's origin. Raises InputError naming PatchesX or PatchesY."""
    ...
def patch_shapes() -> list[str]:
    """The names of all patch shapes, in the order in which they are offered. Raises nothing."""
    ...
def row_directions(pattern: PatchPattern) -> int:
    """How many directions rows can have on the pattern's lattice. Raises nothing."""
    ...
def row_pitch(shape: str) -> float:
    """Distance of neighbouring rows of dimples over the spacing. Raises InputError naming PatchShape."""
    ...
def set_depth(dimples: Dimples, division: PatchDivision, lattice: SurfaceLattice, mask: Mask, depth_at_0: float, depth_at_1: float, least: float = 0.0) -> None:
    """Depth linear in the mask [mm]; dimples shallower than `least` are left out. Raises InputError naming Depth or MinimumDepth."""
    ...
def sink(dimples: Dimples, depth: float) -> None:
    """Puts the bottoms of all dimples `depth` [mm] below the surface. Raises InputError naming Depth."""
    ...
def spacing_spread(dimples: Dimples, pattern: PatchPattern) -> dict[str, typing.Any]:
    """Distances of neighbouring dimples over the spacing: least, greatest, rms of the change, and the least and greatest angle of the lattice [rad]. Raises nothing."""
    ...
def state_names() -> list[str]:
    """The DimpleStates as phrases, in their order. Raises nothing."""
    ...
def texture_plane(origin: numpy.typing.ArrayLike, direction: numpy.typing.ArrayLike, x_hint: numpy.typing.ArrayLike, rotation: float = 0.0) -> TexturePlane:
    """A plane at right angles to `direction`, turned by `rotation` [rad]. Raises InputError naming Origin, Direction or Rotation."""
    ...
def texture_size(kind: str, shape: str, ball_radius: float, spacing: typing.Optional[float] = None, depth: typing.Optional[float] = None, diameter: typing.Optional[float] = None, area_share: typing.Optional[float] = None, ridge_height: typing.Optional[float] = None, tilt: typing.Optional[float] = None) -> dict[str, typing.Any]:
    """All sizes of a texture from those that are given [mm, 0 to 1, rad]. Raises InputError naming TextureKind, PatchShape, BallRadius, Spacing, Depth, DimpleDiameter, AreaShare, RidgeHeight or Tilt."""
    ...
def thin_out(dimples: Dimples, division: PatchDivision, lattice: SurfaceLattice, mask: Mask) -> None:
    """Leaves the share of dimples that the mask says. Raises nothing."""
    ...
def two_sided(shape: str) -> bool:
    """Whether patches have a side across that may differ from the other. Raises InputError naming PatchShape."""
    ...
def up_to_patch(dimples: Dimples, last: int) -> Dimples:
    """The dimples up to the last one of patch `last` in milling order. Raises InputError naming LastPatch."""
    ...
