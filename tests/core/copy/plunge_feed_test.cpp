// The feed downwards against its closed form on moves of every slope.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/plunge_feed.h"

#include "patchmill/geometry/error.h"

#include <cmath>

#include <gtest/gtest.h>

namespace patchmill::copy {
namespace {

ToolPath one_move(const Vec3& way, double feed, MoveKind kind) {
  ToolPath path;
  path.tool = {3.0, 2};
  path.spindle.speed = 100.0;
  Move move;
  move.end.tip = way;
  move.kind = kind;
  if (kind != MoveKind::Rapid) move.turns = path.spindle.speed * way.norm() / feed;
  path.moves.push_back(move);
  return path;
}

TEST(PlungeFeed, CountsForTheVerticalPart) {
  constexpr double kFeed = 10.0, kVertical = 3.0, kLength = 2.0;
  for (int degrees = -90; degrees <= 90; degrees += 3) {
    const double a = degrees * 3.14159265358979323846 / 180.0;
    const Vec3 way(kLength * std::cos(a), 0.0, -kLength * std::sin(a));
    for (const MoveKind kind : {MoveKind::Link, MoveKind::Cut}) {
      const ToolPath made = with_plunge_feed(one_move(way, kFeed, kind), kVertical);
      const double feed = kLength / duration(made.moves[0], made.spindle);
      const double expected = degrees > 0 ? std::min(kFeed, kVertical / std::sin(a))
                                          : kFeed;  // upwards at the path's own
      EXPECT_NEAR(feed, expected, 1e-9) << degrees;
      EXPECT_EQ(made.moves[0].end.tip, way);
    }
  }
}

TEST(PlungeFeed, LeavesRapidsAndWhatIsSlower) {
  const ToolPath rapid = with_plunge_feed(one_move({0, 0, -5}, 1.0, MoveKind::Rapid), 3.0);
  EXPECT_TRUE(std::isnan(rapid.moves[0].turns));
  const ToolPath slow = with_plunge_feed(one_move({0, 0, -5}, 1.0, MoveKind::Cut), 3.0);
  EXPECT_NEAR(5.0 / duration(slow.moves[0], slow.spindle), 1.0, 1e-12);
}

TEST(PlungeFeed, RefusesNoFeed) {
  for (const double bad : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(with_plunge_feed({}, bad), InputError);
}

}  // namespace
}  // namespace patchmill::copy
