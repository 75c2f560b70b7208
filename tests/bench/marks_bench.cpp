// Speed of the cutter-mark simulator: flute-cell evaluations per second, on one and two threads,
// against the arithmetic limit of one core measured in the same run; what a dimple costs as dimples and
// area grow; and one million dimples on a 0.02 mm grid.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/simulate.h"

#include <sys/resource.h>

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

namespace patchmill {
namespace {

constexpr double kSpacing = 0.5;  // of the dimples [mm]

/// Rows of dimples to and fro, one tooth of a two-flute mill per dimple, R = 1.
ToolPath rows(int columns, int count, double tilt) {
  ToolPath path;
  path.tool = {1.0, 2};
  path.spindle = {1000.0 / 60.0, SpindleSense::M3};
  const Vec3 axis(std::sin(tilt), 0.0, std::cos(tilt));
  const auto pose = [&](int i, int j) {
    const int column = j % 2 == 0 ? i : columns - 1 - i;
    return pose_of_ball({column * kSpacing, j * kSpacing, 1.0}, axis, 1.0);
  };
  path.start = pose(0, 0);
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < columns; ++i)
      path.moves.push_back({pose(i, j), 0.5, j * columns + i, MoveKind::Cut});
  return path;
}

marks::SurfaceGrid grid_over(int columns, int count, double step) {
  patch::TexturePlane plane;
  return marks::flat_grid(plane, {0.0, 0.0}, {columns * kSpacing, count * kSpacing}, step);
}

/// Single-precision operations of one evaluation: three Newton steps of 92 (three divisions and a
/// square root among them, counted as one each) and the height and tests of 30.
constexpr double kOperations = 3 * 92 + 30;

using Lanes = float __attribute__((vector_size(64)));

#if defined(__x86_64__) && defined(__ELF__)
__attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif
void
chains(Lanes* v, int rounds) {
  Lanes a = v[0], b = v[1], c = v[2], d = v[3], e = v[4], f = v[5], g = v[6], h = v[7];
  const Lanes k = v[8], m = v[9];
  for (int i = 0; i < rounds; ++i) {
    a = a * k, b = b + m, c = c * k, d = d + m, e = e * k, f = f + m, g = g * k, h = h + m;
  }
  v[0] = a + b + c + d + e + f + g + h;
}

/// The limit: additions and multiplications per second of one core with nothing else to do, in
/// eight independent chains; shown as evaluations per second at kOperations each.
void arithmetic_limit(benchmark::State& state) {
  Lanes v[10] = {};
  for (auto& lanes : v) lanes += 1.0f;
  for (auto _ : state) {
    chains(v, 100000);
    benchmark::DoNotOptimize(v);
  }
  state.counters["evaluations/s"] =
      benchmark::Counter(100000.0 * 8 * 16 / kOperations * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
}
BENCHMARK(arithmetic_limit);

void flute_cells(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(0)));
  const ToolPath path = rows(80, 80, static_cast<double>(state.range(1)) * kPi / 180.0);
  const marks::ToolMotion motion = marks::motion_of(path);
  const marks::SurfaceGrid grid = grid_over(80, 80, 0.02);
  std::int64_t evaluations = 0, dimples = 0;
  for (auto _ : state) {
    const marks::SimulatedRelief out =
        marks::simulate_marks(motion, {path.tool, {}, {}}, grid, {0.08});
    evaluations += out.statistics.evaluations;
    dimples += static_cast<std::int64_t>(path.moves.size());
  }
  state.counters["evaluations/s"] =
      benchmark::Counter(static_cast<double>(evaluations), benchmark::Counter::kIsRate);
  state.counters["dimples/s"] =
      benchmark::Counter(static_cast<double>(dimples), benchmark::Counter::kIsRate);
  state.counters["evaluations/dimple"] =
      static_cast<double>(evaluations) / static_cast<double>(dimples);
}
// threads, tilt in degrees: at 30 the feed is so fast that cells near the tip are searched as well
BENCHMARK(flute_cells)
    ->Args({1, 45})
    ->Args({2, 45})
    ->Args({1, 30})
    ->Args({2, 30})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// So many dimples a side on a grid of so many: what is looked at is the dimples, not the area.
void dimples_on_area(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1);
  const int side = static_cast<int>(state.range(0)), area = static_cast<int>(state.range(1));
  const ToolPath path = rows(side, side, kPi / 4);
  const marks::ToolMotion motion = marks::motion_of(path);
  const marks::SurfaceGrid grid = grid_over(area, area, 0.02);
  std::int64_t dimples = 0, evaluations = 0;
  for (auto _ : state) {
    const marks::SimulatedRelief out =
        marks::simulate_marks(motion, {path.tool, {}, {}}, grid, {0.08});
    dimples += static_cast<std::int64_t>(path.moves.size());
    evaluations += out.statistics.evaluations;
  }
  state.counters["dimples/s"] =
      benchmark::Counter(static_cast<double>(dimples), benchmark::Counter::kIsRate);
  state.counters["evaluations/dimple"] =
      static_cast<double>(evaluations) / static_cast<double>(dimples);
}
BENCHMARK(dimples_on_area)
    ->Args({40, 160})
    ->Args({80, 160})
    ->Args({160, 160})
    ->Args({40, 80})
    ->Args({40, 40})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void million_dimples(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  for (auto _ : state) {
    const ToolPath path = rows(side, side, kPi / 4);
    const marks::ToolMotion motion = marks::motion_of(path);
    const marks::SurfaceGrid grid = grid_over(side, side, 0.02);
    double lowest = 0.0;
    const marks::MarkStatistics statistics = marks::simulate_bands(
        motion, {path.tool, {}, {}}, grid, {0.08}, 1024, 0, [&](const marks::ReliefBand& band) {
          for (const float h : band.relief.height) lowest = std::min<double>(lowest, h);
        });
    benchmark::DoNotOptimize(lowest);
    state.counters["evaluations/s"] = benchmark::Counter(
        static_cast<double>(statistics.evaluations), benchmark::Counter::kIsIterationInvariantRate);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak GiB"] = static_cast<double>(usage.ru_maxrss) / 1048576.0;
}
BENCHMARK(million_dimples)
    ->Arg(100)
    ->Arg(1000)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace patchmill
