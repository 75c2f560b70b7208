// The distance of a holder of several sections from a part: the nearest of all of them counts.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/clear_axis.h"
#include "voxel/shapes.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace patchmill::collision {
namespace {

TEST(HolderSections, TheNearestOfAllOfThemCounts) {
  const mesh::TriangleMesh solid = mesh::box_mesh(Vec3(-5, -5, -5), Vec3(5, 5, 5));
  const mesh::TriangleBvh part(solid);
  const std::vector<HolderSection> holder{
      {1.0, 8.0, 1.0, 3.0}, {8.0, 20.0, 4.0, 4.0}, {20.0, 40.0, 9.0, 12.0}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<int> nearest(holder.size(), 0);
  for (int i = 0; i < 300; ++i) {
    const Vec3 centre = 16.0 * Vec3(number(random), number(random), number(random));
    const Vec3 axis = Vec3(number(random), number(random), number(random)).normalized();
    double least = 100.0;
    std::size_t which = 0;
    for (std::size_t k = 0; k < holder.size(); ++k) {
      const double d = holder_distance(part, {holder[k]}, centre, axis, 1e-4, 100.0);
      if (d < least) which = k;
      least = std::min(least, d);
    }
    EXPECT_NEAR(holder_distance(part, holder, centre, axis, 1e-4, 100.0), least, 2e-4);
    if (least > 0.0) ++nearest[which];
  }
  for (const int times : nearest) EXPECT_GT(times, 5);  // each of them was the nearest at times
}

}  // namespace
}  // namespace patchmill::collision
