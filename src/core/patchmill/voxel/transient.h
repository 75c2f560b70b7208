// Transient diffusion to a time t, by the paper's explicit Euler steps. Kobayashi & Shirase 2014,
// Eqs. (2) to (5). With r = D dt / dx^2 the scheme is stable for r <= 1/2 along one axis and for
// r <= 1/6 in three dimensions. The paper's own numbers (dt = 0.1 s, D = 40 mm^2/s, dx = 2 mm) make
// r = 1 and diverge, so such a step is refused, or divided on request.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/voxel/laplace_level.h"

#include <vector>

namespace patchmill::voxel {

/// Along which axes a field diffuses.
enum class DiffusionAxes { X, Y, Z, All };

/// How long diffusion goes on, and in which steps.
struct TransientOptions {
  double time = 0.0;         ///< to diffuse for [s], > 0
  double step = 0.0;         ///< dt [s], > 0; shortened so that whole steps make up `time`
  double diffusivity = 0.0;  ///< D [mm^2/s], > 0
  bool substep = false;      ///< divide steps that are too long, rather than refuse them
};

/// The largest stable r: 1/2 along one axis, 1/6 for all three.
double stability_limit(DiffusionAxes axes);

/// Number of steps that will be taken, at most a million; `pitch`: side of a voxel [mm], > 0. Errors: InputError
/// naming what is out of its range, or the limit and the longest step that is stable, if the step is too long and
/// sub-steps are not allowed.
int transient_steps(DiffusionAxes axes, double pitch, const TransientOptions& options);

/// Diffuses `field`, a value for each cell of `table` as `role` has, in place; held cells keep their value, nothing
/// flows out through Outside cells. Returns the number of steps taken. Errors: as transient_steps.
int diffuse_transient(const BrickTable& table, const std::vector<CellRole>& role,
                      DiffusionAxes axes, double pitch, const TransientOptions& options,
                      std::vector<double>& field);

/// One explicit step with the given r, stable or not: to = from + r (sum of neighbours - n from).
void explicit_step(const BrickTable& table, const std::vector<CellRole>& role, DiffusionAxes axes,
                   double r, const std::vector<double>& from, std::vector<double>& to);

}  // namespace patchmill::voxel
