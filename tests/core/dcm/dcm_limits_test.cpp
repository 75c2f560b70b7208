// The machine's limits along a path under the voxel model, and where each cutter reads it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "dcm/hill_model.h"
#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace patchmill::dcm {
namespace {

// What speed a move gains or loses on the one before: v^2 - u^2, over 2 a L. Also at the ends of an open path.
double worst_acceleration(const ToolPath& path, double acceleration) {
  double worst = 0.0, last_speed = 0.0, last_length = 0.0;
  Vec3 from = centre_of(path.start, path.tool);
  for (const Move& move : path.moves) {
    const Vec3 to = centre_of(move.end, path.tool);
    const double length = (to - from).norm(), speed = length / duration(move, path.spindle);
    from = to;
    if (!(speed > 0.0)) continue;
    if (last_speed > 0.0) {
      const double gain = speed * speed - last_speed * last_speed;
      worst = std::max(worst, gain / (2.0 * acceleration * (gain > 0.0 ? length : last_length)));
      worst = std::max(worst, -gain / (2.0 * acceleration * (gain > 0.0 ? length : last_length)));
    }
    last_speed = speed;
    last_length = length;
  }
  return worst;
}

TEST(ApplyDcm, NoMoveGainsOrLosesMoreSpeedThanTheMachineCan) {
  const Model& m = convex_model();
  const ToolPath given = over_the_hill();
  DcmOptions options;
  options.acceleration = 2.0;
  const ToolPath free = apply_dcm(given, m.grid, &m.feed, nullptr);
  const ToolPath held = apply_dcm(given, m.grid, &m.feed, nullptr, options);
  EXPECT_GT(worst_acceleration(free, options.acceleration), 1.5);  // or there is nothing to see
  EXPECT_LE(worst_acceleration(held, options.acceleration), 1.0 + 1e-9);
  EXPECT_GT(statistics(held).timed_seconds, statistics(free).timed_seconds);
  ASSERT_EQ(held.moves.size(), free.moves.size());
  for (std::size_t i = 0; i < free.moves.size(); ++i)  // it only slows
    EXPECT_GE(held.moves[i].turns, free.moves[i].turns);
  options.acceleration = 1e6;
  EXPECT_EQ(statistics(apply_dcm(given, m.grid, &m.feed, nullptr, options)).timed_seconds,
            statistics(free).timed_seconds);
}

// A flat end cuts at its tip, a bull nose at its corner: a ball whose centre goes there takes the same time.
TEST(ApplyDcm, FeedIsReadAtTheToolsCentreOfAnyCutter) {
  const Model& m = convex_model();
  const auto seconds = [&](double tip_height, const Tool& tool) {
    ToolPath path = line(Vec3(5, 23, tip_height), Vec3(45, 23, tip_height));
    path.tool = tool;
    return statistics(apply_dcm(path, m.grid, &m.feed, nullptr)).timed_seconds;
  };
  const double ball = seconds(28.0 - kRadius, {kRadius, 2});
  EXPECT_NEAR(seconds(28.0, {kRadius, 2, 0.0}), ball, 1e-9);
  EXPECT_NEAR(seconds(27.0, {kRadius, 2, 1.0}), ball, 1e-9);
  EXPECT_GT(ball, 1.1 * seconds(28.0, {kRadius, 2}));  // a ball with its tip there is faster
}

TEST(ApplyDcm, OnlyABallIsTilted) {
  const Model& m = convex_model();
  ToolPath path = over_the_hill();
  path.tool.corner_radius = 0.0;
  try {
    apply_dcm(path, m.grid, nullptr, &m.posture);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.property(), "ToolController");
  }
}

}  // namespace
}  // namespace patchmill::dcm
