// Feed fields: the linear profile, a tridiagonal reference, free ends, weights of the direction.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/feed_field.h"

#include "patchmill/geometry/error.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::dcm {
namespace {

constexpr FeedLimits kPaper{400.0 / 60.0, 800.0 / 60.0};  // Table 1 of the paper

voxel::VoxelGrid convex_grid(double pitch) {
  voxel::VoxelOptions options;
  options.pitch = pitch;
  return voxel::voxelise(mesh::box_mesh(Vec3::Zero(), Vec3(50, 50, 36)), shapes::convex_part(40),
                         options);
}

// The steady state along one line by elimination (Thomas), no closed form involved.
std::vector<double> by_elimination(const std::vector<voxel::CellRole>& role,
                                   std::vector<double> value) {
  const std::size_t n = role.size();
  std::vector<double> below(n, 0), diagonal(n, 1), above(n, 0), right = value;
  for (std::size_t i = 0; i < n; ++i) {
    if (role[i] != voxel::CellRole::Unknown) continue;
    const bool left_open = i > 0 && role[i - 1] != voxel::CellRole::Outside;
    const bool right_open = i + 1 < n && role[i + 1] != voxel::CellRole::Outside;
    if (!left_open && !right_open) continue;
    below[i] = left_open ? -1 : 0;
    above[i] = right_open ? -1 : 0;
    diagonal[i] = (left_open ? 1 : 0) + (right_open ? 1 : 0);
    right[i] = 0;
  }
  for (std::size_t i = 1; i < n; ++i) {
    const double m = below[i] / diagonal[i - 1];
    diagonal[i] -= m * above[i - 1];
    right[i] -= m * right[i - 1];
  }
  value[n - 1] = right[n - 1] / diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;)
    value[i] = (right[i] - above[i] * value[i + 1]) / diagonal[i];
  return value;
}

TEST(FeedField, EqualsEliminationAlongEveryLine) {
  const voxel::VoxelGrid grid = convex_grid(2.0);
  const FeedField feed = steady_feed(grid, kPaper);
  const std::vector<voxel::CellRole> role = roles(grid, ExteriorRule::Held);
  const std::vector<double> start = initial_feed(grid, kPaper);
  int lines = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int a = 0; a < grid.frame.cells[u]; ++a)
      for (int b = 0; b < grid.frame.cells[v]; ++b) {
        std::vector<voxel::CellRole> line;
        std::vector<double> value, ours;
        for (int i = 0; i < grid.frame.cells[axis]; ++i) {
          voxel::Cell cell;
          cell[axis] = i;
          cell[u] = a;
          cell[v] = b;
          const std::int64_t at = voxel::cell_index(grid.table, cell);
          line.push_back(at < 0 ? voxel::CellRole::Outside : role[at]);
          value.push_back(at < 0 ? 0.0 : start[at]);
          ours.push_back(at < 0 ? 0.0 : feed.along[axis][at]);
        }
        const std::vector<double> reference = by_elimination(line, value);
        for (std::size_t i = 0; i < line.size(); ++i)
          if (line[i] == voxel::CellRole::Unknown) {
            ASSERT_NEAR(ours[i], reference[i], 1e-12);
          }
        ++lines;
      }
  }
  EXPECT_EQ(lines, 25 * 25 + 2 * 25 * 18);
}

TEST(FeedField, IsLinearBetweenSurfaceAndSkin) {
  // a block in the middle of a box: along x from its side (voxels 11, 12 touched) to the skin (29)
  voxel::VoxelOptions options;
  options.pitch = 1.0;
  const voxel::VoxelGrid grid =
      voxel::voxelise(mesh::box_mesh(Vec3::Zero(), Vec3(30, 30, 30)),
                      mesh::box_mesh(Vec3(8, 8, 8), Vec3(12, 22, 22)), options);
  const FeedField feed = steady_feed(grid, kPaper);
  for (int i = 12; i <= 29; ++i) {
    const double exact = kPaper.low + (kPaper.high - kPaper.low) * (i - 12) / (29.0 - 12.0);
    EXPECT_NEAR(feed.along[0][voxel::cell_index(grid.table, voxel::Cell(i, 15, 15))], exact, 1e-12);
  }
}

TEST(FeedField, WithAFreeExteriorEveryLineThatMeetsTheProductEndsAtVLo) {
  const voxel::VoxelGrid grid = convex_grid(2.0);
  const FeedField feed = steady_feed(grid, kPaper, ExteriorRule::Free);
  // z lines all begin on the product: V_Lo everywhere
  for (std::size_t i = 0; i < grid.kind.size(); ++i)
    if (grid.kind[i] == voxel::VoxelKind::Removal || grid.kind[i] == voxel::VoxelKind::Exterior) {
      ASSERT_EQ(feed.along[2][i], kPaper.low);
    }
  // an x line above the product meets nothing and keeps V_Hi
  EXPECT_EQ(feed.along[0][voxel::cell_index(grid.table, voxel::Cell(12, 12, 17))], kPaper.high);
}

RC_GTEST_PROP(FeedField, DirectionWeightsAddUpToOne, (int a, int b, int c)) {
  const Vec3 raw(a % 100, b % 100, c % 100);
  RC_PRE(raw.norm() > 0.0);
  const Vec3 d = raw.normalized();
  RC_ASSERT(std::abs(feed_in_direction(Vec3::Constant(7.0), d) - 7.0) < 1e-12);
  RC_ASSERT(std::abs(feed_in_direction(Vec3(1, 2, 3), d) - feed_in_direction(Vec3(1, 2, 3), -d)) <
            1e-15);
}

TEST(FeedField, BadLimitsAreNamed) {
  const voxel::VoxelGrid grid = convex_grid(5.0);
  EXPECT_THROW(steady_feed(grid, {0.0, 1.0}), InputError);
  EXPECT_THROW(steady_feed(grid, {2.0, 1.0}), InputError);
}

}  // namespace
}  // namespace patchmill::dcm
