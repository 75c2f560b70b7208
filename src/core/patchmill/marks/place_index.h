// Nearest of a set of places in the plane, by buckets.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <cstddef>
#include <vector>

namespace patchmill::marks {

/// Places in the plane, found by where they are.
class PlaceIndex {
 public:
  static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

  /// Keeps a copy of the places [mm], which are finite.
  explicit PlaceIndex(std::vector<Vec2> places);

  /// Number of the place nearest to `at`, of equal ones the first, not counting `except`; kNobody
  /// if there is no other.
  std::size_t nearest(const Vec2& at, std::size_t except = kNobody) const;

  /// Numbers of the places within `radius` of `at`, ascending.
  std::vector<std::size_t> within(const Vec2& at, double radius) const;

 private:
  int column_of(double x) const;
  int row_of(double y) const;

  std::vector<Vec2> places_;
  Vec2 low_ = Vec2::Zero();
  double size_ = 1.0;  // of a bucket
  int columns_ = 1, rows_ = 1;
  std::vector<std::size_t> first_, numbers_;  // of bucket b: numbers_[first_[b] .. first_[b + 1])
};

}  // namespace patchmill::marks
