// Small builders of nodes that the display's parts share: lines, points and triangles with a colour
// for each vertex. Positions are rounded to float: the scene graph's own precision.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"
#include "scene/colours.h"
#include "scene/inventor.h"

#include <vector>

namespace patchmill::scene {

inline Point3f single(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

/// Polylines end to end in one array of vertices, each with its colour.
struct Polylines {
  std::vector<Point3f> vertices;
  std::vector<Rgba> colours;
  std::vector<std::int32_t> lengths;  ///< vertices of each polyline; their sum is vertices.size()

  void add(const Vec3& point, Rgba colour) {
    vertices.push_back(single(point));
    colours.push_back(colour);
  }
  /// Ends a polyline whose vertices began at `first`; one of fewer than two is taken back.
  void close_from(std::size_t first);
};

/// Unlit lines of `width` pixels.
InventorNode line_node(const Polylines& lines, float width);

/// Unlit points of `size` pixels.
InventorNode point_node(const std::vector<Point3f>& points, const std::vector<Rgba>& colours,
                        float size);

struct Triangles {
  std::vector<Point3f> vertices;
  std::vector<Rgba> colours;          ///< one to a vertex
  std::vector<std::int32_t> corners;  ///< three vertex numbers and -1 for each triangle
};

/// Unlit triangles seen from both sides, drawn a little nearer than they are so that a face under
/// them does not shine through.
InventorNode triangle_node(const Triangles& triangles);

/// One of `children`, the finest first, by the pixels that it takes up: `areas`, one fewer than children, largest
/// first. It lies in a node kit, which actions that visit groups only pass over. Some of the host's, for preselection
/// and colours, carry neither matrices nor a viewport, and Coin's LevelOfDetail asks for both without looking.
InventorNode detail_node(const std::vector<float>& areas,
                         const std::vector<InventorNode>& children);

}  // namespace patchmill::scene
