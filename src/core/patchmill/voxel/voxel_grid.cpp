// The voxel model's lookups and memory estimate.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/voxel_grid.h"

#include "patchmill/geometry/error.h"
#include "patchmill/voxel/laplace_level.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::voxel {

VoxelKind VoxelGrid::at(const Cell& cell) const {
  if ((cell.array() < 0).any() || (cell.array() >= frame.cells.array()).any())
    return VoxelKind::Air;
  const std::int64_t index = cell_index(table, cell);
  if (index >= 0) return kind[index];
  const bool solid = solid_bricks[table.flat(Cell(cell.x() >> 3, cell.y() >> 3, cell.z() >> 3))];
  return solid ? VoxelKind::Part : VoxelKind::Air;
}

std::array<std::int64_t, kVoxelKinds> count_kinds(const VoxelGrid& grid) {
  std::array<std::int64_t, kVoxelKinds> count{};
  for (const VoxelKind kind : grid.kind) ++count[static_cast<int>(kind)];
  return count;
}

namespace {

// Measured by tests/bench/jobs_memory_bench.py: bytes of a cell while the kinds are gathered, and of the threads.
constexpr double kGathered = 0.4, kThreads = 4e6;

MemoryEstimate of_bricks(double bricks, double box_bricks, int posture_fields, bool materials) {
  const double cells = bricks * kBrickCells;
  MemoryEstimate need;
  // numbers and flags per brick of the box; per stored brick its place and neighbours; the kinds, and the pieces from
  // which they are gathered: small ones, which the allocator may keep
  need.grid = 5.0 * box_bricks + bricks * (sizeof(Cell) + 6.0 * sizeof(std::int32_t)) +
              (1.0 + kGathered) * cells + kThreads;
  need.fields =
      cells * (3.0 * sizeof(double) + posture_fields * sizeof(float) + (materials ? 1.0 : 0.0));
  const double solving =
      static_cast<double>(laplace_bytes(static_cast<std::size_t>(bricks), posture_fields)) +
      cells * posture_fields * sizeof(double);
  // the posture is solved before materials and feed fields are made: the peak is the larger of the two
  need.solver = std::max(0.0, solving - need.fields);
  return need;
}

}  // namespace

MemoryEstimate estimate_memory(const GridFrame& frame, double volume, double area,
                               int posture_fields, bool materials) {
  const double side = frame.pitch * kBrickSide, box = brick_box(frame.cells).cast<double>().prod();
  const double bricks = volume / (side * side * side) + 0.75 * area / (side * side);
  return of_bricks(std::min(bricks, box), box, posture_fields, materials);
}

MemoryEstimate memory_of(const BrickTable& table, int posture_fields, bool materials) {
  return of_bricks(static_cast<double>(table.size()), table.bricks.cast<double>().prod(),
                   posture_fields, materials);
}

void require_memory(const MemoryEstimate& need, double limit, const GridFrame& frame) {
  if (need.total() <= limit) return;
  const double mib = 1024.0 * 1024.0;
  throw InputError(
      "voxel size",
      fmt::format("{} mm, {:.0f} voxels of box, about {:.0f} MiB of the {:.0f} MiB allowed",
                  frame.pitch, frame.box_cells(), need.total() / mib, limit / mib),
      fmt::format("make voxels about {:.3g} mm or raise the memory limit.",
                  1.05 * frame.pitch * std::cbrt(need.total() / limit)));
}

}  // namespace patchmill::voxel
