// The acceleration along a path whose feed comes from voxels.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/apply_dcm.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace patchmill::dcm {
namespace {

struct Model {
  voxel::VoxelGrid grid;
  FeedField feed;
};

Model hill() {
  voxel::VoxelOptions options;
  options.pitch = 2.0;
  voxel::VoxelGrid grid = voxel::voxelise(mesh::box_mesh(Vec3::Zero(), Vec3(50, 50, 36)),
                                          shapes::convex_part(30), options);
  FeedField feed = steady_feed(grid, FeedLimits{5.0, 60.0});
  return {std::move(grid), std::move(feed)};
}

ToolPath over_the_hill() {
  ToolPath path;
  path.tool = {3.0, 2};
  path.spindle.speed = 100.0;
  path.start.tip = Vec3(-4, 23, 14);
  for (const Vec3& p : {Vec3(12, 23, 27), Vec3(25, 23, 31), Vec3(40, 23, 26), Vec3(54, 23, 14)}) {
    Move move;
    move.end.tip = p;
    move.kind = MoveKind::Cut;
    move.turns = 100.0;
    path.moves.push_back(move);
  }
  return path;
}

// Largest |v1^2 - v0^2| / (2 length) from a move to the next one [mm/s^2].
double largest_acceleration(const ToolPath& path) {
  double largest = 0.0, before = -1.0;
  Vec3 from = path.start.tip;
  for (const Move& move : path.moves) {
    const double length = (move.end.tip - from).norm();
    const double speed = length * path.spindle.speed / move.turns;
    if (before >= 0.0)
      largest = std::max(largest, std::abs(speed * speed - before * before) / (2.0 * length));
    before = speed;
    from = move.end.tip;
  }
  return largest;
}

TEST(Acceleration, IsKeptWhereTheFieldAsksForMore) {
  const Model model = hill();
  DcmOptions options;
  const ToolPath free = apply_dcm(over_the_hill(), model.grid, &model.feed, nullptr, options);
  const double limit = 0.1 * largest_acceleration(free);
  ASSERT_GT(limit, 0.0);
  options.acceleration = limit;
  const ToolPath kept = apply_dcm(over_the_hill(), model.grid, &model.feed, nullptr, options);
  ASSERT_EQ(kept.moves.size(), free.moves.size());
  // a move's length counts on the side that is accelerated
  double before = -1.0;
  Vec3 from = kept.start.tip;
  double length_before = 0.0;
  for (std::size_t i = 0; i < kept.moves.size(); ++i) {
    const double length = (kept.moves[i].end.tip - from).norm();
    const double speed = length * kept.spindle.speed / kept.moves[i].turns;
    if (before >= 0.0) {
      EXPECT_LE(std::abs(speed * speed - before * before),
                2.0 * limit * std::max(length, length_before) * (1.0 + 1e-9));
    }
    EXPECT_GE(kept.moves[i].turns, free.moves[i].turns * (1.0 - 1e-12));
    before = speed;
    length_before = length;
    from = kept.moves[i].end.tip;
  }
}

}  // namespace
}  // namespace patchmill::dcm
