"""Points and borders of faces.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import _patchmill.patch

class FaceSampler:
    """Projects points of a texture plane on trimmed faces along its direction."""
    def __init__(self, breps: list[str], plane: _patchmill.patch.TexturePlane, steepest: float) -> None:
        """Faces as BREP texts; `steepest` [rad]: greatest angle of normal and -direction."""
        ...
    def extent(self) -> tuple[typing.Any, ...]:
        """((x, y) least, (x, y) greatest) that the faces cover in the texture plane [mm]."""
        ...
    def place(self, division: _patchmill.patch.PatchDivision, plane: _patchmill.patch.TexturePlane, surface: _patchmill.patch.PatchSurface, lattice: typing.Optional[_patchmill.patch.SurfaceLattice] = None, progress: object = None) -> typing.Any:
        """Dimples of the division on the faces, projected or on a lattice laid on them, or None if `progress` returned False."""
        ...
    def sample(self, points: numpy.typing.ArrayLike) -> dict[str, typing.Any]:
        """Projects (n, 2) points; a dict of arrays positions, normals, states."""
        ...

def facing(breps: list[str]) -> numpy.typing.NDArray[numpy.float64]:
    """Unit vector to the side from which the faces look largest."""
    ...
def keep_off_borders(dimples: _patchmill.patch.Dimples, breps: list[str], margin: float) -> None:
    """Leaves out dimples nearer than `margin` [mm] to the border of the faces together."""
    ...
