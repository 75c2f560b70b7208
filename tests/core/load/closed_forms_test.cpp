// Engagement and load where they are known in closed form: slot, half immersion, a ball at full depth, a plunge.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace patchmill::load {
namespace {

constexpr double kRadius = 3.0, kFeed = 20.0;
const Tool kFlat{kRadius, 2, 0.0}, kBall{kRadius, 2};
const Resistance kSteel{2000.0, 0.25, 0.3};

// Integral of sin^k from 0 to pi/2.
double sine(double k) {
  return 0.5 * std::sqrt(kPi) * std::tgamma(0.5 * (k + 1.0)) / std::tgamma(0.5 * k + 1.0);
}

// Mean over the end of a move, where all of the tool is in the block.
Engagement steady(const Tool& tool, const Vec3& from, const Vec3& to, double pitch) {
  const auto all = load_along(passes(tool, {from, to}, kFeed), block(pitch), kSteel);
  Engagement mean;
  int n = 0;
  for (const LoadAt& s : all) {
    if (s.at < 0.7) continue;
    mean.section += s.engagement.section;
    mean.chip += s.engagement.chip;
    mean.power += s.engagement.power;
    mean.force += s.engagement.force;
    ++n;
  }
  mean.section /= n;
  mean.chip /= n;
  mean.power /= n;
  mean.force /= n;
  return mean;
}

// The largest share by which one is off the other.
double off(const Engagement& found, const Engagement& known, const std::string& what) {
  const double part[4] = {found.section / known.section - 1.0, found.chip / known.chip - 1.0,
                          found.power / known.power - 1.0, found.force / known.force - 1.0};
  std::printf("%s: section %+.2f %%, chip %+.2f %%, power %+.2f %%, force %+.2f %%\n", what.c_str(),
              100 * part[0], 100 * part[1], 100 * part[2], 100 * part[3]);
  double most = 0.0;
  for (const double p : part) most = std::max(most, std::abs(p));
  return most;
}

// Voxels of 1/4 mm are within 3 %, and those of 2 mm are further off.
void expect_converging(const char* what, const Tool& tool, const Vec3& from, const Vec3& to,
                       const Engagement& known) {
  double first = 0.0, last = 0.0;
  for (const double pitch : {2.0, 1.0, 0.5, 0.25}) {
    last =
        off(steady(tool, from, to, pitch), known, std::string(what) + " " + std::to_string(pitch));
    if (pitch == 2.0) first = last;
  }
  EXPECT_LT(last, 0.03) << what;
  EXPECT_LT(last, 0.5 * first) << what;
}

TEST(ClosedForm, Slot) {
  const double a = 4.3, m = kSteel.exponent;
  Engagement known;
  known.section = 2.0 * kRadius * a;
  known.chip = 2.0 / kPi;
  known.power = a * kRadius * 2.0 * sine(1.0 - m);
  known.force = a * std::hypot(1.0, kSteel.normal);  // one tooth cuts at a time
  expect_converging("slot", kFlat, Vec3(-4, 7.1, kTop - a), Vec3(12, 10.5, kTop - a), known);
  expect_converging("along the voxels", kFlat, Vec3(-4, 9.9, kTop - a), Vec3(12, 9.9, kTop - a),
                    known);
}

TEST(ClosedForm, HalfImmersion) {
  const double a = 4.3, m = kSteel.exponent;
  Engagement known;
  known.section = kRadius * a;
  known.chip = 2.0 / kPi;
  known.power = a * kRadius * sine(1.0 - m);
  known.force = a * std::hypot(1.0, kSteel.normal);
  // along the edge of the block: up milling at one, down milling at the other
  for (const double y : {0.0, 20.0})
    expect_converging(y > 0.0 ? "far side" : "near side", kFlat, Vec3(-4, y, kTop - a),
                      Vec3(12, y, kTop - a), known);
}

TEST(ClosedForm, ABallAtFullDepth) {
  const double m = kSteel.exponent, q = kSteel.normal, r = kRadius;
  Engagement known;
  known.section = 0.5 * kPi * r * r;
  known.chip = 0.5;
  known.power = r * r * 2.0 * sine(1.0 - m) * sine(2.0 - m);
  known.force = r * std::hypot(sine(1.0 - m), q * sine(2.0 - m), q / (2.0 - m));
  expect_converging("ball", kBall, Vec3(-4, 7.1, kTop - r), Vec3(12, 10.5, kTop - r), known);
}

TEST(ClosedForm, APlunge) {
  Engagement known;
  known.section = kPi * kRadius * kRadius;
  known.chip = 1.0;
  known.power = known.section;
  known.force = 2.0 * kSteel.normal * kRadius;  // the cutting forces are a couple
  expect_converging("plunge", kFlat, Vec3(10.3, 9.6, kTop + 2), Vec3(10.3, 9.6, kFloor), known);
}

TEST(Load, FollowsKienzle) {
  const Engagement slot{24.0, 2.0 / kPi, 20.0, 4.0};
  const double teeth = 200.0, feed = 20.0, fz = 0.1;
  const Load load = load_at(slot, kSteel, feed, teeth);
  EXPECT_NEAR(load.removal, 480.0, 1e-9);
  EXPECT_NEAR(load.chip, 0.2 / kPi, 1e-12);
  const double kc = 2000.0 * std::pow(fz, -0.25);
  EXPECT_NEAR(load.force, kc * fz * 4.0, 1e-9);
  EXPECT_NEAR(load.power, kc * 20.0 * feed / 1000.0, 1e-9);
}

TEST(Load, TheLargestFeedMeetsItsLimit) {
  const Engagement slot{24.0, 2.0 / kPi, 20.0, 4.0};
  const double teeth = 200.0;
  LoadLimits limits;
  EXPECT_TRUE(std::isinf(largest_feed(slot, kSteel, limits, teeth)));
  limits.force = 700.0;
  EXPECT_NEAR(load_at(slot, kSteel, largest_feed(slot, kSteel, limits, teeth), teeth).force, 700.0,
              1e-6);
  limits.power = 50.0;
  EXPECT_NEAR(load_at(slot, kSteel, largest_feed(slot, kSteel, limits, teeth), teeth).power, 50.0,
              1e-6);
  limits.chip = 0.0004;
  EXPECT_NEAR(load_at(slot, kSteel, largest_feed(slot, kSteel, limits, teeth), teeth).chip, 0.0004,
              1e-9);
  EXPECT_TRUE(std::isinf(largest_feed({}, kSteel, limits, teeth)));
}

}  // namespace
}  // namespace patchmill::load
