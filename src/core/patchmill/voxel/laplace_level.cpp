// Multigrid level: kernels and transfer; see laplace_level.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/laplace_level.h"

#include "patchmill/geometry/stop.h"
#include "patchmill/voxel/brick_halo.h"
#include "patchmill/voxel/row.h"

namespace patchmill::voxel {
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
        const float d = diagonal[row + i];
        residual[row + i] = d > 0.0f ? b[row + i] + sum_of_neighbours(c + i) - d * c[i] : 0.0f;
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
  for (const std::size_t f : level.live) {
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
    patchmill::parallel_for(std::size_t{0}, bricks.size(), [&](std::size_t i) {
      smooth_brick(level, bricks[i], order, from_zero, from_zero && turn == 0, sweeps);
    });
  }
}

}  // namespace

void load_diagonal(const LaplaceLevel& level, std::size_t brick, float* diagonal) {
  const std::size_t first = brick * kBrickCells;
  if (!level.faces.empty())
    for (int i = 0; i < kBrickCells; ++i) diagonal[i] = level.faces[first + i];
  else
    std::copy_n(level.diagonal.data() + first, kBrickCells, diagonal);
}

void smooth(LaplaceLevel& level, SweepOrder order, bool from_zero) {
  smooth_bricks(level, order, from_zero, kInnerSweeps);
}

void restrict_residual(const LaplaceLevel& fine, LaplaceLevel& coarse) {
  patchmill::parallel_for(std::size_t{0}, fine.table->size(), [&](std::size_t brick) {
    alignas(64) float diagonal[kBrickCells], residual[kBrickCells];
    load_diagonal(fine, brick, diagonal);
    const CoarseOctant up = octant_of(*fine.table, *coarse.table, brick);
    for (const std::size_t f : fine.live) {
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
  patchmill::parallel_for(std::size_t{0}, fine.table->size(), [&](std::size_t brick) {
    alignas(64) float diagonal[kBrickCells];
    load_diagonal(fine, brick, diagonal);
    const CoarseOctant up = octant_of(*fine.table, *coarse.table, brick);
    for (const std::size_t f : fine.live) {
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

namespace {

constexpr std::size_t kSideBySide = std::size_t{1} << 30;  // bytes

// Residual, direction and preconditioned residual of the finest level; x and b of the others, an eighth of
// the cells each, and of partly filled bricks a little more.
std::size_t bytes_of_fields(std::size_t bricks, int fields) {
  const std::size_t cells = bricks * std::size_t{kBrickCells};
  return sizeof(float) * fields * (3 * cells + 2 * cells / 6);
}

}  // namespace

int fields_at_once(std::size_t bricks, int fields) {
  return bytes_of_fields(bricks, fields) <= kSideBySide ? fields : 1;
}

std::size_t laplace_bytes(std::size_t bricks, int fields) {
  const std::size_t cells = bricks * std::size_t{kBrickCells};
  const std::size_t diagonals = cells + cells / 6 * (sizeof(float) + 5);  // and what makes them
  return diagonals + bytes_of_fields(bricks, fields_at_once(bricks, fields));
}

}  // namespace patchmill::voxel
