// The square helix: every point once, every step one lattice step.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/helix.h"

#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::patch {
namespace {

RC_GTEST_PROP(SquareHelix, VisitsEachPointOnceInUnitSteps, ()) {
  const int side = *rc::gen::inRange(1, 40);
  for (HelixOrder order : {HelixOrder::Inward, HelixOrder::Outward}) {
    const auto path = patch_helix(PatchShape::Square, side, order);
    RC_ASSERT(path.size() == std::size_t(side) * side);
    RC_ASSERT(std::set<LatticePoint>(path.begin(), path.end()).size() == path.size());
    for (std::size_t i = 1; i < path.size(); ++i)
      RC_ASSERT(std::abs(path[i][0] - path[i - 1][0]) + std::abs(path[i][1] - path[i - 1][1]) == 1);
  }
}

TEST(SquareHelix, LoopsShrinkByEight) {
  // 5 x 5: outline 16, next loop 8, centre 1
  const auto path = patch_helix(PatchShape::Square, 5, HelixOrder::Inward);
  auto loop = [](const LatticePoint& p) {
    return std::min(std::min(p[0], 4 - p[0]), std::min(p[1], 4 - p[1]));
  };
  int count[3] = {0, 0, 0};
  for (const auto& p : path) ++count[loop(p)];
  EXPECT_EQ(count[0] - count[1], 8);
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_GE(loop(path[i]), loop(path[i - 1]));
}

}  // namespace
}  // namespace patchmill::patch
