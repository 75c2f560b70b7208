// Base under a ball; see base_lookup.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/base_lookup.h"

#include "patchmill/geometry/angle.h"

#include <algorithm>
#include <cmath>

namespace patchmill::marks {
namespace {

constexpr int kLookUps = 4;
constexpr int kRings = 16;  // within a ball's radius, on which a base is looked for beside a gap

int nearest_index(double coordinate, int count) {
  return static_cast<int>(std::clamp(std::round(coordinate), 0.0, static_cast<double>(count - 1)));
}

bool has_base(const SurfaceGrid& grid, int i, int j) {
  return std::isfinite(grid.sag[static_cast<std::size_t>(grid.number(i, j))]);
}

/// A cell with a base near `at`, in cells from the first one, not farther than about `reach`; -1: none.
std::int64_t cell_near(const SurfaceGrid& grid, const Vec2& at, double reach) {
  const Vec2 last(grid.columns - 1.0, grid.rows - 1.0);
  const Vec2 inside = at.cwiseMax(0.0).cwiseMin(last);
  const int i = nearest_index(inside.x(), grid.columns), j = nearest_index(inside.y(), grid.rows);
  if (has_base(grid, i, j)) return grid.number(i, j);
  if ((at - inside).norm() > reach) return -1;
  for (int ring = 1; ring <= kRings; ++ring) {
    const double radius = std::max(reach * ring / kRings, static_cast<double>(ring));
    for (int k = 0; k < 8 * ring; ++k) {
      const double angle = 0.25 * kPi * k / ring;
      const Vec2 there = at + radius * Vec2(std::cos(angle), std::sin(angle));
      if ((there.array() < -0.5).any() || ((there - last).array() > 0.5).any()) continue;
      const int u = nearest_index(there.x(), grid.columns);
      const int v = nearest_index(there.y(), grid.rows);
      if (has_base(grid, u, v)) return grid.number(u, v);
    }
  }
  return -1;
}

}  // namespace

Vec2 project(const patch::TexturePlane& plane, const Vec3& point) {
  const Vec3 n = plane_normal(plane);
  const Vec3 from = point - plane.origin;
  const Vec3 on_plane = from - plane.direction * (from.dot(n) / plane.direction.dot(n));
  return {on_plane.dot(plane.x_axis), on_plane.dot(plane.y_axis)};
}

BaseUnder base_under(const SurfaceGrid& grid, const Vec3& centre, double radius) {
  BaseUnder base;
  base.normal = plane_normal(grid.plane);
  base.found = true;
  if (grid.curved()) {
    std::int64_t last = -1;
    for (int k = 0; k < kLookUps; ++k) {
      const Vec2 at = (project(grid.plane, centre - radius * base.normal) - grid.first) / grid.step;
      const std::int64_t cell = cell_near(grid, at, radius / grid.step);
      base.found = cell >= 0;
      if (!base.found || cell == last) break;
      last = cell;
      const int i = static_cast<int>(cell % grid.columns),
                j = static_cast<int>(cell / grid.columns);
      const Vec3 place = base_point(grid, i, j);
      base.normal = base_normal(grid, i, j);
      base.foot = centre - (centre - place).dot(base.normal) * base.normal;
    }
    if (base.found) return base;
    base.normal = plane_normal(grid.plane);
  }
  base.foot = centre - (centre - grid.plane.origin).dot(base.normal) * base.normal;
  return base;
}

}  // namespace patchmill::marks
