// Patches counted in milling order, and what is left of a texture from one of them on.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/patch_order.h"

#include "patchmill/geometry/error.h"

#include <gtest/gtest.h>

namespace patchmill::patch {
namespace {

// Dimples of these patches, in order; negative ones are left out.
Dimples of(const std::vector<int>& patches) {
  Dimples dimples;
  for (const int patch : patches) {
    Dimple dimple;
    dimple.patch = patch < 0 ? -patch : patch;
    dimple.state = patch < 0 ? DimpleState::Masked : DimpleState::Cut;
    dimple.surface.position = Vec3(static_cast<double>(dimples.size()), 0, 0);
    dimples.push_back(dimple);
  }
  return dimples;
}

TEST(PatchOrder, PatchesWithoutDimplesAreNotCounted) {
  EXPECT_EQ(milled_patches(of({3, 3, -3, -5, 1, -1, 7})), (std::vector<int>{3, 1, 7}));
  EXPECT_TRUE(milled_patches(of({-2, -2})).empty());
}

TEST(PatchOrder, TheRestBeginsWithTheFirstDimpleOfItsPatch) {
  const Dimples all = of({3, 3, -1, -5, 1, 1, -1, 7});
  EXPECT_EQ(from_patch(all, 1).size(), 8u);
  const Dimples second = from_patch(all, 2);
  ASSERT_EQ(second.size(), 4u);
  EXPECT_EQ(second[0].surface.position.x(), 4.0);
  EXPECT_EQ(milled_patches(second), (std::vector<int>{1, 7}));
  EXPECT_EQ(from_patch(all, 3).size(), 1u);
}

TEST(PatchOrder, APartEndsWithTheLastDimpleOfItsPatch) {
  const Dimples all = of({3, 3, -1, -5, 1, 1, -1, 7, -7});
  EXPECT_EQ(up_to_patch(all, 3).size(), all.size());
  EXPECT_EQ(up_to_patch(all, 2).size(), 6u);
  EXPECT_EQ(up_to_patch(all, 1).size(), 2u);
  // one after the other, parts are the whole
  std::vector<double> places;
  for (int number = 1; number <= 3; ++number)
    for (const Dimple& dimple : from_patch(up_to_patch(all, number), number))
      if (dimple.state == DimpleState::Cut) places.push_back(dimple.surface.position.x());
  EXPECT_EQ(places, (std::vector<double>{0, 1, 4, 5, 7}));
}

TEST(PatchOrder, OtherNumbersAreRefused) {
  for (const int first : {-1, 0, 4}) {
    try {
      from_patch(of({3, 1, 7}), first);
      FAIL() << first;
    } catch (const InputError& error) {
      EXPECT_EQ(error.property(), "FirstPatch");
    }
    try {
      up_to_patch(of({3, 1, 7}), first);
      FAIL() << first;
    } catch (const InputError& error) {
      EXPECT_EQ(error.property(), "LastPatch");
    }
  }
}

}  // namespace
}  // namespace patchmill::patch
