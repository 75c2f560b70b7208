// The load along a path, and the path that keeps it within limits.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block.h"
#include "patchmill/dcm/air_cuts.h"
#include "patchmill/geometry/error.h"

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

namespace patchmill::load {
namespace {

constexpr double kFeed = 20.0;
const Tool kFlat{3.0, 2, 0.0}, kBall{3.0, 2};
const Resistance kSteel{2000.0, 0.25, 0.3};

// Into the block from the air, a slot, out of it, back through the slot and along its wall.
ToolPath slot(const Tool& tool) {
  const double z = kTop - 4.0;
  return passes(
      tool, {Vec3(-9, 10, z), Vec3(29, 10, z), Vec3(-9, 10, z), Vec3(-9, 12, z), Vec3(29, 12, z)},
      kFeed);
}

double most(const std::vector<LoadAt>& steps, double Load::*what) {
  double found = 0.0;
  for (const LoadAt& s : steps) found = std::max(found, s.load.*what);
  return found;
}

TEST(PathLoad, TakesTheVolumeThatTheStockLoses) {
  const voxel::VoxelGrid grid = block(1.0);
  const ToolPath path = slot(kBall);
  dcm::RemainingStock stock(grid);
  const double before = stock.volume();
  double sum = 0.0;
  for (const LoadAt& s : load_along(path, grid, kSteel)) {
    sum += s.engagement.section * s.length;
    EXPECT_NEAR(s.load.removal, s.engagement.section * kFeed, 1e-9);
  }
  Vec3 from = path.start.tip;
  for (const Move& m : path.moves) {
    for (int i = 1; i <= 400; ++i)
      stock.cut(from + i / 400.0 * (m.end.tip - from) + Vec3(0, 0, 3), Vec3::UnitZ(), kBall);
    from = m.end.tip;
  }
  EXPECT_NEAR(sum, before - stock.volume(), 0.01 * sum);
}

TEST(PathLoad, IsNothingInAirAndWhereTheToolHasBeen) {
  for (const LoadAt& s : load_along(slot(kFlat), block(1.0), kSteel))
    if (s.move == 1) {
      EXPECT_EQ(s.load.force, 0.0);
      EXPECT_EQ(s.load.removal, 0.0);
    }
}

void expect_kept(const LoadLimits& limits, double limit, double Load::*what) {
  const voxel::VoxelGrid grid = block(0.5);
  const ToolPath path = slot(kFlat);
  ASSERT_GT(most(load_along(path, grid, kSteel), what), 1.5 * limit);
  std::vector<std::int64_t> source;
  const ToolPath out = limit_load(path, grid, kSteel, limits, &source);
  ASSERT_EQ(source.size(), out.moves.size());
  const auto steps = load_along(out, grid, kSteel);
  EXPECT_LT(most(steps, what), 1.03 * limit);
  // and no slower than it must: over most of the slot the load is near the limit
  std::vector<double> loads;
  for (const LoadAt& s : steps)
    if (source[s.move] == 0 && s.engagement.section > 20.0) loads.push_back(s.load.*what);
  std::sort(loads.begin(), loads.end());
  EXPECT_GT(loads[loads.size() / 2], 0.9 * limit);
  for (const LoadAt& s : steps) EXPECT_LT(s.feed, kFeed * (1 + 1e-9));
  EXPECT_EQ(out.moves.back().end.tip, path.moves.back().end.tip);
}

TEST(LimitLoad, KeepsTheForce) {
  LoadLimits limits;
  limits.force = 600.0;
  expect_kept(limits, 600.0, &Load::force);
}

TEST(LimitLoad, KeepsThePower) {
  LoadLimits limits;
  limits.power = 500.0;
  expect_kept(limits, 500.0, &Load::power);
}

TEST(LimitLoad, KeepsTheChipThickness) {
  LoadLimits limits;
  limits.chip = 0.03;
  expect_kept(limits, 0.03, &Load::chip);
}

TEST(LimitLoad, SlowsDownBeforeTheToolMeetsTheStock) {
  LoadLimits limits;
  limits.force = 600.0;
  const voxel::VoxelGrid grid = block(1.0);
  const ToolPath out = limit_load(slot(kFlat), grid, kSteel, limits);
  double x = -9.0;
  for (const Move& m : out.moves) {
    const double length = m.end.tip.x() - x, feed = length / duration(m, out.spindle);
    if (m.end.tip.x() < -4.0 - 1e-9) {
      EXPECT_NEAR(feed, kFeed, 1e-9);  // in air as it was
    }
    if (x <= -3.5 && m.end.tip.x() > -3.4) {
      EXPECT_LT(feed, 0.9 * kFeed);
    }
    x = m.end.tip.x();
    if (x > -3.0) break;  // where the tool's front comes to the block
  }
  EXPECT_GT(x, -3.0);
}

TEST(LimitLoad, LeavesAPathWithinItsLimitsAsItIs) {
  LoadLimits limits;
  limits.force = 1e6;
  limits.power = 1e6;
  limits.chip = 1.0;
  const ToolPath path = slot(kFlat), out = limit_load(path, block(1.0), kSteel, limits);
  ASSERT_EQ(out.moves.size(), path.moves.size());
  for (std::size_t i = 0; i < out.moves.size(); ++i) {
    EXPECT_EQ(out.moves[i].turns, path.moves[i].turns);
    EXPECT_EQ(out.moves[i].end.tip, path.moves[i].end.tip);
  }
}

TEST(LimitLoad, RapidsStayRapids) {
  ToolPath path = slot(kFlat);
  path.moves[0].kind = MoveKind::Rapid;
  path.moves[0].turns = kUnknownTurns;
  LoadLimits limits;
  limits.force = 100.0;
  const ToolPath out = limit_load(path, block(1.0), kSteel, limits);
  EXPECT_EQ(out.moves[0].kind, MoveKind::Rapid);
  EXPECT_TRUE(std::isnan(out.moves[0].turns));
  EXPECT_EQ(out.moves[0].end.tip, path.moves[0].end.tip);
}

std::string named(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& e) {
    return e.property();
  }
  return "";
}

TEST(LimitLoad, RefusesWhatItCannotUse) {
  const voxel::VoxelGrid grid = block(2.0);
  const auto with = [&](const std::function<void(ToolPath&, Resistance&, LoadLimits&)>& change) {
    ToolPath path = slot(kFlat);
    Resistance resistance = kSteel;
    LoadLimits limits;
    limits.force = 100.0;
    change(path, resistance, limits);
    return named([&] { limit_load(path, grid, resistance, limits); });
  };
  EXPECT_EQ(with([](auto& p, auto&, auto&) { p.moves[0].dimple = 3; }), "base operation");
  EXPECT_EQ(with([](auto& p, auto&, auto&) { p.tool.flutes = 0; }), "flutes");
  EXPECT_EQ(with([](auto& p, auto&, auto&) { p.spindle.speed = 0; }), "spindle speed");
  EXPECT_EQ(with([](auto&, auto& r, auto&) { r.specific = 0; }), "SpecificForce");
  EXPECT_EQ(with([](auto&, auto& r, auto&) { r.exponent = 1; }), "ForceExponent");
  EXPECT_EQ(with([](auto&, auto& r, auto&) { r.normal = -1; }), "NormalForce");
  EXPECT_EQ(with([](auto&, auto&, auto& l) { l.force = 0; }), "ForceLimit");
  EXPECT_EQ(with([](auto&, auto&, auto& l) { l.power = -1; }), "PowerLimit");
  EXPECT_EQ(with([](auto&, auto&, auto& l) { l.chip = std::nan(""); }), "ChipLimit");
}

}  // namespace
}  // namespace patchmill::load
