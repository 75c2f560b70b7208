// The dimples of a relief: what a tooth pass leaves is a hollow with a lowest point and, where it
// meets its neighbours, ridges. Each cell belongs to the hollow into which water would run from it;
// hollows that are shallower than a limit are dents in a larger one and are merged with it,
// shallowest first.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/marks/relief.h"

namespace patchmill::marks {

/// A dimple that was found.
struct DimpleMark {
  Vec2 place = Vec2::Zero();  ///< of the lowest point, plane coordinates [mm]; finer than the grid
  Vec3 point = Vec3::Zero();  ///< the same in the work frame, on the relief [mm]
  double bottom = 0.0;        ///< height of the lowest point over the base [mm]
  /// Lowest point of the rim, where it would overflow, above the bottom [mm].
  double depth = 0.0;
  /// Diameter of the circle with the area of its hollow, in the texture plane [mm].
  double diameter = 0.0;
  /// Whether the hollow touches the edge of the grid or of the base: depth and diameter are then of
  /// the part that is seen.
  bool at_edge = false;
};

/// What counts as a dimple.
struct FindOptions {
  double least_depth = 0.002;  ///< hollows not so deep are dents [mm]
};

/// Dimples in order of grid row and column of their lowest cell. Cells at the stock's height were
/// never cut and belong to none. Errors: InputError naming LeastDepth (negative or not finite).
std::vector<DimpleMark> find_dimples(const Relief& relief, const FindOptions& options = {});

/// Mean distance from a dimple to the nearest other one [mm]; NaN for fewer than two.
double mean_spacing(const std::vector<DimpleMark>& dimples);

}  // namespace patchmill::marks
