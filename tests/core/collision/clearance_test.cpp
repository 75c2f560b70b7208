// Gouges and collisions are found with their place and depth; clean paths pass; a part without a
// shape is unknown.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/clearance.h"

#include "marks/arrays.h"
#include "patchmill/collision/gouge.h"
#include "patchmill/collision/point_distance.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::collision {
namespace {

const PartDistance kHalfSpace = [](const Vec3& p) { return p.z(); };
const Vec3 kAxis(0.5, 0.0, std::sqrt(0.75));

ToolPath path_of_balls(const std::vector<Vec3>& centres, const Vec3& axis = kAxis) {
  ToolPath path;
  path.tool = {1.0, 2};
  path.spindle = {10.0, SpindleSense::M3};
  path.start = pose_of_ball(centres.front(), axis, 1.0);
  for (std::size_t k = 1; k < centres.size(); ++k)
    path.moves.push_back({pose_of_ball(centres[k], axis, 1.0), 0.5, kNoDimple, MoveKind::Cut});
  return path;
}

TEST(Clearance, TouchingPathIsClear) {
  const auto report =
      check_sections(path_of_balls({{0, 0, 3}, {0, 0, 1}, {0.5, 0, 1}, {5, 0, 4}}), {}, kHalfSpace);
  EXPECT_EQ(report.outcome, ClearanceOutcome::Clear);
}

TEST(Clearance, GougeHasPlaceAndDepth) {
  const auto report =
      check_sections(path_of_balls({{0, 0, 3}, {2, 0, 0.95}, {4, 0, 3}}), {}, kHalfSpace);
  ASSERT_EQ(report.outcome, ClearanceOutcome::Violated);
  ASSERT_EQ(report.findings.size(), 2u);  // the end of one move and the start of the next
  EXPECT_EQ(report.findings[0].part, ToolPart::Ball);
  EXPECT_EQ(report.findings[0].move, 0);
  EXPECT_EQ(report.findings[0].share, 1.0);
  EXPECT_NEAR(report.findings[0].depth, 0.05 - 0.002, 1e-9);
  EXPECT_LT((report.findings[0].place - Vec3(2, 0, 0)).norm(), 1e-6);
}

// A thin pin in the middle of a long link: nothing that is sampled at the ends sees it.
TEST(Clearance, LinksAreCheckedOnTheirWay) {
  const Vec3 pin(5.3, 0.0, 0.0);
  const PartDistance distance = [&](const Vec3& p) { return (p - pin).norm() - 0.05; };
  ToolPath path = path_of_balls({{0, 0, 0.9}, {10, 0, 0.9}});
  path.moves[0].kind = MoveKind::Rapid;
  path.moves[0].turns = kUnknownTurns;
  const auto report = check_sections(path, {}, distance);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_NEAR(report.findings[0].depth, 1.0 + 0.05 - 0.9 - 0.002, 1e-3);
  EXPECT_NEAR(report.findings[0].share, 0.53, 1e-3);
}

TEST(Clearance, HolderCollidesWhereTheShankDoesNot) {
  const std::vector<ToolSection> tool = {{ToolPart::Shank, 1.0, 20.0, 1.0, 1.0},
                                         {ToolPart::Holder, 20.0, 60.0, 15.0, 20.0}};
  // tilted by 60 degrees: the holder's lower edge is at z = 20 cos 60 - 15 sin 60 < 0
  const Vec3 flat(std::sin(kPi / 3), 0.0, std::cos(kPi / 3));
  const auto report = check_sections(path_of_balls({{0, 0, 9}, {0, 0, 1}}, flat), tool, kHalfSpace);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].part, ToolPart::Holder);
  const double tip = 1 - std::cos(kPi / 3);
  const double lowest = tip + 20 * std::cos(kPi / 3) - 15 * std::sin(kPi / 3);
  const double top = tip + 60 * std::cos(kPi / 3) - 20 * std::sin(kPi / 3);
  EXPECT_NEAR(report.findings[0].depth, 0.1 - std::min(lowest, top), 0.02 * 2.6);
  EXPECT_NEAR(report.findings[0].place.z(), lowest, 0.02 * 2.6);
  EXPECT_EQ(check_sections(path_of_balls({{0, 0, 9}, {0, 0, 1}}), tool, kHalfSpace).outcome,
            ClearanceOutcome::Clear);
}

// The disc below a holder is flat: a ball of its radius would reach lower.
TEST(Clearance, UprightHolderMayComeNear) {
  const std::vector<ToolSection> tool = {{ToolPart::Holder, 10.0, 30.0, 15.0, 15.0}};
  const auto path = path_of_balls({{0, 0, 1}, {3, 0, 1}}, Vec3::UnitZ());
  EXPECT_EQ(check_sections(path, tool, kHalfSpace).outcome, ClearanceOutcome::Clear);
  const PartDistance wall = [](const Vec3& p) { return std::min(p.z(), 12.0 - p.x()); };
  const auto report = check_sections(path, tool, wall);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_NEAR(report.findings[0].depth, 15.0 + 3.0 - 12.0 + 0.1, 0.02 * 6.1);
}

TEST(Clearance, UnknownIsNotAPass) {
  const auto path = path_of_balls({{0, 0, 3}, {5, 0, 3}});
  const auto none = check_sections(path, {}, {});
  EXPECT_EQ(none.outcome, ClearanceOutcome::Unknown);
  EXPECT_FALSE(none.reason.empty());
  const PartDistance hole = [](const Vec3& p) {
    return p.x() > 4.0 ? std::numeric_limits<double>::quiet_NaN() : p.z();
  };
  const auto partly = check_sections(path, {}, hole);
  EXPECT_EQ(partly.outcome, ClearanceOutcome::Unknown);
  EXPECT_EQ(partly.unknown_moves, 1);
  EXPECT_EQ(check_sections(path, {}, kHalfSpace, {}, [](double) { return false; }).outcome,
            ClearanceOutcome::Unknown);
  EXPECT_EQ(check_sections(path, {}, distance_from_points({}, 0.1)).outcome,
            ClearanceOutcome::Unknown);
}

TEST(Gouges, OfTheReliefHavePlaceAndDepth) {
  test::MarkMaker maker;
  ToolPath path = maker.path({{0, 0}, {0.5, 0}, {1.0, 0}});
  for (std::size_t k = 3; k <= 4; ++k) path.moves[k].end.tip.z() -= 0.03;  // the second mark
  const marks::SurfaceGrid grid =
      marks::flat_grid(test::plane_z0(), {-0.3, -0.3}, {1.3, 0.3}, 0.01);
  const marks::Relief relief = marks::simulate_marks(marks::motion_of(path, maker.locked(3)),
                                                     {path.tool, {}, {}}, grid, {0.05})
                                   .relief;
  const auto gouges = find_gouges(relief, 0.002);
  ASSERT_EQ(gouges.size(), 1u);
  EXPECT_NEAR(gouges[0].depth, 0.03, 1e-3);
  EXPECT_LT((gouges[0].plane_place - Vec2(0.5, 0)).norm(), 0.05);
  EXPECT_TRUE(find_gouges(relief, 0.04).empty());
}

std::vector<patch::SurfacePoint> plane_points(double spacing) {
  std::vector<patch::SurfacePoint> points;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j)
      points.push_back({{spacing * i, spacing * j, 0.0}, Vec3::UnitZ()});
  return points;
}

RC_GTEST_PROP(PointDistance, IsNeverMoreThanTheTrueOneOutside,
              (std::uint16_t a, std::uint16_t b, std::uint16_t c)) {
  static const PartDistance distance =
      distance_from_points(plane_points(0.25), 0.25 * std::sqrt(2.0));
  const Vec3 p(a % 1000 * 0.01, b % 1000 * 0.01, c % 500 * 0.01);
  const double d = distance(p);
  RC_ASSERT(d <= p.z() + 1e-12);
  RC_ASSERT(d >= p.z() - 0.18);
}

TEST(PointDistance, GougeInAPointCloud) {
  const PartDistance distance = distance_from_points(plane_points(0.25), 0.25 * std::sqrt(2.0));
  const auto report =
      check_sections(path_of_balls({{2, 2, 4}, {5, 5, 0.9}}), {}, distance, {0.01, 0.1, 0.001, 10});
  ASSERT_EQ(report.outcome, ClearanceOutcome::Violated);
  EXPECT_NEAR(report.findings[0].depth, 0.09, 0.01);
  EXPECT_TRUE(std::isnan(distance_from_points(plane_points(0.25), 0.36, 1.0)({5, 5, 3})));
}

TEST(Clearance, NothingLookedAtIsNoPass) {
  const PartDistance far_away = [](const Vec3&) { return 100.0; };
  const ToolPath path = path_of_balls({{2, 2, 4}, {5, 5, 4}});
  ClearanceOptions options;
  options.first_move = path.moves.size() - 1;
  EXPECT_EQ(check_sections(path, {}, far_away, options).outcome, ClearanceOutcome::Clear);
  options.first_move = path.moves.size();
  const auto report = check_sections(path, {}, far_away, options);
  EXPECT_EQ(report.outcome, ClearanceOutcome::Unknown);
  EXPECT_FALSE(report.reason.empty());
}

}  // namespace
}  // namespace patchmill::collision
