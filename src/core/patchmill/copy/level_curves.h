// Level curves of a function of two variables, by marching squares with each crossing found to a
// tolerance on the function itself: contours of the height of the ball over the part (contour-line
// mode), and the section of the part's offset surface (scanning with undercuts).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <functional>
#include <vector>

namespace patchmill::copy {

/// Nodes at origin + pitch (i, j), 0 <= i < columns, 0 <= j < rows.
struct PlanarGrid {
  Vec2 origin = Vec2::Zero();
  double pitch = 0.0;  ///< [mm], > 0
  int columns = 0, rows = 0;
};

/// The grid that covers [lo, hi] and half a pitch more on each side.
/// Errors: InputError if it would have more than 5e7 nodes.
PlanarGrid planar_grid(const Vec2& lo, const Vec2& hi, double pitch);

/// A curve of equal height.
struct Polyline {
  std::vector<Vec2> points;
  bool closed = false;  ///< the last point is joined to the first, which is not repeated
};

/// Negative on one side of the curve and positive on the other; may be infinite, may jump. Called
/// from several threads at once.
using PlanarFunction = std::function<double(const Vec2&)>;

/// All curves f = 0 with f < 0 on their left. Points lie on grid edges, where f changes its sign
/// within `tolerance` [mm]; they are on the side f >= 0. Details smaller than the pitch may be
/// missed.
std::vector<Polyline> level_curves(const PlanarGrid& grid, const PlanarFunction& f,
                                   double tolerance);

}  // namespace patchmill::copy
