// Tessellation: a shape's faces as one TriangleMesh, for checks, voxels and copy milling. OpenCASCADE meshes
// face by face; here the nodes on common edges are made one by the shape's own topology, not by their
// coordinates, so that a closed shell gives a closed mesh also where faces carry different placements.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/triangle_mesh.h"

#include <string>

#include <TopoDS_Shape.hxx>

namespace patchmill {

struct TessellationOptions {
  /// Distance of triangles from the surface and of chords from edges [mm]. OpenCASCADE aims at it and may
  /// miss it by a factor of two.
  double deflection = 0.01;
  Angle angle = Angle::degrees(20);  ///< between neighbouring triangles of one face
  double most_triangles = 2e6;  ///< about so many are made at most, which takes some ten seconds
};

struct Tessellation {
  mesh::TriangleMesh
      mesh;  ///< work frame of the shape [mm]; wound anticlockwise seen from outside if `closed`
  /// Number of the face, in the shape's order, that each triangle lies on.
  std::vector<std::int32_t> face;
  bool closed = false;  ///< every edge is met as often one way as the other, and there is a volume
  /// What keeps the mesh from being a closed solid, a sentence; empty if `closed`. Faces that could not be
  /// meshed are left out of `mesh`.
  std::string reason;
};

/// Meshes all faces of a shape; what is not a closed solid is told by `closed` and `reason`, not by an
/// error. The shape's own triangulation is replaced. The same shape gives the same mesh. Errors:
/// InputError naming Deflection (less than 10 nm, or so fine that it makes too many triangles) or
/// DeflectionAngle (0 to 90 degrees).
Tessellation tessellate(const TopoDS_Shape& shape, const TessellationOptions& options = {});

}  // namespace patchmill
