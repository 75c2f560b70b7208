// Multigrid level: kernels and transfer; see laplace_level.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/voxel/laplace_level.h"

#include "core/voxel/brick_halo.h"
#include "core/voxel/row.h"

#include <tbb/parallel_for.h>

namespace patchmill {
namespace {

constexpr int kInnerSweeps = 2;      // red-black sweeps in a brick at each visit
constexpr int kCoarsestSweeps = 24;  // each way, on the single brick of the coarsest level
using Halo = BrickHalo<float>;

// One half sweep: cells whose x + y + z has the parity of `colour`. `inverse` is 0 where not unknown.
PATCHMILL_VECTOR_CLONES
void relax_colour(float* halo, const float* b, const float* inverse, int colour) {
  static constexpr RowMask take[2] = {{-1, 0, -1, 0, -1, 0, -1, 0}, {0, -1, 0, -1, 0, -1, 0, -1}};
  for (int k = 0; k < kBrickSide; ++k)
    for (int j = 0; j < kBrickSide; ++j) {
      float* c = halo + Halo::index(0, j, k);
      Row here, west, east, south, north, below, above, right, scale;
      load_row(c, here);
      load_row(c - 1, west);
      load_row(c + 1, east);
      load_row(c - Halo::kRow, south);
      load_row(c + Halo::kRow, north);
      load_row(c - Halo::kSlab, below);
      load_row(c + Halo::kSlab, above);
      load_row(b + in_brick(0, j, k), right);
      load_row(inverse + in_brick(0, j, k), scale);
      const Row sum = ((west + east) + (south + north)) + (below + above);
      assign_where(take[(j + k + colour) & 1], (right + sum) * scale, here);
      store_row(here, c);
    }
}

PATCHMILL_VECTOR_CLONES
void invert(const float* diagonal, float* inverse) {
  for (int i = 0; i < kBrickCells; ++i) inverse[i] = diagonal[i] > 0.0f ? 1.0f / diagonal[i] : 0.0f;
}

// Residual b - A x of one brick.
PATCHMILL_VECTOR_CLONES
void brick_residual(const float* halo, const float* b, const float* diagonal, float* residual) {
  for (int k = 0; k < kBrickSide; ++k)
    for (int j = 0; j < kBrickSide; ++j) {
      const float* c = halo + Halo::index(0, j, k);
      const int row = in_brick(0, j, k);
      for (int i = 0; i < kBrickSide; ++i) {
        const float sum = ((c[i - 1] + c[i + 1]) + (c[i - Halo::kRow] + c[i + Halo::kRow])) +
                          (c[i - Halo::kSlab] + c[i + Halo::kSlab]);
        const float d = diagonal[row + i];
        residual[row + i] = d > 0.0f ? b[row + i] + sum - d * c[i] : 0.0f;
      }
    }
}

void store_interior(const Halo& halo, float* to) {
  for (int k = 0; k < kBrickSide; ++k)
    for (int j = 0; j < kBrickSide; ++j) detail::copy_row(halo.row(j, k), to + in_brick(0, j, k));
}

void smooth_brick(LaplaceLevel& level, std::size_t brick, SweepOrder order, bool zero_own,
                  bool zero_near, int sweeps) {
  alignas(64) float diagonal[kBrickCells], inverse[kBrickCells];
  load_diagonal(level, brick, diagonal);
  invert(diagonal, inverse);
  for (std::size_t f = 0; f < level.x.size(); ++f) {
    Halo halo;
    float* x = level.x[f].data();
    if (zero_own)
      halo.clear();
    else
      load_halo(x, *level.table, brick, halo);
    if (zero_own && !zero_near) detail::load_sides(x, level.table->neighbours[brick], halo);
    const float* b = level.b[f].data() + brick * kBrickCells;
    const int first = order == SweepOrder::Forward ? 0 : 1;
    for (int s = 0; s < sweeps; ++s) {
      relax_colour(halo.value, b, inverse, first);
      relax_colour(halo.value, b, inverse, 1 - first);
    }
    store_interior(halo, x + brick * kBrickCells);
  }
}

void smooth_bricks(LaplaceLevel& level, SweepOrder order, bool from_zero, int sweeps) {
  for (int turn = 0; turn < 2; ++turn) {
    const auto& bricks = level.checker[order == SweepOrder::Forward ? turn : 1 - turn];
    tbb::parallel_for(std::size_t{0}, bricks.size(), [&](std::size_t i) {
      smooth_brick(level, bricks[i], order, from_zero, from_zero && turn == 0, sweeps);
    });
  }
}

void allocate(LaplaceLevel& level, int fields) {
  const std::size_t n = level.table->cell_count();
  level.x.assign(fields, std::vector<float>(n, 0.0f));
  level.b.assign(fields, std::vector<float>(n, 0.0f));
  for (std::size_t i = 0; i < level.table->size(); ++i)
    level.checker[level.table->place[i].sum() & 1].push_back(static_cast<std::int32_t>(i));
}

// Where the 4 x 4 x 4 parents of a brick's cells are: number of the coarse brick and first index in
// it.
struct Parent {
  std::size_t brick;
  int first;
};
Parent parent_of(const BrickTable& fine, const BrickTable& coarse, std::size_t brick) {
  const Cell p = fine.place[brick];
  const std::int32_t up = coarse.find(Cell(p.x() / 2, p.y() / 2, p.z() / 2));
  return {static_cast<std::size_t>(up),
          in_brick(4 * (p.x() % 2), 4 * (p.y() % 2), 4 * (p.z() % 2))};
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
  Coarse out{std::vector<float>(coarse.cell_count(), 0.0f),
             std::vector<CellRole>(coarse.cell_count(), CellRole::Outside)};
  tbb::parallel_for(std::size_t{0}, fine.size(), [&](std::size_t brick) {
    BrickHalo<CellRole> halo;
    load_halo(role.data(), fine, brick, halo);
    const Parent up = parent_of(fine, coarse, brick);
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
  level.diagonal.assign(level.table->cell_count(), 0.0f);
  tbb::parallel_for(std::size_t{0}, level.table->size(), [&](std::size_t brick) {
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

void load_diagonal(const LaplaceLevel& level, std::size_t brick, float* diagonal) {
  const std::size_t first = brick * kBrickCells;
  if (!level.faces.empty())
    for (int i = 0; i < kBrickCells; ++i) diagonal[i] = level.faces[first + i];
  else
    std::copy_n(level.diagonal.data() + first, kBrickCells, diagonal);
}

LaplaceLevel finest_level(const BrickTable& table, const std::vector<CellRole>& role, int fields) {
  LaplaceLevel level;
  level.table = &table;
  level.faces.assign(table.cell_count(), 0);
  allocate(level, fields);
  tbb::parallel_for(std::size_t{0}, table.size(), [&](std::size_t brick) {
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

void smooth(LaplaceLevel& level, SweepOrder order, bool from_zero) {
  smooth_bricks(level, order, from_zero, kInnerSweeps);
}

void restrict_residual(const LaplaceLevel& fine, LaplaceLevel& coarse) {
  tbb::parallel_for(std::size_t{0}, fine.table->size(), [&](std::size_t brick) {
    alignas(64) float diagonal[kBrickCells], residual[kBrickCells];
    load_diagonal(fine, brick, diagonal);
    const Parent up = parent_of(*fine.table, *coarse.table, brick);
    for (std::size_t f = 0; f < fine.x.size(); ++f) {
      Halo halo;
      load_halo(fine.x[f].data(), *fine.table, brick, halo);
      brick_residual(halo.value, fine.b[f].data() + brick * kBrickCells, diagonal, residual);
      float* to = coarse.b[f].data() + up.brick * kBrickCells + up.first;
      for (int k = 0; k < 4; ++k)
        for (int j = 0; j < 4; ++j)
          for (int i = 0; i < 4; ++i) {
            const float* r = residual + in_brick(2 * i, 2 * j, 2 * k);
            const float low = (r[0] + r[1]) + (r[8] + r[9]);
            const float high = (r[64] + r[65]) + (r[72] + r[73]);
            to[in_brick(i, j, k)] = 0.5f * (low + high);
          }
    }
  });
}

void prolong_correction(const LaplaceLevel& coarse, LaplaceLevel& fine) {
  tbb::parallel_for(std::size_t{0}, fine.table->size(), [&](std::size_t brick) {
    alignas(64) float diagonal[kBrickCells];
    load_diagonal(fine, brick, diagonal);
    const Parent up = parent_of(*fine.table, *coarse.table, brick);
    for (std::size_t f = 0; f < fine.x.size(); ++f) {
      const float* from = coarse.x[f].data() + up.brick * kBrickCells + up.first;
      float* x = fine.x[f].data() + brick * kBrickCells;
      for (int k = 0; k < kBrickSide; ++k)
        for (int j = 0; j < kBrickSide; ++j) {
          const float* c = from + in_brick(0, j / 2, k / 2);
          const int row = in_brick(0, j, k);
          for (int i = 0; i < kBrickSide; ++i)
            x[row + i] += diagonal[row + i] > 0.0f ? c[i / 2] : 0.0f;
        }
    }
  });
}

void v_cycle(std::vector<LaplaceLevel>& levels) {
  const std::size_t last = levels.size() - 1;
  for (std::size_t l = 0; l < last; ++l) {
    smooth(levels[l], SweepOrder::Forward, true);
    restrict_residual(levels[l], levels[l + 1]);
  }
  smooth_bricks(levels[last], SweepOrder::Forward, true, kCoarsestSweeps);
  smooth_bricks(levels[last], SweepOrder::Backward, false, kCoarsestSweeps);
  for (std::size_t l = last; l-- > 0;) {
    prolong_correction(levels[l + 1], levels[l]);
    smooth(levels[l], SweepOrder::Backward, false);
  }
}

std::size_t laplace_bytes(std::size_t bricks, int fields) {
  const std::size_t cells = bricks * std::size_t{kBrickCells};
  const std::size_t finest = cells * (1 + 3 * sizeof(float) * fields);  // faces; r, z, p
  const std::size_t coarser = cells / 7 * (sizeof(float) * (2 * fields + 1) + 5);
  return finest + coarser;
}

}  // namespace patchmill
