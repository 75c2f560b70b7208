// A shallow tree that bounds how high the triangles under a node can lift a ball that rests on them. A node
// has eight children, whose bounds are made side by side in one vector of floats (shallow trees: Dammertz,
// Hanika & Keller 2008, section 3); a child is another node or one triangle.
//
// With the ball's axis at c in the plan, radius R, d the distance in the plan from c to the child's box:
//  - on its box the ball rests no higher than       z_top + sqrt(R^2 - d^2)            (none for d >= R);
//  - under its lid, a plane z = g . p + h over all its triangles, no higher than
//                                                   g . c + h + R sqrt(1 + |g|^2) - e^2 / 2R,
//    e the distance from the place q = c + R g / sqrt(1 + |g|^2), where the ball would touch the lid, to the
//    box: a contact that far from q lowers the centre by e^2 / 2R or more, for sqrt(R^2 - r^2) curves down by
//    1 / R or more. Over a smooth surface the lid is off by the square of the child's size only.
// Everything is rounded so that a bound is never too low.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/geometry/vec.h"

#include <cstdint>
#include <vector>

namespace patchmill {

struct Triangle {
  Vec3 a, b, c;
};

constexpr int kDropWidth = 8;

/// Eight children. Lengths are in mm from the middle of the mesh; boxes and lids are a little too large.
struct alignas(64) DropNode {
  using Row = float[kDropWidth];
  Row lo_x, hi_x, lo_y, hi_y, top;        ///< box; an unused child has lo > hi
  Row slope_x, slope_y, height, stretch;  ///< lid; stretch = sqrt(1 + |slope|^2)
  std::int32_t child[kDropWidth];         ///< >= 0: a node; below: ~index of a triangle
};

class DropTree {
 public:
  DropTree() = default;
  /// Over triangles whose halves, halves of halves, and so on lie close together (the leaves of a tree that
  /// was split at the middle of its list). At least one.
  explicit DropTree(const std::vector<Triangle>& triangles);

  const std::vector<DropNode>& nodes() const { return nodes_; }  ///< node 0 is the root
  const Vec3& middle() const { return middle_; }

 private:
  struct Span;
  void add(std::size_t at, int halvings, const Span& span);
  void bound(DropNode& node, std::size_t lane, const Span& span) const;
  std::vector<DropNode> nodes_;
  Vec3 middle_ = Vec3::Zero();
  double extent_ = 0.0;  // largest distance from the middle along an axis
};

/// A ball over (x, y) as the bounds want it: from the middle of the tree, and a little too large.
struct DropBall {
  float low_x, high_x, low_y, high_y;  ///< its place, give or take rounding
  float ahead;                         ///< R, for the place of the contact
  float radius, radius2, half_curve;   ///< R and R^2 rounded up; 1 / 2R rounded down
};
DropBall drop_ball_over(const DropTree& tree, double x, double y, double radius);

/// How high the children of a node can lift the ball's centre, from the middle of the tree [mm]; -infinity
/// for a child that cannot lift it above `best` or that the ball does not reach. Never too low.
void drop_bounds(const DropNode& node, const DropBall& ball, float best, DropNode::Row& bound);

}  // namespace patchmill
