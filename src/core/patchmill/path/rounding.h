// Decimals: the grid on which a program's numbers lie. Coordinates are put on it before lengths are
// taken, so that what is planned is what the machine is told.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/vec.h"

#include <cmath>

namespace patchmill {

/// Numbers as a program with so many decimals has them.
class Decimals {
 public:
  /// Errors: InputError naming Decimals if `count` is not in 0..12.
  explicit Decimals(int count) : count_(count) {
    require_in_range("Decimals", count, 0, 12, "decimals");
    scale_ = std::pow(10.0, count);
  }
  /// How many decimals.
  int count() const { return count_; }
  double unit() const { return 1.0 / scale_; }  ///< distance of neighbouring numbers
  /// The nearest number with so many decimals.
  double round(double x) const { return std::round(x * scale_) / scale_; }
  /// The same of each coordinate.
  Vec3 round(const Vec3& p) const { return {round(p.x()), round(p.y()), round(p.z())}; }

 private:
  int count_;
  double scale_;
};

}  // namespace patchmill
