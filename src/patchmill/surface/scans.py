"""Measured meshes and clouds of points (STL, PLY) as height maps: each triangle is laid on a grid seen along
z. Points without triangles count for the nearest grid point.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import struct

import numpy as np
from _patchmill import InputError

from patchmill.surface.height_map import HeightMap, require_grid

STL = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
PLY_NUMBERS = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4",
    "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4",
    "float32": "f4", "float64": "f8",
}  # fmt: skip
ROUNDING = 1e-3  # of a step or of a triangle: files keep places as 32-bit numbers
POINTS_A_CELL = 1.0  # of the grid that is chosen where none is given


def read_stl(content, step=None):
    """The HeightMap of a binary STL's bytes, lengths in mm. `step`: of the grid [mm]; None: such that there
    is a grid point for each corner. Raises InputError naming Surface or GridStep."""
    if len(content) < 84 or 84 + 50 * struct.unpack_from("<I", content, 80)[0] != len(content):
        raise InputError("Surface", "STL", "give a binary STL file whose length fits its count of triangles.")
    corners = np.frombuffer(content, STL, offset=84)["corners"].astype(float)
    return height_map_of(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3), step, shared=6)


def read_ply(content, step=None):
    """The HeightMap of a PLY's bytes (binary or text), lengths in mm. As read_stl."""
    try:
        form, elements, at = _ply_header(content)
        points, faces = np.zeros((0, 3)), np.zeros((0, 3), int)
        words = iter(content[at:].split()) if form == "ascii" else None
        for name, count, properties in elements:
            if name == "vertex":
                points, at = _vertices(content, at, words, form, count, properties)
            elif name == "face":
                faces, at = _faces(content, at, words, form, count, properties)
                break
        if len(faces) and not (0 <= faces.min() and faces.max() < len(points)):
            raise ValueError("a face with points that do not exist")
    except (ValueError, KeyError, IndexError, StopIteration, struct.error) as error:
        raise InputError("Surface", "PLY: %s" % error, "the file is damaged.") from error
    return height_map_of(points, faces, step)


def height_map_of(points, faces, step=None, shared=1):
    """HeightMap of (n, 3) points [mm] and (m, 3) triangles of them; the highest one counts where several lie
    over each other. `shared`: how often each corner stands in `points`."""
    if len(points) < 3 or not np.isfinite(points).all():
        raise InputError("Surface", "%d points" % len(points), "give at least three finite points.")
    low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
    if step is None:
        step = float(np.sqrt(np.prod(high - low) * shared / len(points) / POINTS_A_CELL))
    if not np.isfinite(step) or step <= 0:
        raise InputError("GridStep", "%g mm" % step, "give a distance above 0 mm.")
    if not (high - low < 1e9 * step).all():
        raise InputError("GridStep", "%g mm" % step, "give a larger one.")
    columns, rows = (int(n) for n in np.floor((high - low) / step + ROUNDING) + 1)
    require_grid(rows, columns, "mesh")
    heights = np.full((rows, columns), -np.inf)
    at = (points[:, :2] - low) / step
    if len(faces):
        for face in faces:
            _lay(heights, at[face], points[face, 2])
    else:
        cell = np.rint(at).astype(int)
        np.maximum.at(heights, (cell[:, 1].clip(0, rows - 1), cell[:, 0].clip(0, columns - 1)), points[:, 2])
    return HeightMap(np.where(np.isfinite(heights), heights, np.nan), step, tuple(low))


def _lay(heights, corners, z):
    """Lays one triangle, corners in grid units, on the grid."""
    rows, columns = heights.shape
    first = np.maximum(np.ceil(corners.min(axis=0) - ROUNDING), 0).astype(int)
    last = np.minimum(np.floor(corners.max(axis=0) + ROUNDING), (columns - 1, rows - 1)).astype(int)
    if (last < first).any():
        return
    a, b = corners[1] - corners[0], corners[2] - corners[0]
    area = a[0] * b[1] - a[1] * b[0]
    if abs(area) < 1e-12:
        return
    x, y = np.meshgrid(np.arange(first[0], last[0] + 1), np.arange(first[1], last[1] + 1))
    x, y = x - corners[0][0], y - corners[0][1]
    u, v = (x * b[1] - y * b[0]) / area, (a[0] * y - a[1] * x) / area
    inside = (u >= -ROUNDING) & (v >= -ROUNDING) & (u + v <= 1 + ROUNDING)
    block = heights[first[1] : last[1] + 1, first[0] : last[0] + 1]
    np.maximum(block, z[0] + u * (z[1] - z[0]) + v * (z[2] - z[0]), out=block, where=inside)


def _ply_header(content):
    """Format, [(name, count, properties)] and where the data begin."""
    end = content.find(b"end_header\n", 0, 1 << 16)
    if not content.startswith(b"ply") or end < 0:
        raise ValueError("no PLY header")
    elements: list = []
    form = None
    for line in content[:end].decode("ascii").splitlines()[1:]:
        words = line.split()
        if words[:1] == ["format"]:
            form = words[1]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append(words[1:])
    if form not in ("ascii", "binary_little_endian", "binary_big_endian"):
        raise ValueError("format %s" % form)
    if any(count < 0 or count > len(content) for _, count, _ in elements):
        raise ValueError("more elements than bytes")
    return form, elements, end + len(b"end_header\n")


def _vertices(content, at, words, form, count, properties):
    names = [p[-1] for p in properties]
    places = [names.index(axis) for axis in "xyz"]
    if words is not None:
        rows = [[float(next(words)) for _ in names] for _ in range(count)]
        return np.array(rows).reshape(-1, len(names))[:, places], at
    order = "<" if form == "binary_little_endian" else ">"
    kind = np.dtype([(str(i), order + PLY_NUMBERS[p[0]]) for i, p in enumerate(properties)])
    table = np.frombuffer(content, kind, count, at)
    points = np.column_stack([table[str(i)].astype(float) for i in places])
    return points, at + count * kind.itemsize


def _faces(content, at, words, form, count, properties):
    """Triangles; a face with more corners is a fan of them."""
    if len(properties) != 1 or properties[0][0] != "list":
        raise ValueError("faces that are not one list of points")
    order = "<" if form == "binary_little_endian" else ">"
    number, index = (np.dtype(order + PLY_NUMBERS[name]) for name in properties[0][1:3])
    triangles = []
    for _ in range(count):
        if words is not None:
            corners = [int(next(words)) for _ in range(int(next(words)))]
        else:
            many = int(np.frombuffer(content, number, 1, at)[0])
            corners = np.frombuffer(content, index, many, at + number.itemsize).tolist()
            at += number.itemsize + many * index.itemsize
        triangles += [(corners[0], b, c) for b, c in zip(corners[1:], corners[2:])]
    return np.array(triangles, int).reshape(-1, 3), at
