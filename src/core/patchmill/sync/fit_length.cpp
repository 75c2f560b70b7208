// Search for the rounded corner; see fit_length.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/fit_length.h"

#include <algorithm>
#include <limits>

namespace patchmill::sync {
namespace {

constexpr double kPredicted = 0.01;  // of a unit: how well a step's length is predicted
constexpr double kSmallStep = 0.35;  // of a leg
constexpr double kRounding = 1e-13;  // of a leg
constexpr double kSingle = 1e-6;     // of a term in single precision: sixteen roundings
constexpr double kFar = 10.0;        // units: legs that are longer change little by a step

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

  Legs(const Vec3& from_a, const Vec3& from_b, const Vec3& side, const Vec3& lift, double length,
       int reach)
      : length_(length),
        a_{from_a.squaredNorm(), 2.0 * from_a.dot(side)},
        b_{from_b.squaredNorm(), 2.0 * from_b.dot(side)},
        square_(side.squaredNorm()),
        slope_(from_a.dot(lift) / from_a.norm() + from_b.dot(lift) / from_b.norm()) {
    double missing[5] = {length, 0.0, 0.0, 0.0, 0.0}, power = 1.0;
    for (const Leg& leg : {a_, b_}) expand(leg, reach, missing);
    for (int i = 0; i < 5; ++i, power *= reach) {
      missing_[i] = float(missing[i]);
      slack_ += kSingle * std::abs(missing[i]) * power;
    }
    slack_ += kSingle * std::abs(slope_);
  }

  Step nearest(int side) const {
    const double missing = length_ - root(a_, side) - root(b_, side);
    int lift = 0;
    if (std::abs(missing) > 0.5 * std::abs(slope_))
      lift = (missing > 0.0) == (slope_ > 0.0) ? 1 : -1;
    return {lift, std::abs(missing - lift * slope_)};
  }
  /// The misses of `nearest` for steps from `first` on, first to the negative side, within slack() of them.
  Misses about(int first) const {
    using Steps = Eigen::Array<float, kAtOnce, 1>;
    const Steps s = float(first) + Eigen::Map<const Steps>(kAhead), s2 = s * s;
    const Steps even = missing_[0] + s2 * (missing_[2] + s2 * missing_[4]);
    const Steps odd = s * (missing_[1] + s2 * missing_[3]);
    Misses miss;
    miss.col(0) = (even - odd).abs();
    miss.col(1) = (even + odd).abs();
    return miss.min((miss - float(std::abs(slope_))).abs());
  }
  double slack() const { return slack_; }
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

  double length_;
  Leg a_, b_;
  double square_;
  double slope_;      // of the way over the lift, at the base
  float missing_[5];  // of the powers of the step
  double slack_ = 0.0;
};

// The 27 grid points at `base` and around it that can be the best: those whose way is, to first order, as near to
// the length as that of the nearest one but for the second order, which is bounded.
void consider_near(const Vec3& a, const Vec3& base, const Vec3& b, double length, double unit,
                   BestCorner& best) {
  const Vec3 from_a = base - a, from_b = base - b;
  const double way_a = from_a.norm(), way_b = from_b.norm();
  const bool far = std::min(way_a, way_b) > kFar * unit;
  const Vec3 slope = far ? Vec3(unit * (from_a / way_a + from_b / way_b)) : Vec3(Vec3::Zero());
  // of a step of sqrt(3) units over half the leg, and what rounding may add
  const double bound = far ? 2.0 * unit * unit * (1.0 / way_a + 1.0 / way_b) + kRounding * length
                           : std::numeric_limits<double>::infinity();
  double miss[3][3][3], least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) {
        miss[i][j][k] = std::abs(way_a + way_b - length + (i - 1) * slope.x() +
                                 (j - 1) * slope.y() + (k - 1) * slope.z());
        least = std::min(least, miss[i][j][k]);
      }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        if (miss[i][j][k] <= least + 2.0 * bound)
          best.consider(base + unit * Vec3(i - 1, j - 1, k - 1));
}

}  // namespace

Vec3 fit_corner(const Vec3& a, const Vec3& ideal, const Vec3& b, double length,
                const Decimals& decimals, double good_enough) {
  const double unit = decimals.unit();
  const Vec3 base = decimals.round(ideal);
  BestCorner best(a, b, length);
  consider_near(a, base, b, length, unit, best);
  if (best.miss() <= good_enough) return decimals.round(best.corner());

  const Vec3 up = ideal - 0.5 * (a + b), across = b - a;
  const Vec3 side = main_axis(up.cross(across.norm() > 0.0 ? across : any_normal_to(up)));
  const Vec3 lift = main_axis(up - up.dot(side) * side);
  const int reach = static_cast<int>(std::ceil(std::sqrt(length / unit)));
  const Legs legs(base - a, base - b, unit * side, unit * lift, length, reach + Legs::kAtOnce);
  Legs::Misses about;
  for (int e = 2; e <= reach && best.miss() > good_enough; ++e) {
    const int at = (e - 2) % Legs::kAtOnce;
    if (at == 0) {
      about = legs.about(e);
      if (legs.known() &&
          double(about.minCoeff()) > best.miss() + kPredicted * unit + legs.slack()) {
        e += Legs::kAtOnce - 1;
        continue;
      }
    }
    for (int sign = -1; sign <= 1; sign += 2) {
      const double enough = best.miss() + kPredicted * unit;
      if (double(about(at, sign > 0)) > enough + legs.slack()) continue;
      const Legs::Step step = legs.nearest(sign * e);
      if (step.miss < enough) best.consider(base + unit * (sign * e * side + step.lift * lift));
    }
  }
  return decimals.round(best.corner());
}

}  // namespace patchmill::sync
