// Multigrid-preconditioned conjugate gradients; see laplace_solver.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/laplace_solver.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/large_vector.h"
#include "patchmill/voxel/brick_halo.h"
#include "patchmill/voxel/laplace_kernels.h"
#include "patchmill/voxel/reach.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace patchmill::voxel {
namespace {

using Values = std::vector<double>;
using Fields = std::vector<Values>;
using Floats = std::vector<std::vector<float>>;
using Halo = BrickHalo<float>;
using WideHalo = BrickHalo<double>;

// Per live field, the sum over bricks of `kernel(brick, field, diagonal)`, added in the order of the bricks; 0
// for the other fields.
template <class Kernel>
std::vector<double> sum_over_bricks(const LaplaceLevel& level, const std::vector<std::size_t>& live,
                                    const Kernel& kernel) {
  const std::size_t bricks = level.table->size();
  std::vector<double> part(bricks * live.size());
  patchmill::parallel_for(std::size_t{0}, bricks, [&](std::size_t brick) {
    alignas(64) float diagonal[kBrickCells];
    load_diagonal(level, brick, diagonal);
    for (std::size_t i = 0; i < live.size(); ++i)
      part[brick * live.size() + i] = kernel(brick, live[i], diagonal);
  });
  std::vector<double> sum(level.x.size(), 0.0);
  for (std::size_t i = 0; i < part.size(); ++i) sum[live[i % live.size()]] += part[i];
  return sum;
}

// Field f of the level is x[f].
std::vector<double> true_residual(LaplaceLevel& level, const std::vector<std::size_t>& live,
                                  const Values* x) {
  return sum_over_bricks(level, live, [&](std::size_t brick, std::size_t f, const float* diagonal) {
    WideHalo halo;
    load_halo(x[f].data(), *level.table, brick, halo);
    return brick_true_residual(halo.value, diagonal, level.b[f].data() + brick * kBrickCells);
  });
}

// Conjugate gradients of one field.
struct Descent {
  double first = 0.0;  // squares of the first residual
  double rz = 0.0;
  bool restart = true;            // the next direction is the preconditioned residual itself
  double true_residual = 0.0;     // relative, the last one in double
  std::vector<double> history{};  // relative residuals
};

// Fields solved side by side. Each goes its own way and stops when it is done, so that none depends on the
// others.
struct Batch {
  std::vector<LaplaceLevel>& levels;
  Floats& p;
  Values* x;  // the solution of field f is x[f]
  std::vector<Descent> field;

  LaplaceLevel& top() const { return levels[0]; }
  const std::vector<std::size_t>& live() const { return levels[0].live; }
  const float* at(const std::vector<float>& v, std::size_t brick) const {
    return v.data() + brick * kBrickCells;
  }

  void work_on(const std::vector<std::size_t>& fields) {
    for (LaplaceLevel& level : levels) level.live = fields;
  }

  void begin(std::size_t fields, double tolerance) {
    field.assign(fields, {});
    std::vector<std::size_t> all(fields), open;
    std::iota(all.begin(), all.end(), std::size_t{0});
    const auto first = true_residual(top(), all, x);
    for (const std::size_t f : all) {
      field[f].first = first[f];
      field[f].true_residual = first[f] > 0.0 ? 1.0 : 0.0;
      field[f].history.push_back(field[f].true_residual);
      if (field[f].true_residual > tolerance) open.push_back(f);
    }
    work_on(open);
  }

  void choose_direction() {
    v_cycle(levels);
    const auto next =
        sum_over_bricks(top(), live(), [&](std::size_t brick, std::size_t f, const float*) {
          return brick_dot(at(top().x[f], brick), at(top().b[f], brick));
        });
    patchmill::parallel_for(std::size_t{0}, top().table->size(), [&](std::size_t brick) {
      for (const std::size_t f : live()) {
        const double beta = field[f].restart || field[f].rz <= 0.0 ? 0.0 : next[f] / field[f].rz;
        brick_direction(at(top().x[f], brick), static_cast<float>(beta),
                        p[f].data() + brick * kBrickCells);
      }
    });
    for (const std::size_t f : live()) field[f].rz = next[f];
  }

  // Squares of the residuals after the step.
  std::vector<double> step() {
    const auto energy = sum_over_bricks(
        top(), live(), [&](std::size_t brick, std::size_t f, const float* diagonal) {
          Halo halo;
          load_halo(p[f].data(), *top().table, brick, halo);
          return brick_energy(halo.value, diagonal);
        });
    return sum_over_bricks(
        top(), live(), [&](std::size_t brick, std::size_t f, const float* diagonal) {
          Halo halo;
          load_halo(p[f].data(), *top().table, brick, halo);
          const double alpha = energy[f] > 0.0 ? field[f].rz / energy[f] : 0.0;
          return brick_step(halo.value, diagonal, alpha, x[f].data() + brick * kBrickCells,
                            top().b[f].data() + brick * kBrickCells);
        });
  }

  // One iteration of every live field; those that are done, or may not go on, live no longer.
  void iterate(const LaplaceOptions& options) {
    choose_direction();
    const auto squares = step();
    std::vector<std::size_t> asked;
    for (const std::size_t f : live()) {
      Descent& d = field[f];
      d.history.push_back(std::sqrt(squares[f] / d.first));
      // the recursion is good for about four digits; then, and at the end, the truth is asked for
      d.restart = d.history.back() <= std::max(options.tolerance, 1e-4 * d.true_residual) ||
                  int(d.history.size()) > options.max_iterations;
      if (d.restart) asked.push_back(f);
    }
    if (asked.empty()) return;
    const auto truth = true_residual(top(), asked, x);
    for (const std::size_t f : asked)
      field[f].history.back() = field[f].true_residual = std::sqrt(truth[f] / field[f].first);
    std::vector<std::size_t> open;
    for (const std::size_t f : live())
      if (!field[f].restart || (field[f].true_residual > options.tolerance &&
                                int(field[f].history.size()) <= options.max_iterations))
        open.push_back(f);
    work_on(open);
  }
};

// Adds what became of a field: the largest residual of all after each iteration.
void include(const Descent& field, LaplaceOutcome& outcome) {
  auto& history = outcome.history;
  while (history.size() < field.history.size())
    history.push_back(history.empty() ? 0.0 : history.back());
  for (std::size_t i = 0; i < history.size(); ++i)
    history[i] = std::max(history[i], field.history[std::min(i, field.history.size() - 1)]);
  outcome.iterations = static_cast<int>(history.size()) - 1;
  outcome.true_residual = std::max(outcome.true_residual, field.true_residual);
}

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
  patchmill::parallel_for(std::size_t{0}, role.size() / kBrickCells, [&](std::size_t brick) {
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
  const std::size_t together =
      std::size_t(fields_at_once(table.size(), static_cast<int>(fields.size())));
  std::vector<LaplaceLevel> levels;
  levels.push_back(finest_level(table, role, static_cast<int>(together)));
  append_coarser_levels(levels, role);
  std::vector<CellRole>().swap(role);  // the levels know it now
  Floats p(together);
  for (auto& values : p) fill_large(values, table.cell_count(), [](std::size_t) { return 0.0f; });

  LaplaceOutcome outcome;
  for (std::size_t first = 0; first < fields.size() && !outcome.cancelled; first += together) {
    Batch batch{levels, p, &fields[first], {}};
    batch.begin(std::min(together, fields.size() - first), options.tolerance);
    while (!batch.live().empty() && !outcome.cancelled) {
      const double residual = batch.field[batch.live()[0]].history.back();
      const double share = std::log(residual) / std::log(options.tolerance);
      const double all = double(first) + std::min(0.99, std::max(0.0, share)) * double(together);
      outcome.cancelled = !go_on(progress, all / double(fields.size()));
      if (!outcome.cancelled) batch.iterate(options);
    }
    for (const Descent& field : batch.field) include(field, outcome);
  }
  outcome.converged = !outcome.cancelled && outcome.true_residual <= options.tolerance;
  return outcome;
}

std::vector<double> laplace_residual(const BrickTable& table, const std::vector<CellRole>& role,
                                     const Fields& fields) {
  check(table, role, fields, {});
  LaplaceLevel level = finest_level(table, role, static_cast<int>(fields.size()));
  std::vector<double> squares = true_residual(level, level.live, fields.data());
  for (double& s : squares) s = std::sqrt(s);
  return squares;
}

}  // namespace patchmill::voxel
