// A convex function of one variable between its tangents; see sweep.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/sweep.h"

#include <algorithm>
#include <cmath>

namespace patchmill::collision {
namespace {

constexpr double kExact = 1e-9;  // mm
constexpr int kMostSteps = 100;

/// The distance at a fraction of the travel, with its slope over the fraction.
struct At {
  double fraction, value, slope;
  Vec3 gradient;
};

}  // namespace

// With tangents at a and b that fall and rise, the least lies between them, and no lower than where they cross. The
// mean of their gradients that does not change along the travel is a subgradient of the least.
SweptDistance swept_distance(const Frustum& frustum, const Vec3& origin, const Vec3& axis,
                             const Vec3& travel, const Vec3& p) {
  const auto at = [&](double fraction) {
    const SignedDistance d = frustum_distance(frustum, origin + fraction * travel, axis, p);
    return At{fraction, d.value, -d.gradient.dot(travel), d.gradient};
  };
  At a = at(0.0);
  if (a.slope >= 0.0) return {a.value, a.gradient, 0.0};
  At b = at(1.0);
  if (b.slope <= 0.0) return {b.value, b.gradient, 1.0};
  double crossing = 0.0;
  for (int step = 0; step < kMostSteps; ++step) {
    const double where =
        (a.value - b.value + b.slope * b.fraction - a.slope * a.fraction) / (b.slope - a.slope);
    crossing = a.value + a.slope * (where - a.fraction);
    if (std::min(a.value, b.value) - crossing <= kExact) break;
    // where the tangents cross, but now and then in the middle: a bend near one end would take many steps
    const double middle = 0.5 * (a.fraction + b.fraction);
    const bool within = where > a.fraction && where < b.fraction;
    const At next = at(within && step % 3 != 2 ? where : middle);
    if (next.slope == 0.0) return {next.value, next.gradient, next.fraction};
    (next.slope < 0.0 ? a : b) = next;
  }
  const double part = b.slope / (b.slope - a.slope);
  const At& nearest = a.value <= b.value ? a : b;
  return {nearest.value, part * a.gradient + (1.0 - part) * b.gradient, nearest.fraction};
}

}  // namespace patchmill::collision
