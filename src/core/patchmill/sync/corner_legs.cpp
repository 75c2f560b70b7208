// Legs in powers of the step; see corner_legs.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/corner_legs.h"

#include "patchmill/geometry/vector_clones.h"

namespace patchmill::sync {
namespace {

constexpr float kAhead[Legs::kAtOnce] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr float kNone = std::numeric_limits<float>::infinity();

// |x| or, where that is nearer to nothing, what a lift of `rise` makes of it.
inline float lifted(float x, float rise) {
  const float size = std::abs(x), other = std::abs(size - rise);
  return size < other ? size : other;
}

// `missing`: what is missing at no step, and its change with the powers of the step. Misses at `first`, ... .
PATCHMILL_VECTOR_CLONES
void evaluate(const float (&missing)[5], float rise, float first, float* below, float* above) {
  for (int k = 0; k < Legs::kAtOnce; ++k) {
    const float s = first + kAhead[k], s2 = s * s;
    const float even = missing[0] + s2 * (missing[2] + s2 * missing[4]);
    const float odd = s * (missing[1] + s2 * missing[3]);
    below[k] = lifted(even - odd, rise);
    above[k] = lifted(even + odd, rise);
  }
}

}  // namespace

Legs::Legs(const Vec3& from_a, double way_a, const Vec3& from_b, double way_b, Eigen::Index side,
           Eigen::Index lift, double unit, int reach)
    : a_{from_a.squaredNorm(), 2.0 * (from_a[side] * unit)},
      b_{from_b.squaredNorm(), 2.0 * (from_b[side] * unit)},
      square_(unit * unit),
      reach_(reach) {
  const double slope_a = from_a[lift] * unit / way_a, slope_b = from_b[lift] * unit / way_b;
  slope_ = slope_a + slope_b;
  double missing[5] = {}, power = 1.0;
  expand(a_, way_a, slope_a, unit, missing);
  expand(b_, way_b, slope_b, unit, missing);
  at_base_ = -missing[0];
  for (int i = 1; i < 5; ++i) {
    power *= reach;
    missing_[i - 1] = float(missing[i]);
    slack_ += kSingle * std::abs(missing[i]) * power;
  }
  slack_ += kSingle * std::abs(slope_);
  astray_ += 0.5 * reach *
             std::abs(slope_a * a_.per_side / a_.at_base + slope_b * b_.per_side / b_.at_base);
}

void Legs::about(int first, double length, Misses& misses) const {
  const float missing[5] = {float(length - at_base_), missing_[0], missing_[1], missing_[2],
                            missing_[3]};
  evaluate(missing, float(std::abs(slope_)), float(first), misses.below, misses.above);
  for (int k = std::max(0, reach_ + 1 - first); k < kAtOnce; ++k)
    misses.below[k] = misses.above[k] = kNone;
  using Row = Eigen::Map<const Eigen::Array<float, kAtOnce, 1>>;
  misses.least = Row(misses.below).min(Row(misses.above)).minCoeff();
}

// sqrt(1 + x) in powers of the step, x = p s + q s^2. With z the greater of |p s| and sqrt(q) s, what is left out is
// less than 0.4 z^5 / (1 - 1.62 z), and that less than z^5 up to z = 0.35.
//
// A lift by one unit changes the leg by slope (1 + x)^(-1/2). Of that slope (1 - p s / 2) is the constructor's; the
// rest is less than slope (q s^2 / 2 + 2 x^2) up to z = 0.35, and the second order less than unit^2 / 2 over the
// shortest leg.
void Legs::expand(const Leg& leg, double way, double slope, double unit, double (&missing)[5]) {
  const double p = leg.per_side / leg.at_base, q = square_ / leg.at_base, p2 = p * p;
  missing[0] -= way;
  missing[1] -= way * p / 2.0;
  missing[2] -= way * (q / 2.0 - p2 / 8.0);
  missing[3] -= way * p * (p2 / 16.0 - q / 4.0);
  missing[4] -= way * (3.0 * p2 * q / 16.0 - q * q / 8.0 - 5.0 * p2 * p2 / 128.0);
  const double z = reach_ * std::max(std::abs(p), unit / way);
  slack_ += z < kSmallStep ? way * (z * z * z * z * z + kRounding)
                           : std::numeric_limits<double>::infinity();
  const double bend = reach_ * (reach_ * q), x = reach_ * std::abs(p) + bend;
  astray_ +=
      std::abs(slope) * (0.5 * bend + 2.0 * x * x) + 0.5 * square_ / (way * (1.0 - x) - unit);
}

}  // namespace patchmill::sync
