// The 3-D solver: order of convergence, a slow reference, symmetry of roles, determinism,
// residuals.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/error.h"
#include "patchmill/geometry/vec.h"
#include "patchmill/voxel/laplace_solver.h"
#include "voxel/shapes.h"

#include <cmath>
#include <cstdio>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <tbb/global_control.h>

namespace patchmill::voxel {
namespace {

using Fields = std::vector<std::vector<double>>;

double harmonic(const Vec3& p) {
  return std::sin(2.0 * p.x()) * std::cos(1.5 * p.y()) * std::cosh(2.5 * p.z()) + p.x() * p.y();
}

struct Problem {
  BrickTable table;
  std::vector<CellRole> role;
  Fields fields;
};

// Unit box of n^3 cells; unknown inside a ball with a hollow, the exact value held around it.
Problem ball_problem(int n) {
  Problem p{shapes::full_table(Cell(n, n, n)), {}, {}};
  p.role.assign(p.table.cell_count(), CellRole::Outside);
  p.fields.assign(1, std::vector<double>(p.role.size(), 0.0));
  shapes::for_each_cell(p.table, [&](std::size_t i, const Cell& c) {
    const Vec3 at = (c.cast<double>() + Vec3::Constant(0.5)) / n;
    const bool in =
        (at - Vec3::Constant(0.5)).norm() < 0.46 && (at - Vec3(0.5, 0.45, 0.3)).norm() > 0.17;
    p.role[i] = in ? CellRole::Unknown : CellRole::Held;
    if (!in) p.fields[0][i] = harmonic(at);
  });
  return p;
}

double worst_error(const Problem& p, int n) {
  double worst = 0.0;
  shapes::for_each_cell(p.table, [&](std::size_t i, const Cell& c) {
    const Vec3 at = (c.cast<double>() + Vec3::Constant(0.5)) / n;
    if (p.role[i] == CellRole::Unknown)
      worst = std::max(worst, std::abs(p.fields[0][i] - harmonic(at)));
  });
  return worst;
}

TEST(Laplace, ConvergesAtSecondOrderOnAHarmonicFunction) {
  std::vector<double> error;
  for (const int n : {16, 32, 64}) {
    Problem p = ball_problem(n);
    const LaplaceOutcome outcome = solve_laplace(p.table, p.role, p.fields);
    ASSERT_TRUE(outcome.converged);
    error.push_back(worst_error(p, n));
    std::printf("h = 1/%d: largest error %.3e, residual history", n, error.back());
    for (const double r : outcome.history) std::printf(" %.1e", r);
    std::printf("\n");
  }
  for (std::size_t i = 1; i < error.size(); ++i) {
    const double order = std::log2(error[i - 1] / error[i]);
    EXPECT_GT(order, 1.8);
    EXPECT_LT(order, 2.3);
  }
}

TEST(Laplace, FreeWallsAreOfSecondOrderToo) {
  // cos(pi x) cosh(pi z) has no slope across x = 0 and x = 1, nor along y: free there, held in z
  std::vector<double> error;
  for (const int n : {8, 16, 32}) {
    Problem p{shapes::full_table(Cell(n, n, n)), {}, {}};
    p.role.assign(p.table.cell_count(), CellRole::Unknown);
    p.fields.assign(1, std::vector<double>(p.role.size(), 0.0));
    const auto exact = [&](const Cell& c) {
      const Vec3 at = (c.cast<double>() + Vec3::Constant(0.5)) / n;
      return std::cos(kPi * at.x()) * std::cosh(kPi * at.z());
    };
    shapes::for_each_cell(p.table, [&](std::size_t i, const Cell& c) {
      if (c.z() != 0 && c.z() != n - 1) return;
      p.role[i] = CellRole::Held;
      p.fields[0][i] = exact(c);
    });
    ASSERT_TRUE(solve_laplace(p.table, p.role, p.fields).converged);
    double worst = 0.0;
    shapes::for_each_cell(p.table, [&](std::size_t i, const Cell& c) {
      worst = std::max(worst, std::abs(p.fields[0][i] - exact(c)));
    });
    error.push_back(worst);
  }
  EXPECT_GT(std::log2(error[1] / error[2]), 1.8);
}

TEST(Laplace, IterationsDoNotGrowWithTheGrid) {
  std::vector<int> iterations;
  for (const int n : {24, 48, 96}) {
    Problem p = ball_problem(n);
    LaplaceOptions options;
    options.tolerance = 1e-6;
    iterations.push_back(solve_laplace(p.table, p.role, p.fields, options).iterations);
  }
  EXPECT_LE(iterations.back(), 12);
  EXPECT_LE(iterations.back() - iterations.front(), 4);
}

TEST(Laplace, ReportsTheTrueResidual) {
  Problem p = ball_problem(40);
  Problem start = p;
  LaplaceOptions options;
  options.tolerance = 1e-12;
  const LaplaceOutcome outcome = solve_laplace(p.table, p.role, p.fields, options);
  ASSERT_TRUE(outcome.converged);
  for (std::size_t i = 0; i < p.role.size(); ++i)
    if (p.role[i] == CellRole::Outside) start.fields[0][i] = 0.0;
  const double before = laplace_residual(start.table, start.role, start.fields)[0];
  const double after = laplace_residual(p.table, p.role, p.fields)[0];
  EXPECT_NEAR(after / before, outcome.true_residual, 1e-3 * outcome.true_residual);
  EXPECT_LE(outcome.true_residual, 1e-12);
}

TEST(Laplace, SameBytesOnAnyNumberOfThreads) {
  Fields result[2];
  for (const int threads : {1, 2}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Problem p = ball_problem(48);
    solve_laplace(p.table, p.role, p.fields);
    result[threads - 1] = p.fields;
  }
  EXPECT_EQ(result[0], result[1]);
}

// Side by side or alone, a field goes through the same numbers: where memory asks it they are solved one after
// the other.
TEST(Laplace, EachFieldIsSolvedAsIfItWereAlone) {
  Problem together = ball_problem(40);
  together.fields.push_back(together.fields[0]);
  for (std::size_t i = 0; i < together.role.size(); ++i)
    together.fields[1][i] = together.role[i] == CellRole::Held ? std::sin(0.01 * double(i)) : 0.0;
  together.fields.emplace_back(together.role.size(), 0.0);
  const Problem start = together;
  LaplaceOptions options;
  options.tolerance = 1e-6;
  const LaplaceOutcome all = solve_laplace(together.table, together.role, together.fields, options);
  int most = 0;
  for (std::size_t f = 0; f < start.fields.size(); ++f) {
    Fields alone{start.fields[f]};
    const LaplaceOutcome one = solve_laplace(start.table, start.role, alone, options);
    EXPECT_TRUE(one.converged);
    EXPECT_EQ(alone[0], together.fields[f]);
    most = std::max(most, one.iterations);
  }
  EXPECT_TRUE(all.converged);
  EXPECT_EQ(all.iterations, most);
}

// A random mask on a small box, solved by a dense factorisation.
RC_GTEST_PROP(Laplace, EqualsADenseSolve, (unsigned seed)) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  const Cell cells(9, 4, 5);
  const BrickTable table = shapes::full_table(cells);
  std::vector<CellRole> role(table.cell_count(), CellRole::Outside);
  Fields fields(2, std::vector<double>(role.size(), 0.0));
  std::vector<int> number(role.size(), -1);
  int unknowns = 0;
  shapes::for_each_cell(table, [&](std::size_t i, const Cell& c) {
    const int draw = below(10);
    role[i] = draw < 2 ? CellRole::Held : draw < 4 ? CellRole::Outside : CellRole::Unknown;
    if (c.z() == 0) role[i] = CellRole::Held;
    if (role[i] == CellRole::Held)
      for (auto& f : fields) f[i] = below(200) / 50.0 - 2.0;
    if (role[i] == CellRole::Unknown) number[i] = unknowns++;
  });
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(unknowns, unknowns);
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(unknowns, 2);
  shapes::for_each_cell(table, [&](std::size_t i, const Cell& c) {
    if (number[i] < 0) return;
    for (int side = 0; side < 6; ++side) {
      Cell near = c;
      near[side / 2] += side % 2 == 0 ? -1 : 1;
      if ((near.array() >= cells.array()).any()) continue;
      const std::int64_t j = cell_index(table, near);
      if (j < 0 || role[j] == CellRole::Outside) continue;
      a(number[i], number[i]) += 1.0;
      if (number[j] >= 0) a(number[i], number[j]) -= 1.0;
      if (role[j] == CellRole::Held)
        for (int f = 0; f < 2; ++f) b(number[i], f) += fields[f][j];
    }
  });
  // least squares of least norm: parts of the mask that touch nothing held stay at their first
  // guess, 0
  const Eigen::MatrixXd x = a.completeOrthogonalDecomposition().solve(b);
  LaplaceOptions options;
  options.tolerance = 1e-11;
  RC_ASSERT(solve_laplace(table, role, fields, options).converged);
  for (std::size_t i = 0; i < role.size(); ++i)
    for (int f = 0; number[i] >= 0 && f < 2; ++f)
      RC_ASSERT(std::abs(fields[f][i] - x(number[i], f)) < 1e-7);
}

TEST(Laplace, BadInputIsNamed) {
  Problem p = ball_problem(8);
  LaplaceOptions options;
  options.tolerance = 0.0;
  EXPECT_THROW(solve_laplace(p.table, p.role, p.fields, options), InputError);
  p.fields[0].pop_back();
  EXPECT_THROW(solve_laplace(p.table, p.role, p.fields), InputError);
}

TEST(Laplace, CancelsBetweenIterations) {
  Problem p = ball_problem(16);
  const LaplaceOutcome outcome =
      solve_laplace(p.table, p.role, p.fields, {}, [](double) { return false; });
  EXPECT_TRUE(outcome.cancelled);
  EXPECT_FALSE(outcome.converged);
}

}  // namespace
}  // namespace patchmill::voxel
