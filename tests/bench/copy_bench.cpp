// A ball of 3 mm dropped on hills of 50 x 50 mm, by the number of triangles, which grows because one hill is meshed
// finer, or because there are more hills side by side. PatchMill's probe, along scanning lines as in copy milling, and
// its search from the root of the tree at random places, against the plain way, which tries every triangle under the
// ball from a grid of buckets of one ball diameter. Besides, the probe is compared with all triangles at 220 places
// of the same lines (counter `largest_difference_mm`). One thread; items are points.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/voxel/shapes.h"
#include "patchmill/copy/drop_probe.h"

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

// Points 0.05 mm apart on 40 lines over so many hills side by side, as copy milling drops them.
std::vector<Vec2> scanning_points(int hills) {
  std::vector<Vec2> points;
  for (int line = 0; line < 40; ++line)
    for (int i = 0; i < 1000 * hills; ++i) points.emplace_back(0.05 * i, 1.25 * line);
  return points;
}

// Blocks with a hill, in a row along x.
mesh::TriangleMesh hills_in_a_row(int hills, int fineness) {
  const mesh::TriangleMesh one = shapes::convex_part(fineness);
  mesh::TriangleMesh row;
  for (int h = 0; h < hills; ++h) {
    const auto first = static_cast<std::int32_t>(row.vertices.size());
    for (const Vec3& v : one.vertices) row.vertices.push_back(v + Vec3(50.0 * h, 0, 0));
    for (const auto& t : one.triangles)
      row.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return row;
}

// Buckets of one diameter over the part; each holds the triangles that a ball over it can touch.
struct Buckets {
  static constexpr int kSide = 9;
  std::vector<mesh::TriangleBvh> bucket;

  explicit Buckets(const mesh::TriangleMesh& mesh) {
    for (int n = 0; n < kSide * kSide; ++n) {
      const Vec2 lo(6.0 * (n % kSide) - kRadius, 6.0 * (n / kSide) - kRadius);
      mesh::TriangleMesh near;
      near.vertices = mesh.vertices;
      for (const auto& t : mesh.triangles) {
        mesh::Box box;
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
    const mesh::TriangleBvh& near =
        bucket[std::size_t(int(p.y() / 6.0) * kSide + int(p.x() / 6.0))];
    double best = copy::kNoContact;
    for (const mesh::Triangle& t : near.triangles())
      best = std::max(best, copy::drop_ball_on(t, p.x(), p.y(), kRadius));
    return best;
  }
};

void every_triangle_under_the_ball(benchmark::State& state) {
  const mesh::TriangleMesh mesh = hills_in_a_row(1, int(state.range(0)));
  const Buckets buckets(mesh);
  const auto points = random_points(2000);
  for (auto _ : state)
    for (const Vec2& p : points) benchmark::DoNotOptimize(buckets.drop(p));
  state.SetItemsProcessed(state.iterations() * int64_t(points.size()));
  state.counters["triangles"] = double(mesh.triangles.size());
}

double largest_difference(const mesh::TriangleBvh& bvh, const std::vector<Vec2>& points) {
  copy::DropProbe probe(bvh, kRadius);
  double worst = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double z = probe(points[i].x(), points[i].y());
    if (i % (points.size() / 20) > 10) continue;
    double largest = copy::kNoContact;
    for (const mesh::Triangle& t : bvh.triangles())
      largest = std::max(largest, copy::drop_ball_on(t, points[i].x(), points[i].y(), kRadius));
    worst = std::max(worst, std::abs(z - largest));
  }
  return worst;
}

// Along lines; with a new probe each time.
void patchmill_probe(benchmark::State& state) {
  const int hills = int(state.range(1));
  const mesh::TriangleMesh mesh = hills_in_a_row(hills, int(state.range(0)));
  const mesh::TriangleBvh bvh(mesh);
  const auto points = scanning_points(hills);
  for (auto _ : state) {
    copy::DropProbe probe(bvh, kRadius);
    for (const Vec2& p : points) benchmark::DoNotOptimize(probe(p.x(), p.y()));
  }
  state.SetItemsProcessed(state.iterations() * int64_t(points.size()));
  state.counters["triangles"] = double(mesh.triangles.size());
  state.counters["largest_difference_mm"] = largest_difference(bvh, points);
}

// At random, each place from the root.
void patchmill_drop_ball(benchmark::State& state) {
  const mesh::TriangleMesh mesh = hills_in_a_row(1, int(state.range(0)));
  const mesh::TriangleBvh bvh(mesh);
  const auto points = random_points(200000);
  for (auto _ : state)
    for (const Vec2& p : points)
      benchmark::DoNotOptimize(copy::drop_ball(bvh, p.x(), p.y(), kRadius));
  state.SetItemsProcessed(state.iterations() * int64_t(points.size()));
  state.counters["triangles"] = double(mesh.triangles.size());
}

// fineness 16, 70 and 176: 1,152, 20,160 and 125,312 triangles a hill; 18 and 109 hills of 16: 20,736 and 125,568
BENCHMARK(every_triangle_under_the_ball)->Arg(70)->Arg(16)->Arg(176)->Unit(benchmark::kMillisecond);
BENCHMARK(patchmill_probe)
    ->ArgNames({"fineness", "hills"})
    ->Args({16, 1})
    ->Args({70, 1})
    ->Args({176, 1})
    ->Args({16, 18})
    ->Args({16, 109})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(patchmill_drop_ball)->Arg(16)->Arg(70)->Arg(176)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace patchmill
