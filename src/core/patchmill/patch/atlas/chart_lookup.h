// ChartLookup: from places in the plane to parameters and back, over a flattened mesh. Places between the
// vertices are interpolated in space and brought on the face where it is nearest.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/atlas/chart.h"
#include "patchmill/patch/atlas/flatten.h"

namespace patchmill::patch {

/// Goes between the parameters of a face and the places of its chart.
class ChartLookup {
 public:
  /// `flat` are the places of the mesh's vertices, `fit` says of each triangle whether it is of use.
  ChartLookup(const CurvedFace& face, ChartMesh mesh, std::vector<Vec2> flat,
              std::vector<char> fit);

  /// Place in the plane [mm] of parameters.
  Vec2 flat(const Vec2& uv) const;
  /// Parameters of a place in the plane [mm]; nothing beyond the mesh.
  std::optional<Chart::Place> uv(const Vec2& flat) const;

  /// The mesh over the parameters.
  const ChartMesh& mesh() const { return mesh_; }
  /// Places in the plane of the mesh's vertices [mm].
  const std::vector<Vec2>& places() const { return flat_; }
  /// Of all places [mm].
  const Box2& bounds() const { return bounds_; }

 private:
  static constexpr int kMostBuckets = 128;
  using Weights = Eigen::Vector3d;

  Vec2 corner(std::size_t triangle, int k) const;
  Weights weights(std::size_t triangle, const Vec2& flat) const;
  int triangle_at_uv(const Vec2& uv) const;
  Vec2 nearest_on_face(Vec2 uv, const Vec3& point) const;
  int bucket(double x, int axis) const;

  const CurvedFace& face_;
  ChartMesh mesh_;
  std::vector<Vec2> flat_;
  std::vector<char> fit_;
  Box2 bounds_, uv_bounds_;
  int count_ = 1;                                       // buckets along each side
  std::vector<std::vector<int>> buckets_, uv_buckets_;  // triangles by place and by parameters
};

}  // namespace patchmill::patch
