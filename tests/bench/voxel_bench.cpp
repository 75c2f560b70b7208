// Steady diffusion on a masked voxel grid, both posture angles, and voxelisation: PatchMill against
// OpenVDB (Poisson solver with its incomplete Cholesky preconditioner; meshToLevelSet) and Eigen's
// conjugate gradients, in one run, at the same residual. Every solver's result is put through the same
// residual (counter `residual`, relative, in the 2-norm); items are unknown voxels, each with its two
// fields. The peers are told the tolerance, in their own norms, that brings the residual to 1e-6.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/voxel/shapes.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel_problem.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#ifdef PATCHMILL_HAVE_OPENVDB
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/PoissonSolver.h>
#endif

namespace patchmill {
namespace {

constexpr double kTolerance = 1e-6;

void report(benchmark::State& state, const MaskedProblem& p,
            const std::vector<std::vector<double>>& x, int iterations) {
  state.SetItemsProcessed(state.iterations() * int64_t(p.unknowns));
  state.counters["unknowns"] = double(p.unknowns);
  state.counters["per_voxel"] =
      benchmark::Counter(double(p.unknowns), benchmark::Counter::kIsIterationInvariantRate |
                                                 benchmark::Counter::kInvert);
  state.counters["iterations"] = iterations;
  state.counters["residual"] = relative_residual(p, x);
}

#ifdef PATCHMILL_HAVE_OPENVDB
openvdb::Coord coord(const voxel::Cell& c) {
  return {c.x(), c.y(), c.z()};
}

void openvdb_poisson(benchmark::State& state) {
  namespace pcg = openvdb::math::pcg;
  const MaskedProblem p = masked_problem(int(state.range(0)));
  openvdb::DoubleTree domain(0.0);
  shapes::for_each_cell(p.table, [&](std::size_t i, const voxel::Cell& c) {
    if (p.role[i] == voxel::CellRole::Unknown) domain.setValueOn(coord(c), 0.0);
  });
  auto x = p.fields;
  int iterations = 0;
  for (auto _ : state)
    for (std::size_t f = 0; f < 2; ++f) {
      const auto boundary = [&](const openvdb::Coord&, const openvdb::Coord& near, double& source,
                                double& diagonal) {
        const std::int64_t j =
            voxel::cell_index(p.table, voxel::Cell(near.x(), near.y(), near.z()));
        if (j < 0 || p.role[std::size_t(j)] != voxel::CellRole::Held) return;
        source -= p.fields[f][std::size_t(j)];
        diagonal -= 1.0;
      };
      auto limits = pcg::terminationDefaults<double>();
      limits.iterations = 10000;
      limits.absoluteError = 0.0;
      limits.relativeError = 0.2 * kTolerance;  // of the largest entry
      openvdb::util::NullInterrupter never;
      const auto solved = openvdb::tools::poisson::solveWithBoundaryConditionsAndPreconditioner<
          pcg::IncompleteCholeskyPreconditioner<openvdb::tools::poisson::LaplacianMatrix>>(
          domain, boundary, limits, never, /*staggered=*/true);
      state.PauseTiming();
      shapes::for_each_cell(p.table, [&](std::size_t i, const voxel::Cell& c) {
        if (p.role[i] == voxel::CellRole::Unknown) x[f][i] = solved->getValue(coord(c));
      });
      iterations = limits.iterations;
      state.ResumeTiming();
    }
  report(state, p, x, iterations);
}
#endif

void eigen_cg(benchmark::State& state) {
  const MaskedProblem p = masked_problem(int(state.range(0)));
  std::vector<int> number(p.role.size(), -1);
  int count = 0;
  for (std::size_t i = 0; i < p.role.size(); ++i)
    if (p.role[i] == voxel::CellRole::Unknown) number[i] = count++;
  auto x = p.fields;
  int iterations = 0;
  for (auto _ : state) {
    Eigen::SparseMatrix<double, Eigen::RowMajor> a(count, count);
    a.reserve(Eigen::VectorXi::Constant(count, 7));
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(count, 2);
    shapes::for_each_cell(p.table, [&](std::size_t i, const voxel::Cell& c) {
      if (number[i] < 0) return;
      double diagonal = 0.0;
      for (int side = 0; side < 6; ++side) {
        voxel::Cell near = c;
        near[side / 2] += side % 2 == 0 ? -1 : 1;
        const std::int64_t j = voxel::cell_index(p.table, near);
        if (j < 0 || p.role[std::size_t(j)] == voxel::CellRole::Outside) continue;
        diagonal += 1.0;
        if (number[std::size_t(j)] >= 0)
          a.insert(number[i], number[std::size_t(j)]) = -1.0;
        else
          for (int f = 0; f < 2; ++f) b(number[i], f) += p.fields[std::size_t(f)][std::size_t(j)];
      }
      a.insert(number[i], number[i]) = diagonal;
    });
    a.makeCompressed();
    Eigen::ConjugateGradient<decltype(a), Eigen::Lower | Eigen::Upper> solver(a);
    solver.setTolerance(kTolerance);
    const Eigen::MatrixXd solved = solver.solve(b);
    state.PauseTiming();
    iterations = int(solver.iterations());
    for (std::size_t i = 0; i < p.role.size(); ++i)
      for (int f = 0; number[i] >= 0 && f < 2; ++f) x[std::size_t(f)][i] = solved(number[i], f);
    state.ResumeTiming();
  }
  report(state, p, x, iterations);
}

void patchmill_laplace(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(state.range(1)));
  const MaskedProblem p = masked_problem(int(state.range(0)));
  voxel::LaplaceOptions options;
  options.tolerance = kTolerance;
  auto x = p.fields;
  voxel::LaplaceOutcome outcome;
  for (auto _ : state) {
    state.PauseTiming();
    x = p.fields;
    state.ResumeTiming();
    outcome = voxel::solve_laplace(p.table, p.role, x, options);
  }
  report(state, p, x, outcome.iterations);
}

// A sphere of 32,768 triangles in a box of n^3 voxels.
struct SphereInBox {
  mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Constant(-1), Vec3::Constant(1));
  mesh::TriangleMesh part = shapes::sphere(Vec3(0.01, 0.02, 0.03), 0.8, 6);
};

#ifdef PATCHMILL_HAVE_OPENVDB
// Signed distances within a voxel of the sphere, and which tiles beyond are inside; with `mask` also what the
// voxel model needs to know of each voxel: the set of those inside.
void openvdb_level_set(benchmark::State& state, bool mask) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(state.range(1)));
  const SphereInBox solids;
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  for (const Vec3& v : solids.part.vertices)
    points.emplace_back(float(v.x()), float(v.y()), float(v.z()));
  for (const auto& t : solids.part.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  const auto transform =
      openvdb::math::Transform::createLinearTransform(2.0 / double(state.range(0)));
  for (auto _ : state) {
    const auto level =
        openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, points, triangles, 1.0f);
    if (mask) benchmark::DoNotOptimize(openvdb::tools::sdfInteriorMask(*level));
  }
  state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(0) * state.range(0));
}
void openvdb_mesh_to_level_set(benchmark::State& state) {
  openvdb_level_set(state, false);
}
void openvdb_mesh_to_interior_mask(benchmark::State& state) {
  openvdb_level_set(state, true);
}
#endif

// Every voxel of box less sphere stored, with its kind: Removal, Surface, Exterior; Part and Air around.
void patchmill_voxelise(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(state.range(1)));
  const SphereInBox solids;
  voxel::VoxelOptions options;
  options.pitch = 2.0 / double(state.range(0));
  options.memory_limit = 1e12;
  for (auto _ : state)
    benchmark::DoNotOptimize(voxel::voxelise(solids.stock, solids.part, options));
  state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(0) * state.range(0));
}

// 1, 5, 20 and 88 million unknowns; the last is a box of 10^8 voxels
constexpr int kMillion = 106, kFiveMillion = 181, kTwentyMillion = 287, kBox = 464;

void peers_sizes(benchmark::internal::Benchmark* b) {
  for (const int size : {kMillion, kFiveMillion, kTwentyMillion}) b->Arg(size);
  b->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);
}
void our_sizes(benchmark::internal::Benchmark* b) {
  b->ArgsProduct({{kMillion, kFiveMillion, kTwentyMillion, kBox}, {1, 2}});
  b->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);
}
void box_sides(benchmark::internal::Benchmark* b) {
  b->ArgsProduct({{64, 256, 512, 1024}, {1, 2}});
  b->UseRealTime()->Unit(benchmark::kMillisecond);
}

#ifdef PATCHMILL_HAVE_OPENVDB
BENCHMARK(openvdb_poisson)->Apply(peers_sizes);
#endif
BENCHMARK(eigen_cg)->Apply(peers_sizes);
BENCHMARK(patchmill_laplace)->Apply(our_sizes);
#ifdef PATCHMILL_HAVE_OPENVDB
BENCHMARK(openvdb_mesh_to_level_set)->Apply(box_sides);
BENCHMARK(openvdb_mesh_to_interior_mask)->Apply(box_sides);
#endif
BENCHMARK(patchmill_voxelise)->Apply(box_sides);

}  // namespace
}  // namespace patchmill
