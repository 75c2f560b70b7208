// One level of the multigrid hierarchy for the discrete Laplace equation on a masked brick grid.
//
// Unknown cells obey   diagonal_i x_i - sum over the 6 neighbours x_j = b_i,   x = 0 elsewhere.
// On the finest level the diagonal is the number of neighbours that are unknown or held; a
// neighbour outside the grid does not count, which is the free (Neumann) boundary. A coarser cell
// is unknown if one of its eight children is; its diagonal is the number of unknown neighbours plus
// the conductance to the held cells below it, corrected for the distance from the coarse centre to
// the held centre: (2^l + 1) h / 2 on level l. Restriction adds the eight residuals, prolongation
// copies to the eight children; with that conductance the V-cycle is a preconditioner whose quality
// does not depend on the size of the grid.
//
// The smoother is red-black Gauss-Seidel inside a brick while it is in cache, over the bricks in
// checkerboard order: parallel, and the same result on any number of threads. Run backwards it is
// its own adjoint, so the V-cycle is symmetric. (Briggs, Henson & McCormick 2000; McAdams, Sifakis
// & Teran 2010 for multigrid as preconditioner on masked voxel domains.)
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/voxel/bricks.h"

#include <cstdint>
#include <vector>

namespace patchmill::voxel {

/// What a cell is to the solver.
enum class CellRole : std::uint8_t {
  Outside,  ///< not part of the grid: no flux crosses its faces
  Unknown,  ///< to be solved for
  Held      ///< its value is given
};

/// One grid of the multigrid solver.
struct LaplaceLevel {
  const BrickTable* table = nullptr;
  BrickTable own_table;                  ///< on coarser levels; `table` points here
  std::vector<std::uint8_t> faces;       ///< finest level: the diagonal, 0 where not unknown
  std::vector<float> diagonal;           ///< coarser levels: the diagonal, 0 where not unknown
  std::vector<std::vector<float>> x, b;  ///< per field; on the finest level the CG's z and r
  std::vector<std::size_t> live;         ///< the fields that are worked on, ascending
  std::vector<std::int32_t> checker[2];  ///< brick numbers, by parity of their place
};

enum class SweepOrder { Forward, Backward };

/// The finest level: diagonal from the roles. Fields are allocated, `fields` of them.
LaplaceLevel finest_level(const BrickTable& table, const std::vector<CellRole>& role, int fields);

/// All coarser levels, down to one that is a single brick. Held conductances come from the roles.
/// Element 0 of `levels` is the finest; the rest are appended.
void append_coarser_levels(std::vector<LaplaceLevel>& levels, const std::vector<CellRole>& role);

/// One smoothing sweep over all bricks. With `from_zero` the old x is taken as zero (and not read).
void smooth(LaplaceLevel& level, SweepOrder order, bool from_zero);

/// b of the coarse level = half the sum of the eight children's residuals.
void restrict_residual(const LaplaceLevel& fine, LaplaceLevel& coarse);

/// x of the fine level += x of the coarse level, at unknown cells.
void prolong_correction(const LaplaceLevel& coarse, LaplaceLevel& fine);

/// The symmetric V-cycle: levels[0].x = M levels[0].b.
void v_cycle(std::vector<LaplaceLevel>& levels);

/// Diagonal of one brick as 512 floats.
void load_diagonal(const LaplaceLevel& level, std::size_t brick, float* diagonal);

/// Where the 4 x 4 x 4 parents of a brick's cells are: the coarse brick and the first index in it.
struct CoarseOctant {
  std::size_t brick;
  int first;
};
inline CoarseOctant octant_of(const BrickTable& fine, const BrickTable& coarse, std::size_t brick) {
  const Cell p = fine.place[brick];
  const std::int32_t up = coarse.find(Cell(p.x() / 2, p.y() / 2, p.z() / 2));
  return {static_cast<std::size_t>(up),
          in_brick(4 * (p.x() % 2), 4 * (p.y() % 2), 4 * (p.z() % 2))};
}

/// Fields that are solved side by side: all, unless what they need would be more than a GiB; then one after
/// the other, in the same arrays. Each field's result is the same either way, to the last bit.
int fields_at_once(std::size_t bricks, int fields);

/// Bytes that a solve of `fields` fields takes, for `bricks` stored bricks, besides the solution.
std::size_t laplace_bytes(std::size_t bricks, int fields);

}  // namespace patchmill::voxel
