"""Height maps as OpenEXR pictures: one channel Y of 32-bit floats, heights in mm, NaN where nothing is known;
scan lines without compression, the top row first. Source: the OpenEXR project's "OpenEXR File Layout".

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import struct

import numpy as np
from _patchmill import InputError

from patchmill.surface.height_map import HeightMap, require_grid

MAGIC = struct.pack("<II", 20000630, 2)
FLOAT = 2
MOST_ATTRIBUTES = 1000
PIXEL_NAMES = {"stepX": 0, "stepY": 1, "originX": 2, "originY": 3}  # mm


def write(file, surface):
    """Writes a HeightMap to a binary file."""
    rows, columns = surface.heights.shape
    window = struct.pack("<iiii", 0, 0, columns - 1, rows - 1)
    channel = b"Y\0" + struct.pack("<iBBBBii", FLOAT, 0, 0, 0, 0, 1, 1) + b"\0"
    attributes = [
        ("channels", "chlist", channel), ("compression", "compression", b"\0"),
        ("dataWindow", "box2i", window),
        ("displayWindow", "box2i", window), ("lineOrder", "lineOrder", b"\0"),
        ("pixelAspectRatio", "float", struct.pack("<f", surface.step[0] / surface.step[1])),
        ("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)),
        ("screenWindowWidth", "float", struct.pack("<f", 1)),
    ]  # fmt: skip
    for name, value in zip(PIXEL_NAMES, surface.step + surface.origin):
        attributes.append((name, "double", struct.pack("<d", value)))
    header = b"".join(
        name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value
        for name, kind, value in attributes
    )
    header = MAGIC + header + b"\0"
    line = 8 + 4 * columns
    first = len(header) + 8 * rows
    file.write(header)
    file.write((first + line * np.arange(rows, dtype=np.uint64)).astype("<u8").tobytes())
    for number, row in enumerate(surface.heights[::-1]):
        file.write(struct.pack("<ii", number, 4 * columns) + row.astype("<f4").tobytes())


def read(content, step=None):
    """The HeightMap of a file's bytes with one channel of floats, without compression. `step` [mm] is needed
    of a file that does not say it. Raises InputError naming Surface or GridStep."""
    try:
        attributes, at = _attributes(content)
        left, top, right, bottom = struct.unpack("<iiii", attributes["dataWindow"])
        columns, rows = right - left + 1, bottom - top + 1
        name, _, rest = attributes["channels"].partition(b"\0")
        one = name and rest[16:] == b"\0" and struct.unpack_from("<i", rest)[0] == FLOAT
        if not one or attributes["compression"] != b"\0":
            raise ValueError("not one channel of floats without compression")
        require_grid(rows, columns, "OpenEXR", len(content) - at, 4)
        places = np.frombuffer(content, "<u8", rows, at)
        heights = np.full((rows, columns), np.nan)
        for place in places:
            number, size = struct.unpack_from("<ii", content, int(place))
            if size != 4 * columns or not 0 <= number - top < rows:
                raise ValueError("a damaged line")
            heights[rows - 1 - (number - top)] = np.frombuffer(content, "<f4", columns, int(place) + 8)
        said = [struct.unpack("<d", attributes[name])[0] for name in PIXEL_NAMES if name in attributes]
    except (struct.error, KeyError, ValueError, OverflowError) as error:
        remedy = "the file is damaged, or no OpenEXR file of heights."
        raise InputError("Surface", "OpenEXR: %s" % error, remedy) from error
    heights[~np.isfinite(heights)] = np.nan
    if len(said) == 4:
        return HeightMap(heights, tuple(said[:2]), tuple(said[2:]))
    if step is None:
        raise InputError("GridStep", "not said in the OpenEXR file", "give the distance of its pixels in mm.")
    return HeightMap(heights, step)


def _attributes(content):
    """{name: bytes} of the header, and where it ends."""
    if content[:8] != MAGIC:
        raise ValueError("no single picture in scan lines")
    found: dict = {}
    at = 8
    while content[at : at + 1] != b"\0":
        name_end = content.index(b"\0", at)
        kind_end = content.index(b"\0", name_end + 1)
        size = struct.unpack_from("<i", content, kind_end + 1)[0]
        value = content[kind_end + 5 : kind_end + 5 + size]
        if size < 0 or len(value) != size or len(found) > MOST_ATTRIBUTES:
            raise ValueError("a damaged header")
        found[content[at:name_end].decode("latin-1")] = value
        at = kind_end + 5 + size
    return found, at + 1
