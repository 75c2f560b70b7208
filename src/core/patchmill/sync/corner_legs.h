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
inline Eigen::Index main_axis(const Vec3& d) {
  Eigen::Index k = 0;
  d.cwiseAbs().maxCoeff(&k);
  return k;
}

// The way over a corner that is moved from its base by whole steps to the side and up, along coordinate axes. Squared
// lengths of the legs are exact second-degree forms of the steps' numbers, so that a side step costs two roots. What a
// root is to the fourth power of the step costs none, and tells most steps that are not worth them.
class Legs {
 public:
  static constexpr int kAtOnce = 16;
  /// Of steps e, e + 1, ... to the negative side, and to the other; and the least of either.
  struct Misses {
    float below[kAtOnce], above[kAtOnce], least;
  };
  struct Step {
    int lift;        // -1, 0 or 1: what comes nearest to the length
    double missing;  // to the length: predicted to first order in the lift
    double miss() const { return std::abs(missing); }
  };

  Legs() = default;
  /// The base as seen from the ends, and how far that is; the axes; up to `reach` steps.
  Legs(const Vec3& from_a, double way_a, const Vec3& from_b, double way_b, Eigen::Index side,
       Eigen::Index lift, double unit, int reach);

  Step nearest(int side, double length) const {
    const double missing = length - root(a_, side) - root(b_, side);
    int lift = 0;
    if (std::abs(missing) > 0.5 * std::abs(slope_))
      lift = (missing > 0.0) == (slope_ > 0.0) ? 1 : -1;
    return {lift, missing - lift * slope_};
  }
  /// The misses of `nearest` for steps from `first` on, up to reach, within slack() of them.
  void about(int first, double length, Misses& misses) const;
  double slack(double length) const { return slack_ + kSingle * std::abs(length - at_base_); }
  bool known() const { return std::isfinite(slack_); }
  /// How far the misses of `nearest` may be off where the slack is known.
  double astray() const { return astray_; }

 private:
  struct Leg {
    double at_base, per_side;
  };
  double root(const Leg& leg, int side) const {
    return std::sqrt(leg.at_base + side * (leg.per_side + side * square_));
  }
  void expand(const Leg& leg, double way, double slope, double unit, double (&missing)[5]);

  Leg a_{}, b_{};
  double square_ = 0.0;
  double slope_ = 0.0;     // of the way over the lift, at the base
  double at_base_ = 0.0;   // the way there
  float missing_[4] = {};  // of the powers of the step, from the first on
  int reach_ = 0;
  double slack_ = 0.0, astray_ = 0.0;
};

}  // namespace patchmill::sync
