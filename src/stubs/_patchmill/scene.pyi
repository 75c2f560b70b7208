"""What displays show.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import _patchmill.patch
import _patchmill.path

class Display:
    """Something to show, in chunks; made in any thread."""
    def __len__(self) -> int:
        """How many chunks there are. Raises nothing."""
        ...
    def chunk(self, number: int) -> bytes:
        """A chunk as the bytes of an Open Inventor file, for coin.SoDB.readAll. Raises InputError naming number."""
        ...

def arrow_display(places: numpy.typing.ArrayLike, vectors: numpy.typing.ArrayLike, scale: float, values: list[float], low: float, high: float) -> Display:
    """Arrows of length `scale` times the (n, 3) vectors. Raises InputError naming vectors, scale, values, low or high."""
    ...
def dimple_display(dimples: _patchmill.patch.Dimples, radius: float) -> Display:
    """Discs of `radius` [mm] on the surface, coloured by state. Raises InputError naming radius."""
    ...
def grid_display(points: numpy.typing.ArrayLike, values: numpy.typing.ArrayLike, low: float, high: float) -> Display:
    """A surface of (rows, columns, 3) points [mm], coloured by (rows, columns) values. Raises InputError naming points, values, low or high."""
    ...
def order_display(dimples: _patchmill.patch.Dimples, spacing: float) -> Display:
    """The order in which dimples are milled, with arrowheads. Raises InputError naming spacing."""
    ...
def outline_display(outlines: list[numpy.typing.ArrayLike]) -> Display:
    """Polylines, each (k, 3) [mm]; rows of NaN interrupt them. Raises nothing."""
    ...
def path_axis_display(path: _patchmill.path.ToolPath, length: float, most: int = 2000) -> Display:
    """Tool axes at ends of moves, at most `most` of them. Raises InputError naming length."""
    ...
def path_display(path: _patchmill.path.ToolPath) -> Display:
    """The tool tip's way, coloured by kind of move. Raises nothing."""
    ...
def scale_colour(share: float) -> tuple[typing.Any, ...]:
    """Red, green, blue (0 to 255) of the colour scale at a share of 0 to 1. Raises nothing."""
    ...
def slice_display(centres: numpy.typing.ArrayLike, values: list[float], side: float, axis: int, low: float, high: float) -> Display:
    """Squares of `side` [mm] at right angles to axis 0, 1 or 2. Raises InputError naming values, side, axis, low or high."""
    ...
def state_colours() -> dict[str, typing.Any]:
    """Red, green, blue (0 to 255) in which dimple_display draws each state, by name. Raises nothing."""
    ...
