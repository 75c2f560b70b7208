// Points and normals on a mesh along a direction: what brep/face_sampler.h does on faces. A place of the texture
// plane is looked for among the triangles as they are seen along the direction, by the parity of crossed edges
// (patchmill/mesh/parity.h): both triangles at an edge decide by the same numbers, so that no ray passes between
// them. Positions lie on the triangles; normals are those of the corners (mesh::corner_normals) between them, which
// follow the surface that the mesh was made from to second order in the length of edges.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/triangle_bvh.h"
#include "patchmill/patch/boundary.h"
#include "patchmill/patch/projected_surface.h"

#include <memory>
#include <optional>

namespace patchmill::patch {

/// Triangles as a surface, open or closed, with the material behind their clockwise side. Made once, looked at from
/// any number of planes.
class MeshSurface {
 public:
  /// Normals are smoothed over edges whose triangles lie within `crease` of each other. Errors: InputError naming
  /// Mesh (no triangle with an area, a corner that is no vertex, a vertex that is not finite) or Crease outside
  /// [0, 90] degrees.
  MeshSurface(mesh::TriangleMesh mesh, Angle crease);

  const mesh::TriangleMesh& mesh() const { return mesh_; }
  const mesh::TriangleBvh& bvh() const { return bvh_; }
  /// Unit normals at the corners of each triangle, by its number in the mesh.
  const std::vector<std::array<Vec3, 3>>& normals() const { return normals_; }
  /// Half the cross product of two sides of each triangle: its area along its normal [mm²].
  std::vector<Vec3> area_vectors() const;
  /// Edges with one triangle only.
  std::vector<Segment3> border() const;
  /// Greatest angle between a triangle's own normal and that of one of its corners.
  Angle normal_deviation() const;
  /// How far a smooth surface with the corners' normals rises over the edges at most [mm]: an edge of length l whose
  /// ends' normals differ by a along it is taken for an arc, l a / 8.
  double chord_height() const;

 private:
  mesh::TriangleMesh mesh_;
  mesh::TriangleBvh bvh_;
  std::vector<std::array<Vec3, 3>> normals_;
};

/// A mesh as it is seen from a texture plane.
class MeshSampler : public ProjectedSurface {
 public:
  /// Errors: InputError naming SteepestSlope, or Base without a surface.
  MeshSampler(std::shared_ptr<const MeshSurface> surface, const TexturePlane& plane,
              Angle steepest);

  std::pair<Vec2, Vec2> extent() const override;

 private:
  struct Hit {
    std::int32_t triangle;  // in the order of the tree
    double depth;           // along the direction, from the plane [mm]
  };
  class Line;
  void sample_run(const Vec2* places, SurfaceSample* samples, std::size_t count) const override;
  std::optional<Hit> first_hit(const Vec2& place) const;
  mesh::Triangle seen(std::int32_t triangle) const;
  SurfacePoint point_at(const Vec2& place, const Hit& hit) const;

  std::shared_ptr<const MeshSurface> surface_;
  ObliqueFrame frame_;
  double slack_;  // mm, over what rounding can do to coordinates
};

}  // namespace patchmill::patch
