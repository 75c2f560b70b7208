// Angle: units and wrapping.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/angle.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill {
namespace {

TEST(Angle, NamesItsUnit) {
  EXPECT_DOUBLE_EQ(Angle::degrees(180).radians(), kPi);
  EXPECT_DOUBLE_EQ(Angle::turns(1.5).degrees(), 540.0);
  EXPECT_DOUBLE_EQ(Angle::radians(kPi / 2).turns(), 0.25);
}

RC_GTEST_PROP(Angle, WrappedIsCongruentAndInRange, (int degrees, unsigned char n)) {
  const Angle period = Angle::degrees(360.0 / (1 + n % 8));
  const Angle angle = Angle::degrees(degrees % 1000000 + 0.25);
  const Angle w = angle.wrapped(period), s = angle.wrapped_signed(period);
  RC_ASSERT(w.radians() >= 0.0 && w < period);
  RC_ASSERT(s.radians() >= -period.radians() / 2 - 1e-12 && s.radians() <= period.radians() / 2);
  const double turns = (angle - w) / period;
  RC_ASSERT(std::abs(turns - std::round(turns)) < 1e-6);
}

}  // namespace
}  // namespace patchmill
