"""Points and borders of faces.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import _patchmill.patch

class FaceSampler(_patchmill.patch.ProjectedSurface):
    """Projects points of a texture plane on trimmed faces along its direction."""
    def __init__(self, breps: list[str], plane: _patchmill.patch.TexturePlane, steepest: float) -> None:
        """Faces as BREP texts; `steepest` [rad]: greatest angle of normal and -direction. Raises InputError naming Base or SteepestSlope."""
        ...

class LaidOnFaces:
    """A lattice laid on faces by their own parameters."""
    @property
    def area(self) -> float:
        """Of the faces, inside their trimming [mm²]."""
        ...
    def cover(self) -> _patchmill.patch.PatchDivision:
        """The patches that have lattice points. Raises nothing."""
        ...
    @property
    def crowded(self) -> int:
        """Lattice points too near to others where parts meet."""
        ...
    @property
    def lattice(self) -> _patchmill.patch.SurfaceLattice:
        """The SurfaceLattice."""
        ...
    @property
    def pieces(self) -> int:
        """Parts of the faces that were rolled out, each for itself."""
        ...
    @property
    def rounds(self) -> list[tuple[int, float]]:
        """Of each closed face that comes back to itself: dimples round it, and their distance [mm]."""
        ...

def facing(breps: list[str]) -> numpy.typing.NDArray[numpy.float64]:
    """Unit vector to the side from which the faces look largest. Raises InputError naming AutoDirection or Base."""
    ...
def keep_apart(dimples: _patchmill.patch.Dimples, least: float) -> int:
    """Leaves out dimples nearer than `least` [mm] to one before them; returns how many. Raises InputError naming LeastDistance."""
    ...
def keep_off_borders(dimples: _patchmill.patch.Dimples, breps: list[str], margin: float) -> None:
    """Leaves out dimples nearer than `margin` [mm] to the border of the faces together. Raises InputError naming Base or Margin."""
    ...
def lay_on_faces(pattern: _patchmill.patch.PatchPattern, breps: list[str], plane: _patchmill.patch.TexturePlane, sampler: FaceSampler, steepest: float, rotation: float = 0.0, start: typing.Optional[numpy.typing.ArrayLike] = None, progress: object = None) -> typing.Optional[LaidOnFaces]:
    """The pattern's lattice on the faces, turned by `rotation` [rad] against their own lines, from the point `start` [mm] or the middle of the largest part. None if `progress` returned False. Raises InputError naming Origin, Base, Spacing, SteepestSlope or Rotation."""
    ...
def nearest_distances(dimples: _patchmill.patch.Dimples) -> numpy.typing.NDArray[numpy.float64]:
    """Distance of each cut dimple to the nearest other one, in space [mm]. Raises nothing."""
    ...
def seen_best(breps: list[str], preferred: numpy.typing.ArrayLike) -> dict[str, typing.Any]:
    """The direction along which the faces look largest, and whether they look to all sides alike, so that `preferred` or an axis was chosen: a dict of direction and even. Raises InputError naming Base or Direction."""
    ...
