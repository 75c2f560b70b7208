// The calculator of sizes: closed forms, completion from any part, contradictions by name.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/texture_size.h"

#include "patchmill/geometry/error.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::patch {
namespace {

double uniform(double lo, double hi) {
  return lo + (hi - lo) * *rc::gen::inRange(0, 1 << 30) / (1 << 30);
}

void same(const TextureSize& a, const TextureSize& b) {
  auto near = [](double x, double y) { RC_ASSERT(std::abs(x - y) < 1e-9 * (1.0 + std::abs(y))); };
  near(a.spacing, b.spacing);
  near(a.depth, b.depth);
  near(a.diameter, b.diameter);
  near(a.area_share, b.area_share);
  near(a.ridge_height, b.ridge_height);
  near(a.least_tilt.radians(), b.least_tilt.radians());
}

TEST(TextureSize, ClosedForms) {
  TextureWish w;
  w.ball_radius = 1.0;
  w.spacing = 0.5;
  TextureSize s = complete(w);
  EXPECT_NEAR(s.ridge_height, 1 - std::sqrt(1 - 0.0625), 1e-15);
  EXPECT_NEAR(s.depth, 0.064586, 1e-6);
  EXPECT_EQ(s.sunk, 0.0);
  w.lattice = LatticeKind::Triangular;
  EXPECT_NEAR(complete(w).depth, 0.042573, 1e-6);
  w.kind = TextureKind::Isolated;
  w.depth = 0.02;
  s = complete(w);
  EXPECT_NEAR(s.diameter, 0.397995, 1e-6);
  EXPECT_NEAR(s.area_share, kPi * 0.0396 / (0.25 * std::sqrt(0.75)), 1e-12);
  EXPECT_NEAR(std::cos(s.least_tilt.radians()), 1 - 0.02, 1e-12) << "R - d over R";
  EXPECT_EQ(s.sunk, 0.02);
}

RC_GTEST_PROP(TextureSize, AnySufficientPartGivesTheWhole, ()) {
  TextureWish base;
  base.lattice = *rc::gen::element(LatticeKind::Square, LatticeKind::Triangular);
  base.ball_radius = uniform(0.5, 6.0);
  TextureWish w = base;
  w.spacing = uniform(0.1, 0.5);
  const TextureSize over = complete(w);
  auto from = [&](TextureKind kind, auto set) {
    TextureWish v = base;
    v.kind = kind;
    set(v);
    return complete(v);
  };
  using W = TextureWish&;
  same(from(TextureKind::Overlapping, [&](W v) { v.ridge_height = over.ridge_height; }), over);
  same(from(TextureKind::Overlapping, [&](W v) { v.depth = over.depth; }), over);
  same(from(TextureKind::Overlapping, [&](W v) { v.diameter = over.diameter; }), over);
  w.kind = TextureKind::Isolated;
  w.diameter = *w.spacing * uniform(0.1, 0.95);
  const TextureSize alone = complete(w);
  same(from(TextureKind::Isolated, [&](W v) { v.depth = alone.depth, v.spacing = alone.spacing; }),
       alone);
  same(from(TextureKind::Isolated,
            [&](W v) { v.depth = alone.depth, v.area_share = alone.area_share; }),
       alone);
  same(from(TextureKind::Isolated,
            [&](W v) { v.spacing = alone.spacing, v.area_share = alone.area_share; }),
       alone);
  // all at once is no contradiction
  same(from(TextureKind::Isolated,
            [&](W v) {
              v.spacing = alone.spacing, v.area_share = alone.area_share, v.depth = alone.depth;
              v.diameter = alone.diameter, v.ridge_height = alone.ridge_height;
            }),
       alone);
}

TEST(TextureSize, ContradictionsAreNamed) {
  auto property = [](TextureKind kind, auto set) -> std::string {
    TextureWish w;
    w.kind = kind;
    w.ball_radius = 1.0;
    set(w);
    try {
      complete(w);
    } catch (const InputError& e) {
      EXPECT_FALSE(e.remedy().empty());
      return e.property();
    }
    return "";
  };
  using W = TextureWish&;
  const auto over = TextureKind::Overlapping, alone = TextureKind::Isolated;
  EXPECT_EQ(property(over, [](W w) { w.spacing = 0.5; }), "");
  EXPECT_EQ(property(over, [](W) {}), "Spacing") << "nothing given";
  EXPECT_EQ(property(over, [](W w) { w.spacing = 0.5, w.ridge_height = 0.04; }), "RidgeHeight");
  EXPECT_EQ(property(over, [](W w) { w.spacing = 0.5, w.depth = 0.01; }), "Depth");
  EXPECT_EQ(property(over, [](W w) { w.spacing = 0.5, w.area_share = 0.5; }), "AreaShare");
  EXPECT_EQ(property(over, [](W w) { w.spacing = 1.5; }), "Spacing") << "the ball does not reach";
  EXPECT_EQ(property(alone, [](W w) { w.spacing = 0.5; }), "Depth") << "size missing";
  EXPECT_EQ(property(alone, [](W w) { w.depth = 0.02; }), "Spacing") << "distance missing";
  EXPECT_EQ(property(alone, [](W w) { w.depth = 0.02, w.spacing = 0.39; }), "Spacing") << "touch";
  EXPECT_EQ(property(alone, [](W w) { w.depth = 0.02, w.area_share = 0.8; }), "AreaShare")
      << "over pi/4, dimples touch";
  EXPECT_EQ(property(alone, [](W w) { w.depth = 0.02, w.diameter = 0.5, w.spacing = 1; }),
            "DimpleDiameter");
  EXPECT_EQ(property(alone, [](W w) { w.depth = 1.2, w.spacing = 3; }), "Depth") << "over R";
  EXPECT_EQ(
      property(alone, [](W w) { w.depth = 0.02, w.spacing = 0.5, w.tilt = Angle::degrees(10); }),
      "Tilt")
      << "the cap's half angle is 11.48 degrees";
  EXPECT_EQ(
      property(alone, [](W w) { w.depth = 0.02, w.spacing = 0.5, w.tilt = Angle::degrees(12); }),
      "");
  EXPECT_EQ(property(alone, [](W w) { w.ball_radius = 0; }), "BallRadius");
}

// Beyond pi/4 isolated dimples touch; beyond one there is nothing left to cover, whatever else is given.
TEST(TextureSize, MoreThanTheWholeAreaIsRefusedForThat) {
  for (const double share : {1.0 + 1e-9, 1.5, 50.0})
    for (const TextureKind kind : {TextureKind::Overlapping, TextureKind::Isolated}) {
      TextureWish w;
      w.kind = kind;
      w.ball_radius = 1.0;
      w.spacing = 0.5;
      w.area_share = share;
      try {
        complete(w);
        ADD_FAILURE() << share;
      } catch (const InputError& e) {
        EXPECT_EQ(e.property(), "AreaShare");
        EXPECT_NE(e.remedy().find("1e-09 to 1"), std::string::npos) << e.remedy();
      }
    }
}

}  // namespace
}  // namespace patchmill::patch
