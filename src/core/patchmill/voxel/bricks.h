// Bricks: a box of cells cut into bricks of 8 x 8 x 8, of which only those that hold something are
// stored. Every field over a voxel grid is one plain array of 512 values a brick, in the order of
// the brick table; inside a brick x runs fastest, so that a row of 8 cells is one vector register.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace patchmill::voxel {

using Cell = Eigen::Vector3i;

constexpr int kBrickSide = 8;
constexpr int kBrickCells = kBrickSide * kBrickSide * kBrickSide;
constexpr std::int32_t kNoBrick = -1;

/// Which bricks of a box exist, where they are, and which ones touch.
struct BrickTable {
  Cell cells = Cell::Zero();     ///< size of the box in cells
  Cell bricks = Cell::Zero();    ///< size of the box in bricks, cells / 8 rounded up
  std::vector<std::int32_t> at;  ///< per brick of the box, x fastest: its number or kNoBrick
  std::vector<Cell> place;       ///< per stored brick: its place in the box, in bricks
  /// per stored brick: numbers of the bricks at -x, +x, -y, +y, -z, +z, or kNoBrick
  std::vector<std::array<std::int32_t, 6>> neighbours;

  /// How many bricks are stored.
  std::size_t size() const { return place.size(); }
  /// How many cells they have.
  std::size_t cell_count() const { return place.size() * std::size_t{kBrickCells}; }

  /// Number of the brick at `place`, or kNoBrick outside the box and where none is stored.
  std::int32_t find(const Cell& brick_place) const {
    if ((brick_place.array() < 0).any() || (brick_place.array() >= bricks.array()).any())
      return kNoBrick;
    return at[flat(brick_place)];
  }
  /// Index of a brick of the box by its place, x fastest.
  std::size_t flat(const Cell& p) const {
    return (static_cast<std::size_t>(p.z()) * bricks.y() + p.y()) * bricks.x() + p.x();
  }
};

/// Index of a cell within its brick; 0 <= x, y, z < 8.
constexpr int in_brick(int x, int y, int z) {
  return (z * kBrickSide + y) * kBrickSide + x;
}

/// Index of `cell` into a field over `table`, or -1 where no brick is stored.
inline std::int64_t cell_index(const BrickTable& table, const Cell& cell) {
  if ((cell.array() < 0).any()) return -1;
  const std::int32_t brick = table.find(Cell(cell.x() >> 3, cell.y() >> 3, cell.z() >> 3));
  if (brick == kNoBrick) return -1;
  return std::int64_t{brick} * kBrickCells + in_brick(cell.x() & 7, cell.y() & 7, cell.z() & 7);
}

/// The first cell of a stored brick.
inline Cell first_cell(const BrickTable& table, std::size_t brick) {
  return table.place[brick] * kBrickSide;
}

/// Table of the bricks with a nonzero flag. `wanted` has one flag per brick of the box, x fastest.
BrickTable make_brick_table(const Cell& cells, const std::vector<std::uint8_t>& wanted);

/// The box in bricks that holds `cells`: each size divided by 8 and rounded up.
inline Cell brick_box(const Cell& cells) {
  return {(cells.x() + 7) / 8, (cells.y() + 7) / 8, (cells.z() + 7) / 8};
}

/// Bytes that a table takes for a box of so many bricks, of which `stored` are stored.
std::size_t table_bytes(const Cell& bricks, std::size_t stored);

}  // namespace patchmill::voxel
