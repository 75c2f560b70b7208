// Waves as triangles, for tests of meshes that are projected on.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/mesh_sampler.h"

#include <cmath>
#include <functional>
#include <random>

namespace patchmill::patch {

using Height = std::function<double(double, double)>;
constexpr double kHalf = 10.0;

// z = height(x, y) over [-kHalf, kHalf]², n x n fields of two triangles.
inline mesh::TriangleMesh field(int n, const Height& height) {
  mesh::TriangleMesh m;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = kHalf * (2.0 * i / n - 1.0), y = kHalf * (2.0 * j / n - 1.0);
      m.vertices.emplace_back(x, y, height(x, y));
    }
  for (std::int32_t j = 0; j < n; ++j)
    for (std::int32_t i = 0; i < n; ++i) {
      const std::int32_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
  return m;
}

inline double waves(double x, double y) {
  return std::sin(0.7 * x) * std::cos(0.5 * y);
}
inline Vec3 normal_of_waves(double x, double y) {
  return Vec3(-0.7 * std::cos(0.7 * x) * std::cos(0.5 * y),
              0.5 * std::sin(0.7 * x) * std::sin(0.5 * y), 1.0)
      .normalized();
}

inline MeshSampler sampler_on(const mesh::TriangleMesh& m,
                              const TexturePlane& plane = TexturePlane(), double steepest = 80.0,
                              double crease = 60.0) {
  return MeshSampler(std::make_shared<MeshSurface>(m, Angle::degrees(crease)), plane,
                     Angle::degrees(steepest));
}

inline std::vector<Vec2> random_places(int n, double half, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> xy(-half, half);
  std::vector<Vec2> places;
  for (int i = 0; i < n; ++i) {
    const double x = xy(random);
    places.emplace_back(x, xy(random));
  }
  return places;
}

}  // namespace patchmill::patch
