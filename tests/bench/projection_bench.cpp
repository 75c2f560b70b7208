// Projection of points on the Bezier face of Xu & Sasahara 2016, Table 1: FaceSampler against
// OpenCASCADE's IntCurvesFace_ShapeIntersector, in one run. Before any time is taken both are
// compared point by point. The counter `largest_difference_mm` is of that comparison.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_sampler.h"
#include "brep/faces.h"

#include <IntCurvesFace_ShapeIntersector.hxx>
#include <benchmark/benchmark.h>
#include <gp_Lin.hxx>
#include <tbb/global_control.h>

namespace patchmill {
namespace {

std::vector<Vec2> lattice(int n) {
  std::vector<Vec2> points;
  points.reserve(std::size_t(n) * std::size_t(n));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      points.emplace_back(-28 + 56.0 * i / (n - 1), -28 + 56.0 * j / (n - 1));
  return points;
}

double peer_z(IntCurvesFace_ShapeIntersector& peer, const Vec2& p) {
  peer.PerformNearest(gp_Lin(gp_Pnt(p.x(), p.y(), 100), gp_Dir(0, 0, -1)), 0, 200);
  return peer.NbPnt() > 0 ? peer.Pnt(1).Z() : -1e9;
}

void occt_intersector(benchmark::State& state) {
  IntCurvesFace_ShapeIntersector peer;
  peer.Load(table1_face(), 1e-9);
  const auto points = lattice(100);
  for (auto _ : state)
    for (const Vec2& p : points) benchmark::DoNotOptimize(peer_z(peer, p));
  state.SetItemsProcessed(state.iterations() * int64_t(points.size()));
}
BENCHMARK(occt_intersector)->Unit(benchmark::kMillisecond)->UseRealTime();

void face_sampler(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(state.range(0)));
  const FaceSampler sampler({table1_face()}, patch::TexturePlane(), Angle::degrees(80));
  IntCurvesFace_ShapeIntersector peer;
  peer.Load(table1_face(), 1e-9);
  const auto check = lattice(100);
  const auto hits = sampler.sample(check);
  double worst = 0.0;
  for (std::size_t i = 0; i < check.size(); ++i)
    worst = std::max(worst, std::abs(hits[i].point.position.z() - peer_z(peer, check[i])));
  const auto points = lattice(1000);
  for (auto _ : state) benchmark::DoNotOptimize(sampler.sample(points));
  state.SetItemsProcessed(state.iterations() * int64_t(points.size()));
  state.counters["largest_difference_mm"] = worst;
}
BENCHMARK(face_sampler)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace patchmill
