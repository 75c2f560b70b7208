// Signed distance of a point from a frustum that is moved along a straight line without turning: the least over the
// line of the distance from the frustum there (frustum.h). The distance is convex in point and position together, so
// that its least over the positions is convex in the point (Boyd & Vandenberghe 2004, section 3.2.5), and a tangent
// plane bounds it as it bounds the frustum's own.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/collision/frustum.h"

namespace patchmill::collision {

/// A distance, the direction in which it grows, and where on the way.
struct SweptDistance {
  double value = 0.0;            ///< [mm], negative inside, exact to 1e-9
  Vec3 gradient = Vec3::Zero();  ///< a subgradient, at most of unit length
  double fraction = 0.0;         ///< of the travel, 0 .. 1, where the frustum is nearest
};

/// Of `p` from the frustum on the unit `axis`, whose heights are counted from a point that goes from `origin` to
/// `origin` + `travel` [mm].
SweptDistance swept_distance(const Frustum& frustum, const Vec3& origin, const Vec3& axis,
                             const Vec3& travel, const Vec3& p);

}  // namespace patchmill::collision
