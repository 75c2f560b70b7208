// Patch division: which lattice points make which patch, and in what order they are milled.
// Square patches of m x m points tile the square lattice with the vectors (m, 0) and (0, m), so
// every point belongs to exactly one patch and lines of dimples run on from patch to patch (Matsuda
// 2008, Fig. 1a; Xu & Sasahara 2016, section 2.1). SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/patch/helix.h"
#include "core/patch/texture_plane.h"

namespace patchmill {

/// A block of square patches, centred on the texture plane's origin.
struct SquareDivision {
  double spacing = 0.0;  ///< f: distance of neighbouring lattice points in the texture plane [mm]
  int side = 0;          ///< m: dimples along a patch's side
  int patches_x = 0;     ///< number of patches along x
  int patches_y = 0;
  HelixOrder order = HelixOrder::Inward;
};

/// Errors: InputError naming Spacing, PatchSide, PatchesX or PatchesY; also if there would be more
/// than `max_dimples` lattice points.
void require_valid(const SquareDivision& division, std::int64_t max_dimples = 20000000);

/// How many patches of the division's side and spacing it takes to cover width x height [mm]:
/// {along x, along y}, each at least 1.
/// Errors: as require_valid, and InputError naming PatchSide if a patch is larger than the area.
std::array<int, 2> patches_to_cover(const SquareDivision& division, double width, double height);

/// Place of a lattice point in the texture plane's own coordinates [mm].
Vec2 place(const SquareDivision& division, const LatticePoint& lattice);

/// All lattice points in milling order (patches row by row, to and fro), not yet on a surface:
/// `surface` is unset and `state` is Cut.
Dimples lattice_points(const SquareDivision& division);

/// Outlines of the patches in the texture plane [mm]: four corners each, half a step outside the
/// outermost dimples, so that neighbours share their borders.
std::vector<std::array<Vec2, 4>> outlines(const SquareDivision& division);

}  // namespace patchmill
