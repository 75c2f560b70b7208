// Construction of texture planes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/texture_plane.h"

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/require.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::patch {

ObliqueFrame::ObliqueFrame(const TexturePlane& plane) : origin(plane.origin) {
  Eigen::Matrix3d columns;
  columns << plane.x_axis, plane.y_axis, plane.direction;
  inverse = columns.inverse();
}

TexturePlane texture_plane(const Vec3& origin, const Vec3& direction, const Vec3& x_hint,
                           double rotation) {
  constexpr double kFarthest = 1e6;  // mm; beyond it coordinates are not known to a nanometre
  require_finite("Origin", origin, "mm");
  require_in_range("Origin", origin.cwiseAbs().maxCoeff(), 0.0, kFarthest, "mm");
  require_in_range("Rotation", Angle::radians(rotation).degrees(), -1e6, 1e6, "degrees");
  const double length = direction.norm();
  if (!std::isfinite(length) || length < 1e-12)
    throw InputError("Direction",
                     fmt::format("({}, {}, {})", direction.x(), direction.y(), direction.z()),
                     "give a finite vector that is not zero.");
  TexturePlane plane;
  plane.origin = origin;
  plane.direction = direction / length;
  const Vec3 x = x_hint - x_hint.dot(plane.direction) * plane.direction;
  if (!(x.norm() > 1e-9 * x_hint.norm()))
    throw InputError("Direction",
                     fmt::format("({}, {}, {})", direction.x(), direction.y(), direction.z()),
                     "the direction is parallel to the texture's x axis: choose another one.");
  const Vec3 ex = x.normalized(), ey = (-plane.direction).cross(ex);
  plane.x_axis = std::cos(rotation) * ex + std::sin(rotation) * ey;
  plane.y_axis = std::cos(rotation) * ey - std::sin(rotation) * ex;
  return plane;
}

}  // namespace patchmill::patch
