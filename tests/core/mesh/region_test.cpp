// Regions of meshes by hand: boxes, strips with flipped, degenerate and loose triangles.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/error.h"
#include "patchmill/mesh/mesh_region.h"

#include <cmath>

#include <gtest/gtest.h>

namespace patchmill::mesh {
namespace {

using Numbers = std::vector<std::int32_t>;

// Rows of points in a strip that is bent at each inner row by `angle`, two triangles to each field.
TriangleMesh bent_strip(const std::vector<double>& angles) {
  TriangleMesh strip;
  double x = 0.0, z = 0.0, heading = 0.0;
  for (std::size_t i = 0; i <= angles.size() + 1; ++i) {
    strip.vertices.emplace_back(x, 0.0, z);
    strip.vertices.emplace_back(x, 1.0, z);
    if (i > 0 && i <= angles.size()) heading += angles[i - 1] * kPi / 180.0;
    x += std::cos(heading);
    z += std::sin(heading);
  }
  for (std::int32_t i = 0; i <= static_cast<std::int32_t>(angles.size()); ++i) {
    const std::int32_t a = 2 * i;
    strip.triangles.push_back({a, a + 2, a + 3});
    strip.triangles.push_back({a, a + 3, a + 1});
  }
  return strip;
}

TEST(MeshRegion, OfABoxIsOneSide) {
  const TriangleMesh box = box_mesh({0, 0, 0}, {1, 2, 3});
  EXPECT_EQ(region_around(box, 2, Angle::degrees(89)), Numbers({2, 3}));
  EXPECT_EQ(region_around(box, 2, Angle::degrees(90)).size(), 12u);
}

TEST(MeshRegion, EndsWhereTheAngleIsGreater) {
  const TriangleMesh strip = bent_strip({10, 30, 10});
  EXPECT_EQ(region_around(strip, 0, Angle::degrees(20)), Numbers({0, 1, 2, 3}));
  EXPECT_EQ(region_around(strip, 7, Angle::degrees(20)), Numbers({4, 5, 6, 7}));
  EXPECT_EQ(region_around(strip, 7, Angle::degrees(5)), Numbers({6, 7}));
  EXPECT_EQ(region_around(strip, 3, Angle::degrees(31)).size(), 8u);
}

TEST(MeshRegion, FollowsABendThatIsGreatInAll) {
  const TriangleMesh strip = bent_strip(std::vector<double>(17, 10.0));
  EXPECT_EQ(region_around(strip, 0, Angle::degrees(15)).size(), strip.triangles.size());
}

TEST(MeshRegion, LeavesOutWhatIsFlipped) {
  TriangleMesh strip = bent_strip({0, 0});
  std::swap(strip.triangles[2][0], strip.triangles[2][1]);
  EXPECT_EQ(region_around(strip, 0, Angle::degrees(60)), Numbers({0, 1, 3}));  // it bars the way
}

TEST(MeshRegion, GoesOverTrianglesWithoutArea) {
  // a point in the middle of the edge 2-3 for one side only, closed by a triangle without area
  TriangleMesh strip = bent_strip({0});
  strip.vertices.emplace_back(1.0, 0.5, 0.0);
  strip.triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 6}, {6, 4, 5}, {6, 5, 3}, {3, 2, 6}};
  EXPECT_EQ(region_around(strip, 1, Angle::degrees(1)).size(), 6u);
  // and is stopped there by an edge as it is without
  TriangleMesh bent = bent_strip({40});
  bent.vertices.emplace_back(1.0, 0.5, 0.0);
  bent.triangles = strip.triangles;
  EXPECT_EQ(region_around(bent, 1, Angle::degrees(30)), Numbers({0, 1, 5}));
}

TEST(MeshRegion, RefusesBadSeedsAndAngles) {
  const TriangleMesh strip = bent_strip({0});
  EXPECT_THROW(region_around(strip, -1, Angle::degrees(1)), InputError);
  EXPECT_THROW(region_around(strip, 4, Angle::degrees(1)), InputError);
  EXPECT_THROW(region_around(strip, 0, Angle::degrees(181)), InputError);
  EXPECT_THROW(part_of(strip, {}), InputError);
  EXPECT_THROW(part_of(strip, {0, 4}), InputError);
}

TEST(MeshRegion, PartHasItsCornersOnly) {
  const TriangleMesh strip = bent_strip({10, 30});
  const TriangleMesh part = part_of(strip, {5, 4});
  ASSERT_EQ(part.triangles.size(), 2u);
  EXPECT_EQ(part.vertices.size(), 4u);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(part.vertices[std::size_t(part.triangles[0][std::size_t(k)])],
              strip.vertices[std::size_t(strip.triangles[5][std::size_t(k)])]);
}

TEST(MeshRegion, BorderIsAroundAndInHoles) {
  EXPECT_TRUE(border_edges(box_mesh({0, 0, 0}, {1, 1, 1})).empty());
  const TriangleMesh strip = bent_strip({10, 30});
  double length = 0.0;
  for (const auto& [a, b] : border_edges(strip)) length += (b - a).norm();
  EXPECT_NEAR(length, 8.0, 1e-12);
  TriangleMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
  box.triangles.pop_back();
  EXPECT_EQ(border_edges(box).size(), 3u);
}

TEST(MeshRegion, NearestTriangle) {
  const TriangleMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
  const std::int32_t top = nearest_triangle(box, {0.9, 0.2, 5.0});
  EXPECT_TRUE(top == 2 || top == 3);
  EXPECT_GT(nearest_triangle(box, {9.0, 0.5, 0.6}), 3);
}

TEST(MeshRegion, JoinsVerticesAndKeepsTriangles) {
  TriangleMesh loose;
  for (const Vec3& v : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(1, 1, 0),
                        Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)})
    loose.vertices.push_back(v);
  loose.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  const TriangleMesh joined = join_vertices(loose);
  EXPECT_EQ(joined.vertices.size(), 4u);
  EXPECT_EQ(joined.triangles.size(), 3u);
  EXPECT_EQ(weld(loose).triangles.size(), 2u);
  EXPECT_EQ(region_around(joined, 0, Angle::degrees(1)).size(), 3u);
  EXPECT_EQ(region_around(loose, 0, Angle::degrees(1)).size(), 1u);
}

}  // namespace
}  // namespace patchmill::mesh
