// Tool-axis modes: what each promises, and what smoothing may do.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/tool_axis.h"

#include "patchmill/geometry/error.h"
#include "patchmill/sync/contact_azimuth.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace patchmill::sync {
namespace {

// A row over a cylinder of radius 20 along Y, its normals from -30 to 30 degrees in the X-Z plane.
patch::Dimples row_over_cylinder(int count) {
  patch::Dimples dimples;
  for (int i = 0; i < count; ++i) {
    const double a = Angle::degrees(-30.0 + 60.0 * i / (count - 1)).radians();
    patch::Dimple d;
    d.surface.normal = Vec3(std::sin(a), 0.0, std::cos(a));
    d.surface.position = 20.0 * d.surface.normal;
    dimples.push_back(d);
  }
  return dimples;
}

ToolAxisRule normal_rule(double lead, double tilt) {
  ToolAxisRule rule;
  rule.mode = ToolAxisMode::Normal;
  rule.lead = Angle::degrees(lead);
  rule.tilt = Angle::degrees(tilt);
  return rule;
}

TEST(ToolAxis, LeadAndTiltAreAngledFromTheNormal) {
  const patch::Dimples row = row_over_cylinder(31);
  const auto ahead = tool_axes(row, normal_rule(12.0, 0.0));
  const auto aside = tool_axes(row, normal_rule(0.0, 7.0));
  for (std::size_t k = 1; k + 1 < row.size(); ++k) {
    const Vec3& n = row[k].surface.normal;
    const Vec3 feed = (row[k + 1].surface.position - row[k - 1].surface.position).normalized();
    EXPECT_NEAR(Angle::between(ahead[k], n).radians(), Angle::degrees(12.0).radians(), 1e-12);
    EXPECT_GT(ahead[k].dot(feed), 0.2);
    EXPECT_NEAR(Angle::between(aside[k], n).radians(), Angle::degrees(7.0).radians(), 1e-12);
    EXPECT_NEAR(aside[k].dot(feed), 0.0, 1e-12);
    EXPECT_GT(aside[k].dot(n.cross(feed)), 0.1);  // to the left of the feed
  }
  ToolAxisRule fixed = normal_rule(12.0, 0.0);
  fixed.towards = Vec3::UnitY();
  for (const Vec3& t : tool_axes(row, fixed))
    EXPECT_NEAR(t.y(), std::sin(Angle::degrees(12.0).radians()), 1e-12);
}

TEST(ToolAxis, MinimumLeadLeavesAloneWhatIsFarEnough) {
  const patch::Dimples row = row_over_cylinder(61);
  ToolAxisRule rule;
  rule.mode = ToolAxisMode::MinimumLead;
  rule.least_lead = Angle::degrees(10.0);
  const auto axes = tool_axes(row, rule);
  int moved = 0;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const Vec3& n = row[k].surface.normal;
    EXPECT_GE(Angle::between(axes[k], n).radians(), Angle::degrees(10.0).radians() - 1e-12);
    if (Angle::between(n, Vec3::UnitZ()).radians() >= Angle::degrees(10.0).radians()) {
      EXPECT_EQ(axes[k], Vec3(Vec3::UnitZ()));
    } else {
      EXPECT_NEAR(Angle::between(axes[k], n).radians(), Angle::degrees(10.0).radians(), 1e-12);
      ++moved;
    }
  }
  EXPECT_EQ(moved, 19);
}

TEST(ToolAxis, NoDimpleHoldsTheTipWithALead) {
  patch::Dimples row = row_over_cylinder(61);
  mark_tool_tip(row, std::vector<Vec3>(row.size(), Vec3::UnitZ()), Angle::degrees(5.0));
  EXPECT_GT(patch::count_states(row)[static_cast<std::size_t>(patch::DimpleState::ToolTip)], 0);
  patch::Dimples leading = row_over_cylinder(61);
  mark_tool_tip(leading, tool_axes(leading, normal_rule(12.0, 0.0)), Angle::degrees(5.0));
  EXPECT_EQ(patch::count_states(leading)[static_cast<std::size_t>(patch::DimpleState::ToolTip)], 0);
}

// Total bend of a run of axes: sum of second differences.
double roughness(const std::vector<Vec3>& axes) {
  double sum = 0.0;
  for (std::size_t k = 1; k + 1 < axes.size(); ++k)
    sum += (axes[k - 1] - 2.0 * axes[k] + axes[k + 1]).norm();
  return sum;
}

TEST(ToolAxis, SmoothingStaysWithinItsTolerance) {
  patch::Dimples row = row_over_cylinder(61);
  ToolAxisRule rule;
  rule.mode = ToolAxisMode::Field;
  for (std::size_t k = 0; k < row.size(); ++k)  // a staircase, as of a coarse posture field
    rule.field.push_back(
        Vec3(std::sin(0.1 * std::floor(k / 10.0)), 0.02 * (k % 2), 1.0).normalized());
  const auto rough = tool_axes(row, rule);
  rule.smoothing = Angle::degrees(4.0);
  const auto smooth = tool_axes(row, rule);
  for (std::size_t k = 0; k < row.size(); ++k)
    EXPECT_LE(Angle::between(smooth[k], rough[k]).radians(), Angle::degrees(4.0).radians() + 1e-12);
  EXPECT_LT(roughness(smooth), 0.2 * roughness(rough));
}

TEST(ToolAxis, AFieldIsTakenAsItIsButLeanedAwayFromTheNormal) {
  const patch::Dimples row = row_over_cylinder(61);
  ToolAxisRule rule;
  rule.mode = ToolAxisMode::Field;
  for (std::size_t k = 0; k < row.size(); ++k)
    rule.field.push_back((row[k].surface.normal + 0.01 * k * Vec3::UnitX()).normalized());
  for (std::size_t k = 0; k < row.size(); ++k)
    EXPECT_LT((tool_axes(row, rule)[k] - rule.field[k]).norm(), 1e-15);
  rule.least_lead = Angle::degrees(10.0);
  const auto axes = tool_axes(row, rule);
  for (std::size_t k = 0; k < row.size(); ++k) {
    const double asked = Angle::between(rule.field[k], row[k].surface.normal).radians();
    const double now = Angle::between(axes[k], row[k].surface.normal).radians();
    EXPECT_NEAR(now, std::max(asked, rule.least_lead.radians()), 1e-9);
    EXPECT_NEAR(Angle::between(axes[k], rule.field[k]).radians(), now - asked, 1e-9);
  }
}

TEST(ToolAxis, WidestTiltIsKept) {
  ToolAxisRule rule = normal_rule(20.0, 0.0);
  rule.widest = Angle::degrees(25.0);
  for (const Vec3& t : tool_axes(row_over_cylinder(31), rule))
    EXPECT_LE(Angle::between(t, Vec3::UnitZ()).radians(), Angle::degrees(25.0).radians() + 1e-12);
}

TEST(ToolAxis, RowsKeepOneAxisWithinTheTolerance) {
  const patch::Dimples row = row_over_cylinder(61);
  const auto asked = tool_axes(row, normal_rule(10.0, 0.0));
  const auto axes = axes_by_row(row, asked, Angle::degrees(8.0));
  int pieces = 1;
  for (std::size_t k = 0; k < row.size(); ++k) {
    EXPECT_LE(Angle::between(axes[k], asked[k]).radians(), Angle::degrees(8.0).radians() + 1e-12);
    if (k && axes[k] != axes[k - 1]) ++pieces;
  }
  EXPECT_EQ(pieces, 4);  // 60 degrees of normals in pieces of less than 16
}

// Two straight rows of ten, the second a step to the side and back again.
patch::Dimples two_rows() {
  patch::Dimples rows;
  for (int k = 0; k < 20; ++k) {
    patch::Dimple d;
    d.surface.position = Vec3(k < 10 ? k : 19 - k, k < 10 ? 0.0 : 1.0, 0.0);
    d.surface.normal = Vec3::UnitZ();
    rows.push_back(d);
  }
  return rows;
}

TEST(ToolAxis, ARowKeepsTheAxisBeforeAsFarAsHalfTheTolerance) {
  const patch::Dimples rows = two_rows();
  const auto tilted = [](double degrees) {
    const double a = Angle::degrees(degrees).radians();
    return Vec3(0.0, std::sin(a), std::cos(a));
  };
  for (const double apart : {2.0, 4.9, 7.0, 20.0}) {
    std::vector<Vec3> asked(20, tilted(1.0));
    std::fill(asked.begin() + 10, asked.end(), tilted(1.0 + apart));
    const auto axes = axes_by_row(rows, asked, Angle::degrees(10.0));
    for (int k = 0; k < 10; ++k) EXPECT_LT(Angle::between(axes[k], asked[k]).radians(), 1e-12);
    // both rows ask for one axis each: the second stands still, or turns all but five degrees
    const double turned = std::max(0.0, apart - 5.0);
    for (int k = 10; k < 20; ++k)
      EXPECT_LT(Angle::between(axes[k], tilted(1.0 + turned)).radians(), 1e-9) << apart;
    EXPECT_EQ(axes[9] == axes[10], apart < 5.0);
  }
}

TEST(ToolAxis, KeepingARowsAxisNeverLeavesTheTolerance) {
  std::mt19937 random(11);
  std::normal_distribution<double> wander(0.0, 0.04);
  const patch::Dimples rows = two_rows();
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec3> asked;
    for (int k = 0; k < 20; ++k)
      asked.push_back(
          Vec3(wander(random), wander(random) + (k < 10 ? 0.0 : 0.15), 1.0).normalized());
    const auto axes = axes_by_row(rows, asked, Angle::degrees(9.0));
    for (int k = 0; k < 20; ++k)
      EXPECT_LE(Angle::between(axes[k], asked[k]).radians(), Angle::degrees(9.0).radians() + 1e-12);
  }
}

std::string fault(const ToolAxisRule& rule) {
  try {
    tool_axes(row_over_cylinder(3), rule);
  } catch (const InputError& error) {
    return error.property();
  }
  return "none";
}

TEST(ToolAxis, BadInputIsNamed) {
  EXPECT_EQ(fault(normal_rule(85.0, 0.0)), "Lead");
  EXPECT_EQ(fault(normal_rule(0.0, -95.0)), "Tilt");
  ToolAxisRule rule;
  rule.axis = Vec3::Zero();
  EXPECT_EQ(fault(rule), "FixedAxis");
  rule = ToolAxisRule();
  rule.mode = ToolAxisMode::Field;
  EXPECT_EQ(fault(rule), "PostureField");
  rule.field.assign(3, Vec3::Zero());
  EXPECT_EQ(fault(rule), "PostureField");
  rule = ToolAxisRule();
  rule.smoothing = Angle::degrees(50.0);
  EXPECT_EQ(fault(rule), "AxisSmoothing");
}

}  // namespace
}  // namespace patchmill::sync
