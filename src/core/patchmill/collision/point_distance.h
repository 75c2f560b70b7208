// Signed distance from a surface that is known by points with normals: a sampled face, or a relief.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/collision/clearance.h"
#include "patchmill/marks/relief.h"
#include "patchmill/patch/dimple.h"

namespace patchmill::collision {

/// Distance from a cloud of surface points [mm]. `spacing`: every place of the surface is within
/// half of it from a point. Near the surface it is the height over the nearest point's tangent
/// plane; away from it the distance from that point less spacing / 2, which is never more than the
/// true one. Where the nearest point is further off than `reach`, NaN: unknown, unless `reach` is
/// infinite. An empty cloud gives an empty function. Errors: InputError naming Spacing.
PartDistance distance_from_points(std::vector<patch::SurfacePoint> points, double spacing,
                                  double reach = std::numeric_limits<double>::infinity());

/// Places and base normals of a relief, one per cell that has a base, every `stride` cells each
/// way.
std::vector<patch::SurfacePoint> surface_points(const marks::Relief& relief, int stride = 1);

}  // namespace patchmill::collision
