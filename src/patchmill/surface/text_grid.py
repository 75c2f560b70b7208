"""Height maps as tables of text (.csv): a first line that begins with # and says the grid, then a line of
heights in mm for each row, the lowest y first, with commas between. Unknown heights are empty.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re

import numpy as np
from _patchmill import InputError

from patchmill.surface.height_map import HeightMap, require_grid

HEAD = "# heights in mm; step %r %r mm; origin %r %r mm\n"
NUMBER = r"([-+0-9.eE]+)"
HEAD_PATTERN = re.compile(r"# heights in mm; step {0} {0} mm; origin {0} {0} mm".format(NUMBER))


def write(file, surface):
    """Writes a HeightMap; heights to eight digits."""
    file.write((HEAD % (surface.step + surface.origin)).encode())
    for row in surface.heights:
        words = ("" if np.isnan(height) else "%.8g" % height for height in row)
        file.write((",".join(words) + "\n").encode())


def read(content, step=None):
    """The HeightMap of a file's bytes. Columns may be parted by commas, semicolons, tabs or blanks; lines
    that begin with # are remarks. `step` [mm] is needed where the first line does not say it. Raises
    InputError naming Surface or GridStep."""
    try:
        lines = content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError as error:
        raise InputError("Surface", "CSV: byte %d" % error.start, "save the file as UTF-8.") from error
    said = HEAD_PATTERN.match(lines[0]) if lines else None
    lines = [line for line in lines if line.strip() and not line.startswith("#")]
    mark = next((m for m in ",;\t" if lines and m in lines[0]), None)
    rows = [line.split(mark) for line in lines]
    if not rows or any(len(row) != len(rows[0]) for row in rows):
        raise InputError("Surface", "CSV: rows of different length", "give a table with equal rows.")
    require_grid(len(rows), len(rows[0]), "CSV")
    try:
        heights = np.array([[float(word) if word.strip() else np.nan for word in row] for row in rows])
        numbers = [float(word) for word in said.groups()] if said else None
    except ValueError as error:
        raise InputError("Surface", "CSV: %s" % error, "give numbers in mm, with points.") from error
    heights[~np.isfinite(heights)] = np.nan
    if numbers:
        return HeightMap(heights, tuple(numbers[:2]), tuple(numbers[2:]))
    if step is None:
        raise InputError("GridStep", "not said in the CSV", "give the distance of its heights in mm.")
    return HeightMap(heights, step)
