// Corners by their predicted misses; see corner_search.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/corner_search.h"

namespace patchmill::sync {
namespace {

constexpr double kClear = 1e-6;  // share by which an axis must be the main one whatever the length
constexpr float kNone = std::numeric_limits<float>::infinity();

// Whether axis k is the main one of `d` by far.
bool is_clear(const Vec3& d, Eigen::Index k) {
  const Vec3 size = d.cwiseAbs();
  return size[k] > std::max(size[(k + 1) % 3], size[(k + 2) % 3]) + kClear * size.sum();
}

}  // namespace

// The best rounded corner seen so far.
class BestCorner {
 public:
  BestCorner(const Vec3& a, const Vec3& b, double length) : a_(a), b_(b), length_(length) {}

  void consider(const Vec3& p) { consider(p, std::abs(miss_of(p))); }
  void consider(const Vec3& p, double miss) {
    if (!(miss < miss_)) return;
    miss_ = miss;
    corner_ = p;
  }
  double miss_of(const Vec3& p) const { return (p - a_).norm() + (b_ - p).norm() - length_; }
  double miss() const { return miss_; }
  const Vec3& corner() const { return corner_; }

 private:
  Vec3 a_, b_;
  double length_;
  double miss_ = std::numeric_limits<double>::infinity();
  Vec3 corner_ = Vec3::Zero();
};

int steps_aside(double length, double unit) {
  return static_cast<int>(std::ceil(std::sqrt(length / unit)));
}

CornerSearch::CornerSearch(const Vec3& a, const Vec3& ideal, const Vec3& b, const Vec3& base,
                           int reach, double unit)
    : a_(a), b_(b), base_(base), unit_(unit), reach_(reach) {
  const Vec3 from_a = base - a, from_b = base - b;
  const double way_a = from_a.norm(), way_b = from_b.norm();
  way_ = way_a + way_b;
  // of a step of sqrt(3) units over half the leg, and what rounding may add
  bound_ = std::numeric_limits<double>::infinity();
  if (std::min(way_a, way_b) > kFar * unit) {
    const double part_a = unit / way_a, part_b = unit / way_b;
    slope_ = part_a * from_a + part_b * from_b;
    bound_ = 2.0 * unit * (part_a + part_b) + kRounding * way_;
  }
  level_.setConstant(kNone);
  for (int i = -1, n = 0; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) level_[n++] = float(i * slope_.x() + j * slope_.y());

  const Vec3 across = b - a;
  Vec3 up = ideal - 0.5 * (a + b);
  const Vec3 level = up.cross(across.norm() > 0.0 ? across : any_normal_to(up));
  side_ = main_axis(level);
  up[side_] = 0.0;
  lift_ = main_axis(up);
  clear_ = is_clear(level, side_) && is_clear(up, lift_);
  legs_ = Legs(from_a, way_a, from_b, way_b, side_, lift_, unit, reach);
}

double CornerSearch::off_at_base(double length) const {
  return bound_ + kSingle * (std::abs(way_ - length) + slope_.cwiseAbs().sum());
}

// The least misses of the three corners at each level, known to first order.
CornerSearch::Levels CornerSearch::at_base(double length) const {
  const Levels miss = (level_ + float(way_ - length)).abs();
  return miss.min((miss - float(std::abs(slope_.z()))).abs());
}

// Those of the 27 at the base that may be the best of them.
void CornerSearch::try_base(double length, const Levels& misses, BestCorner& best) const {
  const double most = misses.minCoeff() + 2.0 * off_at_base(length);
  for (int n = 0; n < kLevels; ++n) {
    if (double(misses[n]) > most) continue;
    const double off = double(level_[n]) + way_ - length;
    for (int k = -1; k <= 1; ++k)
      if (std::abs(off + k * slope_.z()) <= most)
        best.consider(base_ + unit_ * Vec3(double(n / 3 - 1), double(n % 3 - 1), double(k)));
  }
}

Vec3 CornerSearch::corner(int side, int lift) const {
  Vec3 steps = Vec3::Constant(side * 0.0 + lift * 0.0);
  steps[side_] += side;
  steps[lift_] += lift;
  return base_ + unit_ * steps;
}

CornerSearch::Aside CornerSearch::aside(int side, double length) const {
  const Legs::Step step = legs_.nearest(side, length);
  const Vec3 at = corner(side, step.lift);
  const double miss = (at - a_).norm() + (b_ - at).norm() - length;
  return {at, std::abs(miss), std::abs(miss + step.missing) < kPredicted * unit_};
}

// The first step aside that is good enough, or the better one where those to both sides are. The misses are known
// within `off`; `least` becomes that of all. False if one_by_one() may leave it out.
bool CornerSearch::first_aside(double length, double good_enough, double off, BestCorner& best,
                               double& least) const {
  Legs::Misses about;
  for (int first = 2; first <= reach_ && best.miss() > good_enough; first += Legs::kAtOnce) {
    legs_.about(first, length, about);
    least = std::min(least, double(about.least));
    if (double(about.least) > good_enough + off) continue;
    for (int k = 0; k < Legs::kAtOnce && best.miss() > good_enough; ++k)
      for (const int to : {0, 1}) {
        if (double(to ? about.above[k] : about.below[k]) > good_enough + off) continue;
        const Aside found = aside(to ? first + k : -first - k, length);
        if (!found.predicted) return false;
        if (found.miss <= good_enough) best.consider(found.corner, found.miss);
      }
  }
  return true;
}

// The best of the steps aside, where none is good enough. `least`: no less than its miss. False as above.
bool CornerSearch::best_aside(double length, double off, double least, BestCorner& best) const {
  Legs::Misses about;
  for (int first = 2; first <= reach_; first += Legs::kAtOnce) {
    legs_.about(first, length, about);
    if (double(about.least) > least + off) continue;
    for (int k = 0; k < Legs::kAtOnce; ++k)
      for (const int to : {0, 1}) {
        if (double(to ? about.above[k] : about.below[k]) > least + off) continue;
        const Aside found = aside(to ? first + k : -first - k, length);
        if (!found.predicted) return false;
        best.consider(found.corner, found.miss);
      }
  }
  return true;
}

// Moves the corner aside, one step after the other, until one is good enough.
void CornerSearch::one_by_one(double length, double good_enough, BestCorner& best) const {
  const double slack = legs_.slack(length);
  Legs::Misses about;
  for (int e = 2; e <= reach_ && best.miss() > good_enough; ++e) {
    const int at = (e - 2) % Legs::kAtOnce;
    if (at == 0) legs_.about(e, length, about);
    for (int sign = -1; sign <= 1; sign += 2) {
      const double enough = best.miss() + kPredicted * unit_;
      if (double(sign > 0 ? about.above[at] : about.below[at]) > enough + slack) continue;
      const Legs::Step step = legs_.nearest(sign * e, length);
      if (step.miss() < enough) best.consider(corner(sign * e, step.lift));
    }
  }
}

Vec3 CornerSearch::best(double length, double good_enough) const {
  BestCorner best(a_, b_, length);
  const Levels misses = at_base(length);
  const double of_base = misses.minCoeff() - off_at_base(length);
  if (of_base <= good_enough) try_base(length, misses, best);
  if (best.miss() <= good_enough) return best.corner();
  if (legs_.known()) {
    const double off = legs_.slack(length) + legs_.astray();
    double least = std::numeric_limits<double>::infinity();
    BestCorner found = best;
    bool sure = first_aside(length, good_enough, off, found, least);
    if (sure && found.miss() > good_enough) {
      if (of_base > good_enough && of_base <= least + off) try_base(length, misses, found);
      sure = best_aside(length, off, std::min(least + off, found.miss()), found);
    }
    if (sure) return found.corner();
  }
  if (of_base > good_enough) try_base(length, misses, best);
  one_by_one(length, good_enough, best);
  return best.corner();
}

}  // namespace patchmill::sync
