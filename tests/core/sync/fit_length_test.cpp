// The corner that fits a length best, against the plain search of fit_length.h: every grid point near the ideal one,
// then one step to the side after the other, each by its length; and corners found ahead against it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/fit_length.h"

#include "patchmill/sync/constant_feed.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::sync {
namespace {

Vec3 main_axis(const Vec3& d) {
  Eigen::Index k = 0;
  d.cwiseAbs().maxCoeff(&k);
  return Vec3::Unit(k);
}

struct Plain {
  Vec3 a, b;
  double length, miss = std::numeric_limits<double>::infinity();
  Vec3 corner = Vec3::Zero();

  void consider(const Vec3& p) {
    const double m = std::abs(way_over(a, p, b) - length);
    if (m < miss) {
      miss = m;
      corner = p;
    }
  }
  // What a lift by `up` is predicted to miss by, a first-order one of one, none or minus one unit.
  std::pair<int, double> lifted(const Vec3& base, const Vec3& side, const Vec3& up, int e) const {
    const double square = side.squaredNorm();
    double missing = length, slope = 0.0;
    for (const Vec3& end : {a, b}) {
      const Vec3 from = base - end;
      missing -= std::sqrt(from.squaredNorm() + e * (2.0 * from.dot(side) + e * square));
      slope += from.dot(up) / from.norm();
    }
    int lift = 0;
    if (std::abs(missing) > 0.5 * std::abs(slope)) lift = (missing > 0.0) == (slope > 0.0) ? 1 : -1;
    return {lift, std::abs(missing - lift * slope)};
  }
  Vec3 search(const Vec3& ideal, const Decimals& decimals, double good) {
    const double unit = decimals.unit();
    const Vec3 base = decimals.round(ideal);
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) consider(base + unit * Vec3(i, j, k));
    const Vec3 up = ideal - 0.5 * (a + b), across = b - a;
    const Vec3 side = main_axis(up.cross(across.norm() > 0.0 ? across : any_normal_to(up)));
    const Vec3 lift = main_axis(up - up.dot(side) * side);
    const int reach = static_cast<int>(std::ceil(std::sqrt(length / unit)));
    for (int e = 2; e <= reach && miss > good; ++e)
      for (const int at : {-e, e}) {
        const auto [by, predicted] = lifted(base, unit * side, unit * lift, at);
        if (predicted < miss + 0.01 * unit) consider(base + unit * (at * side + by * lift));
      }
    return decimals.round(corner);
  }
};

RC_GTEST_PROP(FitLength, FindsWhatThePlainSearchFinds, (unsigned seed)) {
  std::mt19937 engine(seed);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  for (int count : {1, 2, 3, 4, 5}) {
    const Decimals decimals(count);
    for (int k = 0; k < 40; ++k) {
      const Vec3 a = decimals.round(Vec3(draw(-30, 30), draw(-30, 30), draw(-5, 5)));
      const Vec3 b = decimals.round(Vec3(a + Vec3(draw(-1, 1), draw(-1, 1), draw(-0.3, 0.3))));
      const double distance = (b - a).norm(), length = distance * draw(1.0, 1.5) + draw(0.0, 2.0);
      const Vec3 ideal = apex(a, b, Vec3(draw(-0.5, 0.5), draw(-0.5, 0.5), 1.0), length);
      Plain plain{a, b, length};
      const Vec3 found = fit_corner(a, ideal, b, length, decimals, 2e-5);
      RC_ASSERT(found == plain.search(ideal, decimals, 2e-5));
    }
  }
}

constexpr double kGood = 2e-5;  // mm

// A step of a texture: of half a millimetre over a corner a millimetre high.
struct Texture {
  std::mt19937 engine;
  Vec3 a, b, up;
  double length = 0.0;

  double draw(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  void next(const Decimals& decimals) {
    a = decimals.round(Vec3(draw(-900, 900), draw(-900, 900), draw(-5, 5)));
    const double way = draw(0.0, 2.0 * kPi);
    b = decimals.round(Vec3(a + Vec3(0.5 * std::cos(way), 0.5 * std::sin(way), draw(-0.3, 0.3))));
    up = Vec3(draw(-0.7, 0.7), draw(-0.7, 0.7), 1.0);
    length = draw(0.7, 2.5);
  }
};

CornerAhead ahead_of(const Texture& t, const Decimals& decimals) {
  return {t.a, t.b, t.up, t.length, decimals};
}

RC_GTEST_PROP(CornerAhead, IsThatOfTheSearchForAnyLength, (unsigned seed)) {
  Texture texture{std::mt19937(seed), {}, {}, {}};
  for (int count : {1, 2, 3, 3, 3, 3, 4, 4, 5}) {
    const Decimals decimals(count);
    for (int k = 0; k < 20; ++k) {
      texture.next(decimals);
      const auto& [engine, a, b, up, about] = texture;
      const CornerAhead ahead = ahead_of(texture, decimals);
      RC_ASSERT(!ahead.fit(about + 4.0 * decimals.unit(), decimals, kGood));
      for (int i = 0; i < 20; ++i) {
        const double length = about + texture.draw(-1.0, 1.0) * (i < 10 ? kGood : decimals.unit());
        const std::optional<Vec3> found = ahead.fit(length, decimals, kGood);
        if (found)
          RC_ASSERT(*found == fit_corner(a, apex(a, b, up, length), b, length, decimals, kGood));
      }
    }
  }
}

TEST(CornerAhead, NearlyAlwaysHoldsOnThreeDecimals) {
  const Decimals decimals(3);
  Texture texture{std::mt19937(1), {}, {}, {}};
  int holds = 0;
  constexpr int kSteps = 5000;
  for (int k = 0; k < kSteps; ++k) {
    texture.next(decimals);
    const CornerAhead ahead = ahead_of(texture, decimals);
    holds += ahead.fit(texture.length + texture.draw(-kGood, kGood), decimals, kGood).has_value();
  }
  EXPECT_GT(holds, 0.9 * kSteps);
}

}  // namespace
}  // namespace patchmill::sync
