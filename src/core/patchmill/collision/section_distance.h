// How near a piece of the tool comes to a mesh: least over the mesh of the signed distance f from the frustum.
// A frustum is convex, so f is, and over a box or triangle about c
//     f(p) >= f(c) + grad f(c) . (p - c):
// the tangent bounds it, exactly where flat meets flat.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/collision/clearance.h"
#include "patchmill/mesh/triangle_bvh.h"

namespace patchmill {

/// A value of the signed distance from a frustum [mm] and its gradient, of length 1.
struct SignedDistance {
  double value = 0.0;
  Vec3 gradient = Vec3::Zero();
};
SignedDistance distance_from_section(const ToolSection& section, const ToolPose& pose,
                                     const Vec3& at);

/// The nearest place of the mesh, to 1e-6 mm; if none is nearer than `enough`, that as the distance.
SectionDistance nearest_section(const TriangleBvh& bvh, const ToolSection& section,
                                const ToolPose& pose, double enough);

}  // namespace patchmill
