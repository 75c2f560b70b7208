// Neighbours over edges, and what is reached over them; see mesh_region.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/mesh/mesh_region.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/mesh/triangle_bvh.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <tbb/parallel_sort.h>

namespace patchmill::mesh {
namespace {

// A side of a triangle: its ends, the lower number first, and 3 x triangle + side.
struct Side {
  std::int32_t a, b;
  std::int64_t of;
  bool operator<(const Side& o) const {
    if (a != o.a) return a < o.a;
    return b != o.b ? b < o.b : of < o.of;
  }
  bool same_edge(const Side& o) const { return a == o.a && b == o.b; }
};

// Sorted, so that those of one edge stand together.
std::vector<Side> sides_of(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax({mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3]});
      if (a != b) sides.push_back({a, b, static_cast<std::int64_t>(3 * i + k)});
    }
  stop_point();
  tbb::parallel_sort(sides.begin(), sides.end());
  stop_point();
  return sides;
}

// The first of the sides from `at` on that has another edge.
std::size_t end_of_edge(const std::vector<Side>& sides, std::size_t at) {
  std::size_t end = at + 1;
  while (end < sides.size() && sides[end].same_edge(sides[at])) ++end;
  return end;
}

Vec3 normal_of(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  const Vec3& a = mesh.vertices[std::size_t(t[0])];
  return (mesh.vertices[std::size_t(t[1])] - a)
      .cross(mesh.vertices[std::size_t(t[2])] - a)
      .normalized();
}

}  // namespace

std::vector<std::int32_t> region_around(const TriangleMesh& mesh, std::int32_t seed, Angle angle) {
  const std::size_t count = mesh.triangles.size();
  if (seed < 0 || std::size_t(seed) >= count)
    throw InputError("Seed", fmt::format("{}", seed),
                     fmt::format("give the number of a triangle, 0 to {}.", count - 1));
  require_in_range("Angle", angle.degrees(), 0.0, 180.0, "degrees");
  const std::vector<Side> sides = sides_of(mesh);
  std::vector<std::size_t> place(3 * count, sides.size());  // of the first side of the edge
  for (std::size_t i = 0; i < sides.size();) {
    const std::size_t end = end_of_edge(sides, i);
    for (std::size_t j = i; j < end; ++j) place[std::size_t(sides[j].of)] = i;
    i = end;
  }
  const double least = std::cos(angle.radians()) - 1e-12;
  std::vector<char> taken(count, 0);
  std::vector<std::pair<std::int32_t, Vec3>> todo{{seed, normal_of(mesh, std::size_t(seed))}};
  taken[std::size_t(seed)] = 1;
  for (std::size_t next = 0; next < todo.size(); ++next) {
    if (next % 4096 == 0) stop_point();
    const auto [triangle, normal] = todo[next];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t first = place[3 * std::size_t(triangle) + k];
      for (std::size_t j = first; j < sides.size() && sides[j].same_edge(sides[first]); ++j) {
        const std::size_t other = std::size_t(sides[j].of) / 3;
        if (taken[other]) continue;
        Vec3 theirs = normal_of(mesh, other);
        if (theirs.isZero(0.0)) theirs = normal;
        if (!normal.isZero(0.0) && theirs.dot(normal) < least) continue;
        taken[other] = 1;
        todo.emplace_back(static_cast<std::int32_t>(other), theirs);
      }
    }
  }
  std::vector<std::int32_t> region;
  for (std::size_t i = 0; i < count; ++i)
    if (taken[i]) region.push_back(static_cast<std::int32_t>(i));
  return region;
}

std::int32_t nearest_triangle(const TriangleMesh& mesh, const Vec3& point) {
  std::int32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 4096 == 0) stop_point();
    const auto& t = mesh.triangles[i];
    const Triangle triangle{mesh.vertices[std::size_t(t[0])], mesh.vertices[std::size_t(t[1])],
                            mesh.vertices[std::size_t(t[2])]};
    const double distance = (closest_on(triangle, point) - point).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    nearest = static_cast<std::int32_t>(i);
  }
  return nearest;
}

TriangleMesh part_of(const TriangleMesh& mesh, const std::vector<std::int32_t>& triangles) {
  if (triangles.empty())
    throw InputError("Triangles", "none", "give the numbers of those that are meant.");
  TriangleMesh part;
  std::vector<std::int32_t> number(mesh.vertices.size(), -1);
  part.triangles.reserve(triangles.size());
  for (const std::int32_t i : triangles) {
    if (i < 0 || std::size_t(i) >= mesh.triangles.size())
      throw InputError("Triangles", fmt::format("{}", i),
                       fmt::format("give numbers of 0 to {}.", mesh.triangles.size() - 1));
    std::array<std::int32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = std::size_t(mesh.triangles[std::size_t(i)][k]);
      if (number[v] < 0) {
        number[v] = static_cast<std::int32_t>(part.vertices.size());
        part.vertices.push_back(mesh.vertices[v]);
      }
      corners[k] = number[v];
    }
    part.triangles.push_back(corners);
  }
  return part;
}

std::vector<std::array<Vec3, 2>> border_edges(const TriangleMesh& mesh) {
  const std::vector<Side> sides = sides_of(mesh);
  std::vector<std::array<Vec3, 2>> border;
  for (std::size_t i = 0; i < sides.size();) {
    const std::size_t end = end_of_edge(sides, i);
    if (end - i == 1)
      border.push_back(
          {mesh.vertices[std::size_t(sides[i].a)], mesh.vertices[std::size_t(sides[i].b)]});
    i = end;
  }
  return border;
}

}  // namespace patchmill::mesh
