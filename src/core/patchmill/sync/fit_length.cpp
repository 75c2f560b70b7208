// Search for the rounded corner; see fit_length.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/fit_length.h"

namespace patchmill::sync {
namespace {

constexpr double kClear = 1e-6;  // share by which an axis must be the main one whatever the length
constexpr double kLeastLift = 1e-2;  // mm: of the corner, from which rounding does not turn it

// The best rounded corner seen so far.
class BestCorner {
 public:
  BestCorner(const Vec3& a, const Vec3& b, double length) : a_(a), b_(b), length_(length) {}

  void consider(const Vec3& p) {
    consider(way_over(a_, p, b_), [&] { return p; });
  }
  /// The same where the way over it is known; `corner` is asked for if it is the best.
  template <class Corner>
  void consider(double way, const Corner& corner) {
    const double m = std::abs(way - length_);
    if (!(m < miss_)) return;
    miss_ = m;
    corner_ = corner();
  }
  double length() const { return length_; }
  double miss() const { return miss_; }
  const Vec3& corner() const { return corner_; }

 private:
  Vec3 a_, b_;
  double length_;
  double miss_ = std::numeric_limits<double>::infinity();
  Vec3 corner_ = Vec3::Zero();
};

// The grid points around a corner's base, by how much they miss a length: to first order, within `bound`.
struct Around {
  double miss[27], least = std::numeric_limits<double>::infinity(), bound;

  Around(const Vec3& a, const Vec3& base, const Vec3& b, double length, double unit) {
    const Vec3 from_a = base - a, from_b = base - b;
    const double way_a = from_a.norm(), way_b = from_b.norm();
    const bool far = std::min(way_a, way_b) > kFar * unit;
    const Vec3 slope = far ? Vec3(unit * (from_a / way_a + from_b / way_b)) : Vec3(Vec3::Zero());
    // of a step of sqrt(3) units over half the leg, and what rounding may add
    bound = far ? 2.0 * unit * unit * (1.0 / way_a + 1.0 / way_b) + kRounding * length
                : std::numeric_limits<double>::infinity();
    const double off = way_a + way_b - length;
    for (int n = 0, i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k, ++n) {
          miss[n] = std::abs(off + i * slope.x() + j * slope.y() + k * slope.z());
          least = std::min(least, miss[n]);
        }
  }
  static Vec3 at(int n) { return {double(n / 9 - 1), double(n / 3 % 3 - 1), double(n % 3 - 1)}; }
  /// Whether point n may be the best of them for a length that is `within` of the one given.
  bool may_be_best(int n, double within = 0.0) const {
    return miss[n] <= least + 2.0 * bound + 2.0 * within;
  }
};

int steps_aside(double length, double unit) {
  return static_cast<int>(std::ceil(std::sqrt(length / unit)));
}

// The main axis of `d` if it is that by far.
bool is_clear(const Vec3& d, const Vec3& axis, double size) {
  const Vec3 others = d - d.dot(axis) * axis;
  return std::abs(d.dot(axis)) > others.cwiseAbs().maxCoeff() + kClear * size;
}

}  // namespace

// Along which axes a corner is moved aside, and lifted to make up for it.
Aside::Aside(const Vec3& a, const Vec3& ideal, const Vec3& b, const Vec3& base, double length,
             double unit)
    : reach(steps_aside(length, unit)) {
  const Vec3 up = ideal - 0.5 * (a + b), across = b - a;
  const Vec3 level = up.cross(across.norm() > 0.0 ? across : any_normal_to(up));
  side = main_axis(level);
  const Vec3 upright = up - up.dot(side) * side;
  lift = main_axis(upright);
  clear = up.norm() > kLeastLift && is_clear(level, side, level.norm()) &&
          is_clear(upright, lift, up.norm());
  legs = Legs(base - a, base - b, unit * side, unit * lift, reach + Legs::kAtOnce);
}

namespace {

// Moves the corner aside, one step after the other, until one is good enough.
void search(const Aside& aside, const Vec3& base, double unit, double good_enough,
            BestCorner& best) {
  const Legs& legs = aside.legs;
  const double length = best.length(), slack = legs.slack(length);
  Legs::Misses about;
  for (int e = 2; e <= aside.reach && best.miss() > good_enough; ++e) {
    const int at = (e - 2) % Legs::kAtOnce;
    if (at == 0) {
      about = legs.about(e, length);
      if (legs.known() && double(about.minCoeff()) > best.miss() + kPredicted * unit + slack) {
        e += Legs::kAtOnce - 1;
        continue;
      }
    }
    for (int sign = -1; sign <= 1; sign += 2) {
      const double enough = best.miss() + kPredicted * unit;
      if (double(about(at, sign > 0)) > enough + slack) continue;
      const Legs::Step step = legs.nearest(sign * e, length);
      if (step.miss < enough)
        best.consider(base + unit * (sign * e * aside.side + step.lift * aside.lift));
    }
  }
}

}  // namespace

Vec3 fit_corner(const Vec3& a, const Vec3& ideal, const Vec3& b, double length,
                const Decimals& decimals, double good_enough) {
  const double unit = decimals.unit();
  const Vec3 base = decimals.round(ideal);
  BestCorner best(a, b, length);
  const Around around(a, base, b, length, unit);
  for (int n = 0; n < 27; ++n)
    if (around.may_be_best(n)) best.consider(base + unit * Around::at(n));
  if (best.miss() > good_enough)
    search(Aside(a, ideal, b, base, length, unit), base, unit, good_enough, best);
  return decimals.round(best.corner());
}

CornerAhead::CornerAhead(const Vec3& a, const Vec3& b, const Vec3& low_ideal,
                         const Vec3& high_ideal, double length, const Decimals& decimals,
                         double good_enough)
    : a_(a), b_(b), base_(decimals.round(low_ideal)), good_(good_enough), unit_(decimals.unit()) {
  const double low = length - good_, high = length + good_;
  if (base_ != decimals.round(high_ideal) || steps_aside(low, unit_) != steps_aside(high, unit_))
    return;
  const Around around(a, base_, b, length, unit_);
  for (int n = 0; n < 27; ++n) {
    if (!around.may_be_best(n, good_)) continue;
    if (near_ == kMostNear) return;
    const Vec3 corner = base_ + unit_ * Around::at(n);
    ways_[near_] = way_over(a, corner, b);
    steps_[near_++] = n;
  }
  aside_ = Aside(a, low_ideal, b, base_, length, unit_);
  if (!aside_.clear) return;
  low_ = low;
  high_ = high;
}

Vec3 CornerAhead::fit(double length, const Decimals& decimals) const {
  BestCorner best(a_, b_, length);
  for (int k = 0; k < near_; ++k)
    best.consider(ways_[k], [&] { return Vec3(base_ + unit_ * Around::at(steps_[k])); });
  if (best.miss() > good_) search(aside_, base_, unit_, good_, best);
  return decimals.round(best.corner());
}

}  // namespace patchmill::sync
