// The cutting end of a cutter that is no ball over the edge of a block, on both sides of what is allowed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/mesh_distance.h"

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
  return check_clearance(path, {}, shape_from_mesh(mesh::box_mesh({-40, -40, -20}, {0, 40, 0})),
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

}  // namespace
}  // namespace patchmill::collision
