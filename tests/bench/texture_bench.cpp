// A whole texture, from a face to its ToolPath: a wavy B-spline face of 100 x 100 poles, square patches in helices or
// rows over the whole face, constant feed. Before it OpenCASCADE's intersector on the same face, as the peer: what a
// texture would take that only projected its dimples with it, and as the limit the path's moves written to memory on
// two threads, with nothing but a sine and a cosine for each dimple. Items are dimples. Counters: the share of each
// stage in per cent, `moves/s`, and `peak_MiB`, the most memory that the process had up to then. Each planning asks the
// system for its memory anew. Warmed up, for the first one does not measure planning where a virtual machine's host has
// taken free memory back: 200 MB of large pages then take 0.6 s, and 0.04 s from then on.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_sampler.h"
#include "brep/faces.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/patch/boundary.h"
#include "patchmill/patch/cover.h"
#include "patchmill/patch/patch_surface.h"
#include "patchmill/patch/row_order.h"
#include "patchmill/sync/constant_feed.h"
#include "patchmill/sync/contact_azimuth.h"

#include <chrono>
#include <sys/resource.h>

#include <IntCurvesFace_ShapeIntersector.hxx>
#include <benchmark/benchmark.h>
#include <gp_Lin.hxx>
#include <tbb/global_control.h>

namespace patchmill {
namespace {

constexpr int kPoles = 100;
constexpr double kSpacing = 0.5;

double side_for(std::int64_t dimples) {
  return kSpacing * std::sqrt(double(dimples));
}

double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024.0;
}

void occt_projection_alone(benchmark::State& state) {
  const double size = side_for(1000000);
  IntCurvesFace_ShapeIntersector peer;
  peer.Load(wavy_face(size, kPoles), 1e-9);
  constexpr int kSide = 20;
  for (auto _ : state)
    for (int i = 0; i < kSide * kSide; ++i) {
      const double x = (i % kSide + 0.5) / kSide - 0.5, y = (i / kSide + 0.5) / kSide - 0.5;
      peer.PerformNearest(gp_Lin(gp_Pnt(x * size, y * size, size), gp_Dir(0, 0, -1)), 0, 2 * size);
      benchmark::DoNotOptimize(peer.NbPnt());
    }
  state.SetItemsProcessed(state.iterations() * kSide * kSide);
}
BENCHMARK(occt_projection_alone)->Unit(benchmark::kMillisecond)->UseRealTime();

// A place on a sphere for each dimple, and the two moves that end on it.
void moves_written_alone(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 2);
  constexpr std::size_t kDimples = 1000000;
  std::vector<Move> moves(2 * kDimples);
  for (auto _ : state) {
    parallel_for(tbb::blocked_range<std::size_t>(0, kDimples, 1024), [&](const auto& range) {
      for (std::size_t k = range.begin(); k < range.end(); ++k) {
        const double angle = 1e-3 * double(k);
        const Vec3 tip(std::cos(angle), std::sin(angle), angle);
        moves[2 * k] = {{tip, Vec3::UnitZ()}, angle, kNoDimple, MoveKind::Cut};
        moves[2 * k + 1] = {
            {tip, Vec3::UnitZ()}, angle, static_cast<std::int32_t>(k), MoveKind::Cut};
      }
    });
    benchmark::DoNotOptimize(moves.data());
    benchmark::ClobberMemory();
  }
  state.counters["moves/s"] =
      benchmark::Counter(double(state.iterations()) * 2.0 * kDimples, benchmark::Counter::kIsRate);
}
BENCHMARK(moves_written_alone)->Unit(benchmark::kMillisecond)->UseRealTime();

struct Stopwatch {
  std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last).count();
    last = now;
    return seconds;
  }
};

// {preparing the face, projecting, limits and order, path} [s]
std::array<double, 4> face_to_path(const TopoDS_Face& face, double size, bool rows,
                                   std::int64_t& dimples_made, std::size_t& moves_made) {
  const patch::TexturePlane plane;
  std::array<double, 4> seconds{};
  Stopwatch watch;
  const FaceSampler sampler({face}, plane, Angle::degrees(80));
  seconds[0] = watch.lap();
  const Vec2 half = Vec2::Constant(0.5 * size);
  const patch::PatchDivision division =
      patch::cover({patch::PatchShape::Square, kSpacing, 14}, patch::Box2(-half, half));
  const patch::SurfaceSampler sample = [&](const std::vector<Vec2>& places) {
    return sampler.sample(places);
  };
  patch::Dimples dimples = *patch::sample_patches(division, plane, sample, {});
  seconds[1] = watch.lap();
  sync::mark_tool_tip(dimples, Vec3::UnitZ(), Angle::degrees(1));
  patch::drop_slivers(dimples, 10);
  if (rows) dimples = patch::in_rows(dimples, patch::lattice_of(patch::PatchShape::Square), {});
  seconds[2] = watch.lap();
  sync::PhaseRule rule{sync::FluteChoice::Same, 5.0, {}};
  const ToolPath path =
      sync::constant_feed_path(dimples, {1.0, 2}, {1000.0 / 60.0, SpindleSense::M3},
                               {434.413 / 60.0, rule, size, size + 1.0}, Decimals(3));
  benchmark::DoNotOptimize(path.moves.data());
  moves_made = path.moves.size();
  seconds[3] = watch.lap();
  dimples_made = patch::count_states(dimples)[0];
  return seconds;
}

void texture(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(state.range(1)));
  const double size = side_for(state.range(0));
  const TopoDS_Face face = wavy_face(size, kPoles);
  std::array<double, 4> sums{};
  std::int64_t dimples = 0;
  std::size_t moves = 0;
  for (auto _ : state) {
    const auto seconds = face_to_path(face, size, state.range(2) != 0, dimples, moves);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += seconds[i];
  }
  state.SetItemsProcessed(state.iterations() * dimples);
  const double all = sums[0] + sums[1] + sums[2] + sums[3];
  const char* names[] = {"prepare_%", "project_%", "order_%", "path_%"};
  for (std::size_t i = 0; i < sums.size(); ++i) state.counters[names[i]] = 100.0 * sums[i] / all;
  state.counters["moves/s"] =
      benchmark::Counter(double(state.iterations()) * double(moves), benchmark::Counter::kIsRate);
  state.counters["peak_MiB"] = peak_mib();
}
BENCHMARK(texture)
    ->ArgNames({"dimples", "threads", "rows"})
    ->ArgsProduct({{10000, 100000, 1000000}, {2}, {0, 1}})
    ->Args({1000000, 1, 0})
    ->Args({1000000, 1, 1})
    ->MinTime(2.0)
    ->MinWarmUpTime(1.0)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(texture)
    ->ArgNames({"dimples", "threads", "rows"})
    ->Args({10000000, 2, 0})
    ->Args({10000000, 2, 1})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace patchmill
