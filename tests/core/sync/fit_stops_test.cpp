// Legs fitted to a machine that stops: the motion model, which is another computation, has to find the
// tool on each dimple in time.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/fit_stops.h"

#include "ball_surface.h"
#include "patchmill/geometry/error.h"
#include "patchmill/sync/constant_feed.h"
#include "patchmill/sync/verdict.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::sync {
namespace {

const Tool kTool{1.0, 2};
const Spindle kSpindle{1000.0 / 60.0, SpindleSense::M3};
const Decimals kDecimals(4);
const Angle kPeriod = Angle::degrees(180);

machine::MotionModel machine(double acceleration) {
  machine::MotionModel model;
  model.velocity = 100.0;
  model.acceleration = acceleration;
  return model;
}

struct Zigzag {
  patch::Dimples dimples;
  ConstantFeed rule;
  ToolPath path;

  explicit Zigzag(int side, int patches = 1)
      : dimples(dimples_on({25.0, Vec3::Zero()}, 9.0, -8.0, side, patches, 1)) {
    rule.feed = 434.413 / 60.0;
    rule.phase.extra_turns = 5.0;
    rule.safe_height = 40.0;
    rule.clearance_height = 45.0;
    path = constant_feed_path(dimples, kTool, kSpindle, rule, kDecimals);
  }
  double feed() const { return posted_feed(rule.feed, kDecimals); }
  StopFit fitted(const machine::MotionModel& model) const {
    return fit_to_stops(path, model, feed(), kPeriod.turns(), kDecimals);
  }
  PredictedPhase phase(const ToolPath& of, const machine::MotionModel& model) const {
    return predicted_phase(of, model, wanted_phases(dimples, rule.phase, kSpindle), kPeriod);
  }
};

// A period of 1 ms is 6 degrees of spindle: nobody can do better than half of it, at random.
RC_GTEST_PROP(FitStops, BringsEveryDimpleToItsPeriod, (unsigned a, unsigned n)) {
  const Zigzag zigzag(2 + n % 4);
  const machine::MotionModel model = machine(500.0 + 50.0 * (a % 150));
  const StopFit fit = zigzag.fitted(model);
  const PredictedPhase phase = zigzag.phase(fit.path, model);
  RC_ASSERT(phase.known);
  const double degree = 360.0 * kSpindle.speed * model.period;
  RC_ASSERT(phase.largest.degrees() < 360.0 * kSpindle.speed * 2.0 * fit.largest_off + degree);
  RC_ASSERT(fit.largest_off < 2.0 * model.period);
}

TEST(FitStops, HoldsWhereThePlainZigzagIsLost) {
  const Zigzag zigzag(10);
  for (const double acceleration : {500.0, 2000.0, 10000.0}) {
    const machine::MotionModel model = machine(acceleration);
    EXPECT_GT(zigzag.phase(zigzag.path, model).rms.degrees(), 30.0);
    EXPECT_LT(zigzag.phase(zigzag.fitted(model).path, model).rms.degrees(), 4.0);
  }
}

TEST(FitStops, KeepsDimplesFeedAndOrder) {
  const Zigzag zigzag(4, 2);
  const StopFit fit = zigzag.fitted(machine(2000.0));
  ASSERT_EQ(fit.path.moves.size(), zigzag.path.moves.size());
  Vec3 from = fit.path.start.tip;
  for (std::size_t i = 0; i < fit.path.moves.size(); ++i) {
    const Move &a = zigzag.path.moves[i], &b = fit.path.moves[i];
    EXPECT_EQ(a.dimple, b.dimple);
    EXPECT_EQ(a.kind, b.kind);
    if (a.dimple != kNoDimple) {
      EXPECT_EQ(a.end.tip, b.end.tip);
    }
    // a link may rise, never sink
    if (a.kind == MoveKind::Link && a.dimple == kNoDimple) {
      EXPECT_GE(b.end.tip.z(), 40.0 - 1e-9);
    }
    if (b.kind != MoveKind::Rapid) {
      EXPECT_NEAR((b.end.tip - from).norm() / duration(b, kSpindle), zigzag.feed(), 1e-9);
    }
    from = b.end.tip;
  }
}

TEST(FitStops, RefusesWhatItCannotKnow) {
  const Zigzag zigzag(2);
  const auto refused = [&zigzag](const machine::MotionModel& model, const ToolPath& path) {
    try {
      fit_to_stops(path, model, zigzag.feed(), 0.5, kDecimals);
    } catch (const InputError& error) {
      return error.property();
    }
    return std::string();
  };
  machine::MotionModel model = machine(2000.0);
  EXPECT_EQ(refused(model, zigzag.path), "");
  model.tolerance = 0.01;
  EXPECT_EQ(refused(model, zigzag.path), "PathTolerance");
  model = machine(2000.0);
  model.jerk = 1e5;
  EXPECT_EQ(refused(model, zigzag.path), "MaxJerk");
  ToolPath locked = zigzag.path;
  locked.moves.back().pace = Pace::SpindleLocked;
  EXPECT_EQ(refused(machine(2000.0), locked), "Pace");
}

TEST(SampledStop, IsTheClosedFormRoundedUpAndAFewPeriods) {
  for (const double length : {0.02, 0.3, 1.086, 7.0})
    for (const double acceleration : {500.0, 2000.0, 10000.0}) {
      const double exact = machine::stop_to_stop_time(length, 7.24, acceleration);
      const double sampled = machine::sampled_stop_time(length, 7.24, acceleration, 1e-3);
      EXPECT_GE(sampled, exact - 1e-9);
      EXPECT_LE(sampled, exact + 3e-3);
    }
}

}  // namespace
}  // namespace patchmill::sync
