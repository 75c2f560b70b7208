// Which part of a base surface is under the ball: looked up along the texture plane's projection
// direction.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/marks/relief.h"

namespace patchmill::marks {

/// The tangent plane of the base under a ball.
struct BaseUnder {
  Vec3 foot = Vec3::Zero();     ///< foot of the ball centre [mm]
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the material
  bool found = false;  ///< false: no base there; foot and normal are then those of the plane
  /// Height of a ball centre over the tangent plane [mm].
  double height(const Vec3& centre) const { return (centre - foot).dot(normal); }
};

/// Plane coordinates of a point projected on the texture plane along its direction.
Vec2 project(const patch::TexturePlane& plane, const Vec3& point);

/// The base under a ball centre. Exact for a flat base. On a curved one the tangent plane at the
/// cell that is nearest to centre - radius * normal, found by repeated look-up; beyond the edge of
/// the grid the cell at the edge serves.
BaseUnder base_under(const SurfaceGrid& grid, const Vec3& centre, double radius);

}  // namespace patchmill::marks
