// Grids over a texture plane and the reliefs on them; see relief.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/relief.h"

#include "patchmill/geometry/error.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace patchmill::marks {

Vec3 plane_normal(const patch::TexturePlane& plane) {
  const Vec3 n = plane.x_axis.cross(plane.y_axis).normalized();
  return n.dot(plane.direction) < 0.0 ? n : Vec3(-n);
}

Vec3 base_point(const SurfaceGrid& grid, int i, int j) {
  const Vec3 p = grid.plane.at(grid.plane_point(i, j));
  if (!grid.curved()) return p;
  return p + grid.sag[static_cast<std::size_t>(grid.number(i, j))] * grid.plane.direction;
}

Vec3 base_normal(const SurfaceGrid& grid, int i, int j) {
  if (!grid.curved()) return plane_normal(grid.plane);
  return grid.normal[static_cast<std::size_t>(grid.number(i, j))].cast<double>();
}

SurfaceGrid flat_grid(const patch::TexturePlane& plane, const Vec2& low, const Vec2& high,
                      double step) {
  require_positive("GridStep", step, "mm");
  const Vec2 cells = (high - low) / step;
  const double most = std::numeric_limits<int>::max() - 1;
  if (!(cells.minCoeff() >= 0.0) || !(cells.maxCoeff() < most))
    throw InputError("GridSize", fmt::format("{:.6g} x {:.6g} cells", cells.x(), cells.y()),
                     "the upper corner must not lie below the lower one, nor too far from it.");
  SurfaceGrid grid;
  grid.plane = plane;
  grid.first = low;
  grid.step = step;
  grid.columns = 1 + static_cast<int>(std::ceil(cells.x() - 1e-9));
  grid.rows = 1 + static_cast<int>(std::ceil(cells.y() - 1e-9));
  return grid;
}

SurfaceGrid grid_around(const patch::TexturePlane& plane, const std::vector<Vec2>& places,
                        double margin, double step) {
  if (places.empty())
    throw InputError("GridSize", "no places", "there must be a dimple to look at.");
  Vec2 low = places.front(), high = low;
  for (const Vec2& p : places) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return flat_grid(plane, low.array() - margin, high.array() + margin, step);
}

SurfaceGrid curved_grid(SurfaceGrid grid, const patch::SurfaceSampler& sampler) {
  require_valid(grid);
  std::vector<Vec2> row(static_cast<std::size_t>(grid.columns));
  grid.sag.clear();
  grid.normal.clear();
  for (int j = 0; j < grid.rows; ++j) {
    for (int i = 0; i < grid.columns; ++i)
      row[static_cast<std::size_t>(i)] = grid.plane_point(i, j);
    const std::vector<patch::SurfaceSample> samples = sampler(row);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool there = patch::on_face(samples[i].state);
      const Vec3 from = samples[i].point.position - grid.plane.at(row[i]);
      grid.sag.push_back(there ? from.dot(grid.plane.direction)
                               : std::numeric_limits<double>::quiet_NaN());
      grid.normal.push_back(there ? Vec3f(samples[i].point.normal.cast<float>()) : Vec3f::UnitZ());
    }
  }
  return grid;
}

SurfaceGrid row_band(const SurfaceGrid& grid, int first_row, int rows) {
  SurfaceGrid band;
  band.plane = grid.plane;
  band.first = grid.plane_point(0, first_row);
  band.step = grid.step;
  band.columns = grid.columns;
  band.rows = rows;
  if (grid.curved()) {
    const auto from = grid.number(0, first_row), to = grid.number(0, first_row + rows);
    band.sag.assign(grid.sag.begin() + from, grid.sag.begin() + to);
    band.normal.assign(grid.normal.begin() + from, grid.normal.begin() + to);
  }
  return band;
}

void require_valid(const SurfaceGrid& grid) {
  require_positive("GridStep", grid.step, "mm");
  if (grid.columns < 1 || grid.rows < 1)
    throw InputError("GridSize", fmt::format("{} x {}", grid.columns, grid.rows),
                     "a grid needs at least one cell.");
  const auto cells = static_cast<std::size_t>(grid.cells());
  if (grid.sag.size() != grid.normal.size() || (grid.curved() && grid.sag.size() != cells))
    throw InputError("GridBase",
                     fmt::format("{} sags and {} normals", grid.sag.size(), grid.normal.size()),
                     fmt::format("a curved base needs {} of each, a flat one none.", cells));
}

Vec3 relief_point(const Relief& relief, int i, int j) {
  return base_point(relief.grid, i, j) + relief.at(i, j) * base_normal(relief.grid, i, j);
}

}  // namespace patchmill::marks
