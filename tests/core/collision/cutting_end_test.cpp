// The cutting end of a cutter that is no ball over the edge of a block, on both sides of what is allowed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/mesh_distance.h"

#include <cmath>

#include <gtest/gtest.h>

namespace patchmill::collision {
namespace {

// A straight cut of 1 mm along the edge x = 0 of a block whose top is z = 0.
ClearanceReport cut(const Tool& tool, double x, double z) {
  ToolPath path;
  path.tool = tool;
  path.spindle.speed = 100.0;
  path.start.tip = Vec3(x, 0, z);
  Move move;
  move.end.tip = Vec3(x, 1, z);
  move.kind = MoveKind::Cut;
  path.moves.push_back(move);
  ClearanceOptions options;
  options.tolerance = 0.01;
  options.resolution = 0.01;
  return check_clearance(path, shape_from_mesh(mesh::box_mesh({-40, -40, -20}, {0, 40, 0})),
                         options);
}

TEST(CuttingEnd, OfABullNoseTouchesWhereItsProfileDoes) {
  const Tool bull{3.0, 2, 1.0};
  for (const Vec2& touch : {Vec2(1.5, 0.0), Vec2(2.6, -0.2)}) {  // its flat bottom, and its corner
    for (const double above : {5.0, 0.5, 0.001, -0.008})
      EXPECT_EQ(cut(bull, touch.x(), touch.y() + above).outcome, ClearanceOutcome::Clear) << above;
    const auto deep = cut(bull, touch.x(), touch.y() - 0.1);
    ASSERT_EQ(deep.outcome, ClearanceOutcome::Violated);
    EXPECT_EQ(deep.findings[0].part, ToolPart::End);
    EXPECT_GT(deep.findings[0].depth, 0.03);
    EXPECT_LT(deep.findings[0].depth, 0.1);
  }
}

TEST(CuttingEnd, OfAConeTouchesWithItsTipAndItsFlank) {
  Tool cone{3.0, 2, 0.0};
  cone.taper = Angle::degrees(45.0);
  for (const Vec2& touch : {Vec2(1.5, 0.0), Vec2(4.0, -1.0)}) {
    for (const double above : {5.0, 0.5, 0.001, -0.008})
      EXPECT_EQ(cut(cone, touch.x(), touch.y() + above).outcome, ClearanceOutcome::Clear) << above;
    const auto deep = cut(cone, touch.x(), touch.y() - 0.1);
    ASSERT_EQ(deep.outcome, ClearanceOutcome::Violated);
    EXPECT_EQ(deep.findings[0].part, ToolPart::End);
    EXPECT_NEAR(deep.findings[0].depth, touch.x() < 3.0 ? 0.1 : 0.1 * std::sqrt(0.5), 0.02);
  }
}

// A ledge at 2 mm above the tip, where a disc in the tip would pass below it.
TEST(CuttingEnd, OfAFlatEndGoesUpItsEdges) {
  ToolPath path;
  path.tool = {3.0, 2, 0.0};
  path.spindle.speed = 100.0;
  path.start.tip = Vec3(-10, 0, 0);
  Move move;
  move.end.tip = Vec3(-2, 0, 0);
  path.moves.push_back(move);
  const PartShape ledge = shape_from_mesh(mesh::box_mesh({0, -40, 2}, {40, 40, 9}));
  const auto found = check_clearance(path, ledge);
  ASSERT_EQ(found.outcome, ClearanceOutcome::Violated);
  EXPECT_EQ(found.findings[0].part, ToolPart::End);
  EXPECT_NEAR(found.findings[0].depth, 1.0, 0.11);
  path.moves[0].end.tip = Vec3(-3.001, 0, 0);
  EXPECT_EQ(check_clearance(path, ledge).outcome, ClearanceOutcome::Clear);
  path.moves[0].end.tip = Vec3(-2, 0, 0);
  path.tool.shaft.cutting_length =
      1.5;  // its edges end below the ledge, and what is above is thinner
  EXPECT_EQ(check_clearance(path, ledge).outcome, ClearanceOutcome::Clear);
}

// A wall that only the holder comes near to: 1 mm from it while the shank passes over the block below.
TEST(ToolSections, TheToolOfThePathSaysWhatIsChecked) {
  ToolPath path;
  path.tool = {3.0, 2};
  path.tool.shaft = {12.0, 3.0, 20.0, {{20.0, 40.0, 15.0, 15.0}}};
  path.spindle.speed = 100.0;
  path.start.tip = Vec3(-30, 0, 0.5);
  Move move;
  move.end.tip = Vec3(-16, 0, 0.5);
  path.moves.push_back(move);
  const PartShape wall = shape_from_mesh(mesh::box_mesh({0, -40, -20}, {10, 40, 30}));
  EXPECT_EQ(check_clearance(path, wall).outcome, ClearanceOutcome::Clear);
  ClearanceOptions options;
  options.clearance = 1.1;
  const auto near = check_clearance(path, wall, options);
  ASSERT_EQ(near.outcome, ClearanceOutcome::Violated);
  EXPECT_EQ(near.findings[0].part, ToolPart::Holder);
  EXPECT_NEAR(near.findings[0].depth, 0.1, 0.011);
  path.tool.shaft.holder.clear();
  EXPECT_EQ(check_clearance(path, wall, options).outcome, ClearanceOutcome::Clear);
}

TEST(ToolSections, WhatCutsIsLeftOutIfItIsNotAskedFor) {
  ToolPath path;
  path.tool = {3.0, 2};
  path.tool.shaft = {12.0, 2.0, 20.0, {}};
  path.spindle.speed = 100.0;
  path.start.tip = Vec3(0, 0, 0);
  path.moves.resize(1);
  path.moves[0].end.tip = Vec3(0, 0, -1);
  const PartShape block = shape_from_mesh(mesh::box_mesh({-40, -40, -20}, {40, 40, 0}));
  ClearanceOptions options;
  EXPECT_EQ(check_clearance(path, block, options).outcome, ClearanceOutcome::Violated);
  options.cutting = false;
  EXPECT_EQ(check_clearance(path, block, options).outcome, ClearanceOutcome::Clear);
  path.moves[0].end.tip = Vec3(0, 0, -12.5);  // now the shank is in the block
  const auto deep = check_clearance(path, block, options);
  ASSERT_EQ(deep.outcome, ClearanceOutcome::Violated);
  for (const auto& f : deep.findings) EXPECT_EQ(f.part, ToolPart::Shank);
}

}  // namespace
}  // namespace patchmill::collision
