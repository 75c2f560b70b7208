// Throughput of patch division: lattice points in milling order, patch surfaces and lattices on the
// surface over waves with a formula (so that the division's own share shows), borders and masks.
// `formula_alone` is the sampler by itself, the limit of what the others can reach. Items are lattice
// points.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/patch/analytic_surfaces.h"
#include "patchmill/patch/boundary.h"
#include "patchmill/patch/cover.h"
#include "patchmill/patch/mask.h"
#include "patchmill/patch/patch_surface.h"
#include "patchmill/patch/surface_lattice.h"

#include <benchmark/benchmark.h>

namespace patchmill {
namespace {

const patch::TexturePlane kPlane;

patch::SurfaceSampler sampler() {
  return analytic::by_rays(kPlane, analytic::waves(1.0, 25.0));
}

// About `points` lattice points on a square area.
patch::PatchDivision division(patch::PatchShape shape, std::int64_t points) {
  const double half = 0.25 * std::sqrt(double(points));
  const int size = shape == patch::PatchShape::Square    ? 14
                   : shape == patch::PatchShape::Hexagon ? 8
                                                         : 20;
  return patch::cover({shape, 0.5, size}, patch::Box2(Vec2(-half, -half), Vec2(half, half)));
}

void count(benchmark::State& state, std::size_t points) {
  state.SetItemsProcessed(state.iterations() * std::int64_t(points));
}

void divide(benchmark::State& state) {
  const auto shape = patch::PatchShape(state.range(0));
  std::size_t points = 0;
  for (auto _ : state) {
    const patch::Dimples dimples = patch::lattice_points(division(shape, state.range(1)));
    points = dimples.size();
    benchmark::DoNotOptimize(dimples.data());
  }
  count(state, points);
}
BENCHMARK(divide)->ArgsProduct({{0, 1, 2}, {1000000}})->Unit(benchmark::kMillisecond);
BENCHMARK(divide)->ArgsProduct({{0}, {10000, 100000, 10000000}})->Unit(benchmark::kMillisecond);

void formula_alone(benchmark::State& state) {
  const patch::PatchDivision d = division(patch::PatchShape::Square, state.range(0));
  std::vector<Vec2> places;
  for (const patch::Dimple& dimple : patch::lattice_points(d))
    places.push_back(patch::place(d, dimple.lattice));
  const patch::SurfaceSampler on = sampler();
  for (auto _ : state) benchmark::DoNotOptimize(on(places).data());
  count(state, places.size());
}
BENCHMARK(formula_alone)->Arg(1000000)->Unit(benchmark::kMillisecond);

void sample(benchmark::State& state) {
  const patch::PatchDivision d = division(patch::PatchShape::Square, 1000000);
  const patch::SurfaceSampler on = sampler();
  std::size_t points = 0;
  for (auto _ : state) {
    const auto dimples = patch::sample_patches(d, kPlane, on, {patch::SurfaceKind(state.range(0))});
    points = dimples->size();
  }
  count(state, points);
}
BENCHMARK(sample)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->UseRealTime();

void borders(benchmark::State& state) {
  const patch::Dimples all =
      *patch::sample_patches(division(patch::PatchShape::Square, 1000000), kPlane, sampler(), {});
  std::vector<patch::Segment3> edges;
  for (int n = 0; n < 4000; ++n)
    edges.push_back({Vec3(-250 + 0.125 * n, -200, 0), Vec3(-250 + 0.125 * (n + 1), -200, 0)});
  for (auto _ : state) {
    patch::Dimples dimples = all;
    patch::limit_steepness(dimples, kPlane.direction, Angle::degrees(60));
    patch::keep_off_edges(dimples, edges, 1.0);
    patch::drop_slivers(dimples, 10);
    benchmark::DoNotOptimize(dimples.data());
  }
  count(state, all.size());
}
BENCHMARK(borders)->Unit(benchmark::kMillisecond)->UseRealTime();

void curve(benchmark::State& state) {
  const patch::PatchDivision d = division(patch::PatchShape::Square, 1000000);
  const patch::Dimples all = *patch::sample_patches(d, kPlane, sampler(), {});
  patch::Polygon star;
  for (int n = 0; n < 2000; ++n) {
    const double t = 2 * kPi * n / 2000, r = 150 + 80 * std::cos(9 * t);
    star.push_back({r * std::cos(t), r * std::sin(t)});
  }
  const auto place_of = [&](const Vec2& lattice) { return patch::place(d, lattice); };
  for (auto _ : state) {
    patch::Dimples dimples = all;
    patch::keep_where(dimples, place_of, patch::curve_mask({star}));
    benchmark::DoNotOptimize(dimples.data());
  }
  count(state, all.size());
}
BENCHMARK(curve)->Unit(benchmark::kMillisecond);

void net(benchmark::State& state) {
  const double half = 0.25 * std::sqrt(double(state.range(0)));
  const patch::LatticeRequest request{patch::LatticeKind::Square, 0.5, Vec2::Zero(),
                                      patch::Box2(Vec2(-half, -half), Vec2(half, half))};
  const patch::SurfaceSampler on = sampler();
  for (auto _ : state) benchmark::DoNotOptimize(patch::chebyshev_net(request, kPlane, on)->flat);
  count(state, std::size_t(state.range(0)));
}
BENCHMARK(net)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

void low_distortion(benchmark::State& state) {
  const double half = 0.25 * std::sqrt(double(state.range(0)));
  const patch::LatticeRequest request{patch::LatticeKind::Triangular, 0.5, Vec2::Zero(),
                                      patch::Box2(Vec2(-half, -half), Vec2(half, half))};
  const patch::SurfaceSampler on = sampler();
  for (auto _ : state)
    benchmark::DoNotOptimize(patch::low_distortion_lattice(request, kPlane, on)->flat);
  count(state, std::size_t(state.range(0)));
}
BENCHMARK(low_distortion)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace patchmill
