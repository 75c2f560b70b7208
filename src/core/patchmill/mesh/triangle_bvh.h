// A tree of boxes over the triangles of a mesh: one structure for the closest point, for lines
// through the solid, and for dropping a ball on it (patchmill/copy/drop_cutter.h). Built once, then read
// by any number of threads. The same mesh gives the same tree.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/drop_tree.h"
#include "patchmill/mesh/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace patchmill::mesh {

/// A box of the tree.
struct BvhNode {
  Vec3 lo, hi;
  std::int32_t first = 0;  ///< leaf: index into `order`; inner: number of the left child
  std::int32_t count = 0;  ///< leaf: how many triangles; inner: 0, and the right child is first + 1
};

/// A tree of boxes over the triangles of a mesh.
class TriangleBvh {
 public:
  /// Errors: InputError if the mesh has no triangle.
  explicit TriangleBvh(const TriangleMesh& mesh);

  const std::vector<BvhNode>& nodes() const { return nodes_; }  ///< node 0 is the root
  const DropTree& drops() const { return drops_; }              ///< over triangles()
  /// Triangles in the order of the leaves, and what their numbers in the mesh are.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// Number in the mesh of each of triangles().
  const std::vector<std::int32_t>& order() const { return order_; }

 private:
  std::int32_t split(std::int32_t node, const std::vector<Vec3>& middle, const TriangleMesh& mesh);
  std::vector<BvhNode> nodes_;
  DropTree drops_;
  std::vector<Triangle> triangles_;
  std::vector<std::int32_t> order_;
};

/// The nearest point of a mesh.
struct ClosestPoint {
  std::int32_t triangle = -1;  ///< number in the mesh; -1 if none is within reach
  Vec3 point = Vec3::Zero();
  Vec3 barycentric = Vec3::Zero();  ///< weights of the triangle's corners
  double distance = std::numeric_limits<double>::infinity();
};

/// The point of a triangle nearest to `p`.
Vec3 closest_on(const Triangle& triangle, const Vec3& p);

/// The point of the mesh nearest to `p`, among those nearer than `reach` [mm].
ClosestPoint closest_point(const TriangleBvh& bvh, const Vec3& p,
                           double reach = std::numeric_limits<double>::infinity());

/// Whether a triangle of the mesh is no further than `reach` [mm] from `p` in a direction within the angle
/// whose cosine is `least` of its normal, on either side: over it, not beyond its edge.
bool is_over(const TriangleBvh& bvh, const Vec3& p, double reach, double least);

/// The x [mm] at which the line (y, z) parallel to the x axis crosses the mesh, ascending. For a
/// closed mesh the number is even and the line is inside between the 1st and 2nd, the 3rd and
/// 4th...: a line through an edge or a vertex counts each passage once (see parity.h).
std::vector<double> line_crossings(const TriangleBvh& bvh, double y, double z);

/// Whether a point is inside a closed mesh: by the parity of crossings along x.
bool inside(const TriangleBvh& bvh, const Vec3& p);

}  // namespace patchmill::mesh
