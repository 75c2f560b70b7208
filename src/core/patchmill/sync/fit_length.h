// A corner point on the program's decimals such that the way over it has a wanted length. One
// micron of length is 0.83 degrees of phase at the paper's F and S, so of the grid points near the
// ideal corner the one is taken that fits best.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/rounding.h"
#include "patchmill/sync/corner_search.h"

#include <array>
#include <optional>

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

/// The ideal corners of a step from `a` to `b` on two equal legs, the nearest way to `up` out of the way between them:
/// apex() for any length.
class Apexes {
 public:
  Apexes(const Vec3& a, const Vec3& b, const Vec3& up);
  /// Of legs of `length` together [mm]; between `a` and `b` if that is too short.
  Vec3 at(double length) const {
    const double h = 0.5 * std::sqrt(std::max(0.0, length * length - square_));
    return middle_ + h * up_;
  }
  /// {least, greatest} length of those whose ideal corner is `height` over the way or higher, and rounded to `base`
  /// [mm]; spared is what rounding may add.
  std::array<double, 2> lengths(double height, const Vec3& base, double unit) const;

 private:
  Vec3 middle_, up_;
  double square_;  // of the way from a to b
};

/// What fit_corner() finds for lengths that are not known to the last yet: all of it that does not depend on them is
/// done ahead, on any thread, since the lengths themselves come out one after the other.
class CornerAhead {
 public:
  /// Of no corner.
  CornerAhead() = default;
  /// For lengths about `length` [mm], with ideal corners over the way from `a` to `b` as apex() has them.
  CornerAhead(const Vec3& a, const Vec3& b, const Vec3& up, double length,
              const Decimals& decimals);

  /// The corner that fit_corner() finds, to the last bit; nothing where that may be about another grid point.
  std::optional<Vec3> fit(double length, const Decimals& decimals, double good_enough) const {
    if (!(length >= low_ && length <= high_)) return std::nullopt;
    return decimals.round(search_.best(length, good_enough));
  }

 private:
  CornerSearch search_;
  double low_ = 1.0, high_ = 0.0;  // lengths
};

}  // namespace patchmill::sync
