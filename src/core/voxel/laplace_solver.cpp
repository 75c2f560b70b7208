// Multigrid-preconditioned conjugate gradients; see laplace_solver.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/voxel/laplace_solver.h"

#include "core/geometry/error.h"
#include "core/voxel/brick_halo.h"
#include "core/voxel/reach.h"

#include <cmath>
#include <string>

#include <tbb/parallel_for.h>

namespace patchmill {
namespace {

using Fields = std::vector<std::vector<double>>;
using Floats = std::vector<std::vector<float>>;
using Halo = BrickHalo<float>;
using WideHalo = BrickHalo<double>;
constexpr int kLanes = kBrickSide;

double sum_lanes(const double* lane) {
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

// p . A p of one brick.
PATCHMILL_VECTOR_CLONES
double brick_energy(const float* halo, const float* diagonal) {
  double lane[kLanes] = {};
  for (int k = 0; k < kBrickSide; ++k)
    for (int j = 0; j < kBrickSide; ++j) {
      const float* c = halo + Halo::index(0, j, k);
      const float* d = diagonal + in_brick(0, j, k);
      for (int i = 0; i < kBrickSide; ++i) {
        const float sum = ((c[i - 1] + c[i + 1]) + (c[i - Halo::kRow] + c[i + Halo::kRow])) +
                          (c[i - Halo::kSlab] + c[i + Halo::kSlab]);
        const float ap = d[i] > 0.0f ? d[i] * c[i] - sum : 0.0f;
        lane[i] += static_cast<double>(c[i] * ap);
      }
    }
  return sum_lanes(lane);
}

// x += alpha p, r -= alpha A p in one brick; returns r . r.
PATCHMILL_VECTOR_CLONES
double brick_step(const float* halo, const float* diagonal, double alpha, double* x, float* r) {
  double lane[kLanes] = {};
  const float a = static_cast<float>(alpha);
  for (int k = 0; k < kBrickSide; ++k)
    for (int j = 0; j < kBrickSide; ++j) {
      const float* c = halo + Halo::index(0, j, k);
      const int row = in_brick(0, j, k);
      for (int i = 0; i < kBrickSide; ++i) {
        const float sum = ((c[i - 1] + c[i + 1]) + (c[i - Halo::kRow] + c[i + Halo::kRow])) +
                          (c[i - Halo::kSlab] + c[i + Halo::kSlab]);
        const float d = diagonal[row + i];
        const float ap = d > 0.0f ? d * c[i] - sum : 0.0f;
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

// r = sum of neighbours - d x in one brick, in double; returns r . r.
PATCHMILL_VECTOR_CLONES
double brick_true_residual(const double* halo, const float* diagonal, float* r) {
  double lane[kLanes] = {};
  for (int k = 0; k < kBrickSide; ++k)
    for (int j = 0; j < kBrickSide; ++j) {
      const double* c = halo + WideHalo::index(0, j, k);
      const int row = in_brick(0, j, k);
      for (int i = 0; i < kBrickSide; ++i) {
        const double sum =
            ((c[i - 1] + c[i + 1]) + (c[i - WideHalo::kRow] + c[i + WideHalo::kRow])) +
            (c[i - WideHalo::kSlab] + c[i + WideHalo::kSlab]);
        const double d = static_cast<double>(diagonal[row + i]);
        const double value = d > 0.0 ? sum - d * c[i] : 0.0;
        r[row + i] = static_cast<float>(value);
        lane[i] += value * value;
      }
    }
  return sum_lanes(lane);
}

// Per field, the sum over bricks of `kernel(brick, field, diagonal)`, added in the order of the
// bricks.
template <class Kernel>
std::vector<double> sum_over_bricks(const LaplaceLevel& level, const Kernel& kernel) {
  const std::size_t bricks = level.table->size(), fields = level.x.size();
  std::vector<double> part(bricks * fields);
  tbb::parallel_for(std::size_t{0}, bricks, [&](std::size_t brick) {
    alignas(64) float diagonal[kBrickCells];
    load_diagonal(level, brick, diagonal);
    for (std::size_t f = 0; f < fields; ++f) part[brick * fields + f] = kernel(brick, f, diagonal);
  });
  std::vector<double> sum(fields, 0.0);
  for (std::size_t i = 0; i < part.size(); ++i) sum[i % fields] += part[i];
  return sum;
}

std::vector<double> true_residual(LaplaceLevel& level, const Fields& x) {
  return sum_over_bricks(level, [&](std::size_t brick, std::size_t f, const float* diagonal) {
    WideHalo halo;
    load_halo(x[f].data(), *level.table, brick, halo);
    return brick_true_residual(halo.value, diagonal, level.b[f].data() + brick * kBrickCells);
  });
}

double worst_ratio(const std::vector<double>& squares, const std::vector<double>& reference) {
  double worst = 0.0;
  for (std::size_t f = 0; f < squares.size(); ++f)
    if (reference[f] > 0.0) worst = std::max(worst, std::sqrt(squares[f] / reference[f]));
  return worst;
}

// One iteration; p.A p and r.z say the step lengths. A field whose residual is zero stands still.
struct Iteration {
  std::vector<LaplaceLevel>& levels;
  Floats& p;
  std::vector<double> rz;

  const float* at(const std::vector<float>& v, std::size_t brick) const {
    return v.data() + brick * kBrickCells;
  }

  void choose_direction(bool restart) {
    v_cycle(levels);
    LaplaceLevel& top = levels[0];
    const auto next = sum_over_bricks(top, [&](std::size_t brick, std::size_t f, const float*) {
      return brick_dot(at(top.x[f], brick), at(top.b[f], brick));
    });
    tbb::parallel_for(std::size_t{0}, top.table->size(), [&](std::size_t brick) {
      for (std::size_t f = 0; f < p.size(); ++f) {
        const double beta = restart || rz[f] <= 0.0 ? 0.0 : next[f] / rz[f];
        brick_direction(at(top.x[f], brick), static_cast<float>(beta),
                        p[f].data() + brick * kBrickCells);
      }
    });
    rz = next;
  }

  std::vector<double> step(Fields& x) {
    LaplaceLevel& top = levels[0];
    const auto energy =
        sum_over_bricks(top, [&](std::size_t brick, std::size_t f, const float* diagonal) {
          Halo halo;
          load_halo(p[f].data(), *top.table, brick, halo);
          return brick_energy(halo.value, diagonal);
        });
    return sum_over_bricks(top, [&](std::size_t brick, std::size_t f, const float* diagonal) {
      Halo halo;
      load_halo(p[f].data(), *top.table, brick, halo);
      const double alpha = energy[f] > 0.0 ? rz[f] / energy[f] : 0.0;
      return brick_step(halo.value, diagonal, alpha, x[f].data() + brick * kBrickCells,
                        top.b[f].data() + brick * kBrickCells);
    });
  }
};

void check(const BrickTable& table, const std::vector<CellRole>& role, const Fields& fields,
           const LaplaceOptions& options) {
  require_in_range("tolerance of the field", options.tolerance, 1e-13, 1.0, "");
  bool same = role.size() == table.cell_count() && !fields.empty();
  for (const auto& field : fields) same = same && field.size() == table.cell_count();
  if (!same)
    throw InputError("size of the field", std::to_string(role.size()),
                     "give one role and one value per field for each of the grid's " +
                         std::to_string(table.cell_count()) + " cells.");
}

void clear_outside(const std::vector<CellRole>& role, Fields& fields) {
  tbb::parallel_for(std::size_t{0}, role.size() / kBrickCells, [&](std::size_t brick) {
    for (std::size_t i = brick * kBrickCells; i < (brick + 1) * kBrickCells; ++i)
      if (role[i] == CellRole::Outside)
        for (auto& field : fields) field[i] = 0.0;
  });
}

}  // namespace

LaplaceOutcome solve_laplace(const BrickTable& table, std::vector<CellRole> role, Fields& fields,
                             const LaplaceOptions& options, const Progress& progress) {
  check(table, role, fields, options);
  clear_outside(role, fields);
  exclude_unreached(table, role);
  const int count = static_cast<int>(fields.size());
  std::vector<LaplaceLevel> levels;
  levels.push_back(finest_level(table, role, count));
  append_coarser_levels(levels, role);
  Floats p(count, std::vector<float>(table.cell_count(), 0.0f));
  Iteration cg{levels, p, std::vector<double>(count, 0.0)};

  LaplaceOutcome outcome;
  const std::vector<double> first = true_residual(levels[0], fields);
  outcome.true_residual = worst_ratio(first, first);
  outcome.history.push_back(outcome.true_residual);
  bool restart = true;
  while (outcome.true_residual > options.tolerance && outcome.iterations < options.max_iterations) {
    const double share = std::log(outcome.history.back()) / std::log(options.tolerance);
    if (!go_on(progress, std::min(0.99, std::max(0.0, share)))) {
      outcome.cancelled = true;
      return outcome;
    }
    cg.choose_direction(restart);
    outcome.history.push_back(worst_ratio(cg.step(fields), first));
    ++outcome.iterations;
    // the recursion is good for about four digits; then, and at the end, the truth is asked for
    restart = outcome.history.back() <= std::max(options.tolerance, 1e-4 * outcome.true_residual) ||
              outcome.iterations == options.max_iterations;
    if (restart) {
      outcome.true_residual = worst_ratio(true_residual(levels[0], fields), first);
      outcome.history.back() = outcome.true_residual;
    }
  }
  outcome.converged = outcome.true_residual <= options.tolerance;
  return outcome;
}

std::vector<double> laplace_residual(const BrickTable& table, const std::vector<CellRole>& role,
                                     const Fields& fields) {
  check(table, role, fields, {});
  LaplaceLevel level = finest_level(table, role, static_cast<int>(fields.size()));
  std::vector<double> squares = true_residual(level, fields);
  for (double& s : squares) s = std::sqrt(s);
  return squares;
}

}  // namespace patchmill
