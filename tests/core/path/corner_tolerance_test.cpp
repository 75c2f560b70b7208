// CornerTolerance: what is posted comes back to the bit, and nothing becomes a stop, or as the machine is set.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/path/corner_tolerance.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill {
namespace {

constexpr std::uint32_t kSteps =
    0xfffffe;  // all that three bytes hold, but one value that says "as set"

double kept(double mm) {
  return CornerTolerance(mm);
}

TEST(CornerTolerance, UnlessGivenIsAsTheMachineIsSet) {
  EXPECT_TRUE(std::isnan(CornerTolerance()));
  EXPECT_TRUE(std::isnan(kept(kMachineTolerance)));
}

TEST(CornerTolerance, AStopIsAStop) {
  EXPECT_EQ(kept(0.0), 0.0);
  EXPECT_EQ(kept(-0.0), 0.0);
  EXPECT_EQ(kept(-1.0), 0.0);
}

TEST(CornerTolerance, WhatIsNoStopDoesNotBecomeOne) {
  for (double mm : {0.49e-6, 1e-9, 1e-300}) EXPECT_EQ(kept(mm), kFinestRounding) << mm;
}

TEST(CornerTolerance, TooMuchIsTheMostAndNotAsSet) {
  for (double mm : {16.777214, 16.777215, 17.0, 1e9, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(kept(mm), 16.777214) << mm;
}

RC_GTEST_PROP(CornerTolerance, ComesBackToTheBitInWholeSteps, ()) {
  const auto steps = *rc::gen::inRange<std::uint32_t>(0, kSteps + 1);
  const double mm = steps / 1e6;
  RC_ASSERT(kept(mm) == mm);
}

RC_GTEST_PROP(CornerTolerance, AtLeastIsNotBelowAndNoWholeStepMore, ()) {
  const double mm = *rc::gen::inRange(1, 1000000000) * 1.6e-8;
  const double over = CornerTolerance::at_least(mm) - mm;
  RC_ASSERT(over >= -1e-6 * kFinestRounding);
  RC_ASSERT(over < kFinestRounding * (1.0 + 1e-6));
}

RC_GTEST_PROP(CornerTolerance, IsTheNextStep, ()) {
  const double mm = *rc::gen::inRange(1, 1000000000) * 1.6e-8;
  const double off = std::abs(kept(mm) - mm);
  RC_ASSERT(off <= (mm < kFinestRounding ? kFinestRounding : 0.5 * kFinestRounding * (1.0 + 1e-6)));
}

}  // namespace
}  // namespace patchmill
