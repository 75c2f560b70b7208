// Distance from a frustum; see frustum.h. In the half plane of height and radius the frustum is a trapezoid.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/frustum.h"

#include <algorithm>
#include <cmath>

namespace patchmill::collision {
namespace {

// The point of the segment a-b nearest to p (Ericson 2005, section 5.1.2).
Vec2 nearest_on(const Vec2& a, const Vec2& b, const Vec2& p) {
  const double s = (p - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-300);
  return a + std::min(1.0, std::max(0.0, s)) * (b - a);
}

struct Flat {
  double value;
  Vec2 gradient;  // along height and radius
};

Flat inside_or_outside(const Frustum& s, const Vec2& p) {
  const Vec2 low(s.from, s.radius_from), high(s.to, s.radius_to);
  const Vec2 slant = (high - low).normalized(), out(-slant.y(), slant.x());
  const double below = s.from - p.x(), above = p.x() - s.to, beyond = out.dot(p - low);
  if (below <= 0.0 && above <= 0.0 && beyond <= 0.0) {
    if (beyond >= below && beyond >= above) return {beyond, out};
    return below >= above ? Flat{below, Vec2(-1, 0)} : Flat{above, Vec2(1, 0)};
  }
  Vec2 nearest = nearest_on(low, high, p);
  for (const Vec2& end : {nearest_on(Vec2(s.from, 0), low, p), nearest_on(Vec2(s.to, 0), high, p)})
    if ((end - p).squaredNorm() < (nearest - p).squaredNorm()) nearest = end;
  const double d = (p - nearest).norm();
  return {d, d > 0.0 ? Vec2((p - nearest) / d) : out};
}

}  // namespace

SignedDistance frustum_distance(const Frustum& frustum, const Vec3& origin, const Vec3& axis,
                                const Vec3& p) {
  const Vec3 from_origin = p - origin;
  const double height = axis.dot(from_origin);
  const Vec3 across = from_origin - height * axis;
  const double radius = across.norm();
  const Flat flat = inside_or_outside(frustum, Vec2(height, radius));
  SignedDistance out{flat.value, flat.gradient.x() * axis};
  // on the axis itself no direction is steeper than another: none is a subgradient too
  if (radius > 1e-12) out.gradient += flat.gradient.y() / radius * across;
  return out;
}

}  // namespace patchmill::collision
