// Choosing the patches: a block of so many, or as many as cover an area; in an order that keeps the
// links from patch to patch short (row by row, to and fro).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/division.h"

#include <functional>

namespace patchmill::patch {

/// A block of `patches_x` by `patches_y` patches, centred on the texture plane's origin. Rows of
/// triangles count upright and inverted ones; hexagons stand in columns.
/// Errors: as require_valid(pattern), and InputError naming PatchesX or PatchesY (1..100000), or
/// Spacing if there would be more than `max_dimples` lattice points.
PatchDivision patch_block(const PatchPattern& pattern, int patches_x, int patches_y,
                          std::int64_t max_dimples = 20000000);

/// All patches whose outline overlaps `area` (texture plane, mm). Square patches are set
/// symmetrically about the area's centre, as few as cover it; of the others the centre of one patch
/// (hexagon) or the corner of six (triangle) lies there.
/// Errors: as require_valid(pattern); InputError naming Area if it is empty or not finite; Spacing
/// if there would be more than `max_dimples` lattice points.
PatchDivision cover(const PatchPattern& pattern, const Box2& area,
                    std::int64_t max_dimples = 20000000);

/// As above with lattice point (0, 0) at `anchor`.
PatchDivision cover(const PatchPattern& pattern, const Box2& area, const Vec2& anchor,
                    std::int64_t max_dimples = 20000000);

/// The same division with only those patches that have a lattice point for which `keep` is true.
PatchDivision keep_patches(PatchDivision division,
                           const std::function<bool(const LatticePoint&)>& keep);

}  // namespace patchmill::patch
