// Builders of nodes; see shapes.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/shapes.h"

namespace patchmill::scene {
namespace {

InventorNode unlit() {
  InventorNode separator("Separator");
  separator.child(InventorNode("LightModel").name("model", "BASE_COLOR"));
  return separator;
}

InventorNode coloured(const std::vector<Point3f>& vertices, const std::vector<Rgba>& colours,
                      std::string_view binding) {
  InventorNode property("VertexProperty");
  property.points("vertex", vertices)
      .colours("orderedRGBA", colours)
      .name("materialBinding", binding);
  return property;
}

}  // namespace

void Polylines::close_from(std::size_t first) {
  const std::size_t count = vertices.size() - first;
  if (count >= 2) {
    lengths.push_back(static_cast<std::int32_t>(count));
  } else {
    vertices.resize(first);
    colours.resize(first);
  }
}

InventorNode line_node(const Polylines& lines, float width) {
  InventorNode separator = unlit();
  if (lines.lengths.empty()) return separator;
  separator.child(InventorNode("DrawStyle").number("lineWidth", width));
  separator.child(InventorNode("LineSet")
                      .node("vertexProperty", coloured(lines.vertices, lines.colours, "PER_VERTEX"))
                      .integers("numVertices", lines.lengths));
  return separator;
}

InventorNode point_node(const std::vector<Point3f>& points, const std::vector<Rgba>& colours,
                        float size) {
  InventorNode separator = unlit();
  if (points.empty()) return separator;
  separator.child(InventorNode("DrawStyle").number("pointSize", size));
  separator.child(
      InventorNode("PointSet").node("vertexProperty", coloured(points, colours, "PER_VERTEX")));
  return separator;
}

InventorNode triangle_node(const Triangles& triangles) {
  InventorNode separator = unlit();
  if (triangles.corners.empty()) return separator;
  separator.child(InventorNode("ShapeHints")
                      .name("vertexOrdering", "UNKNOWN_ORDERING")
                      .name("faceType", "CONVEX"));
  separator.child(InventorNode("PolygonOffset").number("factor", -1.0f).number("units", -4.0f));
  separator.child(InventorNode("IndexedFaceSet")
                      .node("vertexProperty",
                            coloured(triangles.vertices, triangles.colours, "PER_VERTEX_INDEXED"))
                      .integers("coordIndex", triangles.corners));
  return separator;
}

InventorNode detail_node(const std::vector<float>& areas,
                         const std::vector<InventorNode>& children) {
  InventorNode detail("LevelOfDetail"), contents("Separator"), kit("WrapperKit");
  detail.numbers("screenArea", areas);
  for (const InventorNode& child : children) detail.child(child);
  contents.child(detail);
  kit.node("contents", contents);
  return kit;
}

}  // namespace patchmill::scene
