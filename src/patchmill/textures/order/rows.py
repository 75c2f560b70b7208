"""The order in which a texture's dimples are milled: the papers' helices, or rows.

    Helix   patch by patch, each from its outline inwards or outwards (Matsuda 2008, Fig. 1b)
    Rows    along the lattice, over the whole face or inside each patch (docs/rows.md)
    Thread  all round a cylinder that a rotary table turns (docs/thread.md)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
from _patchmill import InputError

HELIX, ROWS, THREAD = ORDERS = ("Helix", "Rows", "Thread")
WHOLE_FACE, EACH_PATCH = EXTENTS = ("Whole face", "Each patch")
LEAST_TIME, ALONG_X, ALONG_Y, FLATTEST = DIRECTIONS = (
    "Least time",
    "Along X",
    "Along Y",
    "Principal curvature",
)
ACROSS = {ALONG_X: ALONG_Y, ALONG_Y: ALONG_X}


def _choose(name, value, choices):
    if value not in choices:
        raise InputError(name, value, "give one of: %s." % ", ".join(choices))


def in_rows(given):
    """Whether the dimples of a TextureInput are milled in rows. Raises InputError naming Order, RowExtent or
    RowDirection."""
    _choose("Order", given.order, ORDERS)
    if given.order != ROWS:
        return False
    _choose("RowExtent", given.row_extent, EXTENTS)
    _choose("RowDirection", given.row_direction, DIRECTIONS)
    if given.form == "Free":
        raise InputError("Order", given.order, "the free form has no lattice: choose Helix.")
    return True


def across_patches(given):
    """Whether rows run on over the borders of patches."""
    return given.order == ROWS and given.row_extent == WHOLE_FACE


def ordered(given, dimples, division, direction=None):
    """The dimples in the order that a TextureInput asks for. `direction`: number of the lattice's step that
    rows go along; None: the input's own, of least time the one that bends least. Raises InputError."""
    if not in_rows(given):
        return dimples
    if direction is None:
        direction = _direction(given, dimples, division.pattern)
    whole = given.row_extent == WHOLE_FACE
    return core.in_rows(dimples, division.pattern, direction, given.rows_one_way, whole)


def candidates(given, division):
    """Numbers of the lattice's steps that rows are to be tried along, [None] if there is nothing to try."""
    if given.order != ROWS or given.row_direction != LEAST_TIME:
        return [None]
    return list(range(core.row_directions(division.pattern)))


def _direction(given, dimples, pattern):
    if given.row_direction in (ALONG_X, ALONG_Y):
        along = (1.0, 0.0) if given.row_direction == ALONG_X else (0.0, 1.0)
        return core.nearest_row_direction(pattern, along)
    return core.flattest_row_direction(dimples, pattern)


def chosen_patches(placed):
    """(the dimples of a PlacedTexture from its FirstPatch to its LastPatch, how many of those that are milled
    come before them). Raises InputError naming FirstPatch or LastPatch."""
    first, last = placed.input.first_patch, placed.input.last_patch
    if placed.free is not None:
        name, value, all_of = ("FirstPatch", first, 1) if first != 1 else ("LastPatch", last, 0)
        raise InputError(name, value, "the free form is milled as a whole: give %d." % all_of)
    dimples = placed.dimples
    if last:
        if 0 < last < first:
            raise InputError("LastPatch", last, "give no less than FirstPatch, %d." % first)
        dimples = core.up_to_patch(dimples, last)
    chosen = core.from_patch(dimples, first)
    return chosen, dimples.counts()["cut"] - chosen.counts()["cut"]
