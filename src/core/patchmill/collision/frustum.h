// Signed distance of a point from a solid frustum, a convex body, with its gradient. The distance is a convex
// function of the point (Boyd & Vandenberghe 2004, sections 3.1.3 and 8.1), so that a tangent plane lies below it
// everywhere:
//     d(q) >= d(p) + g(p) . (q - p),
// which bounds it over a box or a triangle from one point, to second order in the size.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"
#include "patchmill/tool/tool.h"

namespace patchmill::collision {

/// A distance and the direction in which it grows.
struct SignedDistance {
  double value = 0.0;            ///< [mm], negative inside
  Vec3 gradient = Vec3::Zero();  ///< a subgradient, at most of unit length
};

/// Of `p` from the frustum whose heights are counted from `origin` along the unit `axis`.
SignedDistance frustum_distance(const Frustum& frustum, const Vec3& origin, const Vec3& axis,
                                const Vec3& p);

}  // namespace patchmill::collision
