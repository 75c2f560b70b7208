// The texture that was cut against the texture that was planned, dimple by dimple: missing, extra,
// moved by so much; and one figure for how good it is.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/marks/dimple_marks.h"
#include "patchmill/patch/dimple.h"

namespace patchmill::marks {

/// Where a mark was planned.
struct PlannedPlace {
  std::int32_t dimple = 0;    ///< its number in the plan
  Vec2 place = Vec2::Zero();  ///< plane coordinates [mm]
};

/// Places of all dimples of a plan that are to be cut, seen along the texture plane's direction.
std::vector<PlannedPlace> planned_places(const patch::Dimples& dimples,
                                         const patch::TexturePlane& plane);

/// What became of one planned dimple.
struct DimpleMatch {
  std::int32_t dimple = 0;
  std::int32_t found = -1;    ///< index of the dimple found there; -1: missing
  Vec2 moved = Vec2::Zero();  ///< from the plan to where it was found [mm]
};

/// How marks that were found lie against those that were planned.
struct PlanComparison {
  std::vector<DimpleMatch> matches;  ///< one per planned dimple, in the plan's order
  std::vector<std::int32_t> extra;   ///< indices of dimples found that were not planned
  std::int64_t missing = 0;
  Vec2 mean_move = Vec2::Zero();  ///< of those that were found [mm]
  double rms_move = 0.0;          ///< [mm]; NaN if none was found
  double largest_move = 0.0;      ///< [mm]
  double rms_share = 0.0;         ///< rms_move as a share of the spacing
  double mean_depth = 0.0;        ///< of those that were found [mm]
  double depth_deviation = 0.0;   ///< standard deviation [mm]
  /// Sum over planned dimples of max(0, 1 - (4 move / spacing)²), 0 for a missing one, divided by
  /// the number of planned and extra dimples: 1 for a texture as planned; 0 if nothing is nearer to
  /// its place than a quarter of the spacing.
  double quality = 0.0;
};

/// A planned and a found dimple belong together if each is the other's nearest and they are at most
/// half a `spacing` [mm] apart. Only planned places inside the grid of the relief should be given.
/// Errors: InputError naming Spacing.
PlanComparison compare_with_plan(const std::vector<DimpleMark>& found,
                                 const std::vector<PlannedPlace>& planned, double spacing);

}  // namespace patchmill::marks
