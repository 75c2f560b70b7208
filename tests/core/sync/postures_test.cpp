// Postures in the strategies: where the ball goes, what the phase is counted against, and that both forms
// of a program come back to the same tool tips.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/postures.h"

#include "../machine/machines.h"
#include "patch/table1_surface.h"
#include "patchmill/gcode/programmed_path.h"
#include "patchmill/geometry/error.h"
#include "patchmill/sync/constant_feed.h"
#include "patchmill/sync/paced_path.h"
#include "patchmill/sync/phase_error.h"
#include "patchmill/sync/tool_axis.h"

#include <gtest/gtest.h>

namespace patchmill::sync {
namespace {

const Decimals kDecimals(4);
const Tool kTool{1.0, 2};
const Spindle kSpindle{1000.0 / 60.0, SpindleSense::M3};

struct Case {
  patch::Dimples dimples = patch::table1_dimples(14, 1, 1);
  Postures postures;
  machine::Kinematics machine;

  explicit Case(const machine::Kinematics& m) : machine(m) {
    ToolAxisRule rule;
    rule.mode = ToolAxisMode::Normal;
    rule.lead = Angle::degrees(15.0);
    rule.towards = Vec3::UnitX();
    const PosturePlan plan = plan_postures(machine, dimples, tool_axes(dimples, rule), kDecimals);
    EXPECT_TRUE(plan.complete) << plan.reason;
    postures = plan.postures;
  }
  PhaseRule phase(double extra) const {
    PhaseRule rule;
    rule.extra_turns = extra;
    rule.azimuths = postures.azimuths;
    return rule;
  }
  ToolPath constant_feed() const {
    ConstantFeed rule{434.413 / 60.0, phase(5.0), 40.0, 45.0};
    return constant_feed_path(dimples, kTool, kSpindle, rule, kDecimals);
  }
};

std::vector<machine::NamedMachine> tilting_machines() {
  std::vector<machine::NamedMachine> out;
  for (const machine::NamedMachine& m : machine::machines_of_every_kind())
    if (std::string(m.name) != "skew axes") out.push_back(m);
  return out;
}

TEST(Postures, TheBallMeetsEachDimpleAndThePhaseCountsTheTable) {
  for (const auto& [name, machine] : tilting_machines()) {
    const Case c(machine);
    const machine::PosturePath path =
        with_postures(c.constant_feed(), c.postures, machine, kDecimals);
    double turns = 0.0, first_turns = 0.0, first_azimuth = 0.0;
    bool any = false;
    for (std::size_t i = 0; i < path.path.moves.size(); ++i) {
      const Move& move = path.path.moves[i];
      if (!std::isnan(move.turns)) turns += move.turns;
      if (move.dimple == kNoDimple) continue;
      const patch::SurfacePoint& s = c.dimples[static_cast<std::size_t>(move.dimple)].surface;
      EXPECT_LT((ball_centre(move.end, kTool.radius) - (s.position + s.normal)).norm(), 1e-4)
          << name;
      EXPECT_LT(
          Angle::between(move.end.axis, machine::tool_axis(machine, path.joints[i + 1])).radians(),
          1e-12);
      // seen from the housing, which does not turn: the rotary axes have turned the normal
      const Vec3 n = machine::housing_to_work(machine, path.joints[i + 1]).transpose() * s.normal;
      const double azimuth = std::atan2(-n.y(), -n.x());
      if (!any) {
        any = true;
        first_turns = turns;
        first_azimuth = azimuth;
      }
      const double spindle = -2.0 * kPi * (turns - first_turns);
      EXPECT_LT(std::abs(std::remainder(spindle - (azimuth - first_azimuth), kPi)),
                Angle::degrees(0.5).radians())
          << name;
    }
  }
}

// On an A/C table the contact azimuth is not the one that a vertical tool would have.
TEST(Postures, ARotaryTableChangesWhatEveryStrategyCounts) {
  const Case c(machine::machines_of_every_kind()[0].kinematics);
  machine::MotionModel model;
  model.velocity = 100.0;
  model.acceleration = 2000.0;
  model.spindle_lock = true;
  PacedRule paced;
  paced.phase = c.phase(0.0);
  paced.safe_height = 40.0;
  paced.clearance_height = 45.0;
  const ToolPath locked = paced_path(c.dimples, kTool, kSpindle, paced, model, kDecimals).path;
  for (const ToolPath& path : {c.constant_feed(), locked}) {
    const auto wanted = wanted_phases(c.dimples, c.phase(0.0), kSpindle);
    const auto vertical = wanted_phases(c.dimples, PhaseRule(), kSpindle);
    const Angle half = Angle::degrees(180.0);
    EXPECT_LT(summary(phase_errors(path, wanted, half)).largest.degrees(), 0.5);
    EXPECT_GT(summary(phase_errors(path, vertical, half)).largest.degrees(), 20.0);
  }
}

// Where a rotary axis is by far the slowest, a stop lasts as long as it turns, and what parts and periods add.
TEST(Postures, AStopLastsAsLongAsTheSlowestRotaryAxisTurns) {
  Case c(machine::machines_of_every_kind()[0].kinematics);
  constexpr double kRate = 0.02;  // rad/s
  for (machine::RotaryAxis& axis : c.machine.rotary) axis.rate = kRate;
  machine::MotionModel model;
  model.velocity = 1e4;
  model.acceleration = 1e6;
  gcode::ProgramForm form;
  form.tcp = true;  // so that a stop is of one part
  const std::vector<double> seconds =
      turning_seconds(c.machine, c.dimples, c.postures, kTool, model, form);
  std::size_t before = c.dimples.size(), turned = 0;
  for (std::size_t k = 0; k < c.dimples.size(); ++k) {
    if (c.dimples[k].state != patch::DimpleState::Cut) continue;
    if (before < c.dimples.size()) {
      double angle = 0.0;
      for (std::size_t j = 0; j < 2; ++j)
        angle = std::max(angle, std::abs(c.postures.joints[k][j] - c.postures.joints[before][j]));
      EXPECT_NEAR(seconds[k], angle > 0.0 ? angle / kRate + 3.0 * model.period : 0.0, 2e-3) << k;
      turned += angle / kRate > 0.02 ? 1 : 0;
    }
    before = k;
  }
  EXPECT_GT(turned, 100U);
}

TEST(Postures, BothFormsComeBackToTheSameTips) {
  for (const auto& [name, machine] : tilting_machines()) {
    const Case c(machine);
    const machine::PosturePath work =
        with_postures(c.constant_feed(), c.postures, machine, kDecimals);
    for (const bool tcp : {true, false})
      for (const gcode::ReferencePoint reference :
           {gcode::ReferencePoint::Tip, gcode::ReferencePoint::BallCentre}) {
        const gcode::ProgramForm form{tcp, reference, 1e-4, 0.0};
        const machine::Kinematics with = gcode::with_tool(machine, 80.0, form, kTool);
        const machine::PosturePath told = gcode::programmed(work, with, form);
        const ToolPath back = gcode::work_path(told, with, form);
        // the ends of moves, in order; parts of split moves lie on the straight way between them
        std::size_t r = 0;
        ToolPose from = work.path.start;
        double turns = 0.0, planned = 0.0;
        for (std::size_t i = 0; i < work.path.moves.size(); ++i) {
          const Move& move = work.path.moves[i];
          if (!std::isnan(move.turns)) planned += move.turns;
          for (;; ++r) {
            ASSERT_LT(r, back.moves.size()) << name;
            if (!std::isnan(back.moves[r].turns)) turns += back.moves[r].turns;
            if ((back.moves[r].end.tip - move.end.tip).norm() < 1e-9) break;
          }
          ASSERT_LT(Angle::between(back.moves[r].end.axis, move.end.axis).radians(), 1e-9);
          ++r;
          ASSERT_NEAR(turns, planned, 1e-6) << name;
          from = move.end;
        }
        EXPECT_EQ(tcp, told.path.moves.size() == work.path.moves.size()) << name;
      }
  }
}

TEST(Postures, SplitMovesStayWithinTheChord) {
  for (const auto& [name, machine] : tilting_machines()) {
    const Case c(machine);
    const machine::PosturePath work =
        with_postures(c.constant_feed(), c.postures, machine, kDecimals);
    const gcode::ProgramForm form{false, gcode::ReferencePoint::Tip, 1e-4, 0.0};
    const machine::Kinematics with = gcode::with_tool(machine, 80.0, form, kTool);
    const machine::PosturePath told = gcode::programmed(work, with, form);
    const ToolPath back = gcode::work_path(told, with, form);
    double worst = 0.0;
    for (std::size_t i = 1; i < told.path.moves.size(); ++i) {
      const Vec3 &a = back.moves[i - 1].end.tip, &b = back.moves[i].end.tip;
      for (const double s : {0.25, 0.5, 0.75}) {
        const Vec3 linear =
            (1.0 - s) * told.path.moves[i - 1].end.tip + s * told.path.moves[i].end.tip;
        machine::Joints q{};
        for (int k = 0; k < 2; ++k)
          q[k] = (1.0 - s) * told.joints[i][k] + s * told.joints[i + 1][k];
        worst = std::max(
            worst, (machine::in_work_frame(with, linear, q) - ((1.0 - s) * a + s * b)).norm());
      }
    }
    EXPECT_LT(worst, 1.3e-4) << name;  // the bend is worst near the middle, not quite in it
    EXPECT_GT(worst, 1e-5) << name;
  }
}

TEST(Postures, WhatTheMachineCannotPointAtIsAnOutcome) {
  machine::Kinematics machine = machine::machines_of_every_kind()[0].kinematics;
  machine.rotary[1].lowest = Angle::degrees(-5.0).radians();
  machine.rotary[1].highest = Angle::degrees(5.0).radians();
  const patch::Dimples dimples = patch::table1_dimples(14, 1, 1);
  ToolAxisRule rule;
  rule.mode = ToolAxisMode::Normal;
  rule.lead = Angle::degrees(15.0);
  rule.towards = Vec3::UnitX();
  const PosturePlan plan = plan_postures(machine, dimples, tool_axes(dimples, rule), kDecimals);
  EXPECT_FALSE(plan.complete);
  EXPECT_NE(plan.failed, kNoDimple);
  EXPECT_NE(plan.reason.find("limits"), std::string::npos) << plan.reason;
}

}  // namespace
}  // namespace patchmill::sync
