// Materials of voxels against closed forms: bodies by their inside, layers by their depth, and the feed
// that follows from them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/materials.h"

#include "patchmill/geometry/error.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace patchmill::dcm {
namespace {

struct Fixture {
  mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Zero(), Vec3(50, 50, 36)),
                     part = shapes::convex_part(20);
  mesh::TriangleMesh ball = shapes::sphere(Vec3(30.1, 20.2, 33.3), 9.0, 5);
  mesh::TriangleBvh stock_bvh{stock}, ball_bvh{ball};
  voxel::VoxelGrid grid = voxel::voxelise(stock, part, {1.0});
};

TEST(Materials, AreThoseOfTheLastBodyThatHoldsTheCentre) {
  const Fixture f;
  const auto material =
      materials_of(f.grid, {{&f.stock, &f.stock_bvh, 2.25}, {&f.ball, &f.ball_bvh}});
  ASSERT_EQ(material.size(), f.grid.table.cell_count());
  int count[3] = {};
  shapes::for_each_cell(f.grid.table, [&](std::size_t i, const voxel::Cell& cell) {
    const Vec3 c = f.grid.frame.centre(cell);
    const double off = (c - Vec3(30.1, 20.2, 33.3)).norm();
    if (std::abs(off - 9.0) < 0.05) return;  // the facets are off the sphere by 4 um
    const double skin = std::min(c.minCoeff(), (Vec3(50, 50, 36) - c).minCoeff());
    const int expected = off < 9.0 ? 2 : skin < 2.25 ? 1 : 0;
    EXPECT_EQ(material[i], expected) << c.transpose();
    ++count[expected];
  });
  for (const int n : count) EXPECT_GT(n, 500);
}

TEST(Materials, NoBodiesMeanTheStocksOwn) {
  const Fixture f;
  for (const std::uint8_t m : materials_of(f.grid, {})) EXPECT_EQ(m, 0);
}

TEST(Materials, TheFeedIsTheFieldsTimesTheFactor) {
  const Fixture f;
  const auto material = materials_of(f.grid, {{&f.ball, &f.ball_bvh}});
  const FeedField plain = steady_feed(f.grid, {5.0, 10.0});
  FeedField scaled = plain;
  scale_feed(scaled, material, {1.0, 0.625});
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < material.size(); ++i)
      EXPECT_EQ(scaled.along[k][i], plain.along[k][i] * (material[i] ? 0.625 : 1.0));
}

TEST(Materials, BadInputIsNamed) {
  const Fixture f;
  EXPECT_THROW(materials_of(f.grid, {{&f.ball, &f.ball_bvh, 0.0}}), InputError);
  EXPECT_THROW(materials_of(f.grid, std::vector<MaterialBody>(256, {&f.ball, &f.ball_bvh})),
               InputError);
  FeedField feed = steady_feed(f.grid, {5.0, 10.0});
  const std::vector<std::uint8_t> one(f.grid.table.cell_count(), 1);
  EXPECT_THROW(scale_feed(feed, one, {1.0}), InputError);
  EXPECT_THROW(scale_feed(feed, one, {1.0, 0.0}), InputError);
  EXPECT_THROW(scale_feed(feed, one, {1.0, std::nan("")}), InputError);
}

}  // namespace
}  // namespace patchmill::dcm
