// clear_axis over the overhanging part of the posture experiment (28,880 triangles): at places along a section,
// the ball on the surface, a shank and a holder of 30 mm above it; and in a pit where no axis is clear. The peer
// asks the distance of a dense sampling (1 mm) of the holder's surface for one axis. Items are places.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/voxel/shapes.h"
#include "patchmill/collision/clear_axis.h"

#include <cmath>

#include <benchmark/benchmark.h>

namespace patchmill {
namespace {

const std::vector<collision::HolderSection> kHolder{{3.0, 8.0, 2.5, 2.5}, {8.0, 40.0, 15.0, 15.0}};

struct Places {
  mesh::TriangleBvh part{shapes::overhanging_part(120)};
  std::vector<Vec3> centre, wanted;

  Places() {
    const auto surface = [](double u) {
      const double bump = std::pow(std::sin(kPi * u), 2), lean = 28.0 * bump;
      return Vec3(60 * u + lean * std::sin(kPi * u), 40.0, 8.0 + 22.0 * bump);
    };
    for (double u = 0.02; u < 0.98; u += 0.01) {
      const Vec3 d = surface(u + 1e-5) - surface(u - 1e-5);
      const Vec3 normal = Vec3(-d.z(), 0, d.x()).normalized(), c = surface(u) + 3.0 * normal;
      if (mesh::closest_point(part, c).distance < 2.9) continue;
      centre.push_back(c);
      wanted.push_back(Vec3(normal.x(), 0, std::max(0.35, normal.z())).normalized());
    }
  }
};

void sampling_of_one_axis(benchmark::State& state) {
  const Places places;
  for (auto _ : state)
    for (std::size_t i = 0; i < places.centre.size(); ++i) {
      const Vec3 u = any_normal_to(places.wanted[i]), v = places.wanted[i].cross(u);
      double least = 2.0;
      for (const collision::HolderSection& s : kHolder)
        for (double h = s.from; h <= s.to; h += 1.0)
          for (double a = 0.0; a < 2.0 * kPi; a += 1.0 / s.radius_from) {
            const Vec3 p = places.centre[i] + h * places.wanted[i] +
                           s.radius_from * (std::cos(a) * u + std::sin(a) * v);
            least = std::min(least, mesh::closest_point(places.part, p, least).distance);
          }
      benchmark::DoNotOptimize(least);
    }
  state.SetItemsProcessed(state.iterations() * int64_t(places.centre.size()));
}

void patchmill_clear_axis(benchmark::State& state) {
  const Places places;
  std::int64_t kept = 0, yielded = 0, none = 0;
  double turned = 0.0;
  for (auto _ : state) {
    kept = yielded = none = 0;
    turned = 0.0;
    for (std::size_t i = 0; i < places.centre.size(); ++i) {
      const collision::ClearAxis found =
          collision::clear_axis(places.part, kHolder, places.centre[i], places.wanted[i]);
      (!found.clear ? none : found.axis == places.wanted[i] ? kept : yielded) += 1;
      turned += std::acos(std::min(1.0, found.axis.dot(places.wanted[i])));
    }
  }
  state.SetItemsProcessed(state.iterations() * int64_t(places.centre.size()));
  state.counters["kept"] = double(kept);
  state.counters["yielded"] = double(yielded);
  state.counters["none"] = double(none);
  state.counters["degrees"] = Angle::radians(turned).degrees();
}

void patchmill_clear_axis_in_a_pit(benchmark::State& state) {
  const mesh::TriangleBvh pit(shapes::block_with_top(100, 100, 120, [](double u, double v) {
    const double r = std::hypot(100 * u - 50, 100 * v - 50);
    return Vec3(100 * u, 100 * v, r < 8 ? 10.0 : 60.0);
  }));
  bool clear = false;
  for (auto _ : state)
    clear =
        collision::clear_axis(pit, kHolder, Vec3(50, 50, 14), Vec3(0.1, 0.2, 1).normalized()).clear;
  state.SetItemsProcessed(state.iterations());
  state.counters["clear"] = clear;
}

BENCHMARK(sampling_of_one_axis)->Unit(benchmark::kMillisecond);
BENCHMARK(patchmill_clear_axis)->Unit(benchmark::kMillisecond);
BENCHMARK(patchmill_clear_axis_in_a_pit)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace patchmill
