// The search for the triangle that lifts a ball highest, over one place. A tree of upper bounds
// (patchmill/mesh/drop_bounds.h) is searched from the highest bound down, and what cannot lift the ball above the best
// contact so far is left out: branch and bound (Land & Doig 1960).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/copy/drop_cutter.h"
#include "patchmill/mesh/drop_bounds.h"

namespace patchmill::copy {

/// One ball that is dropped: the best triangle so far, and what may still lift it.
class DropSearch {
 public:
  /// For a ball of `radius` [mm, > 0] over (x, y) [mm]. What does not lift it above `floor` may be left out.
  DropSearch(const mesh::TriangleBvh& bvh, double x, double y, double radius,
             double floor = kNoContact);

  double height() const { return height_; }  ///< best so far [mm]; kNoContact: none
  std::int32_t triangle() const {
    return triangle_;
  }  ///< index into TriangleBvh::triangles(); -1: none

  /// Tries a triangle by its index; first of all one that is likely to be the highest.
  void touch(std::int32_t triangle);
  /// Tries the triangles of a leaf that can be higher than the best so far, or the whole tree's.
  void look_at(const mesh::DropLeaf& leaf);
  /// Tries all triangles of the tree that can be higher than the best so far.
  void look_at_all();

 private:
  const mesh::TriangleBvh& bvh_;
  double x_, y_, radius_, floor_;
  mesh::DropBall ball_;
  double height_ = kNoContact;
  float lowest_;  // what a bound must be above
  std::int32_t triangle_ = -1, guess_ = -1;
};

}  // namespace patchmill::copy
