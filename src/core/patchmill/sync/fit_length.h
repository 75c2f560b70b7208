// A corner point on the program's decimals such that the way over it has a wanted length. One
// micron of length is 0.83 degrees of phase at the paper's F and S, so of the grid points near the
// ideal corner the one is taken that fits best.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/rounding.h"
#include "patchmill/sync/corner_legs.h"

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

/// Along which axes a corner is moved aside, and lifted to make up for it.
struct Aside {
  Aside() = default;
  Aside(const Vec3& a, const Vec3& ideal, const Vec3& b, const Vec3& base, double length,
        double unit);
  Vec3 side = Vec3::Zero(), lift = Vec3::Zero();
  int reach = 0;       ///< steps to the side
  bool clear = false;  ///< the axes are the same for lengths nearby
  Legs legs;
};

/// What fit_corner() finds for lengths that are not known to the last yet: all of it that does not depend on them is
/// done ahead, on any thread, since the lengths themselves come out one after the other.
class CornerAhead {
 public:
  /// Holds for no length.
  CornerAhead() = default;
  /// For lengths within `good_enough` of `length` [mm]; their ideal corners lie between those of the least and of the
  /// greatest, in each coordinate.
  CornerAhead(const Vec3& a, const Vec3& b, const Vec3& low_ideal, const Vec3& high_ideal,
              double length, const Decimals& decimals, double good_enough);

  /// Whether fit() may be asked.
  bool holds_for(double length) const { return length >= low_ && length <= high_; }
  /// The corner that fit_corner() finds, to the last bit.
  Vec3 fit(double length, const Decimals& decimals) const;

 private:
  static constexpr int kMostNear = 6;
  Vec3 a_ = Vec3::Zero(), b_ = Vec3::Zero(), base_ = Vec3::Zero();
  double good_ = 0.0, unit_ = 0.0;
  double low_ = 1.0, high_ = 0.0;  // lengths
  int near_ = 0;                   // how many of the 27 points at the base may be the best
  double ways_[kMostNear] = {};
  int steps_[kMostNear] = {};
  Aside aside_;
};

}  // namespace patchmill::sync
