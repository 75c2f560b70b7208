// Surfaces that roll out into the plane by a formula: cylinders, cones and extruded profiles (do Carmo,
// Differential Geometry of Curves and Surfaces, section 3-5: ruled surfaces without Gaussian curvature).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/patch/atlas/curved_face.h"

namespace patchmill::patch {

/// A plane whose parameters are lengths [mm].
Development develop_plane();

/// A cylinder of `radius` [mm]; u is the angle [rad], v the height [mm].
Development develop_cylinder(double radius);

/// A cone with half angle `half_angle` at its apex (its sign says to which side it opens along v), of
/// `radius` [mm] at v = 0; u is the angle [rad], v the distance along a straight line [mm]. `u_middle` is
/// the angle at the middle of the face: places are unrolled to both sides of it.
Development develop_cone(double radius, Angle half_angle, double u_middle);

/// A profile that is moved along the unit vector `along`: S(u, v) = profile(u) + v along, over `u` from
/// `first` to `last`. `profile` gives point and derivative.
Development develop_extrusion(const std::function<std::pair<Vec3, Vec3>(double u)>& profile,
                              const Vec3& along, double first, double last);

}  // namespace patchmill::patch
