// What the checks of vectors and lists refuse, and what the message names.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/require.h"

#include <limits>

#include <gtest/gtest.h>

namespace patchmill {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

TEST(Require, FiniteNumbersAndVectorsOnly) {
  EXPECT_NO_THROW(require_finite("Length", -1e300, "mm"));
  EXPECT_NO_THROW(require_finite("Point", Vec3(1, -2, 3), "mm"));
  for (const double bad : {kNan, kInf, -kInf}) {
    EXPECT_THROW(require_finite("Length", bad, "mm"), InputError);
    EXPECT_THROW(require_finite("Point", Vec3(0, bad, 0), "mm"), InputError);
    EXPECT_THROW(require_finite("Place", Vec2(0, bad), "mm"), InputError);
  }
  try {
    require_finite("Point", Vec3(1, kNan, 3), "mm");
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "Point = (1, nan, 3) mm: give finite numbers.");
  }
}

TEST(Require, AUnitVectorAlongAnyDirection) {
  const Vec3 along = Vec3(1, -2, 2) / 3.0;
  for (const double length : {1e-8, 1.0, 3.0, 1e300})
    EXPECT_LT((unit_along("Axis", length * Vec3(1, -2, 2)) - along).norm(), 1e-15) << length;
  for (const Vec3& bad : {Vec3(0, 0, 0), Vec3(1e-10, 0, 0), Vec3(kNan, 0, 1), Vec3(kInf, 0, 1)})
    EXPECT_THROW(unit_along("Axis", bad), InputError);
}

TEST(Require, OneForEach) {
  EXPECT_NO_THROW(require_one_each("Axes", 3, 3, "dimples"));
  try {
    require_one_each("Axes", 2, 3, "dimples");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "Axes = 2 given: give one for each of the 3 dimples.");
  }
}

std::string said(double value, const char* unit) {
  try {
    require_in_range("Exponent", value, 0.0, 0.9, unit);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Require, ANumberWithoutAUnitIsSaidWithoutOne) {
  EXPECT_EQ(said(1.5, ""), "Exponent = 1.5: give a value from 0 to 0.9.");
  EXPECT_EQ(said(1.5, "mm"), "Exponent = 1.5 mm: give a value from 0 to 0.9 mm.");
  EXPECT_EQ(said(0.9, ""), "");
}

}  // namespace
}  // namespace patchmill
