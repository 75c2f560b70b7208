// A shallow tree over the triangles of a mesh, for a ball that is lowered on them (patchmill/mesh/drop_bounds.h says
// how high). A node has eight children, side by side in vectors of floats (shallow trees: Dammertz, Hanika &
// Keller 2008, section 3); a leaf has up to eight triangles. Of all triangles under a child it keeps
//   - their box;
//   - their upper bounding plane, z = g . p + h over all of them, g their mean slope;
// and a leaf of each triangle, for the plane z = g . p + h that it lies in,
//   - its three sides, lines in the plan: side(p) = n . p + c is 0 or less for p over the triangle, and beyond a side
//     the distance to it along the plane.
// Everything is rounded so that no triangle sticks out.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <cstdint>
#include <vector>

namespace patchmill::mesh {

/// Three corners [mm].
struct Triangle {
  Vec3 a, b, c;
};

constexpr int kDropWidth = 8;

/// Eight children. Lengths are in mm from the middle of the mesh.
struct alignas(64) DropNode {
  /// One value for each child.
  using Row = float[kDropWidth];
  Row lo_x, hi_x, lo_y, hi_y, top;        ///< box; an unused child has lo > hi
  Row slope_x, slope_y, height, stretch;  ///< upper bounding plane; stretch = sqrt(1 + |slope|^2)
  std::int32_t
      child[kDropWidth];  ///< of a node: >= 0 a node, below: ~ a leaf; of a leaf: a triangle
};

/// Triangles that are tried side by side.
struct DropLeaf {
  DropNode node;
  DropNode::Row side_x[3], side_y[3], side_c[3];
};

/// The tree of bounds that balls are dropped with.
class DropTree {
 public:
  DropTree() = default;
  /// Over triangles whose halves, halves of halves, and so on lie close together (the leaves of a tree that
  /// was split at the middle of its list). At least one.
  explicit DropTree(const std::vector<Triangle>& triangles);

  const std::vector<DropNode>& nodes() const { return nodes_; }  ///< node 0 is the root
  /// Its leaves, in the order of their triangles.
  const std::vector<DropLeaf>& leaves() const { return leaves_; }
  /// Middle of all triangles, from which bounds are counted [mm].
  const Vec3& middle() const { return middle_; }
  double extent() const {
    return extent_;
  }  ///< largest distance from the middle along an axis [mm]

 private:
  struct Span;
  std::int32_t add_node(int halvings, const Span& span);
  std::int32_t add_leaf(const Span& span);
  void bound(DropNode& node, int lane, const Span& span) const;
  void bound_sides(DropLeaf& leaf, int lane, const Triangle& triangle) const;
  std::vector<DropNode> nodes_;
  std::vector<DropLeaf> leaves_;
  Vec3 middle_ = Vec3::Zero();
  double extent_ = 0.0;
};

/// A leaf without triangles.
DropLeaf empty_drop_leaf();
/// Triangle `lane` of one leaf becomes triangle `to_lane` of another.
void copy_triangle(const DropLeaf& from, int lane, DropLeaf& to, int to_lane);

}  // namespace patchmill::mesh
