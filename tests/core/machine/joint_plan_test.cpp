// Angles along paths: continuity, limits, poles, and that no shorter way exists.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/joint_plan.h"

#include "machines.h"

#include <gtest/gtest.h>

namespace patchmill::machine {
namespace {

Kinematics table_ac(double lowest_a, double highest_a, double limit_c) {
  Kinematics k = machine_of(axis_of('C', AxisSide::Table, Vec3::UnitZ(), Vec3::Zero()),
                            axis_of('A', AxisSide::Table, Vec3::UnitX(), Vec3::Zero()));
  k.rotary[0].lowest = -limit_c;
  k.rotary[0].highest = limit_c;
  k.rotary[1].lowest = lowest_a;
  k.rotary[1].highest = highest_a;
  return k;
}

Vec3 tilted(double tilt, double azimuth) {
  return {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)};
}

// A random smooth way on the sphere about the middle of a machine's reach.
std::vector<AxisTarget> smooth_path(std::mt19937& random, double widest, int count) {
  std::uniform_real_distribution<double> u(0.3, 1.0), phase(0.0, 2.0 * kPi);
  const double a = u(random), b = u(random), pa = phase(random), pb = phase(random);
  std::vector<AxisTarget> targets;
  for (int i = 0; i < count; ++i) {
    const double s = 2.0 * kPi * i / count;
    const double x = widest * std::sin(a * s + pa), y = widest * std::cos(b * s + pb);
    targets.push_back({Vec3(x, y, 1.0).normalized(), false});
  }
  return targets;
}

bool within_reach(const Kinematics& k, const std::vector<AxisTarget>& targets) {
  for (const AxisTarget& target : targets)
    if (solve_axis(k, target.axis).count == 0) return false;
  return true;
}

void expect_axes(const Kinematics& k, const std::vector<AxisTarget>& targets, const JointPlan& plan,
                 double tolerance, const char* name) {
  ASSERT_TRUE(plan.complete) << name << ": " << plan.reason;
  ASSERT_EQ(plan.joints.size(), targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i)
    ASSERT_LT(Angle::between(tool_axis(k, plan.joints[i]), targets[i].axis).radians(), tolerance)
        << name;
}

// On the way between two ends, angles running linearly, the axis stays near both of its ends.
void expect_no_jump(const Kinematics& k, const std::vector<AxisTarget>& targets,
                    const JointPlan& plan, const char* name) {
  for (std::size_t i = 1; i < targets.size(); ++i) {
    const double step = Angle::between(targets[i - 1].axis, targets[i].axis).radians();
    for (double s = 0.1; s < 1.0; s += 0.2) {
      Joints q{};
      for (int j = 0; j < 2; ++j)
        q[j] = plan.joints[i - 1][j] + s * (plan.joints[i][j] - plan.joints[i - 1][j]);
      const Vec3 t = tool_axis(k, q);
      ASSERT_LE(Angle::between(t, targets[i].axis).radians(), 1.6 * step + 1e-8)
          << name << " " << i;
      ASSERT_LE(Angle::between(t, targets[i - 1].axis).radians(), 1.6 * step + 1e-8)
          << name << " " << i;
    }
  }
}

TEST(JointPlan, ContinuousAlongRandomSmoothPaths) {
  std::mt19937 random(11);
  for (const auto& [name, k] : machines_of_every_kind()) {
    int planned = 0;
    for (int run = 0; run < 20; ++run) {
      const auto targets = smooth_path(random, 0.8, 600);
      if (!within_reach(k, targets)) continue;
      ++planned;
      const JointPlan plan = plan_joints(k, targets);
      ASSERT_NO_FATAL_FAILURE(expect_axes(k, targets, plan, 2e-9, name));
      ASSERT_NO_FATAL_FAILURE(expect_no_jump(k, targets, plan, name));
      for (std::size_t i = 1; i < targets.size(); ++i)
        for (int j = 0; j < 2; ++j)
          ASSERT_LE(std::abs(plan.joints[i][j] - plan.joints[i - 1][j]), kPi + 1e-9) << name;
    }
    EXPECT_GE(planned, 2) << name;
  }
}

TEST(JointPlan, LimitsAreKeptOrTheReasonIsGiven) {
  std::mt19937 random(12);
  const double limit = Angle::degrees(200.0).radians();
  int complete = 0, refused = 0;
  for (int run = 0; run < 60; ++run) {
    const Kinematics k =
        table_ac(Angle::degrees(-30.0).radians(), Angle::degrees(110.0).radians(), limit);
    auto targets = smooth_path(random, 0.9, 500);
    targets[250].clear = true;
    const JointPlan plan = plan_joints(k, targets);
    if (!plan.complete) {
      ++refused;
      EXPECT_FALSE(plan.reason.empty());
      continue;
    }
    ++complete;
    for (const Joints& q : plan.joints)
      for (int j = 0; j < 2; ++j) {
        ASSERT_GE(q[j], k.rotary[j].lowest - 1e-9);
        ASSERT_LE(q[j], k.rotary[j].highest + 1e-9);
      }
  }
  EXPECT_GT(complete, 10);
}

// Round and round the cone: an unlimited C goes on, a limited one runs out and says so.
TEST(JointPlan, NoUnwindingInsideTheCut) {
  std::vector<AxisTarget> targets;
  for (int i = 0; i <= 1080; i += 2)
    targets.push_back({tilted(0.5, Angle::degrees(i).radians()), false});
  const JointPlan free = plan_joints(table_ac(-2.0, 2.0, kUnlimited), targets);
  ASSERT_TRUE(free.complete);
  EXPECT_NEAR(std::abs(free.joints.back()[0] - free.joints.front()[0]), 6.0 * kPi, 1e-9);
  EXPECT_NEAR(free.travel, 6.0 * kPi, 1e-6);
  const Kinematics limited = table_ac(-2.0, 2.0, Angle::degrees(360.0).radians());
  const JointPlan stuck = plan_joints(limited, targets);
  EXPECT_FALSE(stuck.complete);
  EXPECT_NE(stuck.reason.find("unwind"), std::string::npos) << stuck.reason;
  // with two places clear of the part it unwinds there, and nowhere else
  targets[190].clear = targets[380].clear = true;
  const JointPlan unwound = plan_joints(limited, targets);
  ASSERT_TRUE(unwound.complete) << unwound.reason;
  for (std::size_t i = 1; i < targets.size(); ++i) {
    if (targets[i].clear) continue;
    ASSERT_LT(std::abs(unwound.joints[i][0] - unwound.joints[i - 1][0]), 0.1);
  }
}

TEST(JointPlan, PolesAreCrossedWithoutAJumpOfTheToolAxis) {
  // straight over the pole, past it at many distances, and along it; with A on both sides and on one
  for (const auto& [name, machine] : machines_of_every_kind()) {
    const RotaryAxis& first = machine.rotary[0];
    const Vec3 pole = first.side == AxisSide::Table ? Vec3(-first.direction) : first.direction;
    int crossed = 0;
    for (const double sign : {1.0, -1.0})
      for (const double miss : {0.0, 1e-13, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2}) {
        const Vec3 along = pole.unitOrthogonal(), side = pole.cross(along);
        std::vector<AxisTarget> targets;
        for (int i = -50; i <= 50; ++i)
          targets.push_back({(sign * pole + 0.004 * i * along + miss * side).normalized(), false});
        if (!within_reach(machine, targets)) continue;  // this pole is out of the machine's reach
        ++crossed;
        const JointPlan plan = plan_joints(machine, targets);
        ASSERT_NO_FATAL_FAILURE(expect_axes(machine, targets, plan, 2e-9, name));
        ASSERT_NO_FATAL_FAILURE(expect_no_jump(machine, targets, plan, name));
      }
    std::cout << name << ": " << crossed << " ways over poles\n";
  }
  const Kinematics one_sided = table_ac(0.0, 2.0, kUnlimited);
  for (const double miss : {1e-9, 1e-7, 1e-4, 1e-2}) {
    std::vector<AxisTarget> targets;
    for (int i = -50; i <= 50; ++i)
      targets.push_back({Vec3(0.004 * i, miss, 1.0).normalized(), false});
    const JointPlan plan = plan_joints(one_sided, targets);
    ASSERT_NO_FATAL_FAILURE(expect_axes(one_sided, targets, plan, 2e-9, "one-sided"));
    ASSERT_NO_FATAL_FAILURE(expect_no_jump(one_sided, targets, plan, "one-sided"));
    for (const Joints& q : plan.joints) ASSERT_GE(q[1], -1e-12);
  }
}

TEST(JointPlan, FirstAxisIsHeldAtThePole) {
  const Kinematics k = table_ac(-2.0, 2.0, kUnlimited);
  std::vector<AxisTarget> targets{{tilted(0.3, 0.8)},
                                  {Vec3::UnitZ()},
                                  {Vec3::UnitZ()},
                                  {tilted(1e-11, 2.0)},
                                  {tilted(0.3, 0.8)}};
  const JointPlan plan = plan_joints(k, targets);
  ASSERT_TRUE(plan.complete);
  for (const Joints& q : plan.joints) EXPECT_NEAR(q[0], plan.joints[0][0], 1e-9);
  // a path that begins at the pole takes the angle that it will need
  const JointPlan leading = plan_joints(k, {{Vec3::UnitZ()}, {tilted(0.3, 0.8)}});
  ASSERT_TRUE(leading.complete);
  EXPECT_NEAR(leading.joints[0][0], leading.joints[1][0], 1e-12);
}

// The least travel by trying all choices of branch and turn.
double least_by_trying(const Kinematics& k, const std::vector<AxisTarget>& targets, std::size_t i,
                       const Joints& from) {
  if (i == targets.size()) return 0.0;
  double best = std::numeric_limits<double>::infinity();
  for (const AxisSolution& s : solve_axis(k, targets[i].axis))
    for (int turn = -2; turn <= 2; ++turn) {
      const Joints q{s.joints[0] + 2.0 * kPi * turn, s.joints[1]};
      bool inside = true;
      for (int j = 0; j < 2; ++j)
        inside = inside && q[j] >= k.rotary[j].lowest && q[j] <= k.rotary[j].highest;
      if (!inside) continue;
      const double way = i ? std::abs(q[0] - from[0]) + std::abs(q[1] - from[1]) : 0.0;
      best = std::min(best, way + least_by_trying(k, targets, i + 1, q));
    }
  return best;
}

TEST(JointPlan, NoShorterWayExists) {
  std::mt19937 random(13);
  for (int run = 0; run < 40; ++run) {
    const Kinematics k = table_ac(-2.1, 2.1, 1.5 * kPi);
    std::vector<AxisTarget> targets;
    for (int i = 0; i < 5; ++i) {
      Vec3 t = random_axis(random);
      t.z() = std::abs(t.z());
      targets.push_back({t, true});
    }
    const JointPlan plan = plan_joints(k, targets);
    ASSERT_TRUE(plan.complete) << plan.reason;
    EXPECT_NEAR(plan.travel, least_by_trying(k, targets, 0, {}), 1e-6);
  }
}

TEST(JointPlan, WhatCannotBeHadIsNamed) {
  const Kinematics k = table_ac(-0.2, 0.5, kUnlimited);
  const JointPlan steep = plan_joints(k, {{Vec3::UnitZ()}, {tilted(0.8, 0.0)}});
  EXPECT_FALSE(steep.complete);
  EXPECT_EQ(steep.failed, 1u);
  EXPECT_NE(steep.reason.find("A"), std::string::npos);
  Kinematics mill;
  EXPECT_NE(plan_joints(mill, {{tilted(0.1, 0.0)}}).reason.find("reach"), std::string::npos);
}

}  // namespace
}  // namespace patchmill::machine
