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

// Of vectors of any length, and as exact next to 0 and 180 degrees as anywhere.
RC_GTEST_PROP(Angle, BetweenTwoVectorsIsTheAngleThatOneWasTurnedBy, (int n, unsigned char length)) {
  const double exact = 3.0 * std::pow(10.0, -std::abs(n % 10));
  const Vec3 a = (1.0 + length) * Vec3(0.6, 0.0, 0.8), aside = Vec3(0.0, 1.0, 0.0);
  const Vec3 b = std::cos(exact) * a.normalized() + std::sin(exact) * aside;
  RC_ASSERT(std::abs(Angle::between(a, b).radians() - exact) <= 1e-15);
  RC_ASSERT(std::abs(Angle::between(a, -b).radians() - (kPi - exact)) <= 1e-15);
}

}  // namespace
}  // namespace patchmill
