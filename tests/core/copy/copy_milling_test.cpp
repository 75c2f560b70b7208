// Copy milling: no gouge by an independent check, scallops as predicted, layers, curves.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/copy_milling.h"

#include "patchmill/copy/drop_cutter.h"
#include "patchmill/copy/level_curves.h"
#include "patchmill/copy/scanning.h"
#include "patchmill/geometry/error.h"
#include "voxel/shapes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace patchmill::copy {
namespace {

CopyOptions paper_options(CopyMode mode, const mesh::Box& stock) {
  CopyOptions options;  // Table 1 of the paper
  options.mode = mode;
  options.tool = {3.0, 2};
  options.spindle.speed = 100.0;
  options.feed = 400.0 / 60.0;
  options.radial_depth = 2.0;
  options.axial_depth = 2.0;
  options.stock = stock;
  return options;
}

mesh::Box box(const Vec3& lo, const Vec3& hi) {
  mesh::Box b;
  b.include(lo);
  b.include(hi);
  return b;
}

// Calls `visit(ball centre)` every 0.1 mm of cutting, or of all moves.
template <class Visit>
void along(const ToolPath& path, bool cuts_only, const Visit& visit) {
  Vec3 from = ball_centre(path.start, path.tool.radius);
  for (const Move& move : path.moves) {
    const Vec3 to = ball_centre(move.end, path.tool.radius);
    const int n = 1 + static_cast<int>((to - from).norm() / 0.1);
    if (move.kind == MoveKind::Cut || !cuts_only)
      for (int i = 0; i <= n; ++i) visit(Vec3(from + double(i) / n * (to - from)));
    from = to;
  }
}

// How deep the ball goes into the part in any move, links and rapids too, by distance and parity: no code in common
// with the probe.
double deepest_gouge(const mesh::TriangleBvh& part, const ToolPath& path) {
  double deepest = 0.0;
  along(path, false, [&](const Vec3& c) {
    const auto cross = mesh::line_crossings(part, c.y(), c.z());
    const auto before = std::upper_bound(cross.begin(), cross.end(), c.x()) - cross.begin();
    const double d = mesh::closest_point(part, c).distance;
    deepest = std::max(deepest, path.tool.radius - (before % 2 == 1 ? -d : d));
  });
  return deepest;
}

class CopyParts : public testing::TestWithParam<CopyMode> {};

TEST_P(CopyParts, NoGougeDeeperThanTheToleranceOnTheConvexPart) {
  const mesh::TriangleBvh part(shapes::convex_part(30));
  CopyOptions options = paper_options(GetParam(), box(Vec3::Zero(), Vec3(50, 50, 30)));
  if (GetParam() != CopyMode::Contour) options.radial_depth = 5.0;
  options.axial_depth = 4.0;
  const ToolPath path = copy_mill(part, options).path;
  EXPECT_GT(statistics(path).cut_length, 500.0);
  EXPECT_LE(deepest_gouge(part, path), options.tolerance);
}

TEST_P(CopyParts, NoGougeDeeperThanTheToleranceOnTheOverhangingPart) {
  const mesh::TriangleBvh part(shapes::overhanging_part(30));
  CopyOptions options = paper_options(GetParam(), box(Vec3::Zero(), Vec3(70, 50, 32)));
  options.radial_depth = GetParam() == CopyMode::Contour ? 4.0 : 12.5;
  options.axial_depth = 6.0;
  const ToolPath path = copy_mill(part, options).path;
  EXPECT_GT(statistics(path).cut_length, 200.0);
  EXPECT_LE(deepest_gouge(part, path), options.tolerance);
}

TEST_P(CopyParts, NoGougeOnABlockWithUprightWalls) {
  const mesh::TriangleBvh part(mesh::box_mesh(Vec3(15, 15, 0), Vec3(35, 30, 12)));
  CopyOptions options = paper_options(GetParam(), box(Vec3::Zero(), Vec3(50, 45, 16)));
  options.radial_depth = 3.0;
  options.axial_depth = 4.0;
  const ToolPath path = copy_mill(part, options).path;
  EXPECT_LE(deepest_gouge(part, path), options.tolerance);
}

TEST_P(CopyParts, TheSamePathOnAnyNumberOfThreads) {
  const mesh::TriangleBvh part(shapes::overhanging_part(20));
  CopyOptions options = paper_options(GetParam(), box(Vec3::Zero(), Vec3(76, 50, 32)));
  options.radial_depth = options.axial_depth = 8.0;
  std::vector<double> numbers[2];
  for (const int threads : {1, 2}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    for (const Move& move : copy_mill(part, options).path.moves)
      for (const double n : {move.end.tip.x(), move.end.tip.y(), move.end.tip.z(),
                             move.kind == MoveKind::Rapid ? -1.0 : move.turns})
        numbers[threads - 1].push_back(n);
  }
  EXPECT_GT(numbers[0].size(), 400u);
  EXPECT_EQ(numbers[0], numbers[1]);
}

TEST_P(CopyParts, StopsWhenAskedAndSaysHowFarItIs) {
  const mesh::TriangleBvh part(shapes::convex_part(20));
  CopyOptions options = paper_options(GetParam(), box(Vec3::Zero(), Vec3(50, 50, 30)));
  options.radial_depth = options.axial_depth = 8.0;
  std::vector<double> shares;
  const ToolPath whole = copy_mill(part, options, [&](double share) {
                           shares.push_back(share);
                           return true;
                         }).path;
  EXPECT_GE(shares.size(), 3u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_LT(shares.back(), 1.0);
  const ToolPath none = copy_mill(part, options, [](double) { return false; }).path;
  EXPECT_EQ(statistics(none).cut_length, 0.0);
  EXPECT_GT(statistics(whole).cut_length, 0.0);
}

std::string name_of(const testing::TestParamInfo<CopyMode>& mode) {
  const char* names[] = {"Scanning", "ScanningUndercut", "Contour"};
  return names[static_cast<int>(mode.param)];
}

INSTANTIATE_TEST_SUITE_P(Modes, CopyParts,
                         testing::Values(CopyMode::Scanning, CopyMode::ScanningUndercut,
                                         CopyMode::Contour),
                         name_of);

TEST(CopyMilling, ScallopsOnAFlatAreAsPredicted) {
  const mesh::TriangleBvh part(mesh::box_mesh(Vec3::Zero(), Vec3(20, 20, 5)));
  CopyOptions options = paper_options(CopyMode::Scanning, box(Vec3::Zero(), Vec3(20, 20, 7)));
  const ToolPath path = copy_mill(part, options).path;
  double highest = 0.0;
  for (double y = 4.0; y < 16.0; y += 0.05) {
    double left = 1e9;  // on the part at (10, y): height that no ball has reached
    along(path, true, [&](const Vec3& c) {
      const double dx = c.x() - 10, dy = c.y() - y, rest = 9.0 - dx * dx - dy * dy;
      if (rest > 0) left = std::min(left, c.z() - std::sqrt(rest) - 5.0);
    });
    highest = std::max(highest, left);
  }
  EXPECT_NEAR(highest, scallop_height(Tool{3.0, 2}, 2.0), 0.002);
  EXPECT_NEAR(scallop_height(Tool{3.0, 2}, 2.0), 3.0 - std::sqrt(8.0), 1e-15);
}

TEST(CopyMilling, EveryLayerTakesAtMostTheAxialDepth) {
  const mesh::TriangleBvh part(shapes::convex_part(20));
  const CopyOptions options =
      paper_options(CopyMode::Scanning, box(Vec3::Zero(), Vec3(50, 50, 30)));
  const ToolPath path = copy_mill(part, options).path;
  double lowest = options.stock.hi.z();
  Vec3 from = path.start.tip;
  for (const Move& move : path.moves) {  // levels go down in steps of 2 mm, never back up to cut
    if (move.kind == MoveKind::Cut) {
      const double z = std::min(from.z(), move.end.tip.z());
      ASSERT_GE(z, lowest - 2.0 - 1e-9);
      lowest = std::min(lowest, z);
    }
    from = move.end.tip;
  }
  EXPECT_NEAR(lowest, 0.0, 1e-9);
}

TEST(CopyMilling, TimesEveryMoveByItsFeed) {
  const mesh::TriangleBvh part(shapes::convex_part(20));
  CopyOptions options = paper_options(CopyMode::Scanning, box(Vec3::Zero(), Vec3(50, 50, 30)));
  options.radial_depth = 10;
  const ToolPath path = copy_mill(part, options).path;
  const PathStatistics sum = statistics(path);
  EXPECT_NEAR(sum.timed_seconds, (sum.cut_length + sum.link_length) / options.feed, 1e-6);
  for (const Move& move : path.moves)
    EXPECT_EQ(std::isnan(move.turns), move.kind == MoveKind::Rapid);
}

TEST(CopyMilling, BelowAnOverhangOnlyTheUndercutModeCuts) {
  const mesh::TriangleMesh mesh = shapes::overhanging_part(40);
  const mesh::TriangleBvh part(mesh);
  CopyOptions options = paper_options(CopyMode::Scanning, box(Vec3::Zero(), Vec3(70, 50, 32)));
  options.radial_depth = 10;
  const auto covered = [&](CopyMode mode) {
    options.mode = mode;
    int under = 0;  // ball centres with part above them
    along(copy_mill(part, options).path, true,
          [&](const Vec3& c) { under += drop_ball(part, c.x(), c.y(), 0.01) > c.z() + 0.1; });
    return under;
  };
  EXPECT_EQ(covered(CopyMode::Scanning), 0);
  EXPECT_GT(covered(CopyMode::ScanningUndercut), 100);
}

// A block with a ball-shaped cavity: its wall is part of the offset surface, and no tool comes to it.
TEST(CopyMilling, LinesInACavityAreLeftOutAndCounted) {
  mesh::TriangleMesh mesh = shapes::block_with_top(
      40, 40, 4, [](double u, double v) { return Vec3(40 * u, 40 * v, 30); });
  CopyOptions options =
      paper_options(CopyMode::ScanningUndercut, box(Vec3::Zero(), Vec3(40, 40, 34)));
  options.radial_depth = 10.0;
  EXPECT_EQ(copy_mill(mesh::TriangleBvh(mesh), options).out_of_reach, 0);
  const mesh::TriangleMesh hole = shapes::sphere(Vec3(20, 20, 15), 10.0, 4);
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), hole.vertices.begin(), hole.vertices.end());
  for (const auto& t : hole.triangles)
    mesh.triangles.push_back({first + t[0], first + t[2], first + t[1]});
  const CopiedPath made = copy_mill(mesh::TriangleBvh(mesh), options);
  EXPECT_GT(made.out_of_reach, 0);
  along(made.path, true,
        [&](const Vec3& c) { EXPECT_GT((c - Vec3(20, 20, 15)).norm(), 10.0) << "in the cavity"; });
}

TEST(LevelCurves, ACircleIsOneClosedCurveRoundItsInside) {
  const PlanarGrid grid = planar_grid(Vec2(-6, -6), Vec2(6, 6), 0.5);
  const auto curves = level_curves(
      grid, [](const Vec2& p) { return p.norm() - 5.0; }, 1e-6);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].closed);
  double area = 0.0;
  const auto& points = curves[0].points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points[i].norm(), 5.0, 1e-6);
    const Vec2 &a = points[i], &b = points[(i + 1) % points.size()];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  EXPECT_NEAR(area, 25 * kPi, 0.5);  // positive: the inside is on the left
}

TEST(LevelCurves, SaddlesAndJumpsGiveClosedCurves) {
  const PlanarGrid grid = planar_grid(Vec2(-6, -6), Vec2(6, 6), 0.37);
  const auto jumpy = [](const Vec2& p) {
    const int a = static_cast<int>(std::floor(p.x())) + static_cast<int>(std::floor(p.y()));
    if (p.cwiseAbs().maxCoeff() > 5) return std::numeric_limits<double>::infinity();
    return a % 2 == 0 ? -1.0 : 2.0;
  };
  for (const Polyline& curve : level_curves(grid, jumpy, 1e-3)) {
    EXPECT_TRUE(curve.closed);
    for (const Vec2& p : curve.points) EXPECT_GT(jumpy(p), 0.0);
  }
}

TEST(LayerOf, CutsAndRaises) {
  const std::vector<Vec2> hill{{0, 0}, {4, 8}, {8, 0}};
  const auto runs = layer_of(hill, 6, 4);
  ASSERT_EQ(runs.size(), 2u);
  const std::vector<Vec2> left{{0, 4}, {2, 4}, {3, 6}}, right{{5, 6}, {6, 4}, {8, 4}};
  EXPECT_EQ(runs[0], left);
  EXPECT_EQ(runs[1], right);
  EXPECT_TRUE(layer_of(hill, 0, -2).empty());
}

TEST(CopyMilling, BadInputIsNamed) {
  const mesh::TriangleBvh part(shapes::convex_part(4));
  const mesh::Box stock = box(Vec3::Zero(), Vec3(50, 50, 30));
  const auto refused = [&](const CopyOptions& options) {
    EXPECT_THROW(copy_mill(part, options), InputError);
  };
  CopyOptions options = paper_options(CopyMode::Scanning, stock);
  options.radial_depth = 0;
  refused(options);
  options = paper_options(CopyMode::Contour, stock);
  options.tolerance = 10;
  refused(options);
  refused(paper_options(CopyMode::Contour, mesh::Box()));
}

}  // namespace
}  // namespace patchmill::copy
