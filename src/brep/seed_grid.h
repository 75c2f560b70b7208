// Starting values for the projection of points on a surface: the surface's parameter rectangle is
// cut into cells, coarse where it is flat, and each point of the texture plane is told the cells
// over which it lies. Folds of the surface give several cells, one for each layer.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <functional>
#include <vector>

namespace patchmill {

struct ParameterBox {
  double u0, u1, v0, v1;
};

/// A place where Newton's method may start.
struct Seed {
  double u, v;
};

class SeedGrid {
 public:
  /// `plan(u, v)`: where the surface point lies in the texture plane, along the projection
  /// direction. `u_cells`, `v_cells`: a first guess of how many cells it takes; doubled (up to 128)
  /// until the cells are flat: middles within 2 % of the cell's diagonal from where bilinear
  /// interpolation puts them, and within 0.5 % as long as that takes no more than 64 cells a side.
  SeedGrid(const std::function<Vec2(double, double)>& plan, const ParameterBox& box, int u_cells,
           int v_cells);

  /// Appends a seed for every cell that lies over `p`, with a margin of 15 % of a cell. In a fixed
  /// order.
  void seeds(const Vec2& p, std::vector<Seed>& out) const;

  Vec2 low() const { return low_; }    ///< least plan coordinates of the cells [mm]
  Vec2 high() const { return high_; }  ///< greatest
  /// How far beyond low() and high() a place may be and still have seeds [mm].
  Vec2 reach() const { return 1.001 * bin_size_; }

 private:
  void sample(const std::function<Vec2(double, double)>& plan);
  // greatest distance of a cell's middle from its bilinear one, in cell diagonals; stops at kFlat
  double most_bend(const std::function<Vec2(double, double)>& plan) const;
  void bin();
  const Vec2& corner(int i, int j) const {
    return corners_[std::size_t(j) * std::size_t(nu_ + 1) + std::size_t(i)];
  }

  ParameterBox box_;
  int nu_, nv_;
  std::vector<Vec2> corners_;
  Vec2 low_, high_;
  // bins over the plan, each with the cells that may lie over it
  int bins_x_ = 1, bins_y_ = 1;
  Vec2 bin_size_ = Vec2::Ones();
  std::vector<int> bin_begin_, bin_cells_;
};

}  // namespace patchmill
