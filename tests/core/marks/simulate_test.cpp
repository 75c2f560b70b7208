// The simulator's invariances: threads, instruction sets, bands, curved bases, patches of the path,
// and what it refuses.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/simulate.h"

#include "patchmill/geometry/error.h"
#include "patchmill/marks/dimple_marks.h"
#include "patchmill/marks/flute_kernel.h"
#include "rows.h"

#include <cstring>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace patchmill::marks {
namespace {

using test::MarkMaker;
using test::RowMaker;

struct Job {
  RowMaker maker;
  ToolPath path = maker.path([](int j) { return 0.17 * j; });
  Cutter cutter{path.tool, Angle::degrees(20), {0.0, 0.001}};
  SurfaceGrid grid = maker.grid(0.017);
  SimulatedRelief run() const { return simulate_marks(motion_of(path), cutter, grid, {0.08}); }
};

/// The same cells, told as a curved base.
SurfaceGrid as_curved(SurfaceGrid grid) {
  grid.sag.assign(static_cast<std::size_t>(grid.cells()), 0.0);
  grid.normal.assign(grid.sag.size(), plane_normal(grid.plane).cast<float>());
  return grid;
}

TEST(Simulate, SameBytesOnAnyNumberOfThreads) {
  const Job job;
  std::vector<std::vector<float>> heights;
  for (const std::size_t threads : {1u, 2u, 5u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    heights.push_back(job.run().relief.height);
  }
  for (const auto& h : heights)
    EXPECT_EQ(std::memcmp(h.data(), heights[0].data(), h.size() * sizeof(float)), 0);
}

TEST(Simulate, SameBytesOnAnyInstructionSet) {
  PassFrame pass;
  pass.radius = 1.0f;
  pass.centre_height = 0.99f;
  pass.a[0] = pass.b[1] = 0.8f;
  pass.a[2] = -0.6f;
  pass.t[0] = 0.6f, pass.t[2] = 0.8f;
  pass.a[2] = -0.6f;
  pass.velocity[0] = 0.3f, pass.velocity[1] = 0.2f;
  pass.low = -1.1f, pass.high = 1.1f;
  pass.kinks.push_back({0.3f, {-0.2f, 0.1f, 0.05f}, {}, {}, {}});
  for (const bool search : {false, true}) {
    std::vector<std::vector<float>> rows;
    for (const InstructionSet set : {InstructionSet::Any, InstructionSet::V3, InstructionSet::V4}) {
      std::vector<float> heights(10 * kLanes, 0.4f);
      for (int j = -20; j <= 20; ++j)
        flute_kernel(set).flat(search, pass, -0.8f, 0.04f * j, 0.01f, 10, heights.data());
      rows.push_back(heights);
    }
    EXPECT_LT(*std::min_element(rows[0].begin(), rows[0].end()), 0.1f);
    for (const auto& r : rows)
      EXPECT_EQ(std::memcmp(r.data(), rows[0].data(), r.size() * sizeof(float)), 0);
  }
}

TEST(Simulate, BandsMakeTheWhole) {
  const Job job;
  const Relief whole = job.run().relief;
  int next = 0;
  simulate_bands(motion_of(job.path), job.cutter, job.grid, {0.08}, 37, 5,
                 [&](const ReliefBand& band) {
                   EXPECT_EQ(band.own_from, next);
                   next = band.own_to;
                   for (int j = 0; j < band.relief.grid.rows; ++j)
                     for (int i = 0; i < job.grid.columns; ++i)
                       ASSERT_NEAR(band.relief.at(i, j), whole.at(i, band.first_row + j), 1e-6);
                 });
  EXPECT_EQ(next, job.grid.rows);
}

TEST(Simulate, FlatBaseToldAsCurvedGivesTheSame) {
  Job job;
  const Relief flat = job.run().relief;
  job.grid = as_curved(job.grid);
  const Relief curved = job.run().relief;
  for (std::size_t k = 0; k < flat.height.size(); ++k)
    ASSERT_NEAR(curved.height[k], flat.height[k], 2e-6);
}

/// A sphere of radius `r` (negative: a hollow one) that touches z = 0 from below (above) at the
/// origin.
SurfaceGrid spherical(double r, double half, double step) {
  SurfaceGrid grid = flat_grid(test::plane_z0(), {-half, -half}, {half, half}, step);
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      const Vec2 p = grid.plane_point(i, j);
      const double root = std::sqrt(r * r - p.squaredNorm());
      grid.sag.push_back(r > 0 ? r - root : -(std::abs(r) - root));
      grid.normal.push_back(
          Vec3(p.x() / r, p.y() / r, root / std::abs(r)).normalized().cast<float>());
    }
  return grid;
}

// A still ball of radius R whose centre is at distance D from the centre of the sphere, at angle u
// from the normal: the deviation is D cos u - sqrt(R² - D² sin² u) - Rb on a convex base.
TEST(Simulate, DeviationFromASphereIsTheClosedForm) {
  for (const double base : {7.0, -5.0}) {
    MarkMaker maker;
    maker.height = -0.01;
    maker.axis = test::tilted_axis(kPi / 4, 0.3);
    const SurfaceGrid grid = spherical(base, 0.3, 0.02);
    const Relief relief = test::mark(maker, {{0.0, 0.0}}, grid, 0.03).relief;
    const Vec3 centre(0, 0, 0.99);
    for (int j = 0; j < grid.rows; ++j)
      for (int i = 0; i < grid.columns; ++i) {
        const Vec3 p = base_point(grid, i, j), n = base_normal(grid, i, j);
        const double along = (centre - p).dot(n);
        const double cut = along - std::sqrt(1.0 - ((centre - p) - along * n).squaredNorm());
        ASSERT_NEAR(relief.at(i, j), std::min(cut, 0.03), 2e-6) << base << " " << i << " " << j;
      }
  }
}

TEST(Simulate, MissingBaseStaysMissing) {
  Job job;
  job.grid = as_curved(job.grid);
  job.grid.sag[40 * job.grid.columns + 50] = std::numeric_limits<double>::quiet_NaN();
  const Relief relief = job.run().relief;
  EXPECT_TRUE(std::isnan(relief.at(50, 40)));
  EXPECT_EQ(std::count_if(relief.height.begin(), relief.height.end(),
                          [](float h) { return std::isnan(h); }),
            1);
}

// The ball that mills near the lower border of a slope has its centre over cells beyond the border.
TEST(Simulate, BorderOfASlopeChangesNothingOnIt) {
  constexpr double kSlope = 0.6, kBorder = -0.1, kAbove = 0.2;  // kAbove: of the slope at x = 0
  const Vec3 normal(-std::sin(kSlope), 0.0, std::cos(kSlope));
  SurfaceGrid whole = flat_grid(test::plane_z0(), {-1.2, -0.4}, {0.6, 0.4}, 0.02);
  for (int j = 0; j < whole.rows; ++j)
    for (int i = 0; i < whole.columns; ++i) {
      whole.sag.push_back(-whole.plane_point(i, j).x() * std::tan(kSlope) - kAbove);
      whole.normal.push_back(normal.cast<float>());
    }
  SurfaceGrid part = whole;
  for (int j = 0; j < part.rows; ++j)
    for (int i = 0; i < part.columns; ++i)
      if (part.plane_point(i, j).x() < kBorder)
        part.sag[part.number(i, j)] = std::numeric_limits<double>::quiet_NaN();
  ToolPath path;
  path.tool = {1.0, 1};
  path.spindle = {10.0, SpindleSense::M3};
  const ToolPose there = pose_of_ball(0.99 * normal + kAbove * Vec3::UnitZ(), Vec3::UnitZ(), 1.0);
  path.start = there;
  path.moves.push_back({there, 0.5, 0, MoveKind::Cut});
  path.moves.push_back({there, 0.5, kNoDimple, MoveKind::Cut});
  const auto relief = [&](const SurfaceGrid& grid) {
    return simulate_marks(motion_of(path), {path.tool, {}, {}}, grid, {0.03}).relief;
  };
  const Relief known = relief(whole), seen = relief(part);
  int cut = 0;
  for (int j = 0; j < part.rows; ++j)
    for (int i = 0; i < part.columns; ++i) {
      if (part.plane_point(i, j).x() < kBorder) continue;
      ASSERT_NEAR(seen.at(i, j), known.at(i, j), 1e-6) << i << " " << j;
      cut += known.at(i, j) < 0.0;
    }
  EXPECT_GT(cut, 20);
}

// Moving and turning path and plane together changes nothing.
TEST(Simulate, DoesNotDependOnTheFrame) {
  const Job job;
  const Relief before = job.run().relief;
  const Eigen::AngleAxisd turn(0.8, Vec3(0.3, -0.7, 0.5).normalized());
  const Vec3 by(13.0, -7.0, 4.0);
  Job moved = job;
  const auto move = [&](ToolPose& pose) { pose = {turn * pose.tip + by, turn * pose.axis}; };
  move(moved.path.start);
  for (Move& m : moved.path.moves) move(m.end);
  moved.grid.plane = {turn * job.grid.plane.origin + by, turn * job.grid.plane.x_axis,
                      turn * job.grid.plane.y_axis, turn * job.grid.plane.direction};
  MotionOptions options;
  options.housing_x.assign(moved.path.moves.size() + 1, turn * default_housing_x(job.maker.axis));
  const Relief after =
      simulate_marks(motion_of(moved.path, options), job.cutter, moved.grid, {0.08}).relief;
  for (std::size_t k = 0; k < before.height.size(); ++k)
    ASSERT_NEAR(after.height[k], before.height[k], 2e-6);
}

TEST(Simulate, CostGoesWithTheMarks) {
  Job job;
  const auto cells = [&] { return job.run().statistics.evaluations; };
  const std::int64_t once = cells();
  SurfaceGrid wide = job.grid;
  wide.columns += 500;
  wide.rows += 500;
  job.grid = wide;
  EXPECT_LT(cells(), once + once / 2);  // only the marks' outer halves are new
  for (Move& m : job.path.moves) m.end.tip.z() += 5.0;
  job.path.start.tip.z() += 5.0;
  EXPECT_EQ(cells(), 0);  // as many turns, clear of the surface
}

TEST(Simulate, RefusesAndStops) {
  Job job;
  const ToolMotion motion = motion_of(job.path);
  EXPECT_THROW(simulate_marks(motion, job.cutter, job.grid, {1.0}), InputError);
  EXPECT_THROW(simulate_marks(motion, job.cutter, job.grid, {0.08, 1000.0}), InputError);
  Cutter wrong = job.cutter;
  wrong.runout = {0.0};
  EXPECT_THROW(simulate_marks(motion, wrong, job.grid, {0.08}), InputError);
  wrong.runout.assign(static_cast<std::size_t>(wrong.ball.flutes), 0.0);
  wrong.runout[0] = 0.49 * wrong.ball.radius;
  EXPECT_NO_THROW(require_valid(wrong));
  for (const double share : {0.51, -0.51}) {
    wrong.runout[0] = share * wrong.ball.radius;
    EXPECT_THROW(require_valid(wrong), InputError);
  }
  SurfaceGrid broken = job.grid;
  broken.sag = {0.0};
  EXPECT_THROW(simulate_marks(motion, job.cutter, broken, {0.08}), InputError);
  const auto stopped =
      simulate_marks(motion, job.cutter, job.grid, {0.08}, [](double) { return false; });
  EXPECT_FALSE(stopped.complete);
}

TEST(Motion, RunsAreLockedAtTheirFirstDimple) {
  MarkMaker maker;
  ToolPath path = maker.path({{0, 0}, {1, 0}, {2, 0}});
  path.moves[2].turns = kUnknownTurns;  // a rapid from the first mark to the second
  path.moves[2].kind = MoveKind::Rapid;
  const MotionOptions locked = maker.locked(3);
  const ToolMotion motion = motion_of(path, locked);
  EXPECT_EQ(motion.untimed_moves, 1);
  ASSERT_EQ(motion.runs.size(), 2u);
  const SurfaceGrid grid = flat_grid(test::plane_z0(), {-0.3, -0.3}, {2.3, 0.3}, 0.02);
  const auto found = find_dimples(simulate_marks(motion, {path.tool, {}, {}}, grid, {0.05}).relief);
  ASSERT_EQ(found.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_LT((found[k].place - Vec2(static_cast<double>(k), 0)).norm(), 1e-4)
        << found[k].place.transpose() << " " << found[k].bottom;
}

TEST(Motion, RefusesWhatCannotBe) {
  ToolPath path = MarkMaker{}.path({{0, 0}});
  path.moves[0].turns = -1.0;
  EXPECT_THROW(motion_of(path), InputError);
  path = MarkMaker{}.path({{0, 0}});
  MotionOptions options;
  options.housing_x = {Vec3::UnitX()};
  EXPECT_THROW(motion_of(path, options), InputError);
  MotionSample first, second;
  second.spindle_angle = -1.0;
  EXPECT_THROW(motion_of({first, second}, SpindleSense::M3, 1.0), InputError);  // at one time
  second.time = 0.1;
  EXPECT_NO_THROW(motion_of({first, second}, SpindleSense::M3, 1.0));
  EXPECT_THROW(motion_of({first, second}, SpindleSense::M4, 1.0), InputError);
}

}  // namespace
}  // namespace patchmill::marks
