// The brick table.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/bricks.h"

#include "patchmill/geometry/stop.h"

namespace patchmill::voxel {

BrickTable make_brick_table(const Cell& cells, const std::vector<std::uint8_t>& wanted) {
  BrickTable table;
  table.cells = cells;
  table.bricks = brick_box(cells);
  table.at.assign(wanted.size(), kNoBrick);
  for (int z = 0; z < table.bricks.z(); ++z)
    for (int y = 0; y < table.bricks.y(); ++y) {
      stop_point();
      for (int x = 0; x < table.bricks.x(); ++x) {
        const Cell place(x, y, z);
        if (!wanted[table.flat(place)]) continue;
        table.at[table.flat(place)] = static_cast<std::int32_t>(table.place.size());
        table.place.push_back(place);
      }
    }
  table.neighbours.resize(table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    stop_point();
    for (int side = 0; side < 6; ++side) {
      Cell step = Cell::Zero();
      step[side / 2] = side % 2 == 0 ? -1 : 1;
      table.neighbours[i][side] = table.find(table.place[i] + step);
    }
  }
  return table;
}

std::size_t table_bytes(const Cell& bricks, std::size_t stored) {
  const std::size_t box = static_cast<std::size_t>(bricks.x()) * bricks.y() * bricks.z();
  return box * sizeof(std::int32_t) + stored * (sizeof(Cell) + 6 * sizeof(std::int32_t));
}

}  // namespace patchmill::voxel
