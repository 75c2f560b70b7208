// The search of fit_length.h about one grid point, for any length: what does not depend on the length is done once.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/sync/corner_legs.h"

namespace patchmill::sync {

class BestCorner;

/// How far to the side a corner of a way of `length` is moved [units].
int steps_aside(double length, double unit);

/// The corners about a base, by how much the way over each misses a length.
class CornerSearch {
 public:
  CornerSearch() = default;
  /// About `base`, the grid point next to `ideal`; up to `reach` steps to the side.
  CornerSearch(const Vec3& a, const Vec3& ideal, const Vec3& b, const Vec3& base, int reach,
               double unit);

  const Vec3& base() const { return base_; }
  int reach() const { return reach_; }
  /// Whether an ideal corner on the same side of the way, but for rounding, has the same axes.
  bool clear() const { return clear_; }
  /// The corner that the search chooses; not yet rounded.
  Vec3 best(double length, double good_enough) const;

 private:
  static constexpr int kLevels = 9;
  using Levels =
      Eigen::Array<float, 12,
                   1>;  // of the steps along X and Y at the base; the last three are none
  /// What a corner aside comes to.
  struct Aside {
    Vec3 corner;
    double miss;
    bool predicted;  ///< well enough for one_by_one() not to leave it out
  };
  /// How far the misses at the base may be off.
  double off_at_base(double length) const;
  Levels at_base(double length) const;
  void try_base(double length, const Levels& misses, BestCorner& best) const;
  Vec3 corner(int side, int lift) const;
  Aside aside(int side, double length) const;
  bool first_aside(double length, double good_enough, double off, BestCorner& best,
                   double& least) const;
  bool best_aside(double length, double off, double least, BestCorner& best) const;
  void one_by_one(double length, double good_enough, BestCorner& best) const;

  Vec3 a_ = Vec3::Zero(), b_ = Vec3::Zero(), base_ = Vec3::Zero();
  double unit_ = 0.0;
  int reach_ = 0;
  Eigen::Index side_ = 0, lift_ = 0;  // axes along which it is moved, and lifted to make up for it
  bool clear_ = false;
  double way_ = 0.0,
         bound_ = 0.0;  // over the base; of what is left out beyond the first order next to it
  Vec3 slope_ = Vec3::Zero();      // of the way, for one unit along each axis
  Levels level_ = Levels::Zero();  // what the way changes by
  Legs legs_;
};

}  // namespace patchmill::sync
