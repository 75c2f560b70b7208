// Reading fields and applying them to a path.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/apply_dcm.h"

#include "dcm/hill_model.h"
#include "patchmill/geometry/error.h"
#include "voxel/shapes.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::dcm {
namespace {

RC_GTEST_PROP(FieldReader, ReproducesLinearFields, ()) {
  const auto& grid = convex_model().grid;
  const Vec3 slope(0.3, -0.7, 1.1);
  std::vector<double> field(grid.kind.size());
  shapes::for_each_cell(grid.table, [&](std::size_t i, const voxel::Cell& c) {
    field[i] = slope.dot(grid.frame.centre(c));
  });
  // well above the part, between voxel centres
  const auto part = [](double lo, double hi) {
    return lo + (hi - lo) * *rc::gen::inRange(0, 1001) / 1000;
  };
  const Vec3 p(part(1, 49), part(1, 49), part(31, 35));
  const ReadingStencil at = reading_stencil(grid, p, Reading::Trilinear);
  RC_ASSERT(at.air == 0.0);
  RC_ASSERT(std::abs(at(field, 0.0) - slope.dot(p)) < 1e-12 * 100);
}

TEST(FieldReader, IsContinuousWhereTheStaircaseJumps) {
  const Model& m = convex_model();
  double smooth = 0.0, stairs = 0.0;
  std::optional<double> last_smooth, last_stairs;
  for (double x = 0.5; x < 49.5; x += 0.01) {
    const Vec3 p(x, 24.2, 31.3);
    const auto a = read_feed(m.grid, m.feed, p, Vec3::UnitZ());
    const auto b = read_feed(m.grid, m.feed, p, Vec3::UnitZ(), Reading::Nearest);
    ASSERT_TRUE(a && b);
    if (last_smooth) smooth = std::max(smooth, std::abs(*a - *last_smooth));
    if (last_stairs) stairs = std::max(stairs, std::abs(*b - *last_stairs));
    last_smooth = a;
    last_stairs = b;
  }
  EXPECT_LT(smooth, 0.02);
  EXPECT_GT(stairs, 10.0 * smooth);
}

TEST(FieldReader, AirHasTheValuesOfTheSkinAndThePartHasNone) {
  const Model& m = convex_model();
  for (const Vec3& p : {Vec3(-10, 20, 20), Vec3(25, 25, 1e12), Vec3(25, 25, 60)}) {
    EXPECT_EQ(read_feed(m.grid, m.feed, p, Vec3::UnitX()), kFeed.high);
    EXPECT_EQ(read_axis(m.grid, m.posture, p), Vec3::UnitZ());
  }
  EXPECT_FALSE(read_feed(m.grid, m.feed, Vec3(25, 25, 5), Vec3::UnitX()));
}

TEST(FieldReader, EntersTheStockWithoutAStep) {
  const Model& m = convex_model();
  Vec3 last = read_axis(m.grid, m.posture, Vec3(-3, 24, 6)).value();
  double most = 0.0;
  for (double x = -3.0; x < 0.0; x += 0.01) {  // at the side of the part, which is the stock's too
    const Vec3 axis = read_axis(m.grid, m.posture, Vec3(x, 24, 6)).value();
    ASSERT_LT((axis - last).norm(), 0.02);
    most = std::max(most, (axis - Vec3::UnitZ()).norm());
    last = axis;
  }
  EXPECT_GT(most, 0.1);
}

// Distance of the ball centre from the given path's straight lines, all along the moves as the
// machine makes them: the tip runs straight and the axis turns evenly.
double centre_error(const ToolPath& given, const ToolPath& out) {
  double worst = 0.0;
  ToolPose from = out.start;
  for (const Move& move : out.moves) {
    for (double s = 0.0; s <= 1.0; s += 0.125) {
      const double whole = std::acos(std::min(1.0, from.axis.dot(move.end.axis)));
      const Vec3 axis =
          whole < 1e-9
              ? from.axis
              : Vec3((std::sin((1 - s) * whole) * from.axis + std::sin(s * whole) * move.end.axis) /
                     std::sin(whole));
      const Vec3 c = from.tip + s * (move.end.tip - from.tip) + kRadius * axis;
      double nearest = 1e9;
      Vec3 a = ball_centre(given.start, kRadius);
      for (const Move& base : given.moves) {
        const Vec3 b = ball_centre(base.end, kRadius), d = b - a;
        const double t = std::min(1.0, std::max(0.0, (c - a).dot(d) / d.squaredNorm()));
        nearest = std::min(nearest, (a + t * d - c).norm());
        a = b;
      }
      worst = std::max(worst, nearest);
    }
    from = move.end;
  }
  return worst;
}

TEST(ApplyDcm, KeepsTheBallCentreWithinOneMicrometre) {
  const Model& m = convex_model();
  const ToolPath given = over_the_hill();
  const ToolPath out = apply_dcm(given, m.grid, &m.feed, &m.posture);
  EXPECT_GT(out.moves.size(), 20u);
  EXPECT_LT(centre_error(given, out), 0.001);
  double most = 0.0;
  for (const Move& move : out.moves) most = std::max(most, std::acos(move.end.axis.z()));
  EXPECT_GT(Angle::radians(most).degrees(), 10.0);  // and it does tilt
}

TEST(ApplyDcm, AxisAndFeedAreWithinTheirTolerancesAllAlong) {
  const Model& m = convex_model();
  const ToolPath given = over_the_hill();
  DcmOptions options;
  const ToolPath out = apply_dcm(given, m.grid, &m.feed, &m.posture, options);
  ToolPose from = out.start;
  for (const Move& move : out.moves) {
    const Vec3 a = ball_centre(from, kRadius), b = ball_centre(move.end, kRadius);
    const double length = (b - a).norm();
    if (length < options.shortest_move * 2) continue;
    const double feed = length / duration(move, out.spindle);
    for (double s = 0.05; s < 1.0; s += 0.1) {
      const Vec3 p = a + s * (b - a);
      const Vec3 axis = (from.axis + s * (move.end.axis - from.axis)).normalized();
      const Vec3 exact = read_axis(m.grid, m.posture, p).value_or(Vec3::UnitZ());
      ASSERT_LT(std::acos(std::min(1.0, axis.dot(exact))), 1.3 * options.axis_tolerance.radians());
      const double field = read_feed(m.grid, m.feed, p, (b - a) / length).value_or(kFeed.high);
      ASSERT_NEAR(feed, field, 2.0 * options.feed_tolerance);
    }
    from = move.end;
  }
}

TEST(ApplyDcm, TimeIsTheIntegralOfSlowness) {
  const Model& m = convex_model();
  const ToolPath given = line(Vec3(-4, 23, 31), Vec3(54, 26, 32));
  const ToolPath out = apply_dcm(given, m.grid, &m.feed, nullptr);
  double seconds = 0.0;
  const Vec3 a = ball_centre(given.start, kRadius), b = ball_centre(given.moves[0].end, kRadius);
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const Vec3 p = a + (i + 0.5) / n * (b - a);
    seconds += (b - a).norm() / n /
               read_feed(m.grid, m.feed, p, (b - a).normalized()).value_or(kFeed.high);
  }
  EXPECT_NEAR(statistics(out).timed_seconds, seconds, 0.01 * seconds);
  for (const Move& move : out.moves) EXPECT_EQ(move.end.axis, Vec3::UnitZ());
}

TEST(ApplyDcm, PostureAloneKeepsTheTime) {
  const Model& m = convex_model();
  const ToolPath given = over_the_hill();
  const ToolPath out = apply_dcm(given, m.grid, nullptr, &m.posture);
  EXPECT_NEAR(statistics(out).timed_seconds, statistics(given).timed_seconds, 1e-9);
}

TEST(ApplyDcm, RespectsTheMachinesRates) {
  const Model& m = convex_model();
  DcmOptions options;
  options.axis_rate = 0.2;
  options.acceleration = 5.0;
  const ToolPath out = apply_dcm(over_the_hill(), m.grid, &m.feed, &m.posture, options);
  EXPECT_LE(path_steps(out).axis_rate, 0.2 * (1 + 1e-9));
  const ToolPath free = apply_dcm(over_the_hill(), m.grid, &m.feed, &m.posture);
  EXPECT_GT(path_steps(free).axis_rate, 0.2);
  EXPECT_GT(statistics(out).timed_seconds, statistics(free).timed_seconds);
}

TEST(ApplyDcm, TheStaircaseIsRougher) {
  const Model& m = convex_model();
  DcmOptions paper;
  paper.reading = Reading::Nearest;
  const ToolPath given = over_the_hill();
  const ToolPath stairs_path = apply_dcm(given, m.grid, &m.feed, &m.posture, paper);
  const PathSteps stairs = path_steps(stairs_path);
  const PathSteps smooth = path_steps(apply_dcm(given, m.grid, &m.feed, &m.posture));
  EXPECT_GT(stairs.axis_at_rest.degrees(), 2.0);
  EXPECT_EQ(smooth.axis_at_rest.degrees(), 0.0);
  EXPECT_GT(stairs.axis_at_rest, smooth.axis_per_move);
  EXPECT_GT(stairs.feed, 0.5);
  EXPECT_LT(centre_error(given, stairs_path),
            10.0);  // turning on the spot, the chord leaves the ball
  for (const Move& move : stairs_path.moves) EXPECT_GE(move.turns, 0.0);
}

TEST(ApplyDcm, ATextureKeepsItsTiming) {
  const Model& m = convex_model();
  ToolPath texture = over_the_hill();
  texture.moves[1].dimple = 0;
  EXPECT_THROW(apply_dcm(texture, m.grid, &m.feed, nullptr), InputError);
  const ToolPath out = apply_dcm(texture, m.grid, nullptr, &m.posture);
  int dimples = 0;
  for (const Move& move : out.moves) dimples += move.dimple != kNoDimple;
  EXPECT_EQ(dimples, 1);
  EXPECT_NEAR(statistics(out).cut_turns, statistics(texture).cut_turns, 1e-9);
}

TEST(ApplyDcm, BadInputIsNamed) {
  const Model& m = convex_model();
  ToolPath path = over_the_hill();
  path.tool.radius = 0.0;
  EXPECT_THROW(apply_dcm(path, m.grid, &m.feed, nullptr), InputError);
  DcmOptions options;
  options.axis_tolerance = Angle();
  EXPECT_THROW(apply_dcm(over_the_hill(), m.grid, &m.feed, nullptr, options), InputError);
}

}  // namespace
}  // namespace patchmill::dcm
