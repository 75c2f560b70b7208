// A ball of 3 mm dropped on a hill of 50 x 50 mm, along scanning lines and at random, by the number of
// triangles: PatchMill's tree of bounds against the plain way, which tries every triangle under the ball
// from a grid of buckets of one ball diameter. Before time is taken both are compared at 500 points (counter
// `largest_difference_mm`). Along lines each search begins with the triangle of the point before, as copy
// milling does it. One thread; items are points.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/copy/drop_cutter.h"
#include "core/voxel/shapes.h"

#include <random>

#include <benchmark/benchmark.h>

namespace patchmill {
namespace {

constexpr double kRadius = 3.0;

std::vector<Vec2> random_points(std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 50);
  std::vector<Vec2> points(count);
  for (Vec2& p : points) {
    p.x() = place(random);
    p.y() = place(random);
  }
  return points;
}

// Points 0.05 mm apart on lines 0.25 mm apart, as copy milling drops them.
std::vector<Vec2> scanning_points(std::size_t count) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < count; ++i)
    points.emplace_back(0.05 * double(i % 1000), 0.25 * double(i / 1000));
  return points;
}

// Buckets of one diameter over the part; each holds the triangles that a ball over it can touch.
struct Buckets {
  static constexpr int kSide = 9;
  std::vector<TriangleBvh> bucket;

  explicit Buckets(const TriangleMesh& mesh) {
    for (int n = 0; n < kSide * kSide; ++n) {
      const Vec2 lo(6.0 * (n % kSide) - kRadius, 6.0 * (n / kSide) - kRadius);
      TriangleMesh near;
      near.vertices = mesh.vertices;
      for (const auto& t : mesh.triangles) {
        Box box;
        for (const auto v : t) box.include(mesh.vertices[std::size_t(v)]);
        const Vec2 hi = lo + Vec2::Constant(6.0 + 2 * kRadius);
        if ((box.lo.head<2>().array() <= hi.array()).all() &&
            (box.hi.head<2>().array() >= lo.array()).all())
          near.triangles.push_back(t);
      }
      bucket.emplace_back(near);
    }
  }

  double drop(const Vec2& p) const {
    const TriangleBvh& near = bucket[std::size_t(int(p.y() / 6.0) * kSide + int(p.x() / 6.0))];
    double best = kNoContact;
    for (const Triangle& t : near.triangles())
      best = std::max(best, drop_ball_on(t, p.x(), p.y(), kRadius));
    return best;
  }
};

TriangleMesh hill(benchmark::State& state) {
  return shapes::convex_part(int(state.range(0)));
}

void every_triangle_under_the_ball(benchmark::State& state) {
  const TriangleMesh mesh = hill(state);
  const Buckets buckets(mesh);
  const auto points = random_points(2000);
  for (auto _ : state)
    for (const Vec2& p : points) benchmark::DoNotOptimize(buckets.drop(p));
  state.SetItemsProcessed(state.iterations() * int64_t(points.size()));
  state.counters["triangles"] = double(mesh.triangles.size());
}

void patchmill_drop_ball(benchmark::State& state) {
  const TriangleMesh mesh = hill(state);
  const TriangleBvh bvh(mesh);
  const Buckets buckets(mesh);
  double worst = 0.0;
  for (const Vec2& p : random_points(500))
    worst = std::max(worst, std::abs(drop_ball(bvh, p.x(), p.y(), kRadius) - buckets.drop(p)));
  const bool lines = state.range(1) == 0;
  const auto points = lines ? scanning_points(200000) : random_points(200000);
  for (auto _ : state) {
    DropHint before;
    for (const Vec2& p : points) {
      benchmark::DoNotOptimize(drop_ball(bvh, p.x(), p.y(), kRadius, before));
      if (!lines) before = {};
    }
  }
  state.SetItemsProcessed(state.iterations() * int64_t(points.size()));
  state.counters["triangles"] = double(mesh.triangles.size());
  state.counters["largest_difference_mm"] = worst;
}

// 1,152, 20,160 and 125,312 triangles; 0: along lines, 1: at random
BENCHMARK(every_triangle_under_the_ball)->Arg(70)->Arg(16)->Arg(176)->Unit(benchmark::kMillisecond);
BENCHMARK(patchmill_drop_ball)->ArgsProduct({{16, 70, 176}, {0, 1}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace patchmill
