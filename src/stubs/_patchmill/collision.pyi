"""Gouges and collisions of a tool along a path.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import _patchmill.patch
import _patchmill.path

class PartModel:
    """The part as closed meshes; known is False if it could not be."""
    def distances(self, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """Signed distances [mm] of (n, 3) points, positive outside. Raises InputError naming Part if the model is not known."""
        ...
    @property
    def known(self) -> bool:
        ...
    @property
    def reason(self) -> str:
        ...
    @property
    def triangles(self) -> int:
        ...

class Tessellation:
    """A shape as triangles."""
    @property
    def closed(self) -> bool:
        ...
    @property
    def reason(self) -> str:
        """Why it is no closed solid."""
        ...
    @property
    def triangles(self) -> numpy.typing.NDArray[numpy.int32]:
        """Indices into vertices, (m, 3)."""
        ...
    @property
    def vertices(self) -> numpy.typing.NDArray[numpy.float64]:
        """[mm], (n, 3)."""
        ...

def check_clearance(path: _patchmill.path.ToolPath, part: PartModel, tolerance: float, clearance: float, resolution: float, most_findings: int = 1000, first_move: int = 0, cutting: bool = True, progress: object = None) -> dict[str, typing.Any]:
    """Gouges and collisions of a path with its tool: outcome 'clear', 'violated' or 'unknown', and arrays. `cutting`: whether its end and flutes are looked at, too. Raises InputError naming Tolerance, Clearance or Resolution."""
    ...
def part_model(breps: list[str], deflection: float) -> PartModel:
    """Meshes the solids of shapes given as BREP texts. Raises InputError naming Model or Deflection."""
    ...
def part_model_of_mesh(mesh: _patchmill.patch.TriangleMesh) -> PartModel:
    """The part as a TriangleMesh; not known if that is not closed. Raises nothing."""
    ...
def tessellate(brep: str, deflection: float, angle: float = 0.35) -> Tessellation:
    """A shape, given as BREP text, as one mesh; `deflection` [mm], `angle` [rad]. Raises InputError naming Shape, Deflection or DeflectionAngle."""
    ...
