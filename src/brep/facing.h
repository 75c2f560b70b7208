// The direction in which a set of faces looks: what a texture plane is fitted to when the user gives no
// direction.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"
#include "patchmill/patch/seen_best.h"

#include <vector>

#include <TopoDS_Face.hxx>

namespace patchmill {

/// Unit vector of the faces' summed vector area ∫ n dA, n out of the material: the direction from which
/// they look largest. Taken from a mesh that is at most 1 % of the faces' size off.
/// Errors: InputError naming AutoDirection if the faces look to all sides alike (a whole cylinder, a
/// sphere), so that their areas cancel to under 1 %.
Vec3 facing(const std::vector<TopoDS_Face>& faces);

/// As patch::seen_best, of the same mesh. Errors: InputError naming Direction.
patch::SeenBest seen_best(const std::vector<TopoDS_Face>& faces, const Vec3& preferred);

}  // namespace patchmill
