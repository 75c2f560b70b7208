// Whole textures: bands give what one piece gives; windows, patch planes and machine motion.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/texture_marks.h"

#include "arrays.h"
#include "patchmill/geometry/error.h"
#include "patchmill/marks/machine_motion.h"

#include <cstdio>

#include <gtest/gtest.h>

namespace patchmill::marks {
namespace {

struct Array {
  test::MarkMaker maker;
  std::vector<Vec2> places = test::rows_of_places(6, 6, 0.5, 0.5, [](int) { return 0.0; });
  ToolPath path = maker.path(places);
  ToolMotion motion = motion_of(path, maker.locked(places.size()));
  SurfaceGrid grid = grid_around(test::plane_z0(), places, 0.6, 0.02);
  TextureMarkOptions options;
  Array() { options.marks.stock = 0.08; }
  std::vector<PlannedPlace> plan() const {
    std::vector<PlannedPlace> plan;
    for (std::size_t k = 0; k < places.size(); ++k)
      plan.push_back({static_cast<std::int32_t>(k), places[k]});
    return plan;
  }
};

TEST(TextureMarks, BandsGiveWhatOnePieceGives) {
  Array a;
  const TextureMarks whole =
      simulate_texture(a.motion, {a.path.tool, {}, {}}, a.grid, {}, a.options);
  a.options.band_cells = 40 * a.grid.columns;
  const TextureMarks bands =
      simulate_texture(a.motion, {a.path.tool, {}, {}}, a.grid, {}, a.options);
  ASSERT_EQ(whole.dimples.size(), bands.dimples.size());
  for (std::size_t k = 0; k < whole.dimples.size(); ++k)
    EXPECT_LT((whole.dimples[k].place - bands.dimples[k].place).norm(), 1e-6);
  ASSERT_EQ(whole.height.size(), bands.height.size());
  for (std::size_t k = 0; k < whole.height.size(); ++k)
    EXPECT_NEAR(whole.height[k], bands.height[k], 2e-6);
  EXPECT_GE(compare_with_plan(bands.dimples, a.plan(), 0.5).quality, 0.99);
}

TEST(TextureMarks, CancelLeavesRowsUnknown) {
  Array a;
  a.options.band_cells = 40 * a.grid.columns;
  const TextureMarks some = simulate_texture(a.motion, {a.path.tool, {}, {}}, a.grid, {}, a.options,
                                             [](double share) { return share < 0.5; });
  EXPECT_FALSE(some.complete);
  EXPECT_TRUE(std::isnan(some.height.back()));
  EXPECT_FALSE(std::isnan(some.height.front()));
}

// In one band and in several, whose size is the same at any step.
TEST(TextureMarks, MemoryOverTheLimitIsRefusedWithAStepThatDoes) {
  for (const int rows : {1000, 12}) {
    Array a;
    a.options.band_cells = rows * a.grid.columns;
    a.options.halo = 0.0;
    a.options.marks.memory_limit = rows == 12 ? 2e5 : 1e6;
    const auto simulate = [&](const SurfaceGrid& grid) {
      simulate_texture(a.motion, {a.path.tool, {}, {}}, grid, {}, a.options);
    };
    try {
      simulate(a.grid);
      FAIL() << "more than the limit";
    } catch (const InputError& error) {
      EXPECT_EQ(error.property(), "GridStep");
      double step = 0.0;
      const std::string& remedy = error.remedy();
      ASSERT_EQ(std::sscanf(remedy.c_str() + remedy.find("take "), "take %lf mm", &step), 1)
          << remedy;
      EXPECT_LT(step, 2.0 * a.grid.step);
      EXPECT_NO_THROW(simulate(grid_around(test::plane_z0(), a.places, 0.6, step))) << remedy;
    }
  }
}

// What every tooth pass takes is the same at any step, and no coarser one is proposed for it.
TEST(TextureMarks, MemoryThatNoStepSparesAsksForASmallerWindow) {
  Array a;
  const double passes = memory_needed(a.grid, 1000) - memory_needed(a.grid, 0);
  EXPECT_NO_THROW(require_memory(a.grid, 100.0, passes, passes + 100.0));
  try {
    require_memory(a.grid, 100.0, passes, passes);
    FAIL() << "more than the limit";
  } catch (const InputError& error) {
    EXPECT_EQ(error.remedy().find("mm or more"), std::string::npos) << error.remedy();
  }
}

// A patch in a plane that is tilted against the texture plane: over its own plane the marks are level, and
// their places are those of the plan; over the texture plane they would be off by the slope.
TEST(TextureMarks, PatchPlanesAreTheBaseOfPlanarPatches) {
  Array a;
  const double tilt = 0.15;
  const Eigen::AngleAxisd turn(tilt, Vec3::UnitY());
  patch::Dimples dimples;
  for (const Vec2& p : a.places)
    dimples.push_back({{turn * Vec3(p.x(), p.y(), 0.0), turn * Vec3::UnitZ()}, {}, 0});
  ToolPath path = a.path;
  const auto turned = [&](const ToolPose& pose) {
    return ToolPose{turn * pose.tip, turn * pose.axis};
  };
  path.start = turned(path.start);
  for (Move& move : path.moves) move.end = turned(move.end);
  MotionOptions options = a.maker.locked(a.places.size());
  options.housing_x.assign(path.moves.size() + 1, turn * default_housing_x(a.maker.axis));
  const BaseMaker base = base_of_patches(dimples, test::plane_z0(), 0.4);
  const auto plan = planned_places(dimples, test::plane_z0());
  std::vector<Vec2> places;
  for (const PlannedPlace& p : plan) places.push_back(p.place);
  const SurfaceGrid grid = grid_around(test::plane_z0(), places, 0.6, 0.02);
  const TextureMarks marks =
      simulate_texture(motion_of(path, options), {path.tool, {}, {}}, grid, base, a.options);
  const PlanComparison verdict = compare_with_plan(marks.dimples, plan, 0.5);
  EXPECT_EQ(verdict.missing, 0);
  EXPECT_LT(verdict.rms_move, 0.004);
  const TextureMarks off = simulate_texture(motion_of(path, options), {path.tool, {}, {}}, grid, {},
                                            {{2.0 * 0.08 + 0.5}, {}, 1 << 22, 1.0});
  EXPECT_GT(compare_with_plan(off.dimples, plan, 0.5).rms_move, 0.05);
}

TEST(TextureMarks, AWindowTakesTheMarksThatBelongToIt) {
  Array a;
  const TextureMarks marks =
      simulate_texture(a.motion, {a.path.tool, {}, {}}, a.grid, {}, a.options);
  // the window's border runs through dimples 1 and 4 of each row
  const WindowComparison part =
      compare_window(marks.dimples, a.plan(), {0.4999, -0.2}, {2.0001, 2.7}, 0.5);
  EXPECT_EQ(part.comparison.matches.size(), 24u);
  EXPECT_EQ(part.comparison.missing, 0);
  EXPECT_TRUE(part.comparison.extra.empty());
  std::vector<PlannedPlace> fewer = a.plan();
  fewer.erase(fewer.begin() + 14);  // in the window: its mark is then one that nobody asked for
  EXPECT_EQ(
      compare_window(marks.dimples, fewer, {0.4, -0.2}, {2.1, 2.7}, 0.5).comparison.extra.size(),
      1u);
}

TEST(MachineMotion, StopsTakeTurnsAndTheStartPhaseTakesTheMeanAway) {
  Array a;
  const machine::MotionModel model{100.0, 500.0, machine::kNoJerkLimit, 1e-3, 0.0, false};
  const MachinePath moved = path_on_machine(a.path, model);
  ASSERT_TRUE(moved.known);
  double dwells = 0.0, taken = 0.0;
  Vec3 from = a.path.start.tip;
  for (std::size_t i = 0; i < a.path.moves.size(); ++i) {
    taken += moved.path.moves[i].turns;
    EXPECT_GE(moved.path.moves[i].turns, 0.0);
    if (a.path.moves[i].end.tip == from) dwells += a.path.moves[i].turns;
    from = a.path.moves[i].end.tip;
  }
  EXPECT_GT(dwells, 1.0);
  double last = 0.0;
  for (const machine::Passing& passing : machine::predict(a.path, model).ends)
    last = std::max(last, passing.turns);
  EXPECT_NEAR(taken, last + dwells, 1e-9);

  // one dimple every whole turn, each asked for 0.1 rad late: the start phase takes it all
  ToolPath even;
  even.tool = a.path.tool;
  even.spindle = a.path.spindle;
  for (int k = 0; k < 5; ++k) even.moves.push_back({{Vec3(k, 0, 0), Vec3::UnitZ()}, 1.0, k});
  const std::vector<Angle> wanted(5, Angle::radians(0.1));
  EXPECT_NEAR(best_start_phase(even, wanted, Angle::turns(1)).radians(), 0.1, 1e-12);
  even.moves[2].turns = kUnknownTurns;
  EXPECT_THROW(best_start_phase(even, wanted, Angle::turns(1)), InputError);
}

}  // namespace
}  // namespace patchmill::marks
