// Ranges and units at the ends of what the strategies take, and what a prediction keeps of its errors.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ball_surface.h"
#include "patchmill/geometry/error.h"
#include "patchmill/sync/constant_feed.h"
#include "patchmill/sync/paced_path.h"
#include "patchmill/sync/phase_rule.h"
#include "patchmill/sync/verdict.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace patchmill::sync {
namespace {

TEST(PhaseStep, IsTakenWithinATurn) {
  PhaseRule rule;
  for (const double degrees : {0.0, 1.0, 360.0}) {
    rule.step = Angle::degrees(degrees);
    require_valid(rule, 2);
  }
  for (const double degrees : {-1.0, 361.0}) {
    rule.step = Angle::degrees(degrees);
    try {
      require_valid(rule, 2);
      ADD_FAILURE() << degrees << " degrees were taken";
    } catch (const InputError& error) {
      EXPECT_EQ(error.property(), "PhaseStep");
    }
  }
}

TEST(PostedFeed, IsRoundedInTheUnitThatIsPosted) {
  EXPECT_NEAR(posted_feed(1.23456, Decimals(0)), 74.0 / 60.0, 1e-12);  // 74.07 mm/min
  EXPECT_NEAR(posted_feed(1.23456, Decimals(1)), 74.1 / 60.0, 1e-12);
}

TEST(PredictedPhase, DoesNotDependOnWhereTheSpindleBegan) {
  const Tool tool{1.0, 2};
  const Spindle spindle{1000.0 / 60.0, SpindleSense::M3};
  const Angle period = Angle::degrees(180);
  const patch::Dimples dimples = dimples_on({25.0, Vec3::Zero()}, 9.0, -8.0, 6);
  PacedRule rule;
  rule.safe_height = 40.0;
  rule.clearance_height = 45.0;
  machine::MotionModel model;
  model.velocity = 100.0;
  model.acceleration = 2000.0;
  model.spindle_lock = true;
  const ToolPath path = paced_path(dimples, tool, spindle, rule, model, Decimals(4)).path;
  std::vector<Angle> wanted = wanted_phases(dimples, rule.phase, spindle);
  for (std::size_t i = 0; i < wanted.size(); i += 2) wanted[i] += Angle::radians(0.4);
  const PredictedPhase first = predicted_phase(path, model, wanted, period);
  ASSERT_TRUE(first.known) << first.reason;
  double largest = 0.0;
  for (const PhaseError& e : first.errors) largest = std::max(largest, std::abs(e.error.radians()));
  EXPECT_GT(largest, 0.15);
  EXPECT_NEAR(first.largest.radians(), largest, 1e-12);
  EXPECT_GE(first.largest.radians(), first.rms.radians());
  for (int eighths = 1; eighths < 8; ++eighths) {
    std::vector<Angle> turned = wanted;
    for (Angle& angle : turned) angle += period * (eighths / 8.0);
    const PredictedPhase same = predicted_phase(path, model, turned, period);
    EXPECT_NEAR(same.largest.radians(), largest, 1e-9) << eighths;
  }
}

}  // namespace
}  // namespace patchmill::sync
