// Signed distance from a closed mesh: what the gouge and collision check measures against.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/collision/clearance.h"
#include "patchmill/mesh/triangle_bvh.h"

namespace patchmill::collision {

/// Distance from a solid [mm], positive outside (mesh::signed_distance); may be called from several threads. Errors:
/// InputError of require_closed, naming Part.
PartDistance distance_from_mesh(const mesh::TriangleMesh& mesh);

/// The same solid with the distances of tool sections: least over the mesh of the signed distance from the
/// section, which is convex, so that its tangent at one place bounds it over a whole box or triangle.
PartShape shape_from_mesh(const mesh::TriangleMesh& mesh);

/// The nearest point of the mesh, to 1e-6 mm; if none is nearer than `enough`, that as the distance.
SectionDistance nearest_section(const mesh::TriangleBvh& bvh, const ToolSection& section,
                                const ToolPose& pose, double enough);

/// Several solids as one part; none: a part without a distance.
PartShape join(std::vector<PartShape> parts);

}  // namespace patchmill::collision
