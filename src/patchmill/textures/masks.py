"""Masks of a texture: a picture, or the inside of closed curves, over the texture plane.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import warnings
from dataclasses import dataclass, field

import _patchmill as core
import numpy as np
from _patchmill import InputError

LEAVE_OUT, DENSITY, DEPTH = USES = ("Leave out", "Density", "Depth")
CURVE_DEFLECTION = 0.01  # mm
MOST_PIXELS = 10000000  # of a picture
BYTES_PER_PIXEL = 120  # while it is read


@dataclass
class MaskInput:
    """What a mask is made from. Lengths in mm; loops are points in space, closed by themselves."""

    use: str = LEAVE_OUT
    image: str = ""  # file name; '' for curves
    loops: list = field(default_factory=list)
    invert: bool = False
    width: float = 0.0  # of the picture; 0: as large as fits the faces
    centre: tuple = (0.0, 0.0)  # of the picture, from the texture plane's origin
    threshold: float = 0.5
    depth_at_black: float = 0.0
    depth_at_white: float = 0.02


def read_grey(filename):
    """A picture as rows of grey from 0 (black) to 1 (white), (rows, columns); what is transparent is
    white. Reads PNG, and what Pillow reads if it is there. Raises InputError naming MaskImage."""
    from matplotlib import image

    if not os.path.isfile(filename):
        raise InputError("MaskImage", filename, "there is no such file: choose a picture.")
    _require_few_pixels(filename)
    try:
        pixels = image.imread(filename)
    except (OSError, SyntaxError, ValueError, ImportError) as error:
        raise InputError("MaskImage", filename, "it cannot be read (%s): save it as PNG." % error)
    if pixels.dtype == np.uint8:
        pixels = pixels / 255.0
    elif pixels.dtype.kind in "iu":
        pixels = pixels / float(np.iinfo(pixels.dtype).max)
    pixels = np.clip(np.asarray(pixels, float), 0.0, 1.0)
    if pixels.ndim == 2:
        return pixels
    channels = pixels.shape[2]
    grey = pixels[..., :3] @ [0.2126, 0.7152, 0.0722] if channels >= 3 else pixels[..., 0]
    if channels in (2, 4):
        grey = 1.0 - pixels[..., -1] * (1.0 - grey)
    return grey


def _require_few_pixels(filename):
    """Raises InputError naming MaskImage for a picture that would take more memory than it is worth, however
    small its file is."""
    from PIL import Image

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Pillow's own, of pictures that are too large
            with Image.open(filename) as picture:
                columns, rows = picture.size
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        raise InputError("MaskImage", filename, "it cannot be read (%s): save it as PNG." % error) from error
    if rows * columns > MOST_PIXELS:
        remedy = "it would take %.1f GB: scale it down to %d million pixels, one for each dimple does."
        takes = rows * columns * BYTES_PER_PIXEL / 1e9
        raise InputError(
            "MaskImage", "%d x %d pixels" % (columns, rows), remedy % (takes, MOST_PIXELS // 1000000)
        )


def curve_loops(objects, shape_of):
    """Closed loops of the objects' wires: tuples of points in space. `shape_of` gives the shape of an object
    where it is drawn, or None. Raises InputError naming MaskCurves."""
    loops = []
    for obj in objects:
        wires = getattr(shape_of(obj), "Wires", [])
        if not wires:
            raise InputError("MaskCurves", obj.Label, "it has no wires: choose sketches or wires.")
        for wire in wires:
            if not wire.isClosed():
                raise InputError("MaskCurves", obj.Label, "it has an open curve: close it.")
            points = []
            for edge in wire.OrderedEdges:
                part = [tuple(p) for p in edge.discretize(Deflection=CURVE_DEFLECTION)]
                if edge.Orientation == "Reversed":
                    part.reverse()
                points += part[:-1]
            loops.append(tuple(points))
    return loops


def make_mask(given, plane, low, high):
    """_patchmill.Mask over the texture plane. `low` and `high` are the corners of the rectangle that the
    faces cover there. Raises InputError naming MaskUse, MaskImage, MaskCurves or MaskWidth."""
    if given.use not in USES:
        raise InputError("MaskUse", given.use, "give one of: %s." % ", ".join(USES))
    if given.image:
        pixels = read_grey(given.image)
        if given.invert:
            pixels = 1.0 - pixels
        return core.image_mask(pixels, *_rectangle(given, pixels.shape, low, high))
    if not given.loops:
        raise InputError("MaskUse", given.use, "give a picture or closed curves, or choose None.")
    mask = core.curve_mask([_on_plane(loop, plane) for loop in given.loops])
    return mask.inverted() if given.invert else mask


def _on_plane(points, plane):
    """Places in the texture plane, (n, 2), of points in space seen along the projection."""
    from_origin = np.asarray(points, float) - plane.origin
    return np.column_stack([from_origin @ plane.x_axis, from_origin @ plane.y_axis])


def _rectangle(given, shape, low, high):
    rows, columns = shape
    middle = np.asarray(given.centre, float)
    width = given.width
    if width < 0.0:
        raise InputError("MaskWidth", "%g mm" % width, "give zero or a positive length.")
    if width == 0.0:
        room = 2.0 * np.minimum(high - middle, middle - low)
        width = min(room[0], room[1] * columns / rows)
        if not width > 0.0:
            raise InputError("MaskCentre", "%g, %g mm" % tuple(middle), "put it over the faces.")
    half = 0.5 * width * np.array([1.0, rows / columns])
    return middle - half, middle + half


def apply_mask(given, mask, dimples, division, lattice):
    """Leaves out, thins or sinks the dimples, in place. `lattice`: a SurfaceLattice or None."""
    if given.use == LEAVE_OUT:
        core.keep_where(dimples, division, lattice, mask, given.threshold)
    elif given.use == DENSITY:
        core.thin_out(dimples, division, lattice, mask)
    else:
        core.set_depth(
            dimples, division, lattice, mask, given.depth_at_black, given.depth_at_white, 1e-6
        )
