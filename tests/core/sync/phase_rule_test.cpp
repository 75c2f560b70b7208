// Contact azimuth, tilt and the phase rule against closed forms and invariances.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/phase_rule.h"

#include "patchmill/geometry/error.h"
#include "patchmill/sync/contact_azimuth.h"
#include "patchmill/sync/tool_axis.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::sync {
namespace {

const Tool kTool{1.0, 2};

TEST(ContactAzimuth, IsWhereTheBallTouches) {
  // a slope that rises towards +x touches the ball on its +x side: its normal leans to -x
  EXPECT_NEAR(contact_azimuth(Vec3(-1, 0, 1).normalized()).degrees(), 0.0, 1e-12);
  EXPECT_NEAR(contact_azimuth(Vec3(0, -1, 1).normalized()).degrees(), 90.0, 1e-12);
  EXPECT_NEAR(std::abs(contact_azimuth(Vec3(1, 0, 1).normalized()).degrees()), 180.0, 1e-12);
}

RC_GTEST_PROP(ContactAzimuth, TurnsWithTheWork, ()) {
  const double az = *rc::gen::inRange(-3000, 3000) / 1000.0,
               lean = *rc::gen::inRange(1, 1500) / 1000.0,
               turn = *rc::gen::inRange(-3000, 3000) / 1000.0;
  const Vec3 n(-std::cos(az) * std::sin(lean), -std::sin(az) * std::sin(lean), std::cos(lean));
  const Vec3 m = Eigen::AngleAxisd(turn, Vec3::UnitZ()) * n;
  const Angle difference = contact_azimuth(m) - contact_azimuth(n) - Angle::radians(turn);
  RC_ASSERT(std::abs(difference.wrapped_signed(Angle::turns(1)).radians()) < 1e-9);
  RC_ASSERT(std::abs(tilt(n, Vec3::UnitZ()).radians() - lean) < 1e-12);
}

TEST(Tilt, IsAccurateAtZero) {
  const double small = 1e-9;
  EXPECT_NEAR(tilt(Vec3(small, 0, 1).normalized(), Vec3::UnitZ()).radians() / small, 1.0, 1e-6);
}

RC_GTEST_PROP(PhaseRule, AdvanceBringsAFluteToTheNextContact, ()) {
  const int flutes = *rc::gen::inRange(1, 7);
  const auto choice = *rc::gen::element(FluteChoice::Any, FluteChoice::Same);
  const auto sense = *rc::gen::element(SpindleSense::M3, SpindleSense::M4);
  const PhaseRule rule{choice, double(*rc::gen::inRange(0, 7)), Angle()};
  const Angle a = Angle::degrees(*rc::gen::inRange(-1800, 1800) / 10.0),
              b = Angle::degrees(*rc::gen::inRange(-1800, 1800) / 10.0);
  const Spindle spindle{10.0, sense};
  const Tool tool{1.0, flutes};
  const Angle period = phase_period(flutes, choice);
  const Angle advance = spindle_advance(a, b, rule, tool, spindle);
  RC_ASSERT(advance.turns() >= rule.extra_turns - 1e-12);
  RC_ASSERT(advance.turns() < rule.extra_turns + period.turns() + 1e-12);
  // a flute that was at a is, up to whole periods, at b
  const Angle miss = (a + spindle.sign() * advance - b).wrapped_signed(period);
  RC_ASSERT(std::abs(miss.radians()) < 1e-8);
}

TEST(PhaseRule, SensesAreMirrored) {
  const PhaseRule rule{FluteChoice::Same, 0.0, Angle()};
  const Angle a = Angle::degrees(10), b = Angle::degrees(40);
  EXPECT_NEAR(spindle_advance(a, b, rule, kTool, {1, SpindleSense::M3}).degrees(), 330.0, 1e-9);
  EXPECT_NEAR(spindle_advance(a, b, rule, kTool, {1, SpindleSense::M4}).degrees(), 30.0, 1e-9);
}

TEST(PhaseRule, EqualAzimuthsNeedNoTurnWhateverTheRounding) {
  const PhaseRule rule{FluteChoice::Any, 0.0, Angle()};
  for (double e : {-1e-15, 0.0, 1e-15})
    EXPECT_LT(spindle_advance(Angle::radians(1), Angle::radians(1 + e), rule, kTool,
                              {1, SpindleSense::M3})
                  .radians(),
              1e-9);
}

TEST(PhaseRule, CalibrationStepAddsUp) {
  patch::Dimples dimples(4);
  for (patch::Dimple& d : dimples) d.surface.normal = Vec3(-1, 0, 1).normalized();
  dimples[1].state = patch::DimpleState::ToolTip;
  const PhaseRule rule{FluteChoice::Same, 5.0, Angle::degrees(1)};
  const auto wanted = wanted_phases(dimples, rule, {1, SpindleSense::M4});
  EXPECT_NEAR(wanted[0].degrees(), 0.0, 1e-12);
  EXPECT_TRUE(std::isnan(wanted[1].radians()));
  EXPECT_NEAR(wanted[2].degrees(), 1.0, 1e-12);
  EXPECT_NEAR(wanted[3].degrees(), 2.0, 1e-12);
}

TEST(ToolTip, FacesThatLookAwayFromTheToolAreUndercut) {
  const auto at = [](double degrees) { return Angle::degrees(degrees); };
  EXPECT_EQ(state_of_tilt(at(1.0), at(1.0)), patch::DimpleState::Cut);
  EXPECT_EQ(state_of_tilt(at(0.999), at(1.0)), patch::DimpleState::ToolTip);
  EXPECT_EQ(state_of_tilt(at(89.999), at(1.0)), patch::DimpleState::Cut);
  EXPECT_EQ(state_of_tilt(at(90.0), at(1.0)), patch::DimpleState::Undercut);
  patch::Dimples dimples(2);
  for (patch::Dimple& dimple : dimples) dimple.surface.normal = Vec3::UnitZ();
  mark_tool_tip(dimples,
                std::vector<Vec3>{Vec3(1, 0, -0.01).normalized(), Vec3(1, 0, 1).normalized()},
                at(1.0));
  EXPECT_EQ(dimples[0].state, patch::DimpleState::Undercut);
  EXPECT_EQ(dimples[1].state, patch::DimpleState::Cut);
}

TEST(ToolTip, IsMarkedWithinTheLimit) {
  patch::Dimples dimples(3);
  dimples[0].surface.normal = Vec3::UnitZ();
  dimples[1].surface.normal = Vec3(std::sin(0.05), 0, std::cos(0.05));
  dimples[2].surface.normal = -Vec3::UnitZ();
  mark_tool_tip(dimples, Vec3::UnitZ(), Angle::degrees(1));
  EXPECT_EQ(dimples[0].state, patch::DimpleState::ToolTip);
  EXPECT_EQ(dimples[1].state, patch::DimpleState::Cut);
  EXPECT_EQ(dimples[2].state, patch::DimpleState::Undercut);
  EXPECT_THROW(mark_tool_tip(dimples, Vec3::UnitZ(), Angle()), InputError);
}

}  // namespace
}  // namespace patchmill::sync
