// Kinematics on every kind of machine: axis to angles and back, reach, points, bad machines.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/kinematics.h"

#include "machines.h"
#include "patchmill/geometry/error.h"

#include <gtest/gtest.h>

namespace patchmill::machine {
namespace {

constexpr int kAxes = 20000;

Vec3 from_work(const RotaryAxis& axis) {
  return axis.side == AxisSide::Table ? Vec3(-axis.direction) : axis.direction;
}

// How far inside the reach a direction is, without solving for angles: its angle to the first axis
// must lie between the difference and the sum of the cones' angles.
double inside_reach(const Kinematics& k, const Vec3& t) {
  const Vec3 u1 = from_work(k.rotary[0]), u2 = from_work(k.rotary[1]);
  const double between = Angle::between(u1, u2).radians(),
               cone = Angle::between(u2, Vec3::UnitZ()).radians();
  const double to_axis = Angle::between(u1, t).radians();
  const double sum = between + cone > kPi ? 2.0 * kPi - between - cone : between + cone;
  return std::min(to_axis - std::abs(between - cone), sum - to_axis);
}

TEST(Kinematics, AxisToAnglesToAxisIsRightTo1e12) {
  std::mt19937 random(5);
  for (const auto& [name, k] : machines_of_every_kind()) {
    require_valid(k);
    double worst = 0.0;
    int reached = 0, refused = 0;
    for (int i = 0; i < kAxes; ++i) {
      const Vec3 t = random_axis(random);
      const double inside = inside_reach(k, t);
      if (std::abs(inside) < 1e-6) continue;
      const AxisSolutions s = solve_axis(k, t);
      ASSERT_EQ(s.count, inside > 0.0 ? 2 : 0) << name << " " << t.transpose();
      (inside > 0.0 ? reached : refused) += 1;
      for (const AxisSolution& one : s)
        worst = std::max(worst, Angle::between(tool_axis(k, one.joints), t).radians());
    }
    EXPECT_LT(worst, 1e-12) << name;
    EXPECT_GT(reached, kAxes / 4) << name;
    RecordProperty(name, std::to_string(worst));
  }
}

TEST(Kinematics, RightBesideThePolesToo) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> exponent(-13.0, -1.0);
  for (const auto& [name, k] : machines_of_every_kind())
    for (int i = 0; i < 2000; ++i) {
      const Vec3 pole = from_work(k.rotary[0]) * (i % 2 ? 1.0 : -1.0);
      const Vec3 side = pole.cross(random_axis(random)).normalized();
      const double off = std::pow(10.0, exponent(random));
      const Vec3 t = (std::cos(off) * pole + std::sin(off) * side).normalized();
      if (inside_reach(k, t) < 1e-14) continue;
      const AxisSolutions s = solve_axis(k, t);
      ASSERT_GE(s.count, 1) << name << " " << off;
      for (const AxisSolution& one : s)
        ASSERT_LT(Angle::between(tool_axis(k, one.joints), t).radians(), 1e-12)
            << name << " " << off;
    }
}

TEST(Kinematics, AnglesToAxisToAnglesFindsTheSameWay) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  for (const auto& [name, k] : machines_of_every_kind())
    for (int i = 0; i < 5000; ++i) {
      const Joints q{angle(random), angle(random)};
      const Vec3 t = tool_axis(k, q);
      if (from_work(k.rotary[0]).cross(t).norm() < 1e-3 || inside_reach(k, t) < 1e-6) continue;
      double nearest = 1.0;
      for (const AxisSolution& one : solve_axis(k, t)) {
        double off = 0.0;
        for (int j = 0; j < 2; ++j)
          off = std::max(off, std::abs(std::remainder(one.joints[j] - q[j], 2.0 * kPi)));
        nearest = std::min(nearest, off);
      }
      ASSERT_LT(nearest, 1e-9) << name;
    }
}

// The tool seen from the work, by walking the chain with homogeneous matrices.
Eigen::Isometry3d tool_in_work(const Kinematics& k, const Vec3& linear, const Joints& q) {
  Eigen::Isometry3d work = Eigen::Isometry3d::Identity(), head = work;
  const auto line = [](const RotaryAxis& axis, double angle) {
    return Eigen::Isometry3d(Eigen::Translation3d(axis.point) *
                             Eigen::AngleAxisd(angle, axis.direction) *
                             Eigen::Translation3d(-axis.point));
  };
  for (std::size_t i = 0; i < k.rotary.size(); ++i) {
    if (k.rotary[i].side == AxisSide::Table) work = line(k.rotary[i], q[i]) * work;
    if (k.rotary[i].side == AxisSide::Head) head = head * line(k.rotary[i], q[i]);
  }
  // the gauge point is a tool length above the programmed point when nothing is turned
  const Vec3 gauge = linear + k.work_zero + Vec3(0.0, 0.0, k.tool_length);
  const Eigen::Isometry3d tip =
      Eigen::Translation3d(gauge) * head * Eigen::Translation3d(0.0, 0.0, -k.tool_length);
  return (work * Eigen::Translation3d(k.work_zero)).inverse() * tip;
}

TEST(Kinematics, PointsAgreeWithTheChainOfMatrices) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> angle(-kPi, kPi), way(-300.0, 300.0);
  for (const auto& [name, k] : machines_of_every_kind())
    for (int i = 0; i < 500; ++i) {
      const Joints q{angle(random), angle(random)};
      const Vec3 linear(way(random), way(random), way(random));
      const Eigen::Isometry3d tool = tool_in_work(k, linear, q);
      const Vec3 point = in_work_frame(k, linear, q);
      ASSERT_LT((point - tool.translation()).norm(), 1e-10) << name;
      ASSERT_LT((pivot_referred(k, point, q) - linear).norm(), 1e-10) << name;
      ASSERT_LT((tool.rotation() * Vec3::UnitZ() - tool_axis(k, q)).norm(), 1e-12) << name;
      ASSERT_LT((tool.rotation() - housing_to_work(k, q)).norm(), 1e-12) << name;
    }
}

TEST(Kinematics, LinuxCncTableFormula) {
  // xyzac-trt-kins, table at the origin: work = Rz(-C) Rx(-A) machine
  const Kinematics k = machine_of(axis_of('C', AxisSide::Table, Vec3::UnitZ(), Vec3::Zero()),
                                  axis_of('A', AxisSide::Table, Vec3::UnitX(), Vec3::Zero()));
  Kinematics at_zero = k;
  at_zero.work_zero = Vec3::Zero();
  const double c = 0.7, a = -0.4;
  const Vec3 m(10.0, 20.0, 30.0);
  const Vec3 w(
      std::cos(c) * m.x() + std::sin(c) * std::cos(a) * m.y() + std::sin(c) * std::sin(a) * m.z(),
      -std::sin(c) * m.x() + std::cos(c) * std::cos(a) * m.y() + std::cos(c) * std::sin(a) * m.z(),
      -std::sin(a) * m.y() + std::cos(a) * m.z());
  EXPECT_LT((in_work_frame(at_zero, m, {c, a}) - w).norm(), 1e-12);
}

TEST(Kinematics, ATableThatTurnsChangesTheContactAzimuth) {
  const Kinematics table = machine_of(axis_of('C', AxisSide::Table, Vec3::UnitZ(), Vec3::Zero()),
                                      axis_of('A', AxisSide::Table, Vec3::UnitX(), Vec3::Zero()));
  const Vec3 n = Vec3(0.3, 0.2, 0.9).normalized();
  const double still = contact_azimuth(table, {0.0, 0.0}, n);
  EXPECT_NEAR(contact_azimuth(table, {0.25, 0.0}, n) - still, 0.25, 1e-12);
  EXPECT_NEAR(still, std::atan2(-n.y(), -n.x()), 1e-15);
  // a head that turns about its own spindle turns the housing the other way
  const Kinematics head = machine_of(axis_of('C', AxisSide::Head, Vec3::UnitZ(), Vec3::Zero()),
                                     axis_of('A', AxisSide::Head, Vec3::UnitX(), Vec3::Zero()));
  EXPECT_NEAR(contact_azimuth(head, {0.25, 0.0}, n) - still, -0.25, 1e-12);
}

TEST(Kinematics, ThreeAndFourAxes) {
  Kinematics mill;
  require_valid(mill);
  EXPECT_EQ(solve_axis(mill, Vec3::UnitZ()).count, 1);
  EXPECT_EQ(solve_axis(mill, Vec3(0.01, 0.0, 1.0).normalized()).count, 0);
  mill.rotary = {axis_of('A', AxisSide::Table, Vec3::UnitX(), Vec3::Zero())};
  require_valid(mill);
  const Vec3 t(0.0, std::sin(0.5), std::cos(0.5));
  ASSERT_EQ(solve_axis(mill, t).count, 1);
  EXPECT_LT(Angle::between(tool_axis(mill, solve_axis(mill, t).solution[0].joints), t).radians(),
            1e-12);
  EXPECT_EQ(solve_axis(mill, Vec3(0.01, 0.0, 1.0).normalized()).count, 0);
}

std::string fault(Kinematics k) {
  try {
    require_valid(k);
  } catch (const InputError& error) {
    return error.property();
  }
  return "none";
}

TEST(Kinematics, BadMachinesAreNamedByTheirPlace) {
  const auto table = AxisSide::Table;
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ(), o = Vec3::Zero();
  EXPECT_EQ(fault(machine_of(axis_of('C', table, z, o), axis_of('A', table, x, o))), "none");
  EXPECT_EQ(fault(machine_of(axis_of('A', table, x, o), axis_of('C', table, z, o))),
            "rotary_axes/1/direction");  // the chain the wrong way round
  EXPECT_EQ(fault(machine_of(axis_of('A', table, -x, o), axis_of('B', table, x, o))),
            "rotary_axes/1/direction");  // parallel
  EXPECT_EQ(fault(machine_of(axis_of('C', table, z, o), axis_of('C', table, x, o))),
            "rotary_axes/1/letter");
  Kinematics k = machine_of(axis_of('C', table, z, o), axis_of('A', table, x, o));
  k.rotary[0].direction = Vec3::Zero();
  EXPECT_EQ(fault(k), "rotary_axes/0/direction");
  k.rotary[0] = axis_of('C', table, z, o);
  k.rotary[1].lowest = 1.0;
  k.rotary[1].highest = -1.0;
  EXPECT_EQ(fault(k), "rotary_axes/1/limits_degrees");
  k.rotary.push_back(k.rotary[0]);
  EXPECT_EQ(fault(k), "rotary_axes");
}

}  // namespace
}  // namespace patchmill::machine
