// The dales of a measured surface, as ISO 25178-2 (3.3, 6.9) has them: watershed segmentation, each point to the pit
// into which water would run from it, and Wolf pruning of the change tree: the dale that is shallowest over its lowest
// saddle is merged with the one beyond it, until none is shallower than a height. find_dimples() is for simulated
// reliefs, whose uncut ground belongs to no dale; here every known point belongs to one.
//
//     const std::vector<Dale> found = dales(heights, 0.05 * sz);
//
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <cstdint>
#include <vector>

namespace patchmill::marks {

/// Heights over a rectangular grid, row by row.
struct HeightGrid {
  std::vector<float> height;  ///< [mm], not finite where nothing is known; rows * columns of them
  int rows = 0, columns = 0;
  Vec2 step = Vec2::Ones();  ///< distance of points along a row and from row to row [mm]
};

/// One dale. Its depth, closed area and volume are those below its lowest saddle, the height at which it would
/// overflow.
struct Dale {
  std::int64_t pit = 0;  ///< number of its lowest point, row * columns + column
  double bottom = 0.0;   ///< height there [mm]
  double depth = 0.0;    ///< from there to the lowest saddle [mm]; infinite if it has no neighbour
  double area = 0.0;     ///< of all its points, a step by a step for each [mm²]
  double closed_area = 0.0;  ///< of those below the lowest saddle [mm²]
  double volume = 0.0;       ///< between them and the saddle's height [mm³]
  bool at_edge =
      false;  ///< whether its closed part meets the grid's border or a hole: what is seen is less than it
};

/// The dales that are at least `least_depth` deep [mm] over their lowest saddle, in order of their pits. Neighbours are
/// the eight around a point; which of several lower ones is steepest is seen as on a square grid. Equal heights go to
/// the lower number. About 40 bytes a point, and 300 for each pit of the surface as it is: smooth noise away first.
/// Errors: InputError naming Heights (not rows * columns, or fewer than 2 x 2), GridStep, or LeastDepth (negative or
/// not finite).
std::vector<Dale> dales(const HeightGrid& surface, double least_depth);

}  // namespace patchmill::marks
