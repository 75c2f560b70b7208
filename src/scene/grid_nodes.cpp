// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/grid_nodes.h"

#include "core/geometry/error.h"
#include "scene/colours.h"
#include "scene/shapes.h"

#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoLevelOfDetail.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoVertexProperty.h>
#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace patchmill::scene {
namespace {

constexpr std::size_t kCells = 128;  // cells along the side of a chunk
// Strides of the copies, and the pixels of the screen over which the finer one is drawn.
constexpr std::array<std::size_t, 4> kStrides{1, 2, 4, 16};
constexpr std::array<float, 3> kPixels{200000.0f, 50000.0f, 6000.0f};

/// Rows (or columns) of a chunk from `first` to `last`, both included, every `stride`.
std::vector<std::size_t> picked(std::size_t first, std::size_t last, std::size_t stride) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = first; i < last; i += stride) numbers.push_back(i);
  numbers.push_back(last);
  return numbers;
}

/// Normal of the full grid at a point, by central differences; +z where there is none.
Vec3 normal_at(const Grid& grid, std::size_t row, std::size_t column) {
  const std::size_t up = std::min(row + 1, grid.rows - 1), down = row ? row - 1 : 0;
  const std::size_t right = std::min(column + 1, grid.columns - 1), left = column ? column - 1 : 0;
  const Vec3 normal = (grid.point(row, right) - grid.point(row, left))
                          .cross(grid.point(up, column) - grid.point(down, column));
  return normal.allFinite() && normal.squaredNorm() > 0.0 ? Vec3(normal.normalized())
                                                          : Vec3(Vec3::UnitZ());
}

SoVertexProperty* vertices_of(const Grid& grid, const std::vector<std::size_t>& rows,
                              const std::vector<std::size_t>& columns) {
  std::vector<SbVec3f> places, normals;
  std::vector<Rgba> colours;
  const double span = grid.high > grid.low ? grid.high - grid.low : 1.0;
  for (const std::size_t row : rows)
    for (const std::size_t column : columns) {
      const Vec3 place = grid.point(row, column);
      places.push_back(place.allFinite() ? single(place) : SbVec3f(0, 0, 0));
      normals.push_back(single(normal_at(grid, row, column)));
      colours.push_back(scale_colour((grid.values[row * grid.columns + column] - grid.low) / span));
    }
  auto* property = new SoVertexProperty;
  const int count = static_cast<int>(places.size());
  property->vertex.setValues(0, count, places.data());
  property->normal.setValues(0, count, normals.data());
  property->orderedRGBA.setValues(0, count, colours.data());
  property->normalBinding = SoVertexProperty::PER_VERTEX_INDEXED;
  property->materialBinding = SoVertexProperty::PER_VERTEX_INDEXED;
  return property;
}

SoIndexedFaceSet* chunk(const Grid& grid, const std::vector<std::size_t>& rows,
                        const std::vector<std::size_t>& columns) {
  std::vector<std::int32_t> corners;
  const auto number = [&](std::size_t r, std::size_t c) {
    return static_cast<std::int32_t>(r * columns.size() + c);
  };
  for (std::size_t r = 0; r + 1 < rows.size(); ++r)
    for (std::size_t c = 0; c + 1 < columns.size(); ++c) {
      const bool whole = grid.point(rows[r], columns[c]).allFinite() &&
                         grid.point(rows[r], columns[c + 1]).allFinite() &&
                         grid.point(rows[r + 1], columns[c]).allFinite() &&
                         grid.point(rows[r + 1], columns[c + 1]).allFinite();
      if (!whole) continue;
      const std::int32_t a = number(r, c), b = number(r, c + 1), d = number(r + 1, c);
      corners.insert(corners.end(), {a, b, b + (d - a), -1, a, b + (d - a), d, -1});
    }
  auto* set = new SoIndexedFaceSet;
  set->vertexProperty = vertices_of(grid, rows, columns);
  set->coordIndex.setValues(0, static_cast<int>(corners.size()), corners.data());
  return set;
}

}  // namespace

SoSeparator* grid_node(const Grid& grid) {
  if (grid.rows < 2 || grid.columns < 2)
    throw InputError("Grid", std::to_string(grid.rows) + " x " + std::to_string(grid.columns),
                     "give at least two rows and two columns.");
  auto* root = new SoSeparator;
  auto* hints = new SoShapeHints;
  hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  hints->shapeType = SoShapeHints::UNKNOWN_SHAPE_TYPE;
  hints->faceType = SoShapeHints::CONVEX;
  root->addChild(hints);
  for (std::size_t row = 0; row + 1 < grid.rows; row += kCells)
    for (std::size_t column = 0; column + 1 < grid.columns; column += kCells) {
      auto* detail = new SoLevelOfDetail;
      detail->screenArea.setValues(0, static_cast<int>(kPixels.size()), kPixels.data());
      for (const std::size_t stride : kStrides)
        detail->addChild(
            chunk(grid, picked(row, std::min(row + kCells, grid.rows - 1), stride),
                  picked(column, std::min(column + kCells, grid.columns - 1), stride)));
      auto* separator = new SoSeparator;
      separator->addChild(detail);
      root->addChild(separator);
    }
  return root;
}

}  // namespace patchmill::scene
