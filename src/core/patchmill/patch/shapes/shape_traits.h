// ShapeTraits: all that is known of a patch shape, in one place. The patches of a shape are copies of one another
// (and, for some, of one that is turned half round) on two tiling vectors, so that every lattice point belongs
// to exactly one of them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/lattice.h"
#include "patchmill/patch/shapes/shape_list.h"

#include <string>
#include <vector>

namespace patchmill::patch {

#define PATCHMILL_SHAPE_NAME(name) name,
enum class PatchShape : std::uint8_t { PATCHMILL_PATCH_SHAPES(PATCHMILL_SHAPE_NAME) };
#undef PATCHMILL_SHAPE_NAME

/// How many dimples a patch has along its sides; what that means is its shape's.
struct PatchSize {
  int side = 0;
  int across = 0;  ///< along the other side, of shapes that have two
  /// Of shapes with one side the second counts for nothing.
  constexpr PatchSize(int along_side, int along_other = 0)
      : side(along_side), across(along_other) {}
};

using Polygon = std::vector<Vec2>;

/// All that is asked of a patch shape.
struct ShapeTraits {
  const char* name;  ///< as users choose it
  LatticeKind lattice;
  int turns;          ///< that bring a patch on itself, one of them none
  bool two_sided;     ///< whether `across` counts
  bool has_inverted;  ///< whether each cell has a second patch, turned half round
  bool in_columns;    ///< whether patches are milled column by column
  PatchSize least, greatest;
  const char* size_unit;  ///< of `side`, for messages
  std::int64_t (*point_count)(PatchSize);
  std::array<LatticePoint, 2> (*tiling_vectors)(PatchSize);
  /// Inward from the outline to the middle, each step one lattice step.
  std::vector<LatticePoint> (*helix)(PatchSize);
  /// One turn, counter-clockwise about the patch's middle, of a point of an upright patch.
  LatticePoint (*turned)(PatchSize, const LatticePoint&);
  /// The point of an inverted patch that a point of the upright one becomes; null if there are none.
  LatticePoint (*inverted)(PatchSize, const LatticePoint&);
  /// Corners in lattice coordinates, counter-clockwise, shared with the neighbours; its points inside and no others.
  Polygon (*outline)(PatchSize, bool inverted);
  /// Cell of the patch in column x and row y of a block, and whether it is the inverted one.
  std::pair<LatticePoint, bool> (*in_block)(PatchSize, int x, int y);
  /// Where, as seen from the middle of an area of `cells` lattice steps, the lattice's (0, 0) is put so that patches
  /// cover it evenly, in lattice steps of the texture plane.
  Vec2 (*anchor)(PatchSize, const Vec2& cells);
};

/// What is known of a shape; lives as long as the program.
const ShapeTraits& traits(PatchShape shape);

/// All of them, in the order in which they are offered.
const std::vector<PatchShape>& all_patch_shapes();

/// Number of corners of a patch's outline.
int corners(PatchShape shape);

/// Whether all sides and angles of a patch's outline are alike, as Matsuda's free form takes them.
bool is_regular(PatchShape shape);

/// Distance of neighbouring rows of dimples over the spacing.
double row_pitch(PatchShape shape);

}  // namespace patchmill::patch
