"""Gwyddion Simple Field (.gsf): a text header, and heights as 32-bit numbers. Source: Gwyddion's user guide,
"Simple Field Files". Lengths are metres there; the first row is the top one.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import numpy as np
from _patchmill import InputError

from patchmill.surface.height_map import HeightMap, require_grid

MAGIC = b"Gwyddion Simple Field 1.0\n"
MOST_HEADER = 1 << 20
PREFIXES = {"": 1.0, "m": 1e-3, "u": 1e-6, "µ": 1e-6, "n": 1e-9, "p": 1e-12, "c": 1e-2, "k": 1e3}


def write(file, surface):
    """Writes a HeightMap to a binary file."""
    rows, columns = surface.heights.shape
    across, along = surface.size
    top = surface.origin[1] + (rows - 1) * surface.step[1]
    entries = {
        "XRes": columns,
        "YRes": rows,
        "XReal": repr(across * 1e-3),
        "YReal": repr(along * 1e-3),
        "XOffset": repr(surface.origin[0] * 1e-3),
        "YOffset": repr(-top * 1e-3),  # the top one's, downwards
        "XYUnits": "m",
        "ZUnits": "m",
        "Title": " ".join(surface.title.split()) or "Heights",
    }
    header = MAGIC + "".join("%s = %s\n" % entry for entry in entries.items()).encode()
    file.write(header + b"\0" * (4 - len(header) % 4))
    for row in range(rows - 1, -1, -1):
        file.write((surface.heights[row].astype(float) * 1e-3).astype("<f4").tobytes())


def read(content):
    """The HeightMap of a file's bytes. Raises InputError naming Surface."""
    end = content.find(b"\0", 0, MOST_HEADER)
    if not content.startswith(MAGIC) or end < 0:
        raise InputError("Surface", "no GSF header", "give a Gwyddion Simple Field file, version 1.0.")
    try:
        entries = _entries(content[len(MAGIC) : end].decode("utf-8"))
        columns, rows = int(entries["XRes"]), int(entries["YRes"])
        size = [float(entries.get(name, 1.0)) for name in ("XReal", "YReal")]
        offset = [float(entries.get(name, 0.0)) for name in ("XOffset", "YOffset")]
        across = 1e3 * _metres(entries.get("XYUnits", "m"))
        up = 1e3 * _metres(entries.get("ZUnits", "m"))
    except (ValueError, KeyError) as error:
        raise InputError("Surface", "GSF header: %s" % error, "the header is damaged.") from error
    first = end + 4 - end % 4
    require_grid(rows, columns, "GSF", len(content) - first, 4)
    numbers = np.frombuffer(content, "<f4", rows * columns, first).reshape(rows, columns)
    step = (size[0] / columns * across, size[1] / rows * across)
    origin = (offset[0] * across, -offset[1] * across - (rows - 1) * step[1])
    heights = np.where(np.isfinite(numbers), numbers.astype(float) * up, np.nan)
    return HeightMap(heights[::-1], step, origin, entries.get("Title", ""))


def _entries(text):
    pairs = (line.split("=", 1) for line in text.splitlines() if line.strip())
    return {name.strip(): value.strip() for name, value in pairs}


def _metres(unit):
    """How many metres a unit is."""
    if not unit.endswith("m") or unit[:-1] not in PREFIXES:
        raise ValueError("unit %r is no length" % unit)
    return PREFIXES[unit[:-1]]
