// TexturePlane: where the lattice of dimple places lies, and the direction in which it is projected
// on the faces (Xu & Sasahara 2016, section 2.2.2; any direction, where the paper takes Z).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/vec.h"

namespace patchmill::patch {

/// The plane that a texture is laid out in.
struct TexturePlane {
  Vec3 origin = Vec3::Zero();
  Vec3 x_axis = Vec3::UnitX();      ///< unit
  Vec3 y_axis = Vec3::UnitY();      ///< unit, at right angles to x_axis
  Vec3 direction = -Vec3::UnitZ();  ///< unit, into the material; not in the plane

  /// Point of plane coordinates [mm].
  Vec3 at(const Vec2& p) const { return origin + p.x() * x_axis + p.y() * y_axis; }
};

/// Coordinates (x, y, depth) with  P = origin + x x_axis + y y_axis + depth direction  of a plane. The direction
/// need not be at right angles to it.
struct ObliqueFrame {
  explicit ObliqueFrame(const TexturePlane& plane);
  Vec3 coordinates(const Vec3& p) const { return inverse * (p - origin); }  ///< of a point [mm]
  Vec3 along(const Vec3& v) const { return inverse * v; }                   ///< of a vector [mm]
  Vec3 origin;
  Eigen::Matrix3d inverse;
};

/// A plane through `origin` at right angles to `direction`, with its x axis as near to `x_hint` as
/// possible, turned by `rotation` [rad] about -direction.
/// Errors: InputError naming Direction if it is zero or not finite, or parallel to `x_hint`; Origin or Rotation
/// if not finite.
TexturePlane texture_plane(const Vec3& origin, const Vec3& direction, const Vec3& x_hint,
                           double rotation);

}  // namespace patchmill::patch
