// Relief: the machined surface as a height field, its deviation from a base surface along the
// base's normal. The base is the texture plane, or a curved surface seen from it: one place per
// grid cell, found along the plane's projection direction.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"
#include "patchmill/patch/sampler.h"
#include "patchmill/patch/texture_plane.h"

#include <cstdint>
#include <vector>

namespace patchmill::marks {

using Vec3f = Eigen::Vector3f;

/// A grid of cells over a texture plane. Cell (i, j) is column i, row j, and stands at plane
/// coordinates first + step * (i, j); its number is j * columns + i.
struct SurfaceGrid {
  patch::TexturePlane plane;
  Vec2 first = Vec2::Zero();  ///< of cell (0, 0) [mm]
  double step = 0.0;          ///< [mm], both ways
  int columns = 0, rows = 0;
  /// Curved base: distance from the plane to the base along plane.direction [mm], one per cell, NaN
  /// where there is no base; and the unit normal out of the material. Both empty: the base is the
  /// plane.
  std::vector<double> sag;
  std::vector<Vec3f> normal;

  /// Whether the base is another than the plane.
  bool curved() const { return !sag.empty(); }
  /// How many cells it has.
  std::int64_t cells() const { return static_cast<std::int64_t>(columns) * rows; }
  /// Number of cell (i, j).
  std::int64_t number(int i, int j) const { return static_cast<std::int64_t>(j) * columns + i; }
  /// Plane coordinates of cell (i, j) [mm].
  Vec2 plane_point(int i, int j) const { return first + step * Vec2(i, j); }
};

/// Unit normal of the plane itself, out of the material: at right angles to the plane, against
/// plane.direction.
Vec3 plane_normal(const patch::TexturePlane& plane);

/// Place [mm] and unit normal of the base at a cell; NaN where the base is missing.
Vec3 base_point(const SurfaceGrid& grid, int i, int j);
Vec3 base_normal(const SurfaceGrid& grid, int i, int j);

/// A flat grid that covers plane coordinates `low` to `high` with cells of `step` [mm].
/// Errors: InputError naming GridStep (not positive), GridSize (high below low, or over 2^31 - 1
/// columns or rows).
SurfaceGrid flat_grid(const patch::TexturePlane& plane, const Vec2& low, const Vec2& high,
                      double step);

/// A flat grid that covers all of `places` (plane coordinates, not empty) and `margin` more [mm].
/// Errors: as flat_grid; GridSize if there are no places.
SurfaceGrid grid_around(const patch::TexturePlane& plane, const std::vector<Vec2>& places,
                        double margin, double step);

/// The same grid over a curved base: places and normals as the sampler finds them along the plane's
/// direction, missing where it finds no face (on_face).
SurfaceGrid curved_grid(SurfaceGrid flat, const patch::SurfaceSampler& sampler);

/// Rows `first_row` .. `first_row + rows` of a grid, as a grid of its own.
SurfaceGrid row_band(const SurfaceGrid& grid, int first_row, int rows);

/// Errors: InputError naming GridStep, GridSize, or GridBase (sizes of sag and normal).
void require_valid(const SurfaceGrid& grid);

/// The surface that the tool leaves over a grid.
struct Relief {
  SurfaceGrid grid;
  double stock = 0.0;  ///< height of the surface before cutting [mm]
  /// Deviation from the base along its normal [mm], out of the material positive; one per cell; NaN
  /// where there is no base.
  std::vector<float> height;

  /// Height at cell (i, j) [mm]; NaN where there is no base.
  float at(int i, int j) const { return height[static_cast<std::size_t>(grid.number(i, j))]; }
};

/// The machined surface at a cell [mm], work frame.
Vec3 relief_point(const Relief& relief, int i, int j);

}  // namespace patchmill::marks
