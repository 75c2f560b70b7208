// Square patches: every lattice point in exactly one patch, every helix step one lattice step.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/geometry/error.h"
#include "core/patch/division.h"

#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill {
namespace {

RC_GTEST_PROP(SquareHelix, VisitsEachPointOnceInUnitSteps, ()) {
  const int side = *rc::gen::inRange(1, 40);
  for (HelixOrder order : {HelixOrder::Inward, HelixOrder::Outward}) {
    const auto path = square_helix(side, order);
    RC_ASSERT(path.size() == std::size_t(side) * side);
    RC_ASSERT(std::set<LatticePoint>(path.begin(), path.end()).size() == path.size());
    for (std::size_t i = 1; i < path.size(); ++i)
      RC_ASSERT(std::abs(path[i][0] - path[i - 1][0]) + std::abs(path[i][1] - path[i - 1][1]) == 1);
  }
}

TEST(SquareHelix, LoopsShrinkByEight) {
  // 5 x 5: outline 16, next loop 8, centre 1
  const auto path = square_helix(5, HelixOrder::Inward);
  auto loop = [](const LatticePoint& p) {
    return std::min(std::min(p[0], 4 - p[0]), std::min(p[1], 4 - p[1]));
  };
  int count[3] = {0, 0, 0};
  for (const auto& p : path) ++count[loop(p)];
  EXPECT_EQ(count[0] - count[1], 8);
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_GE(loop(path[i]), loop(path[i - 1]));
}

RC_GTEST_PROP(SquareDivision, TilesTheLattice, ()) {
  SquareDivision d;
  d.spacing = 0.5;
  d.side = *rc::gen::inRange(1, 9);
  d.patches_x = *rc::gen::inRange(1, 6);
  d.patches_y = *rc::gen::inRange(1, 6);
  std::set<LatticePoint> seen;
  for (const Dimple& dimple : lattice_points(d)) {
    RC_ASSERT(seen.insert(dimple.lattice).second);
    RC_ASSERT(dimple.lattice[0] >= 0 && dimple.lattice[0] < d.side * d.patches_x);
    RC_ASSERT(dimple.lattice[1] >= 0 && dimple.lattice[1] < d.side * d.patches_y);
  }
  RC_ASSERT(seen.size() == std::size_t(d.side * d.side * d.patches_x * d.patches_y));
}

TEST(SquareDivision, LinesRunOnAcrossBorders) {
  // places are one spacing apart everywhere, also between patches
  const SquareDivision d{0.5, 14, 8, 8, HelixOrder::Inward};
  for (const Dimple& a : lattice_points(d)) {
    const Vec2 step = place(d, {a.lattice[0] + 1, a.lattice[1]}) - place(d, a.lattice);
    ASSERT_NEAR(step.x(), 0.5, 1e-12);
    ASSERT_EQ(step.y(), 0.0);
  }
  EXPECT_NEAR((place(d, {0, 0}) + place(d, {111, 111})).norm(), 0.0, 1e-12) << "centred";
}

TEST(SquareDivision, BadInputIsNamed) {
  auto property = [](SquareDivision d) -> std::string {
    try {
      require_valid(d);
    } catch (const InputError& e) {
      return e.property();
    }
    return "";
  };
  const SquareDivision good{0.5, 14, 8, 8, HelixOrder::Inward};
  EXPECT_EQ(property(good), "");
  for (double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    SquareDivision d = good;
    d.spacing = bad;
    EXPECT_EQ(property(d), "Spacing");
  }
  SquareDivision d = good;
  d.side = 0;
  EXPECT_EQ(property(d), "PatchSide");
  d = good;
  d.patches_y = 0;
  EXPECT_EQ(property(d), "PatchesY");
  d = good;
  d.patches_x = 99999;
  d.patches_y = 99999;
  EXPECT_EQ(property(d), "Spacing") << "too many dimples";
  EXPECT_THROW(patches_to_cover(good, 6.9, 60), InputError);
  EXPECT_EQ(patches_to_cover(good, 60, 56), (std::array<int, 2>{9, 8}));
}

}  // namespace
}  // namespace patchmill
