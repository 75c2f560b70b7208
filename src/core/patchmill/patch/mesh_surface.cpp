// A mesh with all that is looked for on it; see mesh_sampler.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/error.h"
#include "patchmill/mesh/mesh_region.h"
#include "patchmill/patch/mesh_sampler.h"

#include <algorithm>
#include <cmath>

namespace patchmill::patch {
namespace {

Vec3 area_vector(const mesh::TriangleMesh& mesh, const std::array<std::int32_t, 3>& t) {
  const Vec3& a = mesh.vertices[std::size_t(t[0])];
  const Vec3 ab = mesh.vertices[std::size_t(t[1])] - a, ac = mesh.vertices[std::size_t(t[2])] - a;
  return 0.5 * ab.cross(ac);
}

mesh::TriangleMesh checked(mesh::TriangleMesh mesh, Angle crease) {
  mesh::require_indices(mesh, "Mesh");
  require_in_range("Crease", crease.degrees(), 0.0, 90.0, "degrees");
  const bool some = std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                                [&](const auto& t) { return area_vector(mesh, t).norm() > 0.0; });
  if (!some) throw InputError("Mesh", "no area", "give triangles whose corners are apart.");
  return mesh;
}

// A triangle without area has no normal: its corners take the mean of all that meet there.
void give_normals_to_flat_ones(const mesh::TriangleMesh& mesh,
                               std::vector<std::array<Vec3, 3>>& normals) {
  std::vector<std::size_t> without;
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (normals[i][0].isZero(0.0) || normals[i][1].isZero(0.0) || normals[i][2].isZero(0.0))
      without.push_back(i);
  if (without.empty()) return;
  std::vector<Vec3> sums(mesh.vertices.size(), Vec3::Zero());
  for (const auto& t : mesh.triangles)
    for (const std::int32_t v : t) sums[std::size_t(v)] += area_vector(mesh, t);
  for (const std::size_t i : without)
    for (std::size_t k = 0; k < 3; ++k)
      normals[i][k] = sums[std::size_t(mesh.triangles[i][k])].normalized();
}

}  // namespace

MeshSurface::MeshSurface(mesh::TriangleMesh mesh, Angle crease)
    : mesh_(checked(std::move(mesh), crease)),
      bvh_(mesh_),
      normals_(mesh::corner_normals(mesh_, crease)) {
  give_normals_to_flat_ones(mesh_, normals_);
}

std::vector<Vec3> MeshSurface::area_vectors() const {
  std::vector<Vec3> vectors;
  vectors.reserve(mesh_.triangles.size());
  for (const auto& t : mesh_.triangles) vectors.push_back(area_vector(mesh_, t));
  return vectors;
}

std::vector<Segment3> MeshSurface::border() const {
  std::vector<Segment3> border;
  for (const auto& [a, b] : mesh::border_edges(mesh_)) border.push_back({a, b});
  return border;
}

Angle MeshSurface::normal_deviation() const {
  Angle greatest = Angle::radians(0.0);
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    const Vec3 own = area_vector(mesh_, mesh_.triangles[i]);
    if (own.isZero(0.0)) continue;
    for (const Vec3& n : normals_[i]) greatest = std::max(greatest, Angle::between(own, n));
  }
  return greatest;
}

double MeshSurface::chord_height() const {
  double greatest = 0.0;
  for (std::size_t i = 0; i < normals_.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Vec3 edge = mesh_.vertices[std::size_t(mesh_.triangles[i][next])] -
                        mesh_.vertices[std::size_t(mesh_.triangles[i][k])];
      greatest = std::max(greatest, std::abs(edge.dot(normals_[i][next] - normals_[i][k])) / 8.0);
    }
  return greatest;
}

}  // namespace patchmill::patch
