// Voxelisation, one column of bricks at a time; see voxelise.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/voxelise.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/large_vector.h"
#include "patchmill/voxel/brick_bits.h"
#include "patchmill/voxel/brick_halo.h"
#include "patchmill/voxel/foreseen_memory.h"
#include "patchmill/voxel/row_bits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace patchmill::voxel {
namespace {

// The bricks of one column along x that are worth storing; bits of those that are not removal volume alone.
struct Column {
  std::vector<int> place;                        // along x, ascending
  std::vector<std::pair<int, BrickBits>> mixed;  // place, ascending
};

// The box in the making: column by column, then brick by brick.
struct Gathering {
  GridFrame frame;
  Cell box;
  std::vector<Column> columns;
  std::vector<std::uint8_t> solid, airy;  // per brick of the box: nothing but Part; some Air

  explicit Gathering(const GridFrame& over) : frame(over), box(brick_box(over.cells)) {
    columns.resize(static_cast<std::size_t>(box.y()) * box.z());
    solid.assign(columns.size() * box.x(), 0);
    airy.assign(solid.size(), 0);
  }

  void keep(std::size_t column, int x, const BrickBits& bits) {
    const std::size_t at = column * box.x() + x;
    solid[at] = all_of_kind(bits, VoxelKind::Part) ? 1 : 0;
    airy[at] = has_air(bits) ? 1 : 0;
    if (solid[at] || all_of_kind(bits, VoxelKind::Air)) return;
    columns[column].place.push_back(x);
    if (!all_of_kind(bits, VoxelKind::Removal)) columns[column].mixed.emplace_back(x, bits);
  }

  VoxelGrid grid() {
    VoxelGrid grid;
    grid.frame = frame;
    std::vector<std::uint8_t> wanted(solid.size(), 0);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      stop_point();
      for (const int x : columns[c].place) wanted[c * box.x() + x] = 1;
    }
    grid.table = make_brick_table(frame.cells, wanted);
    fill_large(grid.kind, grid.table.cell_count(), [](std::size_t) { return VoxelKind::Removal; });
    patchmill::parallel_for(std::size_t{0}, columns.size(), [&](std::size_t c) {
      for (const auto& [x, bits] : columns[c].mixed)
        write_kinds(bits, &grid.kind[std::size_t(grid.table.at[c * box.x() + x]) * kBrickCells]);
    });
    grid.solid_bricks = std::move(solid);
    columns.clear();
    mark_skin(grid);
    return grid;
  }

 private:
  // Removal voxels that border on air become Exterior. Only bricks with air in them or beside them are asked.
  void mark_skin(VoxelGrid& grid) const {
    std::vector<std::int32_t> near;
    for (std::size_t brick = 0; brick < grid.table.size(); ++brick) {
      stop_point();
      if (near_air(grid.table, brick)) near.push_back(static_cast<std::int32_t>(brick));
    }
    std::vector<std::array<std::uint8_t, 64>> skin(near.size());
    patchmill::parallel_for(std::size_t{0}, near.size(),
                            [&](std::size_t i) { skin[i] = skin_bits(grid, near[i]); });
    patchmill::parallel_for(std::size_t{0}, near.size(), [&](std::size_t i) {
      VoxelKind* kind = &grid.kind[std::size_t(near[i]) * kBrickCells];
      for (int cell = 0; cell < kBrickCells; ++cell)
        if (skin[i][cell / 8] >> (cell % 8) & 1) kind[cell] = VoxelKind::Exterior;
    });
  }

  bool near_air(const BrickTable& table, std::size_t brick) const {
    const Cell place = table.place[brick];
    if (airy[table.flat(place)]) return true;
    for (int side = 0; side < 6; ++side) {
      const Cell near = place + step_to(side);
      if ((near.array() < 0).any() || (near.array() >= box.array()).any()) return true;
      if (airy[table.flat(near)]) return true;
    }
    return false;
  }

  static Cell step_to(int side) {
    Cell step = Cell::Zero();
    step[side / 2] = side % 2 == 0 ? -1 : 1;
    return step;
  }

  // Bits of the voxels of a brick that are to be removed and border on air.
  static std::array<std::uint8_t, 64> skin_bits(const VoxelGrid& grid, std::size_t brick) {
    using Halo = BrickHalo<VoxelKind>;
    Halo halo;
    load_halo(grid.kind.data(), grid.table, brick, halo);
    bool solid[6];  // a brick not stored reads as air: is it?
    for (int side = 0; side < 6; ++side)
      solid[side] = grid.table.neighbours[brick][side] == kNoBrick &&
                    grid.at(first_cell(grid.table, brick) + 8 * step_to(side)) == VoxelKind::Part;
    fill_solid_sides(halo, solid);
    std::array<std::uint8_t, 64> bits{};
    for (int row = 0; row < 64; ++row) {
      const VoxelKind* c = halo.row(row % 8, row / 8);
      const auto air = [&](int i) { return c[i] == VoxelKind::Air ? 1 : 0; };  // no branches
      for (int i = 0; i < 8; ++i) {
        const int beside = air(i - 1) | air(i + 1) | air(i - Halo::kRow) | air(i + Halo::kRow) |
                           air(i - Halo::kSlab) | air(i + Halo::kSlab);
        if (beside != 0 && c[i] == VoxelKind::Removal)
          bits[row] = static_cast<std::uint8_t>(bits[row] | 1 << i);
      }
    }
    return bits;
  }

  static void fill_solid_sides(BrickHalo<VoxelKind>& halo, const bool* solid) {
    for (int v = 0; v < kBrickSide; ++v)
      for (int u = 0; u < kBrickSide; ++u) {
        if (solid[0]) halo.row(u, v)[-1] = VoxelKind::Part;
        if (solid[1]) halo.row(u, v)[8] = VoxelKind::Part;
        if (solid[2]) halo.row(-1, v)[u] = VoxelKind::Part;
        if (solid[3]) halo.row(8, v)[u] = VoxelKind::Part;
        if (solid[4]) halo.row(v, -1)[u] = VoxelKind::Part;
        if (solid[5]) halo.row(v, 8)[u] = VoxelKind::Part;
      }
  }
};

void require_something_to_remove(const VoxelGrid& grid) {
  const auto to_remove = [](VoxelKind k) {
    return k == VoxelKind::Removal || k == VoxelKind::Exterior;
  };
  for (std::size_t brick = 0; brick < grid.table.size(); ++brick) {
    stop_point();
    const auto first = grid.kind.begin() + static_cast<std::ptrdiff_t>(brick) * kBrickCells;
    if (std::any_of(first, first + kBrickCells, to_remove)) return;
  }
  throw InputError("removal volume", "0 voxels",
                   "give a stock larger than the part, or smaller voxels.");
}

void require_part_in_stock(const mesh::Box& stock, const mesh::Box& part, double pitch) {
  const Vec3 over = (stock.lo - part.lo).cwiseMax(part.hi - stock.hi);
  if (over.maxCoeff() <= 0.5 * pitch) return;
  throw InputError("part", fmt::format("{:.3f} mm outside the stock", over.maxCoeff()),
                   "move the part into the stock or enlarge the stock.");
}

}  // namespace

GridFrame frame_over(const mesh::Box& box, double pitch) {
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

VoxelGrid voxelise(const mesh::TriangleMesh& stock, const mesh::TriangleMesh& part,
                   const VoxelOptions& options) {
  mesh::require_closed(stock, "stock");
  mesh::require_closed(part, "part");
  const GridFrame frame = frame_over(mesh::bounds(stock), options.pitch);
  require_part_in_stock(mesh::bounds(stock), mesh::bounds(part), options.pitch);
  require_memory(foreseen_memory(stock, part, frame, options.posture_fields, options.materials),
                 options.memory_limit, frame);
  const ColumnTriangles stock_sorted = sort_into_columns(stock, frame);
  const ColumnTriangles part_sorted = sort_into_columns(part, frame);
  Gathering gathering(frame);
  const Cell box = gathering.box;
  patchmill::parallel_for(std::size_t{0}, gathering.columns.size(), [&](std::size_t c) {
    RowBits in_stock, in_part, touched;
    const int column = static_cast<int>(c);
    inside_bits(stock_sorted, box, column, in_stock);
    inside_bits(part_sorted, box, column, in_part);
    touched_bits(part_sorted, box, column, touched);
    for (int x = 0; x < box.x(); ++x)
      gathering.keep(c, x, brick_bits(&in_stock[64 * x], &in_part[64 * x], &touched[64 * x]));
  });
  VoxelGrid grid = gathering.grid();
  require_something_to_remove(grid);
  return grid;
}

VoxelGrid voxelise(const Inside& in_stock, const Inside& in_part, const GridFrame& frame,
                   const VoxelOptions& options) {
  require_positive("voxel size", frame.pitch, "mm");
  const double box_volume = frame.box_cells() * std::pow(frame.pitch, 3);
  require_memory(estimate_memory(frame, box_volume, 0.0, options.posture_fields, options.materials),
                 options.memory_limit, frame);
  Gathering gathering(frame);
  const Cell box = gathering.box;
  const auto part_at = [&](const Cell& c) { return in_part(frame.centre(c)); };
  patchmill::parallel_for(std::size_t{0}, gathering.columns.size(), [&](std::size_t c) {
    for (int x = 0; x < box.x(); ++x) {
      std::array<std::uint8_t, 64> stock_rows{}, part_rows{}, touched_rows{};
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
        const auto set = [n](std::array<std::uint8_t, 64>& rows, bool bit) {
          rows[n / 8] = static_cast<std::uint8_t>(rows[n / 8] | int{bit} << (n % 8));
        };
        set(stock_rows, stock);
        set(part_rows, part);
        set(touched_rows, touched);
      }
      gathering.keep(c, x, brick_bits(stock_rows.data(), part_rows.data(), touched_rows.data()));
    }
  });
  VoxelGrid grid = gathering.grid();
  require_something_to_remove(grid);
  return grid;
}

}  // namespace patchmill::voxel
