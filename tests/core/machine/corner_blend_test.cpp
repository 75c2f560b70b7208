// Corner roundings against plane geometry, and the pitches that make up for them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/corner_blend.h"

#include "patchmill/geometry/error.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::machine {
namespace {

MotionModel machine() {
  MotionModel model;
  model.velocity = 100.0;
  model.acceleration = 2000.0;
  model.spindle_lock = true;
  return model;
}

RC_GTEST_PROP(CornerBlend, ArcTouchesBothMovesAndStaysInTolerance, (unsigned a, unsigned t)) {
  const double angle = 0.001 + 2.6 * (a % 1000) / 1000.0, tolerance = 1e-6 * (1 + t % 5000);
  const Corner corner = corner_blend(angle, tolerance, 1e6, 1e6, 2000.0);
  // centre: at right angles to the first move, `trim` before the corner; the moves run along +x and
  // then at `angle`
  const double radius = corner.arc / angle;
  const Eigen::Vector2d centre(-corner.trim, radius);
  const Eigen::Vector2d end = corner.trim * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  RC_ASSERT(std::abs((end - centre).norm() - radius) < 1e-9 * radius + 1e-12);
  RC_ASSERT(std::abs(centre.norm() - radius - tolerance) < 1e-7 * tolerance + 1e-9 * radius);
  // what the normal acceleration allows on it
  RC_ASSERT(corner.speed * corner.speed / radius <= 2000.0);
  RC_ASSERT(std::abs(tolerance_for_speed(angle, corner.speed, 2000.0) - tolerance) <
            1e-9 * tolerance);
}

// A direction between the axes is faster than an axis, and so is a flat corner in the axes' plane: its velocity is
// that of the chord between those of its sides. A straight of 4.04 periods at 100 mm/s is one of 3.99 there, and is
// swallowed, as LinuxCNC's log of such a corner shows.
TEST(CornerBlend, AFlatCornerIsAsFastAsItsSides) {
  const double tilt = 0.16, angle = 0.00776;
  const Vec3 before(std::cos(tilt), 0.0, std::sin(tilt)),
      after(std::cos(tilt - angle), 0.0, std::sin(tilt - angle));
  const double fast = 100.0 / std::cos(tilt - 0.5 * angle);
  const auto corner = [&](double left) {
    return corner_between({before, 0.5147, left}, {after, 0.5137, 0.5137}, 0.000106, machine());
  };
  const double trim = corner(0.5).trim;
  EXPECT_NEAR(corner(0.5).planned, fast, 0.1);
  EXPECT_GT(corner(0.5).planned, 101.0);
  EXPECT_FALSE(corner(trim + 1.002 * 4e-3 * fast).swallows);
  EXPECT_TRUE(corner(trim + 0.998 * 4e-3 * fast).swallows);
}

// A corner of 0.33 mrad, with an arc of 0.025 mm: alone it would be passed in a period at 25 mm/s, and the kink at
// 188. With the straight of 0.48 mm that it swallows it is as fast as its radius lets it be, and LinuxCNC's log shows
// it taken: half of the acceleration, and the next move's K, from the straight's beginning on.
TEST(CornerBlend, AnArcCountsTheStraightThatItSwallows) {
  MotionModel fast = machine();
  fast.velocity = 300.0;
  fast.acceleration = 500.0;
  const Vec3 before(-0.2573, -0.4170, -0.0614), after(-0.2575, -0.4175, -0.0616);
  const auto side = [](const Vec3& way) {
    return CornerSide{way.normalized(), way.norm(), way.norm()};
  };
  const Corner corner = corner_between(side(before), side(after), 1e-6, fast);
  EXPECT_TRUE(corner.swallows);
  EXPECT_NEAR(corner.arc, 0.0245, 1e-3);
  EXPECT_GT(corner.speed, kink_speed(side(before), side(after), fast));
  EXPECT_DOUBLE_EQ(corner.speed, corner.planned);
}

TEST(CornerBlend, TakesAtMostHalfOfANeighbour) {
  const Corner corner = corner_blend(0.4, 0.01, 10.0, 0.15, 2000.0);
  EXPECT_DOUBLE_EQ(corner.trim, 0.075);
}

TEST(CornerBlend, StopsWithoutToleranceAndAtReversals) {
  EXPECT_TRUE(corner_blend(1.0, 0.0, 1.0, 1.0, 2000.0).stop);
  EXPECT_TRUE(corner_blend(kPi, 0.1, 1.0, 1.0, 2000.0).stop);
  EXPECT_FALSE(corner_blend(0.0, 0.0, 1.0, 1.0, 2000.0).stop);
}

// A locked polyline with random corners, pitches' turns and tolerances.
ToolPath random_path(const std::vector<unsigned>& seeds) {
  ToolPath path;
  path.tool = {1.0, 2};
  path.spindle.speed = 1000.0 / 60.0;
  Vec3 at = Vec3::Zero();
  double heading = 0.0;
  for (const unsigned seed : seeds) {
    heading += 0.6 * ((seed % 101) / 50.0 - 1.0);
    const double length = 0.5 + (seed / 101 % 50) / 50.0;
    at += length * Vec3(std::cos(heading), std::sin(heading), 0.0);
    Move move;
    move.end.tip = at;
    move.kind = MoveKind::Cut;
    move.pace = Pace::SpindleLocked;
    move.turns = length * (0.7 + (seed / 5050 % 60) / 100.0);
    move.tolerance = seed % 7 == 0 ? 0.0 : 1e-4 * (seed % 7);
    path.moves.push_back(move);
  }
  return path;
}

RC_GTEST_PROP(LockedPitches, GiveBackTheTurnsOfEachMove, (const std::vector<unsigned>& seeds)) {
  RC_PRE(!seeds.empty());
  const ToolPath path = random_path(seeds);
  const std::vector<Corner> corner = corners(path, machine());
  const std::vector<double> pitches = locked_pitches(path, corner);
  const std::vector<double> turns = locked_turns(path, corner, pitches);
  // and counted along the rounded path, piece by piece, as the controller does
  double counted = 0.0, planned = 0.0;
  Vec3 from = path.start.tip;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    RC_ASSERT(std::abs(turns[i] - path.moves[i].turns) < 1e-12);
    const double line =
        (path.moves[i].end.tip - from).norm() - corner[i].trim - (i ? corner[i - 1].trim : 0.0);
    from = path.moves[i].end.tip;
    counted += line / pitches[i];
    if (i + 1 < pitches.size()) counted += corner[i].arc / pitches[i + 1];
    planned += path.moves[i].turns;
  }
  RC_ASSERT(std::abs(counted - planned) < 1e-9);
}

TEST(LockedPitches, AreLengthOverTurnsWhereTheMachineStops) {
  ToolPath path = random_path({1010, 30303, 77});
  for (Move& move : path.moves) move.tolerance = 0.0;
  const std::vector<double> pitches = locked_pitches(path, corners(path, machine()));
  Vec3 from = path.start.tip;
  for (std::size_t i = 0; i < pitches.size(); ++i) {
    EXPECT_NEAR(pitches[i], (path.moves[i].end.tip - from).norm() / path.moves[i].turns, 1e-12);
    from = path.moves[i].end.tip;
  }
}

TEST(LockedPitches, RefuseAMoveWithoutTurns) {
  ToolPath path = random_path({1010, 30303});
  path.moves[1].turns = 0.0;
  EXPECT_THROW(locked_pitches(path, corners(path, machine())), InputError);
}

TEST(PostedTolerances, GiveEachCornerItsOwn) {
  ToolPath path = random_path({11, 22, 33, 44, 55});
  const double wanted[] = {1e-5, 2e-3, 0.0, 2e-3, 1e-5};
  for (int i = 0; i < 5; ++i) path.moves[i].tolerance = wanted[i];
  const std::vector<double> posted = posted_tolerances(path, machine());
  EXPECT_EQ(posted[2], 0.0);
  for (int i : {0, 3}) EXPECT_EQ(std::min(posted[i], posted[i + 1]), wanted[i]) << i;
}

}  // namespace
}  // namespace patchmill::machine
