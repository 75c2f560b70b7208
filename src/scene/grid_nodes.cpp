// Chunks of a surface at several resolutions; see grid_nodes.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/grid_nodes.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"
#include "scene/colours.h"
#include "scene/shapes.h"

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
// Steps of a depth buffer of 24 bits: 0.6 % of the view's depth, as much as the host's triangles of a bent face
// stand off it when they are coarse.
constexpr float kNearer = -1.0e5f;

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

/// The arrays of one copy of a chunk.
struct GridCopy {
  std::vector<Point3f> places, normals;
  std::vector<Rgba> colours;
  std::vector<std::int32_t> corners;
};

void add_vertices(GridCopy& copy, const Grid& grid, const std::vector<std::size_t>& rows,
                  const std::vector<std::size_t>& columns) {
  const double span = grid.high > grid.low ? grid.high - grid.low : 1.0;
  for (const std::size_t row : rows)
    for (const std::size_t column : columns) {
      const Vec3 place = grid.point(row, column);
      copy.places.push_back(place.allFinite() ? single(place) : Point3f{});
      copy.normals.push_back(single(normal_at(grid, row, column)));
      copy.colours.push_back(
          scale_colour((grid.values[row * grid.columns + column] - grid.low) / span));
    }
}

void add_corners(GridCopy& copy, const Grid& grid, const std::vector<std::size_t>& rows,
                 const std::vector<std::size_t>& columns) {
  const auto there = [&](std::size_t r, std::size_t c) {
    return grid.point(rows[r], columns[c]).allFinite();
  };
  const auto width = static_cast<std::int32_t>(columns.size());
  for (std::size_t r = 0; r + 1 < rows.size(); ++r)
    for (std::size_t c = 0; c + 1 < columns.size(); ++c) {
      if (!there(r, c) || !there(r, c + 1) || !there(r + 1, c) || !there(r + 1, c + 1)) continue;
      const auto a = static_cast<std::int32_t>(r * columns.size() + c);
      const std::int32_t b = a + 1, d = a + width, e = d + 1;
      copy.corners.insert(copy.corners.end(), {a, b, e, -1, a, e, d, -1});
    }
}

InventorNode node_of(const GridCopy& copy) {
  InventorNode property("VertexProperty");
  property.points("vertex", copy.places)
      .points("normal", copy.normals)
      .colours("orderedRGBA", copy.colours)
      .name("normalBinding", "PER_VERTEX_INDEXED")
      .name("materialBinding", "PER_VERTEX_INDEXED");
  InventorNode set("IndexedFaceSet");
  set.node("vertexProperty", property).integers("coordIndex", copy.corners);
  return set;
}

using GridChunk = std::array<GridCopy, kStrides.size()>;

GridChunk chunk_of(const Grid& grid, std::size_t row, std::size_t column) {
  GridChunk chunk;
  for (std::size_t i = 0; i < kStrides.size(); ++i) {
    const auto rows = picked(row, std::min(row + kCells, grid.rows - 1), kStrides[i]);
    const auto columns = picked(column, std::min(column + kCells, grid.columns - 1), kStrides[i]);
    add_vertices(chunk[i], grid, rows, columns);
    add_corners(chunk[i], grid, rows, columns);
  }
  return chunk;
}

InventorNode node_of(const GridChunk& chunk) {
  InventorNode hints("ShapeHints"), material("Material"), nearer("PolygonOffset");
  hints.name("vertexOrdering", "COUNTERCLOCKWISE")
      .name("shapeType", "UNKNOWN_SHAPE_TYPE")
      .name("faceType", "CONVEX");
  // matt: a highlight would look like a height
  material.points("specularColor", {Point3f{}});
  // than the host's own, coarser triangles of the same face
  nearer.number("factor", -1.0f).number("units", kNearer);
  std::vector<InventorNode> copies;
  for (const GridCopy& copy : chunk) copies.push_back(node_of(copy));
  return InventorNode("Separator")
      .child(hints)
      .child(material)
      .child(nearer)
      .child(detail_node({kPixels.begin(), kPixels.end()}, copies));
}

}  // namespace

Display grid_display(const Grid& grid) {
  if (grid.rows < 2 || grid.columns < 2)
    throw InputError("Grid", std::to_string(grid.rows) + " x " + std::to_string(grid.columns),
                     "give at least two rows and two columns.");
  const std::size_t down = (grid.rows - 2) / kCells + 1, across = (grid.columns - 2) / kCells + 1;
  Display display(down * across);
  patchmill::parallel_for(std::size_t{0}, display.size(), [&](std::size_t i) {
    const std::size_t row = i / across * kCells, column = i % across * kCells;
    display[i] = node_of(chunk_of(grid, row, column)).file();
  });
  return display;
}

}  // namespace patchmill::scene
