// Kernels of conjugate gradients; see laplace_kernels.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/laplace_kernels.h"

#include "patchmill/voxel/brick_halo.h"

namespace patchmill::voxel {
namespace {

using Halo = BrickHalo<float>;
using WideHalo = BrickHalo<double>;
constexpr int kLanes = kBrickSide;

double sum_lanes(const double* lane) {
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

}  // namespace

PATCHMILL_VECTOR_CLONES
double brick_energy(const float* halo, const float* diagonal) {
  double lane[kLanes] = {};
  for (int k = 0; k < kBrickSide; ++k)
    for (int j = 0; j < kBrickSide; ++j) {
      const float* c = halo + Halo::index(0, j, k);
      const float* d = diagonal + in_brick(0, j, k);
      for (int i = 0; i < kBrickSide; ++i) {
        const float ap = d[i] > 0.0f ? d[i] * c[i] - sum_of_neighbours(c + i) : 0.0f;
        lane[i] += static_cast<double>(c[i] * ap);
      }
    }
  return sum_lanes(lane);
}

PATCHMILL_VECTOR_CLONES
double brick_step(const float* halo, const float* diagonal, double alpha, double* x, float* r) {
  double lane[kLanes] = {};
  const float a = static_cast<float>(alpha);
  for (int k = 0; k < kBrickSide; ++k)
    for (int j = 0; j < kBrickSide; ++j) {
      const float* c = halo + Halo::index(0, j, k);
      const int row = in_brick(0, j, k);
      for (int i = 0; i < kBrickSide; ++i) {
        const float d = diagonal[row + i];
        const float ap = d > 0.0f ? d * c[i] - sum_of_neighbours(c + i) : 0.0f;
        const float next = r[row + i] - a * ap;
        x[row + i] += alpha * static_cast<double>(c[i]);
        r[row + i] = next;
        lane[i] += static_cast<double>(next * next);
      }
    }
  return sum_lanes(lane);
}

PATCHMILL_VECTOR_CLONES
double brick_dot(const float* a, const float* b) {
  double lane[kLanes] = {};
  for (int row = 0; row < kBrickCells; row += kLanes)
    for (int i = 0; i < kLanes; ++i) lane[i] += static_cast<double>(a[row + i] * b[row + i]);
  return sum_lanes(lane);
}

PATCHMILL_VECTOR_CLONES
void brick_direction(const float* z, float beta, float* p) {
  for (int i = 0; i < kBrickCells; ++i) p[i] = z[i] + beta * p[i];
}

PATCHMILL_VECTOR_CLONES
double brick_true_residual(const double* halo, const float* diagonal, float* r) {
  double lane[kLanes] = {};
  for (int k = 0; k < kBrickSide; ++k)
    for (int j = 0; j < kBrickSide; ++j) {
      const double* c = halo + WideHalo::index(0, j, k);
      const int row = in_brick(0, j, k);
      for (int i = 0; i < kBrickSide; ++i) {
        const double d = static_cast<double>(diagonal[row + i]);
        const double value = d > 0.0 ? sum_of_neighbours(c + i) - d * c[i] : 0.0;
        r[row + i] = static_cast<float>(value);
        lane[i] += value * value;
      }
    }
  return sum_lanes(lane);
}

}  // namespace patchmill::voxel
