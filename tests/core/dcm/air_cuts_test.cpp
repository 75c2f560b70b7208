// Emptied voxels, and the moves that are hurried over.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/air_cuts.h"

#include "patchmill/geometry/error.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::dcm {
namespace {

constexpr double kRadius = 3.0;
const Tool kBall{kRadius, 2}, kFlat{kRadius, 2, 0.0};

voxel::VoxelGrid block(double pitch) {
  voxel::VoxelOptions options;
  options.pitch = pitch;
  return voxel::voxelise(mesh::box_mesh(Vec3(0, 0, 0), Vec3(40, 40, 20)),
                         mesh::box_mesh(Vec3(0, 0, 0), Vec3(40, 40, 8)), options);
}

ToolPath passes(const std::vector<Vec3>& tips, double speed) {
  ToolPath path;
  path.tool = {kRadius, 2};
  path.spindle.speed = 100.0;
  path.start.tip = tips.front();
  Vec3 from = tips.front();
  for (std::size_t i = 1; i < tips.size(); ++i) {
    Move move;
    move.kind = MoveKind::Cut;
    move.end.tip = tips[i];
    move.turns = path.spindle.speed * (tips[i] - from).norm() / speed;
    path.moves.push_back(move);
    from = tips[i];
  }
  return path;
}

TEST(RemainingStock, LosesTheVolumeOfASlot) {
  const voxel::VoxelGrid grid = block(1.0);
  RemainingStock stock(grid);
  const double before = stock.volume();
  const auto count = voxel::count_kinds(grid);
  EXPECT_NEAR(before, double(count[2] + count[3] + count[4]), 1e-6);
  for (double x = -5; x <= 45; x += 0.125) stock.cut(Vec3(x, 20, 13), Vec3::UnitZ(), kBall);
  const double slot = 40 * (0.5 * kPi * kRadius * kRadius + 2 * kRadius * 7);
  EXPECT_NEAR(before - stock.volume(), slot, 0.01 * slot);
}

TEST(RemainingStock, ALyingToolCutsTheSameSlot) {
  const voxel::VoxelGrid grid = block(1.0);
  RemainingStock stock(grid);
  const double before = stock.volume();
  const Vec3 axis = Vec3(0, 1, 0);
  for (double x = -5; x <= 45; x += 0.125) stock.cut(Vec3(x, 20, 14), axis, kBall);
  const double slot = 40 * (0.5 * kPi * kRadius * kRadius + 2 * kRadius * 20);
  EXPECT_NEAR(before - stock.volume(), slot, 0.01 * slot);
}

TEST(RemainingStock, AFlatEndCutsASquareSlot) {
  const voxel::VoxelGrid grid = block(1.0);
  RemainingStock stock(grid);
  const double before = stock.volume();
  for (double x = -5; x <= 45; x += 0.125)
    stock.cut(Vec3(x, 20, 13 - kRadius), Vec3::UnitZ(), kFlat);
  const double slot = 40 * 2 * kRadius * 10;
  EXPECT_NEAR(before - stock.volume(), slot, 0.02 * slot);
}

TEST(RemainingStock, ABullNoseLeavesTheCornersOfItsSlot) {
  const voxel::VoxelGrid grid = block(1.0);
  RemainingStock stock(grid);
  const double before = stock.volume(), corner = 0.5 * kRadius;
  const Tool tool{kRadius, 2, corner};
  for (double x = -5; x <= 45; x += 0.125)
    stock.cut(Vec3(x, 20, 13 - kRadius + corner), Vec3::UnitZ(), tool);
  const double slot = 40 * (2 * kRadius * 10 - (2.0 - 0.5 * kPi) * corner * corner);
  EXPECT_NEAR(before - stock.volume(), slot, 0.02 * slot);
}

// Every sample of every voxel asked at every place, along a random way in the block and beyond it.
RC_GTEST_PROP(RemainingStock, EqualsAskingEverySample, (unsigned seed)) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  voxel::VoxelOptions options;
  options.pitch = 2.0;
  const voxel::VoxelGrid grid = voxel::voxelise(mesh::box_mesh(Vec3(0, 0, 0), Vec3(37, 25, 20)),
                                                shapes::sphere(Vec3(18, 12, 9), 6, 2), options);
  std::vector<Vec3> samples;
  shapes::for_each_cell(grid.table, [&](std::size_t i, const voxel::Cell& c) {
    if (grid.kind[i] == voxel::VoxelKind::Air || grid.kind[i] == voxel::VoxelKind::Part) return;
    for (int n = 0; n < 64; ++n)
      samples.push_back(2.0 * c.cast<double>() +
                        0.5 * (Vec3(n % 4, n / 4 % 4, n / 16) + Vec3::Constant(0.5)));
  });
  RemainingStock stock(grid);
  Tool tool{2.5 + 2.0 * number(random), 2};
  if (seed % 3 == 1) tool.corner_radius = 0.0;
  if (seed % 3 == 2) tool.corner_radius = 0.3 * tool.radius;
  if (seed / 3 % 2 == 1) tool.taper = Angle::degrees(15.0);
  if (seed / 6 % 2 == 1) tool.shaft.cutting_length = 6.0;
  const double edges =
      seed / 3 % 4 == 3 ? 6.0 : 1e9;  // a shank as thick as a cylinder takes what is left
  for (int cut = 0; cut < 12; ++cut) {
    const Vec3 centre(18 + 25 * number(random), 12 + 18 * number(random), 10 + 14 * number(random));
    const Vec3 axis = Vec3(number(random), number(random), 1.01 + number(random)).normalized();
    const std::size_t before = samples.size();
    const auto in_tool = [&](const Vec3& p) {
      const double up = (p - centre).dot(axis), above_tip = up + tool.corner();
      return above_tip <= edges && above_tip >= tool.height_at((p - centre - up * axis).norm());
    };
    samples.erase(std::remove_if(samples.begin(), samples.end(), in_tool), samples.end());
    RC_ASSERT(stock.cut(centre, axis, tool) == (samples.size() < before));
    RC_ASSERT(std::abs(stock.volume() - 0.125 * double(samples.size())) < 1e-6);
  }
}

TEST(RemainingStock, KeepsSamplesOnlyWhereTheToolIsAtWork) {
  voxel::VoxelOptions options;
  options.pitch = 0.5;
  const voxel::VoxelGrid grid =
      voxel::voxelise(mesh::box_mesh(Vec3(0, 0, 0), Vec3(40, 40, 40)),
                      mesh::box_mesh(Vec3(0, 0, 0), Vec3(40, 40, 8)), options);
  RemainingStock stock(grid);
  EXPECT_EQ(stock.opened(), 0u);
  std::size_t most = 0;
  for (double z = 37.0; z >= 8.0; z -= 2.0)
    for (double y = 0; y <= 40; y += 5)
      for (double x = 0; x <= 40; x += 2) {
        stock.cut(Vec3(x, y, z), Vec3::UnitZ(), kFlat);
        most = std::max(most, stock.opened());
      }
  EXPECT_LE(most, grid.table.size() / 4);
  EXPECT_LT(stock.volume(), 0.08 * 40 * 40 * 32);
}

TEST(HurryInAir, ASecondPassOverTheSamePlaceIsAir) {
  const voxel::VoxelGrid grid = block(1.0);
  const ToolPath path = passes({Vec3(-5, 20, 10), Vec3(45, 20, 10), Vec3(-5, 20, 10)}, 10.0);
  std::vector<std::int64_t> source;
  const ToolPath out = hurry_in_air(path, grid, AirCutOptions{50.0, 0.0}, &source);
  ASSERT_EQ(source.size(), out.moves.size());
  double first = 0.0, second = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i)
    (source[i] == 0 ? first : second) += duration(out.moves[i], out.spindle);
  EXPECT_NEAR(second, 50.0 / 50.0, 1e-9);
  // the ball meets the block from x = -3 on, at its equator: 2 mm in and from x = 40 on 5 mm out are air
  EXPECT_NEAR(first, 43.0 / 10.0 + 7.0 / 50.0, 0.2);
  EXPECT_EQ(out.moves.back().end.tip, path.moves.back().end.tip);
}

TEST(HurryInAir, NeverSlowsAndNeverTouchesWhatCuts) {
  const voxel::VoxelGrid grid = block(2.0);
  const ToolPath path = passes({Vec3(-5, 20, 10), Vec3(45, 20, 10)}, 80.0);
  const ToolPath out = hurry_in_air(path, grid, AirCutOptions{50.0, 0.0});
  double sum = 0.0;
  for (const Move& m : out.moves) sum += duration(m, out.spindle);
  EXPECT_NEAR(sum, 50.0 / 80.0, 1e-9);
}

TEST(HurryInAir, RefusesATextureAndABadFeed) {
  const voxel::VoxelGrid grid = block(2.0);
  ToolPath path = passes({Vec3(-5, 20, 10), Vec3(45, 20, 10)}, 10.0);
  EXPECT_THROW(hurry_in_air(path, grid, AirCutOptions{0.0, 0.0}), InputError);
  path.moves[0].dimple = 3;
  EXPECT_THROW(hurry_in_air(path, grid, AirCutOptions{50.0, 0.0}), InputError);
}

}  // namespace
}  // namespace patchmill::dcm
