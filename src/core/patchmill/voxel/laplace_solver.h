// Steady diffusion on a masked voxel grid: the discrete Laplace equation with held cells, by
// conjugate gradients preconditioned with the multigrid V-cycle of laplace_level.h. No matrix is
// assembled. All fields (both posture angles, or three components of a vector) share the grid's data and are
// solved side by side, or one after the other where memory asks it (fields_at_once); each stops when its own
// residual is small enough, so that its result depends on no other. Kobayashi & Shirase 2014, Eq. (5), run to
// its stable state.
//
// The unknowns are kept in double and their residual is recomputed in double whenever the recursion
// (single precision) says that the tolerance is met; if it is not, the iteration restarts from the
// true residual. So the residual that is reported is the true one, at any tolerance down to 1e-12.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/progress.h"
#include "patchmill/voxel/laplace_level.h"

#include <vector>

namespace patchmill::voxel {

/// When the solver ends.
struct LaplaceOptions {
  double tolerance = 1e-8;  ///< of the residual's 2-norm, relative to the first; [1e-13, 1)
  int max_iterations = 200;
};

/// How it ended.
struct LaplaceOutcome {
  bool converged = false;
  bool cancelled = false;
  int iterations = 0;
  /// Largest relative residual over the fields: before the first iteration (1), and after each.
  std::vector<double> history;
  double true_residual = 0.0;  ///< the last one recomputed in double
};

/// Solves in place. `fields` holds, for each field, one value per cell of `table`: the given value
/// at Held cells, the first guess at Unknown cells; Outside cells are set to zero. Unknown cells
/// that no path of unknown cells joins to a Held cell have no unique solution and keep their guess.
/// Errors: InputError if the sizes differ or an option is out of range.
LaplaceOutcome solve_laplace(const BrickTable& table, std::vector<CellRole> role,
                             std::vector<std::vector<double>>& fields,
                             const LaplaceOptions& options = {}, const Progress& progress = {});

/// 2-norm over the unknown cells of sum(x_j) - n_i x_i, in double, per field.
std::vector<double> laplace_residual(const BrickTable& table, const std::vector<CellRole>& role,
                                     const std::vector<std::vector<double>>& fields);

}  // namespace patchmill::voxel
