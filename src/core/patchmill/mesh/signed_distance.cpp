// Nearest triangle and side of it; see signed_distance.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/mesh/signed_distance.h"

#include <algorithm>
#include <cmath>

namespace patchmill::mesh {
namespace {

const double kMaxDihedral = std::cos(80.0 * kPi / 180.0);

double with_side(const TriangleBvh& bvh, const Vec3& p, double distance) {
  return inside(bvh, p) ? -distance : distance;
}

}  // namespace

SmoothFaces::SmoothFaces(const TriangleMesh& mesh)
    : normal_(mesh.triangles.size()), smooth_(mesh.triangles.size()) {
  std::vector<std::vector<std::int32_t>> around(mesh.vertices.size());
  for (std::size_t i = 0; i < normal_.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const Vec3 a = mesh.vertices[t[0]];
    normal_[i] = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized();
    for (const std::int32_t v : t)
      around[static_cast<std::size_t>(v)].push_back(static_cast<std::int32_t>(i));
  }
  std::vector<char> smooth(mesh.vertices.size(), 1);
  for (std::size_t v = 0; v < around.size(); ++v) {
    if (around[v].size() > 1000) smooth[v] = 0;  // the parity then tells
    if (smooth[v] == 0) continue;
    for (const std::int32_t a : around[v])
      for (const std::int32_t b : around[v])
        if (!(normal_[static_cast<std::size_t>(a)].dot(normal_[static_cast<std::size_t>(b)]) >
              kMaxDihedral))
          smooth[v] = 0;
  }
  for (std::size_t i = 0; i < normal_.size(); ++i) {
    const auto& t = mesh.triangles[i];
    smooth_[i] = std::all_of(t.begin(), t.end(),
                             [&](std::int32_t v) { return smooth[static_cast<std::size_t>(v)]; });
  }
}

bool SmoothFaces::tells_side(const ClosestPoint& near, const Vec3& p, double& height) const {
  const auto i = static_cast<std::size_t>(near.triangle);
  height = (p - near.point).dot(normal_[i]);
  const bool on_face = near.barycentric.minCoeff() > 1e-9;
  // u in the cone of normals that are all within 80 degrees of each other: u . n >= cos 80
  return (on_face || smooth_[i]) && std::abs(height) >= 0.99 * kMaxDihedral * near.distance;
}

double signed_distance(const TriangleBvh& bvh, const Vec3& p) {
  return with_side(bvh, p, closest_point(bvh, p).distance);
}

double signed_distance(const TriangleBvh& bvh, const SmoothFaces& faces, const Vec3& p) {
  const ClosestPoint near = closest_point(bvh, p);
  double height = 0.0;
  if (faces.tells_side(near, p, height)) return std::copysign(near.distance, height);
  return with_side(bvh, p, near.distance);
}

}  // namespace patchmill::mesh
