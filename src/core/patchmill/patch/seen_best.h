// From where a surface looks largest, by the areas of its pieces along their normals: what a texture plane is fitted
// to when the user gives no direction.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <optional>
#include <vector>

namespace patchmill::patch {

/// From where a surface is looked at.
struct SeenBest {
  Vec3 direction = -Vec3::UnitZ();  ///< unit, towards the surface
  bool even = false;  ///< whether it looks to all sides alike, so that there was a choice
};

/// Unit vector of the summed vector area of pieces of a surface [mm²], out of the material; nothing if they cancel to
/// under 1 % of the area (a whole cylinder, a sphere).
std::optional<Vec3> summed_normal(const std::vector<Vec3>& area_vectors);

/// Against summed_normal(), if there is one. Else `preferred`, if the area seen along it (as if nothing hid anything)
/// is at least half of what is seen along the best of the six directions of the axes; else that one.
/// Errors: InputError naming Direction if `preferred` is zero or not finite.
SeenBest seen_best(const std::vector<Vec3>& area_vectors, const Vec3& preferred);

}  // namespace patchmill::patch
