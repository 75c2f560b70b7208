// Rectangular patches: their helix, and rows that run on. What holds for every shape is in tiling_test.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/error.h"
#include "patchmill/patch/cover.h"

#include <set>

#include <gtest/gtest.h>

namespace patchmill::patch {
namespace {

TEST(Rectangle, HelixGoesRoundAndInwards) {
  const std::vector<LatticePoint> wanted{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2},
                                         {2, 2}, {1, 2}, {0, 2}, {0, 1}, {1, 1}, {2, 1}};
  EXPECT_EQ(patch_helix(PatchShape::Rectangle, {4, 3}, HelixOrder::Inward), wanted);
  const auto turned = patch_helix(PatchShape::Rectangle, {4, 3}, HelixOrder::Inward, false, 1);
  EXPECT_EQ(turned.front(), (LatticePoint{3, 2}));
}

TEST(Rectangle, OfEqualSidesIsTheSquare) {
  for (int side = 1; side < 9; ++side)
    for (const PatchSize size : {PatchSize(side), PatchSize(side, side)})
      EXPECT_EQ(patch_helix(PatchShape::Rectangle, size, HelixOrder::Inward),
                patch_helix(PatchShape::Square, side, HelixOrder::Inward));
}

TEST(Rectangle, CoverTakesNoMoreThanNeeded) {
  const PatchPattern p{PatchShape::Rectangle, 0.5, {10, 4}};
  EXPECT_EQ(cover(p, Box2(Vec2(3, 4), Vec2(13, 8))).cells.size(), 4u);
  EXPECT_EQ(point_count(p.shape, p.size), 40);
}

TEST(Rectangle, BadSidesAreNamed) {
  const auto property = [](PatchSize size) -> std::string {
    try {
      patch_helix(PatchShape::Rectangle, size, HelixOrder::Inward);
    } catch (const InputError& e) {
      return e.property();
    }
    return "";
  };
  EXPECT_EQ(property({0, 3}), "PatchSide");
  EXPECT_EQ(property({3, -1}), "PatchSideAcross");
}

}  // namespace
}  // namespace patchmill::patch
