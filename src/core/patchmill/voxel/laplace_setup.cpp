// The multigrid hierarchy from the roles of the cells; see laplace_level.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/large_vector.h"
#include "patchmill/voxel/brick_halo.h"
#include "patchmill/voxel/laplace_level.h"

namespace patchmill::voxel {
namespace {

void allocate(LaplaceLevel& level, int fields) {
  const std::size_t n = level.table->cell_count();
  level.x.resize(fields);
  level.b.resize(fields);
  const auto zero = [](std::size_t) { return 0.0f; };
  for (auto& values : level.x) fill_large(values, n, zero);  // in place: no copy beside it
  for (auto& values : level.b) fill_large(values, n, zero);
  for (int f = 0; f < fields; ++f) level.live.push_back(static_cast<std::size_t>(f));
  for (std::size_t i = 0; i < level.table->size(); ++i)
    level.checker[level.table->place[i].sum() & 1].push_back(static_cast<std::int32_t>(i));
}

int count_role(const BrickHalo<CellRole>& halo, int at, CellRole role) {
  using H = BrickHalo<CellRole>;
  const auto is = [&](int step) { return halo.value[at + step] == role ? 1 : 0; };
  return is(-1) + is(1) + is(-H::kRow) + is(H::kRow) + is(-H::kSlab) + is(H::kSlab);
}

// Per coarse cell: conductance to held cells, and whether it is unknown.
struct Coarse {
  std::vector<float> held;
  std::vector<CellRole> role;
};

BrickTable coarse_table(const BrickTable& fine) {
  const Cell cells((fine.cells.x() + 1) / 2, (fine.cells.y() + 1) / 2, (fine.cells.z() + 1) / 2);
  const Cell box = brick_box(cells);
  std::vector<std::uint8_t> wanted(std::size_t(box.x()) * box.y() * box.z(), 0);
  for (const Cell& p : fine.place)
    wanted[(std::size_t(p.z() / 2) * box.y() + p.y() / 2) * box.x() + p.x() / 2] = 1;
  return make_brick_table(cells, wanted);
}

// `held_of(brick, halo index, cell index)` is the held conductance of a fine cell.
template <class HeldOf>
Coarse coarsen(const BrickTable& fine, const std::vector<CellRole>& role, const BrickTable& coarse,
               float scale, const HeldOf& held_of) {
  const std::size_t n = coarse.cell_count();
  Coarse out{large_vector<float>(n, [](std::size_t) { return 0.0f; }),
             large_vector<CellRole>(n, [](std::size_t) { return CellRole::Outside; })};
  patchmill::parallel_for(std::size_t{0}, fine.size(), [&](std::size_t brick) {
    BrickHalo<CellRole> halo;
    load_halo(role.data(), fine, brick, halo);
    const CoarseOctant up = octant_of(fine, coarse, brick);
    for (int k = 0; k < kBrickSide; ++k)
      for (int j = 0; j < kBrickSide; ++j)
        for (int i = 0; i < kBrickSide; ++i) {
          const int at = BrickHalo<CellRole>::index(i, j, k);
          if (halo.value[at] != CellRole::Unknown) continue;
          const std::size_t to = up.brick * kBrickCells + up.first + in_brick(i / 2, j / 2, k / 2);
          out.role[to] = CellRole::Unknown;
          out.held[to] += scale * held_of(halo, at, brick * kBrickCells + in_brick(i, j, k));
        }
  });
  return out;
}

void set_diagonal(LaplaceLevel& level, Coarse& coarse) {
  fill_large(level.diagonal, level.table->cell_count(), [](std::size_t) { return 0.0f; });
  patchmill::parallel_for(std::size_t{0}, level.table->size(), [&](std::size_t brick) {
    BrickHalo<CellRole> halo;
    load_halo(coarse.role.data(), *level.table, brick, halo);
    for (int k = 0; k < kBrickSide; ++k)
      for (int j = 0; j < kBrickSide; ++j)
        for (int i = 0; i < kBrickSide; ++i) {
          const int at = BrickHalo<CellRole>::index(i, j, k);
          const std::size_t cell = brick * kBrickCells + in_brick(i, j, k);
          if (halo.value[at] != CellRole::Unknown) continue;
          level.diagonal[cell] =
              static_cast<float>(count_role(halo, at, CellRole::Unknown)) + coarse.held[cell];
        }
  });
}

}  // namespace

LaplaceLevel finest_level(const BrickTable& table, const std::vector<CellRole>& role, int fields) {
  LaplaceLevel level;
  level.table = &table;
  fill_large(level.faces, table.cell_count(), [](std::size_t) { return std::uint8_t{0}; });
  allocate(level, fields);
  patchmill::parallel_for(std::size_t{0}, table.size(), [&](std::size_t brick) {
    BrickHalo<CellRole> halo;
    load_halo(role.data(), table, brick, halo);
    for (int k = 0; k < kBrickSide; ++k)
      for (int j = 0; j < kBrickSide; ++j)
        for (int i = 0; i < kBrickSide; ++i) {
          const int at = BrickHalo<CellRole>::index(i, j, k);
          if (halo.value[at] != CellRole::Unknown) continue;
          level.faces[brick * kBrickCells + in_brick(i, j, k)] = static_cast<std::uint8_t>(
              count_role(halo, at, CellRole::Unknown) + count_role(halo, at, CellRole::Held));
        }
  });
  return level;
}

void append_coarser_levels(std::vector<LaplaceLevel>& levels, const std::vector<CellRole>& role) {
  const int fields = static_cast<int>(levels[0].x.size());
  double side = 1.0;  // of a cell of the current level, in finest cells
  Coarse below;
  while (levels.back().table->bricks.maxCoeff() > 1) {
    const BrickTable& fine = *levels.back().table;
    LaplaceLevel next;
    next.own_table = coarse_table(fine);
    const double distance = (side + 1.0) / 2.0, coarse_distance = (2.0 * side + 1.0) / 2.0;
    const float scale = static_cast<float>(0.5 * distance / coarse_distance);
    Coarse here;
    if (levels.size() == 1)
      here = coarsen(fine, role, next.own_table, scale,
                     [](const BrickHalo<CellRole>& halo, int at, std::size_t) {
                       return static_cast<float>(count_role(halo, at, CellRole::Held));
                     });
    else
      here = coarsen(
          fine, below.role, next.own_table, scale,
          [&](const BrickHalo<CellRole>&, int, std::size_t cell) { return below.held[cell]; });
    below = std::move(here);
    next.table = &next.own_table;
    set_diagonal(next, below);
    allocate(next, fields);
    levels.push_back(std::move(next));
    levels.back().table = &levels.back().own_table;
    side *= 2.0;
  }
  for (std::size_t l = 1; l < levels.size(); ++l) levels[l].table = &levels[l].own_table;
}

}  // namespace patchmill::voxel
