// What a voxel model of two meshes will take of memory. The bricks that it will store are counted by taking them for
// voxels themselves: a brick is stored if the surface of stock or part is in it, or its middle is in the stock and not
// in the part. That costs a 512th of the voxels.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/triangle_mesh.h"
#include "patchmill/voxel/voxel_grid.h"

#include <cstdint>

namespace patchmill::voxel {

/// How many bricks voxelise() will store for closed meshes over a frame; a few too many where a surface is in a brick
/// and in none of its voxels. Parallel. Throws Stopped like a parallel loop.
std::int64_t bricks_to_store(const mesh::TriangleMesh& stock, const mesh::TriangleMesh& part,
                             const GridFrame& frame);

/// Of bricks_to_store(); of a box of more than a hundred million bricks by volume and area alone, which takes no
/// memory itself. `posture_fields`, `materials`: see estimate_memory().
MemoryEstimate foreseen_memory(const mesh::TriangleMesh& stock, const mesh::TriangleMesh& part,
                               const GridFrame& frame, int posture_fields, bool materials);

}  // namespace patchmill::voxel
