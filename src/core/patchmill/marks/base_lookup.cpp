// Base under a ball; see base_lookup.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/base_lookup.h"

#include <algorithm>
#include <cmath>

namespace patchmill::marks {
namespace {

constexpr int kLookUps = 4;

int nearest_index(double coordinate, int count) {
  return static_cast<int>(std::clamp(std::round(coordinate), 0.0, static_cast<double>(count - 1)));
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
    int last = -1;
    for (int k = 0; k < kLookUps; ++k) {
      const Vec2 at = (project(grid.plane, centre - radius * base.normal) - grid.first) / grid.step;
      const int i = nearest_index(at.x(), grid.columns), j = nearest_index(at.y(), grid.rows);
      const int cell = static_cast<int>(grid.number(i, j));
      if (cell == last) break;
      last = cell;
      const Vec3 place = base_point(grid, i, j);
      base.found = std::isfinite(place.z());
      if (!base.found) break;
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
