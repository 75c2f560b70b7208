// Bits along rows of voxels: for one column of bricks along x (8 x 8 rows), which centres are
// inside a mesh and which voxels its surface touches. One byte holds the 8 voxels of a row in one
// brick.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/triangle_bvh.h"
#include "patchmill/voxel/voxel_grid.h"

#include <cstdint>
#include <vector>

namespace patchmill::voxel {

/// Triangles of a mesh in units of cells, and for each column of bricks those that it may meet.
struct ColumnTriangles {
  std::vector<mesh::Triangle> triangles;  ///< cell units
  std::vector<std::int64_t> first;  ///< per column (y fastest), into `list`; one more at the end
  std::vector<std::int32_t> list;
};
ColumnTriangles sort_into_columns(const mesh::TriangleMesh& mesh, const GridFrame& frame);

/// byte[64 * brick + 8 * z + y], brick = 0 .. bricks along x.
using RowBits = std::vector<std::uint8_t>;

/// Bit set where the voxel's centre is inside. `column` = brick z * bricks along y + brick y.
void inside_bits(const ColumnTriangles& mesh, const Cell& bricks, int column, RowBits& bits);

/// Bit set where the voxel is touched by a triangle, to 1e-9 of its side.
void touched_bits(const ColumnTriangles& mesh, const Cell& bricks, int column, RowBits& bits);

}  // namespace patchmill::voxel
