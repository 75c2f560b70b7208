"""Height maps as 16-bit pictures in TIFF 6.0: one strip, without compression. Heights are grey values from 1
to 65535, the lowest to the highest; 0 is unknown. What a grey value means in mm, and the grid, stand as JSON
in ImageDescription. The first row is the top one.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import math
import struct

import numpy as np
from _patchmill import InputError

from patchmill.surface.height_map import HeightMap, require_grid

WIDTH, LENGTH, BITS, COMPRESSION, PHOTOMETRIC, DESCRIPTION, OFFSETS, SAMPLES, ROWS, COUNTS, FORMAT = (
    256, 257, 258, 259, 262, 270, 273, 277, 278, 279, 339,
)  # fmt: skip
SHORT, LONG, ASCII = 3, 4, 2
SIZES = {1: ("B", 1), SHORT: ("H", 2), LONG: ("I", 4)}
GREYS = 65534  # steps between the lowest and the highest


def write(file, surface):
    """Writes a HeightMap. Heights are rounded to 1/65534 of their range. Raises InputError naming Surface if
    nothing is known, or the picture would be over 4 GB."""
    if not surface.known.any():
        raise InputError("Surface", "no height is known", "give a surface with heights.")
    rows, columns = surface.heights.shape
    if rows * columns * 2 > 2**32 - 2**16:
        remedy = "a TIFF has at most 4 GB: write a part."
        raise InputError("Surface", "%d x %d points" % (columns, rows), remedy)
    low, high = float(np.nanmin(surface.heights)), float(np.nanmax(surface.heights))
    scale = (high - low) / GREYS or 1.0
    said = {
        "patchmill": "height map", "title": surface.title, "step_mm": surface.step,
        "origin_mm": surface.origin,
        "height_mm": {"grey_1": low, "each_grey": scale}, "unknown": 0,
    }  # fmt: skip
    description = json.dumps(said, ensure_ascii=True).encode() + b"\0"
    first = 8 + len(description) + len(description) % 2
    entries = [
        (WIDTH, LONG, 1, columns), (LENGTH, LONG, 1, rows), (BITS, SHORT, 1, 16), (COMPRESSION, SHORT, 1, 1),
        (PHOTOMETRIC, SHORT, 1, 1), (DESCRIPTION, ASCII, len(description), 8), (OFFSETS, LONG, 1, first),
        (SAMPLES, SHORT, 1, 1), (ROWS, LONG, 1, rows), (COUNTS, LONG, 1, rows * columns * 2),
        (FORMAT, SHORT, 1, 1),
    ]  # fmt: skip
    file.write(struct.pack("<2sHI", b"II", 42, first + rows * columns * 2))
    file.write(description.ljust(first - 8, b"\0"))
    for row in surface.heights[::-1]:
        grey = 1.0 + np.round((row.astype(float) - low) / scale)
        file.write(np.where(np.isnan(grey), 0.0, grey).astype("<u2").tobytes())
    file.write(struct.pack("<H", len(entries)))
    file.write(b"".join(struct.pack("<HHII", *entry) for entry in entries) + struct.pack("<I", 0))


def read(content, step=None, each_grey=None):
    """The HeightMap of a TIFF's bytes: grey, without compression, 8 or 16 bits or 32-bit float. Of a picture
    without our description `step` [mm] and `each_grey` [mm] must be given. Raises InputError naming Surface,
    GridStep or GreyHeight."""
    try:
        order, tags = _tags(content)
        columns, rows = tags[WIDTH][0], tags[LENGTH][0]
        bits, kind = tags.get(BITS, [1])[0], tags.get(FORMAT, [1])[0]
        number = {(8, 1): "u1", (16, 1): "u2", (16, 2): "i2", (32, 3): "f4"}.get((bits, kind))
        if number is None or tags.get(COMPRESSION, [1])[0] != 1 or tags.get(SAMPLES, [1])[0] != 1:
            raise ValueError("no grey picture of 8, 16 or 32 bits without compression")
        require_grid(rows, columns, "TIFF", len(content), bits // 8)
        strips = b"".join(content[a : a + n] for a, n in zip(tags[OFFSETS], tags[COUNTS]))
        require_grid(rows, columns, "TIFF", len(strips), bits // 8)
        grey = np.frombuffer(strips, order + number, rows * columns).reshape(rows, columns)
        grey = grey[::-1].astype(float)
        said = json.loads(tags.get(DESCRIPTION, b"null").rstrip(b"\0") or b"null")
    except (struct.error, KeyError, ValueError, TypeError, IndexError, RecursionError) as error:
        remedy = "the file is damaged, or no TIFF of heights."
        raise InputError("Surface", "TIFF: %s" % error, remedy) from error
    if isinstance(said, dict) and said.get("patchmill") == "height map":
        return _ours(grey, said)
    if step is None:
        raise InputError("GridStep", "not said in the TIFF", "give the distance of its pixels in mm.")
    if each_grey is None or not math.isfinite(each_grey) or each_grey == 0:
        raise InputError("GreyHeight", "not said in the TIFF", "give the height of one grey value in mm.")
    return HeightMap(np.where(np.isfinite(grey), grey, np.nan) * each_grey, step)


def _ours(grey, said):
    try:
        low, scale = (float(said["height_mm"][name]) for name in ("grey_1", "each_grey"))
        heights = np.where(grey > 0, low + (grey - 1.0) * scale, np.nan)
        step, origin = ([float(v) for v in said[name]] for name in ("step_mm", "origin_mm"))
        if len(step) != 2 or len(origin) != 2:
            raise ValueError("no pair")
    except (KeyError, ValueError, TypeError) as error:
        raise InputError("Surface", "TIFF: %s" % error, "its description is damaged.") from error
    return HeightMap(heights, tuple(step), tuple(origin), str(said.get("title", "")))


def _tags(content):
    """Byte order and {tag: numbers, or bytes of a text}."""
    order = {b"II": "<", b"MM": ">"}.get(bytes(content[:2]))
    if order is None or struct.unpack_from(order + "H", content, 2)[0] != 42:
        raise ValueError("no TIFF header")
    place = struct.unpack_from(order + "I", content, 4)[0]
    count = struct.unpack_from(order + "H", content, place)[0]
    tags: dict = {}
    for index in range(count):
        at = place + 2 + 12 * index
        tag, kind, many = struct.unpack_from(order + "HHI", content, at)
        if kind == ASCII:
            start = at + 8 if many <= 4 else struct.unpack_from(order + "I", content, at + 8)[0]
            tags[tag] = bytes(content[start : start + many])
        elif kind in SIZES:
            letter, size = SIZES[kind]
            if many * size > len(content):
                raise ValueError("tag %d is longer than the file" % tag)
            start = at + 8 if many * size <= 4 else struct.unpack_from(order + "I", content, at + 8)[0]
            tags[tag] = struct.unpack_from("%s%d%s" % (order, many, letter), content, start)
    return order, tags
