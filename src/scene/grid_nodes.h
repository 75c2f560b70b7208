// A surface given at the points of a grid, with a value for the colour at each: the simulated relief.
// Cut into chunks, each with coarser copies of itself that are drawn where it is small on the screen, so
// that 10^7 points stay movable.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"
#include "scene/display.h"

#include <cstddef>

namespace patchmill::scene {

/// Rows by columns of points [mm], x y z each, row after row; `values` one to a point. Points that are
/// not finite, and the cells at them, are left out.
struct Grid {
  std::size_t rows = 0, columns = 0;
  const double* points = nullptr;
  const double* values = nullptr;
  double low = 0.0, high = 1.0;  ///< values that get the ends of the colour scale

  Vec3 point(std::size_t row, std::size_t column) const {
    return Eigen::Map<const Vec3>(points + 3 * (row * columns + column));
  }
};

/// Lit triangles. Errors: InputError naming Grid if it has fewer than two rows or columns.
Display grid_display(const Grid& grid);

}  // namespace patchmill::scene
