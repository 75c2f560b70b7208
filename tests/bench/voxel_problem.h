// The masked grid that the solvers of voxel_bench.cpp share: a box whose skin is held at zero, less a
// wavy hill whose surface is held at two smooth fields, as for the two posture angles.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"
#include "patchmill/voxel/laplace_solver.h"

#include <cmath>
#include <vector>

namespace patchmill {

struct MaskedProblem {
  voxel::BrickTable table;
  std::vector<voxel::CellRole> role;
  std::vector<std::vector<double>> fields;
  std::size_t unknowns = 0;
};

/// A box of n^3 voxels.
inline MaskedProblem masked_problem(int n) {
  MaskedProblem p;
  const voxel::Cell cells(n, n, n), box = voxel::brick_box(cells);
  p.table = voxel::make_brick_table(cells, std::vector<std::uint8_t>(std::size_t(box.prod()), 1));
  p.role.assign(p.table.cell_count(), voxel::CellRole::Outside);
  p.fields.assign(2, std::vector<double>(p.role.size(), 0.0));
  for (std::size_t b = 0; b < p.table.size(); ++b)
    for (int i = 0; i < voxel::kBrickCells; ++i) {
      const voxel::Cell cell =
          voxel::first_cell(p.table, b) + voxel::Cell(i % 8, i / 8 % 8, i / 64);
      if ((cell.array() >= n).any()) continue;
      const std::size_t at = b * voxel::kBrickCells + std::size_t(i);
      const Vec3 d = cell.cast<double>() + Vec3::Constant(0.5) - n * Vec3(0.53, 0.47, 0.1);
      const double depth = d.norm() - n * (0.33 + 0.04 * std::sin(20.0 * (cell.x() + 0.5) / n));
      const bool skin = (cell.array() == 0).any() || (cell.array() == n - 1).any();
      if (depth < -0.9) continue;
      p.role[at] = skin || depth < 0.9 ? voxel::CellRole::Held : voxel::CellRole::Unknown;
      if (depth < 0.9 && !skin) {
        p.fields[0][at] = d.x() / n;
        p.fields[1][at] = d.y() / n + 0.3 * std::sin(10.0 * d.x() / n);
      }
      p.unknowns += p.role[at] == voxel::CellRole::Unknown ? 1 : 0;
    }
  return p;
}

/// Largest over the fields: residual of `x`, relative to that of `start`.
inline double relative_residual(const MaskedProblem& start,
                                const std::vector<std::vector<double>>& x) {
  const auto before = voxel::laplace_residual(start.table, start.role, start.fields);
  const auto after = voxel::laplace_residual(start.table, start.role, x);
  return std::max(after[0] / before[0], after[1] / before[1]);
}

}  // namespace patchmill
