"""The properties of the texture operations that say in which order dimples are milled (see property_table for
what the rows of the table are).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.textures.order import rows

ROW_PROPERTIES = [
    (
        "App::PropertyEnumeration",
        "Order",
        "Texture",
        "Mill patch by patch along helices, in rows of the lattice, or all round a cylinder along one thread "
        "while a rotary table turns it",
        list(rows.ORDERS),
    ),
    (
        "App::PropertyEnumeration",
        "RowExtent",
        "Texture",
        "Rows run over the whole face, across the borders of patches, or inside each patch",
        list(rows.EXTENTS),
    ),
    (
        "App::PropertyEnumeration",
        "RowDirection",
        "Texture",
        "Direction of the lattice that rows go along: the one of the least time (each is planned), the one "
        "nearest to the texture's X or Y, or the one along which the faces bend least",
        list(rows.DIRECTIONS),
    ),
    (
        "App::PropertyBool",
        "RowsOneWay",
        "Texture",
        "Mill all rows in the same sense; otherwise to and fro",
        False,
    ),
    (
        "App::PropertyInteger",
        "FirstPatch",
        "Texture",
        "Number of the patch, in milling order, with which the program begins; 1: all are milled",
        1,
    ),
    (
        "App::PropertyInteger",
        "LastPatch",
        "Texture",
        "Number of the patch, in milling order, with which the program ends; 0: with the last one",
        0,
    ),
    (
        "App::PropertyBool",
        "PatchStops",
        "Texture",
        "Stop before each patch if the operator has switched optional stops on (M1)",
        False,
    ),
    (
        "App::PropertyBool",
        "PatchComments",
        "Texture",
        "Begin each patch with a comment that has its number",
        False,
    ),
]
