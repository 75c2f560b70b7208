// Which of many faces may lie over a place of the texture plane: bins over the rectangles that the faces cover there,
// so that a place is not tried on every face.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <cstdint>
#include <vector>

namespace patchmill {

/// Least and greatest corner in the texture plane [mm].
struct PlanBox {
  Vec2 low, high;
};

class FaceBins {
 public:
  struct Range {
    const std::int32_t *first, *last;
    const std::int32_t* begin() const { return first; }
    const std::int32_t* end() const { return last; }
  };

  FaceBins() = default;
  /// `boxes`: one of each face, low <= high, finite; at least one.
  explicit FaceBins(const std::vector<PlanBox>& boxes);

  /// Numbers of the faces in whose box `p` may be, and perhaps some more, in rising order; of none if it is in no box.
  Range over(const Vec2& p) const;

 private:
  struct Bins {
    int x0, x1, y0, y1;
  };
  Bins bins_of(const PlanBox& box) const;
  int column(double x) const;
  int row(double y) const;

  PlanBox all_{};
  Vec2 size_ = Vec2::Ones();
  int columns_ = 1, rows_ = 1;
  std::vector<std::int32_t> begin_, faces_;
};

}  // namespace patchmill
