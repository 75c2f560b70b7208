// Where a relief lies below the surface that was wanted.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/marks/relief.h"

namespace patchmill::collision {

/// Cells that touch each other and lie below the base.
struct Gouge {
  Vec3 place = Vec3::Zero();        ///< its deepest point, on the relief [mm]
  Vec2 plane_place = Vec2::Zero();  ///< the same in plane coordinates [mm]
  double depth = 0.0;               ///< of that below the base [mm], > tolerance
  double area = 0.0;  ///< of the cells beyond the tolerance, in the texture plane [mm²]
};

/// Connected patches of cells more than `tolerance` [mm] below the base, deepest first. Cells
/// without a base are not looked at: their number is returned by count_missing, and is not a pass.
/// Errors: InputError naming Tolerance.
std::vector<Gouge> find_gouges(const marks::Relief& relief, double tolerance);

/// Cells without a base.
std::int64_t count_missing(const marks::Relief& relief);

}  // namespace patchmill::collision
