"""Surface data files (.sdf) of ISO 25178-71: a header of fixed fields, heights row by row, a trailer; as text
(aISO-1.0) or binary (bISO-1.0), and their forerunner of BCR (aBCR-1.0, bBCR-1.0). Lengths are metres; y grows
with the row. Unknown heights are BAD in text, and the lowest number of the type in binary files.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import datetime
import struct

import numpy as np
from _patchmill import InputError

from patchmill.surface.height_map import HeightMap, require_grid

HEADER = struct.Struct("<8s10s12s12sHHddddBBB")
TYPES = {0: "<u1", 1: "<u2", 2: "<u4", 3: "<f4", 4: "<i1", 5: "<i2", 6: "<i4", 7: "<f8"}
MOST_SIDE = 65535
LOWEST = -np.finfo(np.float64).max


def write(file, surface):
    """Writes a HeightMap as a binary file of 64-bit heights. The origin is not kept: the format has none."""
    rows, columns = surface.heights.shape
    if max(rows, columns) > MOST_SIDE:
        remedy = "an SDF file has at most %d a side: write a part, or another format." % MOST_SIDE
        raise InputError("Surface", "%d x %d points" % (columns, rows), remedy)
    now = datetime.datetime.now(datetime.timezone.utc).strftime("%d%m%Y%H%M").encode()
    step = [s * 1e-3 for s in surface.step]
    file.write(
        HEADER.pack(b"bISO-1.0", b"PatchMill ", now, now, columns, rows, step[0], step[1], 1.0, -1.0, 0, 7, 0)
    )
    for row in surface.heights:
        metres = row.astype(float) * 1e-3
        file.write(np.where(np.isnan(metres), LOWEST, metres).astype("<f8").tobytes())


def read(content):
    """The HeightMap of a file's bytes. Raises InputError naming Surface."""
    if content[:8] in (b"bISO-1.0", b"bBCR-1.0"):
        return _read_binary(content)
    if content[:8] in (b"aISO-1.0", b"aBCR-1.0"):
        return _read_text(content)
    raise InputError("Surface", "no SDF header", "give a file that begins with aISO-1.0 or bISO-1.0.")


def _read_binary(content):
    if len(content) < HEADER.size:
        raise InputError("Surface", "SDF header of %d bytes" % len(content), "the file is cut off.")
    _, _, _, _, columns, rows, dx, dy, dz, _, compression, kind, _ = HEADER.unpack_from(content)
    if compression != 0 or kind not in TYPES:
        said = "SDF with compression %d, data type %d" % (compression, kind)
        raise InputError("Surface", said, "save it without compression, as one of the types 0 to 7.")
    number = np.dtype(TYPES[kind])
    require_grid(rows, columns, "SDF", len(content) - HEADER.size, number.itemsize)
    values = np.frombuffer(content, number, rows * columns, HEADER.size).reshape(rows, columns)
    heights = values.astype(float)
    if number.kind == "f":
        heights[~np.isfinite(heights) | (values == np.finfo(number).min)] = np.nan
    elif number.kind == "i":
        heights[values == np.iinfo(number).min] = np.nan
    with np.errstate(over="ignore"):
        heights = heights * dz * 1e3
    return HeightMap(heights, (dx * 1e3, dy * 1e3))


def _read_text(content):
    try:
        text = content.decode("ascii", "replace")
        head, _, rest = text[8:].partition("*")
        entries = dict(_pair(line) for line in head.splitlines() if "=" in line)
        columns, rows = int(entries["numpoints"]), int(entries["numprofiles"])
        scale = [float(entries[name]) * 1e3 for name in ("xscale", "yscale", "zscale")]
        require_grid(rows, columns, "SDF", len(rest) + 1, 2)
        words = rest.partition("*")[0].split()
        if len(words) < rows * columns:
            raise ValueError("%d heights instead of %d" % (len(words), rows * columns))
        numbers = [np.nan if word.upper() == "BAD" else float(word) for word in words[: rows * columns]]
    except (ValueError, KeyError) as error:
        raise InputError("Surface", "SDF text: %s" % error, "the file is damaged.") from error
    heights = np.array(numbers).reshape(rows, columns) * scale[2]
    return HeightMap(np.where(np.isfinite(heights), heights, np.nan), tuple(scale[:2]))


def _pair(line):
    name, _, value = line.partition("=")
    return name.strip().lower(), value.strip()
