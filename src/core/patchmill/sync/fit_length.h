// A corner point on the program's decimals such that the way over it has a wanted length. One
// micron of length is 0.83 degrees of phase at the paper's F and S, so of the grid points near the
// ideal corner the one is taken that fits best.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/rounding.h"

namespace patchmill::sync {

inline double way_over(const Vec3& a, const Vec3& corner, const Vec3& b) {
  return (corner - a).norm() + (b - corner).norm();
}

/// Of the rounded points around `ideal` one with way_over(a, ., b) near `length`. First the 27
/// nearest are tried. If the best misses by more than `good_enough` [mm], the corner is moved
/// sideways, out of the plane of the legs: e units sideways lengthen the way by about 2 e² / L
/// only, so between the coarse steps of the grid there are fine ones; up to sqrt(L / unit) units
/// (0.05 mm at L = 2.2 mm and 3 decimals). The search order is fixed: same input, same result.
Vec3 fit_corner(const Vec3& a, const Vec3& ideal, const Vec3& b, double length,
                const Decimals& decimals, double good_enough);

}  // namespace patchmill::sync
