"""Reliefs as triangle meshes: binary STL and PLY, and points with heights as VTK image data (.vti). They are
written in blocks of rows, so that memory does not grow with the relief.

A relief here is anything with `shape` (rows, columns) and `points(first, end)`, which gives the points of
rows first <= row < end, (rows, columns, 3) [mm], NaN where there is none: a HeightMap, or the relief of a
simulated texture.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import struct

import numpy as np
from _patchmill import InputError

BLOCK_POINTS = 1 << 16
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def blocks(relief, overlap=0):
    """(first row, points) of a relief, block by block; each begins `overlap` rows before the last end."""
    rows, columns = relief.shape
    each = max(2, BLOCK_POINTS // columns)
    first = 0
    while first < rows - overlap:
        end = min(rows, first + each + overlap)
        yield first, relief.points(first, end)
        first = end - overlap


def triangles_of(points):
    """Corners of two triangles for each cell of a block all of whose corners exist: (n, 3, 3)."""
    a, b, c, d = points[:-1, :-1], points[:-1, 1:], points[1:, 1:], points[1:, :-1]
    there = _whole_cells(points)
    a, b, c, d = (corner[there] for corner in (a, b, c, d))
    return np.stack([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)], axis=1).reshape(-1, 3, 3)


def _whole_cells(points):
    """Which cells have four corners that exist: (rows - 1, columns - 1)."""
    a, b, c, d = points[:-1, :-1], points[:-1, 1:], points[1:, 1:], points[1:, :-1]
    return np.isfinite(a + b + c + d).all(axis=2)


def write_stl(file, relief):
    """Binary STL; the normal is upwards where the relief's rows and columns turn left."""
    file.write(b"PatchMill relief, mm".ljust(80))
    file.write(struct.pack("<I", 0))
    count = 0
    for _, points in blocks(relief, overlap=1):
        corners = triangles_of(points)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        records = np.zeros(len(corners), RECORD)
        records["normal"], records["corners"] = normals / np.maximum(lengths, 1e-300), corners
        file.write(records.tobytes())
        count += len(corners)
    _require_some(count)
    file.seek(80)
    file.write(struct.pack("<I", count))


def write_ply(file, relief):
    """Binary PLY of points and triangles. Points that do not exist are written as the first one that does,
    and no triangle has them, for a PLY's readers count on every number."""
    rows, columns = relief.shape
    cells = np.concatenate([_whole_cells(points) for _, points in blocks(relief, overlap=1)])
    _require_some(cells.sum())
    file.write(
        (
            "ply\nformat binary_little_endian 1.0\ncomment PatchMill relief, mm\nelement vertex %d\n"
            "property float x\nproperty float y\nproperty float z\nelement face %d\n"
            "property list uchar int vertex_indices\nend_header\n" % (rows * columns, 2 * cells.sum())
        ).encode()
    )
    row, column = np.argwhere(cells)[0]
    instead = relief.points(int(row), int(row) + 1)[0, column]
    for _, points in blocks(relief):
        points = np.where(np.isfinite(points).all(axis=2, keepdims=True), points, instead)
        file.write(points.astype("<f4").tobytes())
    face = np.dtype([("count", "u1"), ("corners", "<i4", 3)])
    each = max(1, BLOCK_POINTS // columns)
    for first in range(0, rows - 1, each):
        a = np.flatnonzero(cells[first : first + each])
        a = (a // (columns - 1) + first) * columns + a % (columns - 1)
        faces = np.zeros(2 * len(a), face)
        faces["count"] = 3
        faces["corners"][0::2] = np.column_stack([a, a + 1, a + columns + 1])
        faces["corners"][1::2] = np.column_stack([a, a + columns + 1, a + columns])
        file.write(faces.tobytes())


def write_vti(file, surface):
    """VTK image data of a HeightMap: heights [mm] as point data over its grid; NaN where nothing is known."""
    rows, columns = surface.heights.shape
    extent = "0 %d 0 %d 0 0" % (columns - 1, rows - 1)
    file.write(
        (
            '<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" '
            'header_type="UInt64">\n<ImageData WholeExtent="%s" Origin="%r %r 0" Spacing="%r %r 1">\n'
            '<Piece Extent="%s">\n<PointData Scalars="height">\n<DataArray type="Float64" Name="height" '
            'format="appended" offset="0"/>\n</PointData>\n</Piece>\n</ImageData>\n'
            '<AppendedData encoding="raw">\n_' % ((extent,) + surface.origin + surface.step + (extent,))
        ).encode()
    )
    file.write(struct.pack("<Q", rows * columns * 8))
    for row in surface.heights:
        file.write(row.astype("<f8").tobytes())
    file.write(b"\n</AppendedData>\n</VTKFile>\n")


def _require_some(count):
    if not count:
        raise InputError("Surface", "no cell of four known points", "give a relief with neighbouring points.")
