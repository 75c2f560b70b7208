// TriangleMesh: a solid as a closed surface of triangles, the form in which stock and part come to
// the voxel model and to copy milling. Triangles wind anticlockwise seen from outside.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/vec.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace patchmill::mesh {

/// Triangles over shared vertices.
struct TriangleMesh {
  std::vector<Vec3> vertices;                          ///< [mm]
  std::vector<std::array<std::int32_t, 3>> triangles;  ///< indices into `vertices`
};

/// A box along the axes; empty until it is given a point.
struct Box {
  Vec3 lo = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 hi = Vec3::Constant(-std::numeric_limits<double>::infinity());
  /// Grows so that it holds the point.
  void include(const Vec3& p) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  /// Its sides [mm].
  Vec3 size() const { return hi - lo; }
};

Box bounds(const TriangleMesh& mesh);           ///< [mm]; of no vertices: lo = inf, hi = -inf
double volume(const TriangleMesh& mesh);        ///< [mm^3], by the divergence theorem
double surface_area(const TriangleMesh& mesh);  ///< [mm^2]

/// Throws InputError naming `property` unless the mesh has triangles, all corners are vertices and these finite.
void require_indices(const TriangleMesh& mesh, const char* property);

/// Throws InputError naming `property` unless the mesh has triangles, indices and coordinates are
/// good, every edge is met as often one way as the other (no open shell, no flipped triangle), and
/// the volume is positive (not inside out).
void require_closed(const TriangleMesh& mesh, const char* property);

/// The same triangles, as many, with vertices of equal coordinates made one.
TriangleMesh join_vertices(const TriangleMesh& mesh);

/// The same triangles with vertices of equal coordinates made one, and triangles that have thereby
/// lost a corner left out: what a list of loose triangles (an STL file) needs before use.
TriangleMesh weld(const TriangleMesh& mesh);

/// Unit normals at each corner of each triangle: the angle-weighted mean of the faces around the
/// vertex (Thuermer & Wuethrich 1998) that lie within `crease` of the triangle's own normal.
/// Interpolated over a triangle they approximate the normal of the tessellated surface to second
/// order in edge length.
std::vector<std::array<Vec3, 3>> corner_normals(const TriangleMesh& mesh, Angle crease);

/// Axis-parallel box from corner `lo` to corner `hi` [mm]. Errors: InputError naming Box if it is not finite or
/// has no volume.
TriangleMesh box_mesh(const Vec3& lo, const Vec3& hi);

}  // namespace patchmill::mesh
