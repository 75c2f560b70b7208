// Cutters that are no ball lowered on a model: closed forms, points of the mesh tried one by one, and paths of copy
// milling with a bull nose that gouge nothing.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/tool_drop.h"

#include "patchmill/copy/copy_milling.h"
#include "patchmill/geometry/error.h"
#include "voxel/shapes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::copy {
namespace {

const Tool kBull{3.0, 2, 1.0};
const Tool kFlat{3.0, 2, 0.0};

Tool cone(double tip, double degrees, double corner = 0.0) {
  Tool tool{tip, 2, corner};
  tool.taper = Angle::degrees(degrees);
  return tool;
}

TEST(ToolDrop, OnABox) {
  const mesh::TriangleBvh box(mesh::box_mesh({-10, -10, -5}, {10, 10, 0}));
  for (const Tool& tool : {kBull, kFlat}) {
    const double r = tool.corner();
    EXPECT_NEAR(drop_tool(box, 1.0, 2.0, tool, 0.0), r, 1e-12);
    EXPECT_NEAR(drop_tool(box, 12.0, 2.0, tool, 0.0), r, 1e-9);  // the flat bottom, half beside it
    EXPECT_EQ(drop_tool(box, 13.1, 2.0, tool, 0.0), kNoContact);
  }
  // 0.6 beyond the flat bottom the corner touches the edge: 1 - 0.8 lower
  EXPECT_NEAR(drop_tool(box, 12.6, 2.0, kBull, 0.0), 0.8, 1e-9);
  // thicker by 0.5: the corner's circle is 1.5, its centre still 2 from the axis
  EXPECT_NEAR(drop_tool(box, 1.0, 2.0, kBull, 0.5), 1.5, 1e-12);
  EXPECT_NEAR(drop_tool(box, 12.9, 2.0, kBull, 0.5), std::sqrt(1.5 * 1.5 - 0.81), 1e-9);
}

// Beside a box the flank of a cone touches its edge, and as far below as the cone is higher there.
TEST(ToolDrop, OfAConeOnABox) {
  const mesh::TriangleBvh box(mesh::box_mesh({-10, -10, -50}, {10, 10, 0}));
  const Tool v_bit = cone(0.5, 30.0);
  EXPECT_NEAR(drop_tool(box, 1.0, 2.0, v_bit, 0.0), 0.0, 1e-12);
  EXPECT_NEAR(drop_tool(box, 12.5, 2.0, v_bit, 0.0), -2.0 * std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(drop_tool(box, 13.0, 14.0, v_bit, 0.0), -4.5 * std::sqrt(3.0),
              1e-9);  // 5 from the corner
  // thicker by 0.2 at right angles to the flank, 0.4 along the axis; the centre is 0.2 above the tip
  EXPECT_NEAR(drop_tool(box, 12.5, 2.0, v_bit, 0.2), -2.0 * std::sqrt(3.0) + 0.4, 1e-9);
  EXPECT_NEAR(drop_tool(box, 1.0, 2.0, v_bit, 0.2), 0.2, 1e-12);
}

// On a slope the corner's circle touches: its centre lies r along the normal from the plane, R - r from the axis.
TEST(ToolDrop, OnASlope) {
  mesh::TriangleMesh slope;
  slope.vertices = {{-50, -50, -50}, {50, -50, 50}, {50, 50, 50}, {-50, 50, -50}};
  slope.triangles = {{0, 1, 2}, {0, 2, 3}};
  const mesh::TriangleBvh bvh(slope);
  const double tilt = kPi / 4;
  EXPECT_NEAR(drop_tool(bvh, 0.0, 0.0, kBull, 0.0), 1.0 / std::cos(tilt) + 2.0 * std::tan(tilt),
              1e-9);
  EXPECT_NEAR(drop_tool(bvh, 0.0, 0.0, kFlat, 0.0), 3.0 * std::tan(tilt), 1e-9);
  // a cone steeper than the slope stands on the rim of its tip
  EXPECT_NEAR(drop_tool(bvh, 0.0, 0.0, cone(0.5, 30.0), 0.0), 0.5 * std::tan(tilt), 1e-9);
}

// Many points of random triangles, tried one by one: none lifts the cutter higher, and one nearly as high.
RC_GTEST_PROP(ToolDrop, IsTheHighestOfAllPoints, (unsigned seed)) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  mesh::TriangleMesh mesh;
  for (int i = 0; i < 12; ++i) {
    const Vec3 a(4 * number(random), 4 * number(random), 2 * number(random));
    for (int k = 0; k < 3; ++k)
      mesh.vertices.push_back(a + Vec3(3 * number(random), 3 * number(random), 2 * number(random)));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  Tool tool{1.5 + number(random), 2, std::nullopt};
  if (seed % 3 != 2) tool.corner_radius = seed % 3 == 0 ? 0.0 : 0.4 * tool.radius;
  if (seed % 3 == 2 || seed % 2 == 1) tool.taper = Angle::degrees(20.0);
  const mesh::TriangleBvh bvh(mesh);
  const Vec2 p(2 * number(random), 2 * number(random));
  const double found = drop_tool(bvh, p.x(), p.y(), tool, 0.0);
  double highest = kNoContact;
  constexpr int kSteps = 200;
  for (const mesh::Triangle& t : bvh.triangles())
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j) {
        const Vec3 q = t.a + (t.b - t.a) * i / kSteps + (t.c - t.a) * j / kSteps;
        highest =
            std::max(highest, q.z() - tool.height_at((q.head<2>() - p).norm()) + tool.corner());
      }
  RC_ASSERT(found >= highest - 1e-9);
  RC_ASSERT(found <= highest + 0.5 || highest == kNoContact);
  ToolProbe probe(bvh, tool, 0.0);
  probe(p.x() + 0.3, p.y());
  RC_ASSERT(std::abs(probe(p.x(), p.y()) - found) <= 1e-9 || found == kNoContact);
}

RC_GTEST_PROP(ToolDrop, OfABallIsDropBall, (std::uint16_t x, std::uint16_t y)) {
  static const mesh::TriangleBvh part(shapes::convex_part(20));
  const double px = x % 500 * 0.1, py = y % 500 * 0.1;
  const Tool nearly{3.0, 2, 3.0 - 1e-9};  // takes the general way
  RC_ASSERT(drop_tool(part, px, py, {3.0, 2}, 0.2) == drop_ball(part, px, py, 3.2));
  RC_ASSERT(std::abs(drop_tool(part, px, py, nearly, 0.2) - drop_ball(part, px, py, 3.2)) < 1e-6);
}

class Cutter : public testing::TestWithParam<std::tuple<CopyMode, Tool>> {};

// At no place of any move is the tool nearer to the part than the allowance less the tolerance.
TEST_P(Cutter, CutsNoDeeperThanTheTolerance) {
  const mesh::TriangleBvh part(shapes::convex_part(20));
  const auto [mode, tool] = GetParam();
  CopyOptions options;
  options.mode = mode;
  options.tool = tool;
  options.spindle.speed = 100.0;
  options.feed = 400.0 / 60.0;
  options.radial_depth = 5.0;
  options.axial_depth = 6.0;
  options.allowance = 0.1;
  options.tolerance = 0.02;
  options.stock.include(Vec3::Zero());
  options.stock.include(Vec3(50, 50, 30));
  const ToolPath path = copy_mill(part, options).path;
  EXPECT_GT(statistics(path).cut_length, 300.0);
  double deepest = kNoContact, lowest = 1e9;
  Vec3 from = centre_of(path.start, path.tool);
  for (const Move& move : path.moves) {
    const Vec3 to = centre_of(move.end, path.tool);
    const int n = 1 + static_cast<int>((to - from).norm() / 0.5);
    for (int i = 0; i <= n; ++i) {
      const Vec3 c = from + double(i) / n * (to - from);
      // a tool thinner than the allowance by a little more than the tolerance must stand free
      const double thinner = options.allowance - 1.5 * options.tolerance;
      deepest = std::max(deepest, drop_tool(part, c.x(), c.y(), path.tool, thinner) - c.z());
      if (move.kind == MoveKind::Cut) lowest = std::min(lowest, move.end.tip.z());
    }
    from = to;
  }
  EXPECT_LE(deepest, 0.0);
  // the tip, not a ball's centre, comes down to the stock's bottom
  if (mode == CopyMode::Contour) {
    EXPECT_NEAR(lowest, 0.0, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, Cutter,
                         testing::Combine(testing::Values(CopyMode::Scanning, CopyMode::Contour),
                                          testing::Values(kBull, kFlat, cone(0.5, 15.0),
                                                          cone(2.0, 10.0, 0.5),
                                                          cone(0.5, 15.0, 0.5))));

TEST(CopyMill, UndercutsNeedABall) {
  CopyOptions options;
  options.mode = CopyMode::ScanningUndercut;
  options.tool = kBull;
  options.spindle.speed = options.feed = options.radial_depth = options.axial_depth = 1.0;
  try {
    require_valid(options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.property(), "ToolController");
  }
}

}  // namespace
}  // namespace patchmill::copy
