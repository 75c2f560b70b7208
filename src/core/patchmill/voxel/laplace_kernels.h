// Conjugate gradients within one brick: the 7-point Laplacian applied on the fly to a brick and the layer around
// it (brick_halo.h), in rows of eight. `diagonal` is 0 where a cell is not unknown. Sums are taken in eight
// lanes, one per x, and added in a fixed order: the same bits whatever the vector width.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace patchmill::voxel {

/// p . A p; `halo` holds p.
double brick_energy(const float* halo, const float* diagonal);

/// x += alpha p, r -= alpha A p; returns r . r. `halo` holds p.
double brick_step(const float* halo, const float* diagonal, double alpha, double* x, float* r);

/// a . b
double brick_dot(const float* a, const float* b);

/// p = z + beta p
void brick_direction(const float* z, float beta, float* p);

/// r = sum of the neighbours - diagonal x, in double; returns r . r. `halo` holds x.
double brick_true_residual(const double* halo, const float* diagonal, float* r);

}  // namespace patchmill::voxel
