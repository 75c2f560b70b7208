// The direction in which a set of faces looks: what a texture plane is fitted to when the user gives no
// direction.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <vector>

#include <TopoDS_Face.hxx>

namespace patchmill {

/// Unit vector of the faces' summed vector area ∫ n dA, n out of the material: the direction from which
/// they look largest. Taken from a mesh that is at most 1 % of the faces' size off.
/// Errors: InputError naming AutoDirection if the faces look to all sides alike (a whole cylinder, a
/// sphere), so that their areas cancel to under 1 %.
Vec3 facing(const std::vector<TopoDS_Face>& faces);

/// From where faces are looked at.
struct SeenBest {
  Vec3 direction = -Vec3::UnitZ();  ///< unit, towards the faces
  bool even = false;  ///< whether they look to all sides alike, so that there was a choice
};

/// Against facing(), if there is such a side. Else `preferred`, if the faces' area seen along it (as if none hid
/// another) is at least half of what is seen along the best of the six directions of the axes; else that one.
/// Errors: InputError naming Direction if `preferred` is zero or not finite.
SeenBest seen_best(const std::vector<TopoDS_Face>& faces, const Vec3& preferred);

}  // namespace patchmill
