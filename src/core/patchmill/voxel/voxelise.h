// Voxelisation: from stock and part, as closed triangle meshes or as inside functions, to the voxel
// model of the removal volume.
//
// Inside and outside: the centres of the voxels lie on lines parallel to x; along each the
// crossings with the mesh toggle inside and outside (parity.h): consistent to the last bit,
// whatever edges and vertices the lines pass through. Surface voxels: each triangle is clipped by
// the square prism of each row of voxels that it meets; the clipped polygon is convex, so its
// extent in x is exactly the run of voxels that the triangle touches. A voxel counts as touched
// within 1e-9 of its side, so that a face lying in the plane between two voxels marks both.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/triangle_mesh.h"
#include "patchmill/voxel/voxel_grid.h"

#include <functional>

namespace patchmill::voxel {

/// How shapes are made voxels.
struct VoxelOptions {
  double pitch = 0.0;                              ///< side of a voxel [mm], > 0
  double memory_limit = 4.0 * 1024 * 1024 * 1024;  ///< for the model and all fields [bytes]
  int posture_fields = 2;                          ///< of a posture to come, for that limit: 2 or 3
  bool materials = false;                          ///< to come, for that limit
};

/// Cubes that cover the box, starting at its low corner.
/// Errors: InputError if the pitch is not positive or an axis gets more than 32,768 voxels.
GridFrame frame_over(const mesh::Box& box, double pitch);

/// Stock minus part. The grid begins at the low corner of the stock's box. Parallel; the same grid
/// on any number of threads. Errors: InputError if a mesh is not closed, if the part reaches out of
/// the stock's box by more than half a voxel, if the memory foreseen is over the limit, or if
/// nothing is to be removed.
VoxelGrid voxelise(const mesh::TriangleMesh& stock, const mesh::TriangleMesh& part,
                   const VoxelOptions& options);

/// True where the point is in the solid. Called from several threads at once.
using Inside = std::function<bool(const Vec3&)>;

/// The same from inside functions over a given frame, for solids that have no mesh. A voxel whose
/// centre is in the stock is a surface voxel if it or a face neighbour has its centre in the part
/// but the other has not: to half a voxel what the triangles give. Errors: InputError if the memory
/// foreseen is over the limit or nothing is to be removed.
VoxelGrid voxelise(const Inside& in_stock, const Inside& in_part, const GridFrame& frame,
                   const VoxelOptions& options);

}  // namespace patchmill::voxel
