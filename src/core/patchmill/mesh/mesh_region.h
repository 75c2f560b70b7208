// Regions of a mesh: where a surface ends that has no faces and edges of its own. Smooth neighbours belong together;
// where the triangles on both sides of an edge make an angle, or where there is no neighbour, the region ends.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/triangle_mesh.h"

namespace patchmill::mesh {

/// Numbers, ascending, of the triangles that are reached from `seed` over edges whose two triangles have normals
/// within `angle` of each other; the seed's is among them. A triangle without area has the normal of the one it
/// was reached from. Errors: InputError naming Seed if there is no such triangle, or Angle outside [0, 180] degrees.
std::vector<std::int32_t> region_around(const TriangleMesh& mesh, std::int32_t seed, Angle angle);

/// Number of the triangle that is nearest to `point` [mm]; of equals the first. At least one triangle.
std::int32_t nearest_triangle(const TriangleMesh& mesh, const Vec3& point);

/// The mesh of some of its triangles, by number, in that order, with their corners only. Errors: InputError naming
/// Triangles if there are none, or one that the mesh does not have.
TriangleMesh part_of(const TriangleMesh& mesh, const std::vector<std::int32_t>& triangles);

/// Edges [mm] that have one triangle only: the border of an open mesh, holes too.
std::vector<std::array<Vec3, 2>> border_edges(const TriangleMesh& mesh);

}  // namespace patchmill::mesh
