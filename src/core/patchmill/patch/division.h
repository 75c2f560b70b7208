// Patch division: which lattice points make which patch, and in what order they are milled.
// The patches of a shape are copies of one another, set on tiling vectors so that every lattice
// point belongs to exactly one patch and lines of dimples run on from patch to patch (Matsuda 2008,
// section 2.1 and Fig. 1a; Xu & Sasahara 2016, section 2.1). What each shape has of its own is in shapes/.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/helix.h"
#include "patchmill/patch/texture_plane.h"

namespace patchmill::patch {

using Box2 = Eigen::AlignedBox2d;

/// Where the helix of a patch begins.
enum class HelixStart : std::uint8_t {
  SameCorner,    ///< all patches alike, as in the papers
  NearestCorner  ///< at the corner next to the end of the patch before: shorter links
};

/// What the patches look like; where they lie is PatchDivision's.
struct PatchPattern {
  PatchShape shape = PatchShape::Square;
  double spacing = 0.0;  ///< f: distance of neighbouring lattice points in the texture plane [mm]
  PatchSize size = 0;    ///< dimples along a side, or the radius r (hexagon)
  HelixOrder order = HelixOrder::Inward;
  HelixStart start = HelixStart::SameCorner;
};

/// One patch: cell (a, b) of the tiling, its helix turned by `turn` corners.
struct PatchCell {
  std::int32_t a = 0, b = 0;
  bool down = false;  ///< the inverted patch of the cell, of shapes that have them
  std::int32_t turn = 0;
};

/// Patches in milling order.
struct PatchDivision {
  PatchPattern pattern;
  Vec2 anchor = Vec2::Zero();  ///< place of lattice point (0, 0) in the texture plane [mm]
  std::vector<PatchCell> cells;
};

/// Errors: InputError naming Spacing, PatchSide or PatchSideAcross.
void require_valid(const PatchPattern& pattern);

/// The two tiling vectors in lattice units.
std::array<LatticePoint, 2> tiling_vectors(PatchShape shape, PatchSize size);

/// Lattice coordinates that a patch's helix is counted from.
LatticePoint cell_origin(const PatchPattern& pattern, const PatchCell& cell);

/// Place of lattice coordinates in the texture plane [mm].
Vec2 place(const PatchDivision& division, const Vec2& lattice);
inline Vec2 place(const PatchDivision& division, const LatticePoint& lattice) {
  return place(division, to_vec(lattice));
}

/// Corners of a patch in lattice coordinates, counter-clockwise. Neighbouring patches share corners
/// and edges, and a patch's outline has its own lattice points inside and no others.
Polygon outline_in_lattice(const PatchPattern& pattern, const PatchCell& cell);

/// Outlines of all patches in the texture plane [mm], in milling order.
std::vector<Polygon> outlines(const PatchDivision& division);

/// All lattice points in milling order, not yet on a surface: `surface` is unset and `state` is
/// Cut. Errors: as require_valid, and InputError naming Spacing if there are more than
/// `max_dimples`.
Dimples lattice_points(const PatchDivision& division, std::int64_t max_dimples = 20000000);

/// Distance in the texture plane that the tool goes between patches, from the last dimple of each
/// to the first of the next, summed up [mm].
double link_length(const PatchDivision& division);

}  // namespace patchmill::patch
