// Voxelisation, one column of bricks at a time; see voxelise.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/voxel/voxelise.h"

#include "core/geometry/error.h"
#include "core/voxel/brick_halo.h"
#include "core/voxel/row_bits.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

namespace patchmill {
namespace {

using BrickKinds = std::array<VoxelKind, kBrickCells>;

// The bricks of one column along x that are worth storing.
struct Column {
  std::vector<int> place;  // along x
  std::vector<BrickKinds> kinds;
};

bool uniform(const BrickKinds& kinds, VoxelKind kind) {
  return std::all_of(kinds.begin(), kinds.end(), [=](VoxelKind k) { return k == kind; });
}

void keep(Column& column, int place, const BrickKinds& kinds, std::uint8_t& solid) {
  solid = uniform(kinds, VoxelKind::Part) ? 1 : 0;
  if (solid || uniform(kinds, VoxelKind::Air)) return;
  column.place.push_back(place);
  column.kinds.push_back(kinds);
}

VoxelKind kind_of(bool stock, bool part, bool touched) {
  if (stock && touched) return VoxelKind::Surface;
  if (part) return VoxelKind::Part;
  return stock ? VoxelKind::Removal : VoxelKind::Air;
}

BrickKinds kinds_of(const std::uint8_t* stock, const std::uint8_t* part,
                    const std::uint8_t* touched) {
  BrickKinds kinds;
  for (int row = 0; row < 64; ++row)
    for (int i = 0; i < 8; ++i)
      kinds[8 * row + i] = kind_of(stock[row] >> i & 1, part[row] >> i & 1, touched[row] >> i & 1);
  return kinds;
}

VoxelGrid gather(const GridFrame& frame, const std::vector<Column>& columns,
                 std::vector<std::uint8_t> solid) {
  VoxelGrid grid;
  grid.frame = frame;
  const Cell box = brick_box(frame.cells);
  std::vector<std::uint8_t> wanted(solid.size(), 0);
  std::size_t stored = 0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (const int x : columns[c].place) wanted[c * box.x() + x] = 1;
    stored += columns[c].place.size();
  }
  grid.table = make_brick_table(frame.cells, wanted);
  grid.kind.reserve(stored * kBrickCells);
  for (const Column& column : columns)
    for (const BrickKinds& kinds : column.kinds)
      grid.kind.insert(grid.kind.end(), kinds.begin(), kinds.end());
  grid.solid_bricks = std::move(solid);
  return grid;
}

// Bits of the cells of a brick that are to be removed and border on air.
std::array<std::uint8_t, 64> skin_bits(const VoxelGrid& grid, std::size_t brick) {
  using Halo = BrickHalo<VoxelKind>;
  Halo halo;
  load_halo(grid.kind.data(), grid.table, brick, halo);
  const Cell first = first_cell(grid.table, brick);
  std::array<std::uint8_t, 64> bits{};
  for (int row = 0; row < 64; ++row)
    for (int i = 0; i < 8; ++i) {
      const int at = Halo::index(i, row % 8, row / 8);
      if (halo.value[at] != VoxelKind::Removal) continue;
      const int steps[6] = {-1, 1, -Halo::kRow, Halo::kRow, -Halo::kSlab, Halo::kSlab};
      for (int side = 0; side < 6; ++side) {
        if (halo.value[at + steps[side]] != VoxelKind::Air) continue;
        Cell near = first + Cell(i, row % 8, row / 8);  // a brick not stored reads as air: ask
        near[side / 2] += side % 2 == 0 ? -1 : 1;
        if (grid.at(near) == VoxelKind::Air)
          bits[row] = static_cast<std::uint8_t>(bits[row] | 1 << i);
      }
    }
  return bits;
}

void mark_skin(VoxelGrid& grid) {
  std::vector<std::array<std::uint8_t, 64>> skin(grid.table.size());
  tbb::parallel_for(std::size_t{0}, skin.size(),
                    [&](std::size_t brick) { skin[brick] = skin_bits(grid, brick); });
  tbb::parallel_for(std::size_t{0}, skin.size(), [&](std::size_t brick) {
    for (int cell = 0; cell < kBrickCells; ++cell)
      if (skin[brick][cell / 8] >> (cell % 8) & 1)
        grid.kind[brick * kBrickCells + cell] = VoxelKind::Exterior;
  });
}

void require_something_to_remove(const VoxelGrid& grid) {
  const auto count = count_kinds(grid);
  if (count[static_cast<int>(VoxelKind::Removal)] + count[static_cast<int>(VoxelKind::Exterior)] >
      0)
    return;
  throw InputError("removal volume", "0 voxels",
                   "give a stock larger than the part, or smaller voxels.");
}

void require_part_in_stock(const Box& stock, const Box& part, double pitch) {
  const Vec3 over = (stock.lo - part.lo).cwiseMax(part.hi - stock.hi);
  if (over.maxCoeff() <= 0.5 * pitch) return;
  throw InputError("part", fmt::format("{:.3f} mm outside the stock", over.maxCoeff()),
                   "move the part into the stock or enlarge the stock.");
}

}  // namespace

GridFrame frame_over(const Box& box, double pitch) {
  require_positive("voxel size", pitch, "mm");
  GridFrame frame{box.lo, pitch, Cell::Zero()};
  for (int axis = 0; axis < 3; ++axis) {
    const double count = std::ceil(box.size()[axis] / pitch - 1e-9);
    if (!(count >= 1.0 && count <= 32768.0))
      throw InputError("voxel size",
                       fmt::format("{} mm for {} mm of stock", pitch, box.size()[axis]),
                       "choose it so that each axis gets 1 to 32,768 voxels.");
    frame.cells[axis] = static_cast<int>(count);
  }
  return frame;
}

VoxelGrid voxelise(const TriangleMesh& stock, const TriangleMesh& part,
                   const VoxelOptions& options) {
  require_closed(stock, "stock");
  require_closed(part, "part");
  const GridFrame frame = frame_over(bounds(stock), options.pitch);
  require_part_in_stock(bounds(stock), bounds(part), options.pitch);
  require_memory(estimate_memory(frame, std::max(0.0, volume(stock) - volume(part)),
                                 surface_area(stock) + surface_area(part)),
                 options.memory_limit, frame);
  const Cell box = brick_box(frame.cells);
  const ColumnTriangles stock_sorted = sort_into_columns(stock, frame);
  const ColumnTriangles part_sorted = sort_into_columns(part, frame);
  std::vector<Column> columns(static_cast<std::size_t>(box.y()) * box.z());
  std::vector<std::uint8_t> solid(columns.size() * box.x(), 0);
  tbb::parallel_for(std::size_t{0}, columns.size(), [&](std::size_t c) {
    RowBits in_stock, in_part, touched;
    const int column = static_cast<int>(c);
    inside_bits(stock_sorted, box, column, in_stock);
    inside_bits(part_sorted, box, column, in_part);
    touched_bits(part_sorted, box, column, touched);
    for (int x = 0; x < box.x(); ++x)
      keep(columns[c], x, kinds_of(&in_stock[64 * x], &in_part[64 * x], &touched[64 * x]),
           solid[c * box.x() + x]);
  });
  VoxelGrid grid = gather(frame, columns, std::move(solid));
  columns.clear();
  mark_skin(grid);
  require_something_to_remove(grid);
  return grid;
}

VoxelGrid voxelise(const Inside& in_stock, const Inside& in_part, const GridFrame& frame,
                   const VoxelOptions& options) {
  require_positive("voxel size", frame.pitch, "mm");
  const double box_volume = frame.box_cells() * std::pow(frame.pitch, 3);
  require_memory(estimate_memory(frame, box_volume, 0.0), options.memory_limit, frame);
  const Cell box = brick_box(frame.cells);
  std::vector<Column> columns(static_cast<std::size_t>(box.y()) * box.z());
  std::vector<std::uint8_t> solid(columns.size() * box.x(), 0);
  const auto part_at = [&](const Cell& c) { return in_part(frame.centre(c)); };
  tbb::parallel_for(std::size_t{0}, columns.size(), [&](std::size_t c) {
    for (int x = 0; x < box.x(); ++x) {
      BrickKinds kinds;
      for (int n = 0; n < kBrickCells; ++n) {
        const Cell cell =
            Cell(x, static_cast<int>(c) % box.y(), static_cast<int>(c) / box.y()) * 8 +
            Cell(n % 8, n / 8 % 8, n / 64);
        const bool in_box = (cell.array() < frame.cells.array()).all();
        const bool stock = in_box && in_stock(frame.centre(cell)), part = part_at(cell);
        bool touched = false;
        for (int side = 0; stock && !touched && side < 6; ++side) {
          Cell near = cell;
          near[side / 2] += side % 2 == 0 ? -1 : 1;
          touched = part_at(near) != part;
        }
        kinds[n] = kind_of(stock, part, touched);
      }
      keep(columns[c], x, kinds, solid[c * box.x() + x]);
    }
  });
  VoxelGrid grid = gather(frame, columns, std::move(solid));
  columns.clear();
  mark_skin(grid);
  require_something_to_remove(grid);
  return grid;
}

}  // namespace patchmill
