// Posture: reading of the angles, boundary values, the steady field.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/posture_field.h"

#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::dcm {
namespace {

Vec3 any_direction() {
  Vec3 n;
  do
    for (int k = 0; k < 3; ++k) n[k] = *rc::gen::inRange(-100, 101) / 100.0;
  while (n.norm() < 0.1);
  return n.normalized();
}

RC_GTEST_PROP(PostureAngles, GiveTheNormalBackWithinTheLimit, ()) {
  const Vec3 n = any_direction();
  const Angle limit = Angle::degrees(70);
  const PostureAngles angles = posture_angles(n, limit);
  RC_ASSERT(std::abs(angles.theta.degrees()) <= 70.0 + 1e-9);
  RC_ASSERT(std::abs(angles.phi.degrees()) <= 70.0 + 1e-9);
  const Vec3 t = posture_axis(angles);
  const double most = std::tan(limit.radians());
  if (n.z() > 0 && std::max(std::abs(n.x()), std::abs(n.y())) <= most * n.z())
    RC_ASSERT((t - n).norm() < 1e-12);
  // limited or not, the tilt points the same way seen from above
  RC_ASSERT(std::abs(t.x() * n.y() - t.y() * n.x()) < 1e-9);
  RC_ASSERT(t.x() * n.x() + t.y() * n.y() >= 0.0);
}

TEST(PostureAngles, SignsAreThoseOfTheProjections) {
  const PostureAngles lean_x = posture_angles(Vec3(1, 0, 1), Angle::degrees(70));
  EXPECT_NEAR(lean_x.phi.degrees(), 45.0, 1e-12);
  EXPECT_NEAR(lean_x.theta.degrees(), 0.0, 1e-12);
  const PostureAngles lean_y = posture_angles(Vec3(0, 1, 1), Angle::degrees(70));
  EXPECT_NEAR(lean_y.theta.degrees(), -45.0, 1e-12);
  // under an overhang the vanishing component stays zero
  EXPECT_NEAR(posture_angles(Vec3(0.8, 1e-9, -0.6), Angle::degrees(70)).theta.degrees(), 0.0, 1e-6);
  EXPECT_NEAR(posture_angles(Vec3(0.8, 1e-9, -0.6), Angle::degrees(70)).phi.degrees(), 70.0, 1e-9);
}

struct Solved {
  voxel::VoxelGrid grid;
  std::vector<Vec3> normal;
  PostureField field;
};

Solved solve_sphere(const PostureOptions& options) {
  const mesh::TriangleMesh part = shapes::sphere(Vec3::Zero(), 12, 4);
  voxel::VoxelOptions voxels;
  voxels.pitch = 1.0;
  const mesh::TriangleBvh bvh(part);
  voxel::VoxelGrid grid =
      voxel::voxelise(mesh::box_mesh(Vec3::Constant(-20), Vec3::Constant(20)), part, voxels);
  auto normal = surface_normals(grid, part, bvh, options.crease);
  PostureField field = steady_posture(grid, part, bvh, options);
  return {std::move(grid), std::move(normal), std::move(field)};
}

TEST(PostureField, NormalsOfATessellatedSphereAreRadial) {
  const Solved s = solve_sphere({});
  double worst = 0.0;
  shapes::for_each_cell(s.grid.table, [&](std::size_t i, const voxel::Cell& c) {
    if (s.grid.kind[i] != voxel::VoxelKind::Surface) return;
    worst = std::max(worst, (s.normal[i] - s.grid.frame.centre(c).normalized()).norm());
  });
  // facets of 6 degrees: a facet's own normal would be off by 0.03 to 0.05
  EXPECT_LT(worst, 0.012);
}

TEST(PostureField, ObeysTheMaximumPrincipleAndTheSymmetryOfTheSphere) {
  const Solved s = solve_sphere({});
  ASSERT_TRUE(s.field.outcome.converged);
  const double limit = Angle::degrees(70).radians() + 1e-6;
  const voxel::BrickTable& table = s.grid.table;
  shapes::for_each_cell(table, [&](std::size_t i, const voxel::Cell& c) {
    ASSERT_LE(std::abs(s.field.value[0][i]), limit);
    ASSERT_LE(std::abs(s.field.value[1][i]), limit);
    if (s.grid.kind[i] == voxel::VoxelKind::Exterior) {
      ASSERT_EQ(s.field.value[0][i], 0.0F);
    }
    if (s.grid.kind[i] != voxel::VoxelKind::Removal) return;
    const std::int64_t mirror = voxel::cell_index(table, voxel::Cell(39 - c.x(), c.y(), c.z()));
    const std::int64_t swapped = voxel::cell_index(table, voxel::Cell(c.y(), c.x(), c.z()));
    ASSERT_NEAR(s.field.value[1][i], -s.field.value[1][mirror], 2e-5);
    ASSERT_NEAR(s.field.value[0][i], s.field.value[0][mirror], 2e-5);
    ASSERT_NEAR(s.field.value[1][i], -s.field.value[0][swapped], 2e-5);
  });
}

TEST(PostureField, UnitVectorFormTurnsTheSameWay) {
  PostureOptions vector;
  vector.form = PostureForm::UnitVector;
  const Solved a = solve_sphere({}), v = solve_sphere(vector);
  ASSERT_EQ(v.field.value.size(), 3u);
  shapes::for_each_cell(a.grid.table, [&](std::size_t i, const voxel::Cell&) {
    if (a.grid.kind[i] == voxel::VoxelKind::Air || a.grid.kind[i] == voxel::VoxelKind::Part) return;
    const Vec3 t(v.field.value[0][i], v.field.value[1][i], v.field.value[2][i]);
    const Vec3 u =
        posture_axis({Angle::radians(a.field.value[0][i]), Angle::radians(a.field.value[1][i])});
    ASSERT_GT(t.z(), 0.0);
    ASSERT_GT(t.normalized().dot(u),
              std::cos(0.30));  // the two formulations differ by some degrees
  });
}

TEST(PostureField, FreeExteriorTakesThePostureOfTheSurface) {
  // a wedge whose only slanted face leans 30 degrees about y: with nothing held at the skin the
  // whole volume above that face ends at its posture
  PostureOptions options;
  options.exterior = ExteriorRule::Free;
  const mesh::TriangleMesh part = shapes::block_with_top(40, 40, 8, [](double u, double v) {
    return Vec3(40 * u, 40 * v, 6 + 40 * u / std::sqrt(3));
  });
  voxel::VoxelOptions voxels;
  voxels.pitch = 2.0;
  const mesh::TriangleBvh bvh(part);
  const voxel::VoxelGrid grid =
      voxel::voxelise(mesh::box_mesh(Vec3::Zero(), Vec3(40, 40, 40)), part, voxels);
  const PostureField field = steady_posture(grid, part, bvh, options);
  ASSERT_TRUE(field.outcome.converged);
  const std::int64_t mid = voxel::cell_index(grid.table, voxel::Cell(10, 10, 14));
  EXPECT_NEAR(Angle::radians(field.value[1][mid]).degrees(), -30.0, 4.0);
  const PostureField held = steady_posture(grid, part, bvh, {});
  EXPECT_GT(Angle::radians(held.value[1][mid]).degrees(), -29.0);
}

}  // namespace
}  // namespace patchmill::dcm
