// Steady posture; see posture_field.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/posture_field.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/large_vector.h"

#include <algorithm>
#include <cmath>

namespace patchmill::dcm {
namespace {

std::vector<double> boundary_values(const PostureOptions& options, const Vec3& normal) {
  const PostureAngles angles = posture_angles(normal, options.limit);
  if (options.form == PostureForm::Angles) return {angles.theta.radians(), angles.phi.radians()};
  const Vec3 axis = posture_axis(angles);
  return {axis.x(), axis.y(), axis.z()};
}

Vec3 smooth_normal(const mesh::ClosestPoint& near, const std::vector<std::array<Vec3, 3>>& corner) {
  const auto& n = corner[near.triangle];
  const Vec3 sum =
      near.barycentric[0] * n[0] + near.barycentric[1] * n[1] + near.barycentric[2] * n[2];
  return sum.norm() > 1e-9 ? Vec3(sum.normalized()) : n[0];
}

// Calls `set(cell index, normal)` for each surface voxel, in parallel over bricks.
template <class Set>
void visit_surface(const voxel::VoxelGrid& grid, const mesh::TriangleMesh& part,
                   const mesh::TriangleBvh& bvh, Angle crease, const Set& set) {
  const auto corner = mesh::corner_normals(part, crease);
  patchmill::parallel_for(std::size_t{0}, grid.table.size(), [&](std::size_t brick) {
    const voxel::Cell first = voxel::first_cell(grid.table, brick);
    for (int n = 0; n < voxel::kBrickCells; ++n) {
      const std::size_t cell = brick * voxel::kBrickCells + n;
      if (grid.kind[cell] != voxel::VoxelKind::Surface) continue;
      const Vec3 centre = grid.frame.centre(first + voxel::Cell(n % 8, n / 8 % 8, n / 64));
      set(cell, smooth_normal(mesh::closest_point(bvh, centre), corner));
    }
  });
}

}  // namespace

PostureAngles posture_angles(const Vec3& n, Angle limit) {
  const double most = std::tan(limit.radians());
  const double across = std::max(std::abs(n.x()), std::abs(n.y()));
  if (across <= 1e-9 * n.norm()) return {};
  // scale so that the larger of |n_x|, |n_y| over the height is n's own ratio, or the limit
  const double height = n.z() > 0.0 ? std::max(n.z(), across / most) : across / most;
  return {Angle::radians(-std::atan(n.y() / height)), Angle::radians(std::atan(n.x() / height))};
}

Vec3 posture_axis(const PostureAngles& angles) {
  return Vec3(std::tan(angles.phi.radians()), -std::tan(angles.theta.radians()), 1.0).normalized();
}

std::vector<Vec3> surface_normals(const voxel::VoxelGrid& grid, const mesh::TriangleMesh& part,
                                  const mesh::TriangleBvh& bvh, Angle crease) {
  std::vector<Vec3> normal(grid.kind.size(), Vec3::Zero());
  visit_surface(grid, part, bvh, crease,
                [&](std::size_t cell, const Vec3& n) { normal[cell] = n; });
  return normal;
}

PostureField steady_posture(const voxel::VoxelGrid& grid, const mesh::TriangleMesh& part,
                            const mesh::TriangleBvh& bvh, const PostureOptions& options,
                            const Progress& progress) {
  require_in_range("posture limit", options.limit.degrees(), 0.1, 89.0, "degrees");
  require_in_range("crease", options.crease.degrees(), 0.0, 180.0, "degrees");
  const std::vector<double> upright = boundary_values(options, Vec3::UnitZ());
  const std::size_t cells = grid.kind.size();
  std::vector<std::vector<double>> field;
  for (const double value : upright)
    field.push_back(large_vector<double>(cells, [&](std::size_t) { return value; }));
  visit_surface(grid, part, bvh, options.crease, [&](std::size_t cell, const Vec3& n) {
    const std::vector<double> values = boundary_values(options, n);
    for (std::size_t f = 0; f < values.size(); ++f) field[f][cell] = values[f];
  });
  PostureField posture;
  posture.form = options.form;
  posture.outcome = voxel::solve_laplace(grid.table, roles(grid, options.exterior), field,
                                         options.solver, progress);
  for (auto& values : field) {
    posture.value.push_back(
        large_vector<float>(cells, [&](std::size_t i) { return static_cast<float>(values[i]); }));
    std::vector<double>().swap(values);
  }
  return posture;
}

}  // namespace patchmill::dcm
