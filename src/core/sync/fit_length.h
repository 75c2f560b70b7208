// A corner point on the program's decimals such that the way over it has a wanted length. One
// micron of length is 0.83 degrees of phase at the paper's F and S, so of the grid points near the
// ideal corner the one is taken that fits best. SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/sync/rounding.h"

namespace patchmill {

inline double way_over(const Vec3& a, const Vec3& corner, const Vec3& b) {
  return (corner - a).norm() + (b - corner).norm();
}

/// Of the rounded points around `ideal` the one with way_over(a, ., b) nearest to `length`:
/// searched in a cube of 3, and of 5 and 7 points a side as long as the miss is more than
/// `good_enough` [mm]. Ties go to the first in x, y, z order, so the result does not depend on the
/// platform's sorting.
Vec3 fit_corner(const Vec3& a, const Vec3& ideal, const Vec3& b, double length,
                const Decimals& decimals, double good_enough);

}  // namespace patchmill
