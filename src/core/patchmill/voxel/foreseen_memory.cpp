// Bricks as voxels; see foreseen_memory.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/foreseen_memory.h"

#include "patchmill/geometry/stop.h"
#include "patchmill/voxel/row_bits.h"

#include <algorithm>
#include <atomic>
#include <bitset>
#include <cmath>

namespace patchmill::voxel {
namespace {

constexpr double kMostCounted = 1e8;  // bricks of the box, which take a few bits each

// Bricks as cells, as far as there are voxels whose middles may be in the stock.
GridFrame frame_of_bricks(const GridFrame& frame, const mesh::Box& stock) {
  const Cell last = (frame.in_cells(stock.hi).array() + 0.5).floor().cast<int>();
  const Cell cells = last.cwiseMin(frame.cells).cwiseMax(1);
  return {frame.origin, kBrickSide * frame.pitch, brick_box(cells)};
}

}  // namespace

std::int64_t bricks_to_store(const mesh::TriangleMesh& stock, const mesh::TriangleMesh& part,
                             const GridFrame& frame) {
  const GridFrame bricks = frame_of_bricks(frame, mesh::bounds(stock));
  const Cell box = brick_box(bricks.cells);
  const ColumnTriangles of_stock = sort_into_columns(stock, bricks);
  const ColumnTriangles of_part = sort_into_columns(part, bricks);
  std::atomic<std::int64_t> count{0};
  patchmill::parallel_for(0, box.y() * box.z(), [&](int column) {
    RowBits in_stock, in_part, on_stock, on_part;
    inside_bits(of_stock, box, column, in_stock);
    inside_bits(of_part, box, column, in_part);
    touched_bits(of_stock, box, column, on_stock);
    touched_bits(of_part, box, column, on_part);
    std::int64_t stored = 0;
    for (std::size_t i = 0; i < in_stock.size(); ++i) {
      const int row = static_cast<int>(i % 64), first = kBrickSide * static_cast<int>(i / 64);
      const int y = kBrickSide * (column % box.y()) + row % 8;
      const int z = kBrickSide * (column / box.y()) + row / 8;
      if (y >= bricks.cells.y() || z >= bricks.cells.z()) continue;
      const int there = std::clamp(bricks.cells.x() - first, 0, 8);  // of the eight
      const int bits =
          ((in_stock[i] & ~in_part[i]) | on_stock[i] | on_part[i]) & ((1 << there) - 1);
      stored += static_cast<std::int64_t>(std::bitset<8>(static_cast<unsigned>(bits)).count());
    }
    count += stored;
  });
  return count;
}

MemoryEstimate foreseen_memory(const mesh::TriangleMesh& stock, const mesh::TriangleMesh& part,
                               const GridFrame& frame, int posture_fields, bool materials) {
  if (brick_box(frame.cells).cast<double>().prod() > kMostCounted)
    return estimate_memory(frame, std::max(0.0, mesh::volume(stock) - mesh::volume(part)),
                           mesh::surface_area(stock) + mesh::surface_area(part), posture_fields,
                           materials);
  const double bricks = static_cast<double>(bricks_to_store(stock, part, frame));
  return estimate_memory(frame, bricks * std::pow(kBrickSide * frame.pitch, 3), 0.0, posture_fields,
                         materials);
}

}  // namespace patchmill::voxel
