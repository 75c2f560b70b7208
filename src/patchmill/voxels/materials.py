"""Materials of a stock: bodies of another material in it, or its skin down to a depth; each with a factor
on the feed (Kobayashi & Shirase 2014, section 3, name the attribute; the factor is ours).

A line of a DressupDCM's Materials is 'NAME FACTOR WHERE', WHERE a depth in mm below the stock's surface or
the name of a solid in the document. Where several say something of a voxel, the last counts.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

from _patchmill import InputError

from patchmill.geometry import shapes

OWN = "stock"  # name of the material that no line says anything of
REMEDY = (
    "give a name, a factor on the feed, and a depth in mm or the name of a solid, such as 'skin 0.6 1.5'."
)


@dataclass(frozen=True)
class Material:
    """`solid`: BREP text of where it is; `depth`: no further below its surface [mm]."""

    name: str
    factor: float
    solid: str
    depth: float = math.inf


def of_lines(lines, document, stock):
    """Tuple of Material for the lines of a property; `stock` is the stock's BREP text. Raises InputError
    naming Materials."""
    return tuple(_of_line(line, document, stock) for line in lines)


def _of_line(line, document, stock):
    words = line.split()
    if len(words) != 3:
        raise InputError("Materials", repr(line), REMEDY)
    name, factor, where = words
    number = _number(factor)
    if number is None or not (number > 0.0 and math.isfinite(number)):
        raise InputError("Materials", repr(line), "give a factor greater than zero.")
    depth = _number(where)
    if depth is not None:
        if not (depth > 0.0 and math.isfinite(depth)):
            raise InputError("Materials", repr(line), "give a depth greater than zero.")
        return Material(name, number, stock, depth)
    found = document.getObject(where) or next(iter(document.getObjectsByLabel(where)), None)
    shape = found and shapes.drawn(found)
    if shape is None:
        remedy = "there is no object '%s' with a shape: %s" % (where, REMEDY)
        raise InputError("Materials", repr(line), remedy)
    return Material(name, number, shape.exportBrepToString())


def _number(word):
    try:
        return float(word)
    except ValueError:
        return None
