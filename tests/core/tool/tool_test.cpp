// Profiles of cutters against closed forms.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/tool/tool.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill {
namespace {

Tool bull_nose(double radius, double corner) {
  return {radius, 2, corner};
}

Tool tapered(double radius, double degrees, std::optional<double> corner = std::nullopt) {
  Tool tool{radius, 2, corner};
  tool.taper = Angle::degrees(degrees);
  return tool;
}

TEST(Tool, ShapesAreNamedByTheirRadii) {
  EXPECT_EQ((Tool{3.0, 2}).shape(), CutterShape::Ball);
  EXPECT_EQ(bull_nose(3.0, 3.0).shape(), CutterShape::Ball);
  EXPECT_EQ(bull_nose(3.0, 1.0).shape(), CutterShape::BullNose);
  EXPECT_EQ(bull_nose(3.0, 0.0).shape(), CutterShape::Flat);
  EXPECT_EQ(tapered(3.0, 5.0).shape(), CutterShape::TaperedBall);
  EXPECT_EQ(tapered(3.0, 5.0, 1.0).shape(), CutterShape::TaperedBullNose);
  EXPECT_EQ(tapered(0.5, 45.0, 0.0).shape(), CutterShape::Conical);
  EXPECT_EQ(std::string(name(CutterShape::BullNose)), "bull nose end mill");
  EXPECT_EQ(std::string(name(CutterShape::TaperedBall)), "tapered ball end mill");
  EXPECT_EQ(std::string(name(CutterShape::TaperedBullNose)), "tapered bull nose end mill");
  EXPECT_EQ(std::string(name(CutterShape::Conical)), "conical end mill");
}

TEST(Tool, HeightsOfTheCuttingSurface) {
  EXPECT_NEAR((Tool{5.0, 2}).height_at(3.0), 5.0 - 4.0, 1e-15);
  const Tool bull = bull_nose(6.0, 2.0);
  EXPECT_EQ(bull.height_at(4.0), 0.0);
  EXPECT_NEAR(bull.height_at(5.2), 2.0 - 1.6, 1e-14);
  EXPECT_NEAR(bull.height_at(6.0), 2.0, 1e-15);
  EXPECT_TRUE(std::isinf(bull.height_at(6.0 + 1e-9)));
  EXPECT_EQ(bull_nose(3.0, 0.0).height_at(3.0), 0.0);
  EXPECT_TRUE(std::isinf(bull_nose(3.0, 0.0).height_at(3.1)));
  const Tool cone = tapered(1.0, 30.0);  // the flank leaves the ball at cos 30 from the axis
  EXPECT_NEAR(cone.height_at(std::cos(kPi / 6)), 0.5, 1e-12);
  EXPECT_NEAR(cone.height_at(std::cos(kPi / 6) + 1.0), 0.5 + std::sqrt(3.0), 1e-12);
  const Tool v_bit = tapered(0.25, 30.0, 0.0);  // 60 degrees between its flanks
  EXPECT_EQ(v_bit.height_at(0.25), 0.0);
  EXPECT_NEAR(v_bit.height_at(1.25), std::sqrt(3.0), 1e-12);
}

// The slope is the height's, it grows outwards, and the place of a slope is where it is.
RC_GTEST_PROP(Tool, SlopesBelongToTheHeights, (unsigned kind, unsigned at)) {
  const unsigned vary = kind / 5;
  const Tool tool = kind % 5 == 0   ? Tool{4.0, 2}
                    : kind % 5 == 1 ? bull_nose(4.0, 0.5 + 0.01 * (vary % 300))
                    : kind % 5 == 2 ? tapered(2.0, 1.0 + 0.1 * (vary % 400))
                    : kind % 5 == 3 ? tapered(2.0, 1.0 + 0.1 * (vary % 400), 0.7)
                                    : tapered(2.0, 1.0 + 0.1 * (vary % 400), 0.0);
  const double d = 0.001 + 0.0035 * (at % 1000), h = 1e-6;
  const double slope = tool.slope_at(d), bend = tool.slope_at(d + h) - tool.slope_at(d - h);
  if (d + h >= tool.radius || bend > 1e-3) return;
  RC_ASSERT(std::abs((tool.height_at(d + h) - tool.height_at(d - h)) / (2 * h) - slope) <
            1e-3 * (1.0 + slope));
  RC_ASSERT(tool.slope_at(d + 1e-3) >= slope);
  if (slope > 0.0 && d < tool.distance_at_slope(1e12) - 1e-6)
    RC_ASSERT(std::abs(tool.distance_at_slope(slope) - d) < 1e-9);
}

// The cutter is all points within the corner's radius of its core.
RC_GTEST_PROP(Tool, TheCoreMadeThickerIsTheCutter, (unsigned kind, unsigned at)) {
  const unsigned vary = kind / 5;
  const Tool tool = kind % 5 == 0   ? Tool{4.0, 2}
                    : kind % 5 == 1 ? bull_nose(4.0, 0.01 * (vary % 400))
                    : kind % 5 == 2 ? tapered(2.0, 0.1 * (vary % 400))
                    : kind % 5 == 3 ? tapered(2.0, 0.1 * (vary % 400), 0.01 * (vary % 200))
                                    : tapered(2.0, 0.1 * (vary % 400), 0.0);
  const double across = 0.0045 * (at % 1000), r = tool.corner();
  const double height = tool.height_at(across);
  if (std::isinf(height) || height > 50.0) return;
  const Frustum core = tool.core(100.0);
  double nearest = 1e9;  // over the core's lower edge and its side
  for (int i = 0; i <= 20000; ++i) {
    const double s = i / 20000.0;
    const double side_h = core.from + s * s * (core.to - core.from);
    const double side_r = core.radius_from + s * s * (core.radius_to - core.radius_from);
    nearest = std::min({nearest, std::hypot(height - side_h, across - side_r),
                        std::hypot(height - core.from, across - s * core.radius_from)});
  }
  RC_ASSERT(std::abs(nearest - r) < 2e-3);
}

TEST(Tool, ScallopsOfABallAndOfABullNose) {
  EXPECT_NEAR(scallop_height(Tool{3.0, 2}, 2.0), 3.0 - std::sqrt(8.0), 1e-15);
  EXPECT_EQ(scallop_height(Tool{3.0, 2}, 7.0), 3.0);
  EXPECT_THROW(scallop_height(Tool{3.0, 2}, -1.0), InputError);
  const Tool bull = bull_nose(5.0, 1.0);
  EXPECT_EQ(scallop_height(bull, 8.0), 0.0);  // the flat bottom, 8 mm wide, covers it
  EXPECT_NEAR(scallop_height(bull, 9.6), 1.0 - 0.6, 1e-12);
}

// A cone leaves ridges with its own flanks, a ball with a taper above the ball its cone's.
TEST(Tool, ScallopsOfCuttersWithATaper) {
  const Tool v_bit = tapered(0.25, 45.0, 0.0);
  EXPECT_EQ(scallop_height(v_bit, 0.5), 0.0);
  EXPECT_NEAR(scallop_height(v_bit, 3.5), 1.5,
              1e-12);  // 1.75 - 0.25 beside the tip, as high at 45 degrees
  EXPECT_NEAR(scallop_height(tapered(1.0, 30.0), 2.0 * std::cos(kPi / 6) + 2.0),
              0.5 + std::sqrt(3.0), 1e-12);
  EXPECT_EQ(scallop_height(bull_nose(5.0, 1.0), 20.0), 1.0);
}

TEST(Tool, WhatIsNoToolIsNamed) {
  const auto property = [](const Tool& tool) {
    try {
      require_valid(tool);
    } catch (const InputError& error) {
      return error.property();
    }
    return std::string();
  };
  EXPECT_EQ(property(Tool{3.0, 2}), "");
  EXPECT_EQ(property(Tool{0.0, 2}), "ToolDiameter");
  EXPECT_EQ(property(bull_nose(3.0, 3.1)), "CornerRadius");
  EXPECT_EQ(property(bull_nose(3.0, -0.1)), "CornerRadius");
  EXPECT_EQ(property(tapered(3.0, 61.0)), "TaperAngle");
  EXPECT_EQ(property(tapered(3.0, 60.0, 0.0)), "");
  EXPECT_EQ(property(tapered(3.0, -1.0, 0.0)), "TaperAngle");
  EXPECT_EQ(property(tapered(3.0, 5.0, 1.0)), "");
}

TEST(Tool, WhatIsNoBallIsRefusedByItsName) {
  EXPECT_NO_THROW(require_ball(Tool{3.0, 2}, "textures are milled"));
  try {
    require_ball(bull_nose(3.0, 1.0), "textures are milled");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.property(), "ToolController");
    EXPECT_EQ(error.value(), "bull nose end mill");
  }
}

TEST(Tool, IsMadeOfEdgesShankAndHolder) {
  Tool tool{3.0, 2};
  EXPECT_TRUE(tool.sections().empty());  // nothing is known of it
  tool.shaft = {12.0, 4.0, 40.0, {{40.0, 60.0, 10.0, 20.0}}};
  const auto all = tool.sections();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].part, ToolPart::Flute);
  EXPECT_TRUE(all[0].frustum() == (Frustum{3.0, 12.0, 3.0, 3.0}));
  EXPECT_EQ(all[1].part, ToolPart::Shank);
  EXPECT_TRUE(all[1].frustum() == (Frustum{12.0, 40.0, 4.0, 4.0}));
  EXPECT_EQ(all[2].part, ToolPart::Holder);
  EXPECT_TRUE(all[2].frustum() == (Frustum{40.0, 60.0, 10.0, 20.0}));
}

TEST(Tool, EdgesThatGoIntoTheHolderLeaveNoShank) {
  Tool tool{3.0, 2, 0.0};
  tool.shaft = {50.0, 3.0, 20.0, {}};
  const auto all = tool.sections();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].from, 0.0);  // of a flat end from the tip on
  EXPECT_EQ(all[0].to, 20.0);
}

TEST(Tool, EdgesOfATaperedBallGoAlongItsFlank) {
  Tool tool = tapered(2.0, 30.0);
  tool.shaft.cutting_length = 11.0;
  const ToolSection flute = tool.sections().at(0);
  EXPECT_NEAR(flute.from, 1.0, 1e-12);
  EXPECT_NEAR(flute.radius_from, std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(flute.radius_to, std::sqrt(3.0) + 10.0 * std::tan(kPi / 6), 1e-12);
  EXPECT_NEAR(tool.height_at(flute.radius_to), flute.to, 1e-12);
}

TEST(Tool, EdgesOfAConeBeginAtItsTip) {
  Tool tool = tapered(0.5, 45.0, 0.0);
  tool.shaft = {4.0, 3.0, 30.0, {}};
  const auto all = tool.sections();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].from, 0.0);
  EXPECT_EQ(all[0].radius_from, 0.5);
  EXPECT_NEAR(all[0].radius_to, 4.5, 1e-12);
  EXPECT_TRUE(all[1].frustum() == (Frustum{4.0, 30.0, 3.0, 3.0}));
}

TEST(Tool, TheCuttingEndIsAsHighAsABall) {
  for (const double corner : {0.0, 0.5, 2.9}) {
    const Frustum end = bull_nose(3.0, corner).end_core();
    EXPECT_EQ(end.from, corner);
    EXPECT_EQ(end.to, 3.0);
    EXPECT_EQ(end.radius_to, 3.0 - corner);
  }
  Tool low = bull_nose(3.0, 0.5);
  low.shaft.cutting_length = 2.0;  // its corner is above it, too
  EXPECT_EQ(low.end_core().to, 1.5);
}

TEST(Tool, WrongShaftsAreRefusedByName) {
  const auto refused = [](const Shaft& shaft) {
    Tool tool{3.0, 2};
    tool.shaft = shaft;
    try {
      require_valid(tool);
    } catch (const InputError& error) {
      return error.property();
    }
    return std::string();
  };
  EXPECT_EQ(refused({10.0, 3.0, 30.0, {{30.0, 60.0, 10.0, 0.0}}}), "");
  EXPECT_EQ(refused({-1.0, 3.0, 30.0, {}}), "CuttingLength");
  EXPECT_EQ(refused({10.0, -3.0, 30.0, {}}), "ShankRadius");
  EXPECT_EQ(refused({10.0, 3.0, -30.0, {}}), "StickOut");
  EXPECT_EQ(refused({10.0, 3.0, 30.0, {{60.0, 30.0, 10.0, 10.0}}}), "ToolSection");
  EXPECT_EQ(refused({10.0, 3.0, 30.0, {{0.0, 60.0, 10.0, 10.0}}}), "");  // from the tip on
  EXPECT_EQ(refused({10.0, 3.0, 30.0, {{-1e-9, 60.0, 10.0, 10.0}}}), "ToolSection");
  EXPECT_EQ(refused({10.0, 3.0, 30.0, {{30.0, 60.0, 10.0, -1.0}}}), "ToolSection");
}

}  // namespace
}  // namespace patchmill
