// The way over a corner on the program's grid, leg by leg, while the corner is moved; part of the search of
// fit_length.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchmill::sync {

constexpr double kPredicted = 0.01;  // of a unit: how well a step's length is predicted
constexpr double kSmallStep = 0.35;  // of a leg
constexpr double kRounding = 1e-13;  // of a leg
constexpr double kSingle = 1e-6;     // of a term in single precision: sixteen roundings
constexpr double kFar = 10.0;        // units: legs that are longer change little by a step

// The coordinate axis nearest to direction `d`.
inline Vec3 main_axis(const Vec3& d) {
  Eigen::Index k = 0;
  d.cwiseAbs().maxCoeff(&k);
  return Vec3::Unit(k);
}

// The way over a corner that is moved from `base` by whole steps to the side and up. Squared lengths of
// the legs are exact second-degree forms of the steps' numbers, so that a side step costs two roots. What a root is to
// the fourth power of the step costs none, and tells most steps that are not worth them.
class Legs {
 public:
  static constexpr int kAtOnce = 8;
  static constexpr float kAhead[kAtOnce] = {0.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F};
  using Misses = Eigen::Array<float, kAtOnce, 2>;  // of steps e, e + 1, ... to either side
  struct Step {
    int lift;     // -1, 0 or 1: what comes nearest to the length
    double miss;  // predicted to first order in the lift
  };

  Legs() = default;
  Legs(const Vec3& from_a, const Vec3& from_b, const Vec3& side, const Vec3& lift, int reach)
      : a_{from_a.squaredNorm(), 2.0 * from_a.dot(side)},
        b_{from_b.squaredNorm(), 2.0 * from_b.dot(side)},
        square_(side.squaredNorm()),
        slope_(from_a.dot(lift) / from_a.norm() + from_b.dot(lift) / from_b.norm()) {
    double missing[5] = {}, power = 1.0;
    for (const Leg& leg : {a_, b_}) expand(leg, reach, missing);
    at_base_ = -missing[0];
    for (int i = 1; i < 5; ++i) {
      power *= reach;
      missing_[i - 1] = float(missing[i]);
      slack_ += kSingle * std::abs(missing[i]) * power;
    }
    slack_ += kSingle * std::abs(slope_);
  }

  Step nearest(int side, double length) const {
    const double missing = length - root(a_, side) - root(b_, side);
    int lift = 0;
    if (std::abs(missing) > 0.5 * std::abs(slope_))
      lift = (missing > 0.0) == (slope_ > 0.0) ? 1 : -1;
    return {lift, std::abs(missing - lift * slope_)};
  }
  /// The misses of `nearest` for steps from `first` on, first to the negative side, within slack() of them.
  Misses about(int first, double length) const {
    using Steps = Eigen::Array<float, kAtOnce, 1>;
    const Steps s = float(first) + Eigen::Map<const Steps>(kAhead), s2 = s * s;
    const Steps even = float(length - at_base_) + s2 * (missing_[1] + s2 * missing_[3]);
    const Steps odd = s * (missing_[0] + s2 * missing_[2]);
    Misses miss;
    miss.col(0) = (even - odd).abs();
    miss.col(1) = (even + odd).abs();
    return miss.min((miss - float(std::abs(slope_))).abs());
  }
  double slack(double length) const { return slack_ + kSingle * std::abs(length - at_base_); }
  bool known() const { return std::isfinite(slack_); }

 private:
  struct Leg {
    double at_base, per_side;
  };
  double root(const Leg& leg, int side) const {
    return std::sqrt(leg.at_base + side * (leg.per_side + side * square_));
  }
  /// sqrt(1 + x) in powers of the step, x = p s + q s^2. With z the greater of |p s| and sqrt(q) s, what is left out is
  /// less than 0.4 z^5 / (1 - 1.62 z), and that less than z^5 up to z = 0.35.
  void expand(const Leg& leg, int reach, double (&missing)[5]) {
    const double way = std::sqrt(leg.at_base), p = leg.per_side / leg.at_base,
                 q = square_ / leg.at_base, p2 = p * p;
    missing[0] -= way;
    missing[1] -= way * p / 2.0;
    missing[2] -= way * (q / 2.0 - p2 / 8.0);
    missing[3] -= way * p * (p2 / 16.0 - q / 4.0);
    missing[4] -= way * (3.0 * p2 * q / 16.0 - q * q / 8.0 - 5.0 * p2 * p2 / 128.0);
    const double z = reach * std::max(std::abs(p), std::sqrt(q));
    slack_ += z < kSmallStep ? way * (z * z * z * z * z + kRounding)
                             : std::numeric_limits<double>::infinity();
  }

  Leg a_{}, b_{};
  double square_ = 0.0;
  double slope_ = 0.0;     // of the way over the lift, at the base
  double at_base_ = 0.0;   // the way there
  float missing_[4] = {};  // of the powers of the step, from the first on
  double slack_ = 0.0;
};

}  // namespace patchmill::sync
