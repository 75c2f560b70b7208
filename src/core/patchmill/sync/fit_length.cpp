// Search for the rounded corner; see fit_length.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/fit_length.h"

#include <limits>

namespace patchmill::sync {
namespace {

constexpr double kPredicted = 0.01;  // of a unit: how well a step's length is predicted

// The best rounded corner seen so far.
class BestCorner {
 public:
  BestCorner(const Vec3& a, const Vec3& b, double length) : a_(a), b_(b), length_(length) {}

  void consider(const Vec3& p) {
    const double m = std::abs(way_over(a_, p, b_) - length_);
    if (m < miss_) {
      miss_ = m;
      corner_ = p;
    }
  }
  double miss() const { return miss_; }
  const Vec3& corner() const { return corner_; }

 private:
  Vec3 a_, b_;
  double length_;
  double miss_ = std::numeric_limits<double>::infinity();
  Vec3 corner_ = Vec3::Zero();
};

// The coordinate axis nearest to direction `d`.
Vec3 main_axis(const Vec3& d) {
  Eigen::Index k = 0;
  d.cwiseAbs().maxCoeff(&k);
  return Vec3::Unit(k);
}

// The way over a corner that is moved from `base` by whole steps to the side and up. Squared lengths of
// the legs are exact second-degree forms of the steps' numbers, so that a side step costs two roots.
class Legs {
 public:
  Legs(const Vec3& from_a, const Vec3& from_b, const Vec3& side, const Vec3& lift)
      : a_{from_a.squaredNorm(), 2.0 * from_a.dot(side)},
        b_{from_b.squaredNorm(), 2.0 * from_b.dot(side)},
        square_(side.squaredNorm()),
        slope_(from_a.dot(lift) / from_a.norm() + from_b.dot(lift) / from_b.norm()) {}

  struct Step {
    int lift;     // -1, 0 or 1: what comes nearest to the length
    double miss;  // predicted to first order in the lift
  };
  Step nearest(int side, double length) const {
    const double missing = length - root(a_, side) - root(b_, side);
    int lift = 0;
    if (std::abs(missing) > 0.5 * std::abs(slope_))
      lift = (missing > 0.0) == (slope_ > 0.0) ? 1 : -1;
    return {lift, std::abs(missing - lift * slope_)};
  }

 private:
  struct Leg {
    double at_base, per_side;
  };
  double root(const Leg& leg, int side) const {
    return std::sqrt(leg.at_base + side * (leg.per_side + side * square_));
  }
  Leg a_, b_;
  double square_;
  double slope_;  // of the way over the lift, at the base
};

}  // namespace

Vec3 fit_corner(const Vec3& a, const Vec3& ideal, const Vec3& b, double length,
                const Decimals& decimals, double good_enough) {
  const double unit = decimals.unit();
  const Vec3 base = decimals.round(ideal);
  BestCorner best(a, b, length);
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k) best.consider(base + unit * Vec3(i, j, k));

  const Vec3 up = ideal - 0.5 * (a + b), across = b - a;
  const Vec3 side = main_axis(up.cross(across.norm() > 0.0 ? across : any_normal_to(up)));
  const Vec3 lift = main_axis(up - up.dot(side) * side);
  const Legs legs(base - a, base - b, unit * side, unit * lift);
  const int reach = static_cast<int>(std::ceil(std::sqrt(length / unit)));
  for (int e = 2; e <= reach && best.miss() > good_enough; ++e)
    for (int sign = -1; sign <= 1; sign += 2) {
      const Legs::Step step = legs.nearest(sign * e, length);
      if (step.miss < best.miss() + kPredicted * unit)
        best.consider(base + unit * (sign * e * side + step.lift * lift));
    }
  return decimals.round(best.corner());
}

}  // namespace patchmill::sync
