// Meshes and grids that the tests of voxel model and copy milling share.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/triangle_mesh.h"
#include "patchmill/voxel/laplace_level.h"

#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace patchmill::shapes {

/// Sphere by subdividing an octahedron `level` times: 8 * 4^level triangles, corners on the sphere.
inline mesh::TriangleMesh sphere(const Vec3& centre, double radius, int level) {
  mesh::TriangleMesh m;
  m.vertices = {Vec3::UnitX(),  -Vec3::UnitX(), Vec3::UnitY(),
                -Vec3::UnitY(), Vec3::UnitZ(),  -Vec3::UnitZ()};
  m.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                 {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int l = 0; l < level; ++l) {
    std::map<std::pair<int, int>, int> middle;
    const auto mid = [&](int a, int b) {
      const auto key = std::minmax(a, b);
      const auto [it, fresh] = middle.try_emplace(key, static_cast<int>(m.vertices.size()));
      if (fresh) m.vertices.push_back((m.vertices[a] + m.vertices[b]).normalized());
      return it->second;
    };
    std::vector<std::array<std::int32_t, 3>> finer;
    for (const auto& t : m.triangles) {
      const int ab = mid(t[0], t[1]), bc = mid(t[1], t[2]), ca = mid(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
    }
    m.triangles = std::move(finer);
  }
  for (Vec3& v : m.vertices) v = centre + radius * v;
  return m;
}

/// A closed solid over the rectangle [0, a] x [0, b]: its upper face is `top(u, v)`, u, v in [0,
/// 1], its bottom the plane z = 0 and its sides vertical strips. n x n quadrilaterals on top. The
/// border of `top` must lie over the border of the rectangle, but inside it the surface may
/// overhang.
inline mesh::TriangleMesh block_with_top(double a, double b, int n,
                                         const std::function<Vec3(double, double)>& top) {
  mesh::TriangleMesh m;
  const auto id = [&](int i, int j) { return j * (n + 1) + i; };
  const int count = (n + 1) * (n + 1);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) m.vertices.push_back(top(double(i) / n, double(j) / n));
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) m.vertices.emplace_back(a * i / n, b * j / n, 0.0);
  const auto quad = [&](int p, int q, int r, int s) {
    m.triangles.push_back({p, q, r});
    m.triangles.push_back({p, r, s});
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      quad(id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
      quad(count + id(i, j), count + id(i, j + 1), count + id(i + 1, j + 1), count + id(i + 1, j));
    }
  for (int i = 0; i < n; ++i) {
    quad(count + id(i, 0), count + id(i + 1, 0), id(i + 1, 0), id(i, 0));
    quad(count + id(i + 1, n), count + id(i, n), id(i, n), id(i + 1, n));
    quad(count + id(0, i + 1), count + id(0, i), id(0, i), id(0, i + 1));
    quad(count + id(n, i), count + id(n, i + 1), id(n, i + 1), id(n, i));
  }
  return m;
}

/// The smooth convex part of the feed experiment: a block 50 x 50 mm with a rounded hill.
inline mesh::TriangleMesh convex_part(int n) {
  return block_with_top(50, 50, n, [](double u, double v) {
    const double s = std::sin(kPi * u), t = std::sin(kPi * v);
    return Vec3(50 * u, 50 * v, 8.0 + 20.0 * s * t);
  });
}

/// The overhanging part of the posture experiment: a wave that leans over towards +x, more so with
/// y.
inline mesh::TriangleMesh overhanging_part(int n) {
  return block_with_top(60, 50, n, [](double u, double v) {
    const double bump = std::pow(std::sin(kPi * u), 2);
    const double lean = (20.0 + 10.0 * v) * bump;
    return Vec3(60 * u + lean * std::sin(kPi * u), 50 * v, 8.0 + 22.0 * bump);
  });
}

/// All bricks of a box of `cells`, stored.
inline voxel::BrickTable full_table(const voxel::Cell& cells) {
  const voxel::Cell box = voxel::brick_box(cells);
  return voxel::make_brick_table(cells, std::vector<std::uint8_t>(box.prod(), 1));
}

/// Calls `visit(index, cell)` for each cell of the table that lies in the box.
template <class Visit>
void for_each_cell(const voxel::BrickTable& table, const Visit& visit) {
  for (std::size_t b = 0; b < table.size(); ++b)
    for (int n = 0; n < voxel::kBrickCells; ++n) {
      const voxel::Cell cell = voxel::first_cell(table, b) + voxel::Cell(n % 8, n / 8 % 8, n / 64);
      if ((cell.array() < table.cells.array()).all()) visit(b * voxel::kBrickCells + n, cell);
    }
}

}  // namespace patchmill::shapes
