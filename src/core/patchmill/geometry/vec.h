// Vectors of the core. All lengths are millimetres; unit vectors say so where they are used.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace patchmill {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// A unit vector at right angles to unit `t`; continuous but at ±Z's switch-over.
inline Vec3 any_normal_to(const Vec3& t) {
  return t.cross(std::abs(t.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX()).normalized();
}

}  // namespace patchmill
