// Distance of a point from a closed mesh, negative inside. The parity of crossings along a line tells the side; where
// the nearest point lies on a face, or where faces that meet hardly differ, the face's normal tells it at once.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/triangle_bvh.h"

#include <vector>

namespace patchmill::mesh {

/// Normals of a mesh, and which triangles are smooth: all that touch them, at a corner only too, have normals within
/// 80 degrees of each other.
class SmoothFaces {
 public:
  /// Of the triangles of a closed mesh, as they are numbered in it.
  explicit SmoothFaces(const TriangleMesh& mesh);

  /// Whether the normal of the triangle tells on which side of the mesh `p` is, whose nearest point is `near`; then
  /// `height` is that of `p` over the triangle's plane [mm].
  bool tells_side(const ClosestPoint& near, const Vec3& p, double& height) const;

 private:
  std::vector<Vec3> normal_;
  std::vector<char> smooth_;
};

/// Distance from a closed mesh [mm], negative inside; the side by parity alone.
double signed_distance(const TriangleBvh& bvh, const Vec3& p);

/// The same, faster; `faces` are of the mesh of the tree.
double signed_distance(const TriangleBvh& bvh, const SmoothFaces& faces, const Vec3& p);

}  // namespace patchmill::mesh
