// Builders of Coin nodes; see shapes.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/shapes.h"

#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoPointSet.h>
#include <Inventor/nodes/SoPolygonOffset.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoVertexProperty.h>

namespace patchmill::scene {
namespace {

SoSeparator* unlit() {
  auto* separator = new SoSeparator;
  auto* light = new SoLightModel;
  light->model = SoLightModel::BASE_COLOR;
  separator->addChild(light);
  return separator;
}

SoVertexProperty* coloured(const std::vector<SbVec3f>& vertices, const std::vector<Rgba>& colours,
                           SoVertexProperty::Binding binding) {
  auto* property = new SoVertexProperty;
  property->vertex.setValues(0, static_cast<int>(vertices.size()), vertices.data());
  property->orderedRGBA.setValues(0, static_cast<int>(colours.size()), colours.data());
  property->materialBinding = binding;
  return property;
}

}  // namespace

void Polylines::close_from(std::size_t first) {
  const std::size_t count = vertices.size() - first;
  if (count >= 2) {
    lengths.push_back(static_cast<int>(count));
  } else {
    vertices.resize(first);
    colours.resize(first);
  }
}

SoSeparator* line_node(const Polylines& lines, float width) {
  SoSeparator* separator = unlit();
  if (lines.lengths.empty()) return separator;
  auto* style = new SoDrawStyle;
  style->lineWidth = width;
  separator->addChild(style);
  auto* set = new SoLineSet;
  set->vertexProperty = coloured(lines.vertices, lines.colours, SoVertexProperty::PER_VERTEX);
  set->numVertices.setValues(0, static_cast<int>(lines.lengths.size()), lines.lengths.data());
  separator->addChild(set);
  return separator;
}

SoSeparator* point_node(const std::vector<SbVec3f>& points, const std::vector<Rgba>& colours,
                        float size) {
  SoSeparator* separator = unlit();
  if (points.empty()) return separator;
  auto* style = new SoDrawStyle;
  style->pointSize = size;
  separator->addChild(style);
  auto* set = new SoPointSet;
  set->vertexProperty = coloured(points, colours, SoVertexProperty::PER_VERTEX);
  separator->addChild(set);
  return separator;
}

SoSeparator* triangle_node(const Triangles& triangles) {
  SoSeparator* separator = unlit();
  if (triangles.corners.empty()) return separator;
  auto* hints = new SoShapeHints;
  hints->vertexOrdering = SoShapeHints::UNKNOWN_ORDERING;
  hints->faceType = SoShapeHints::CONVEX;
  separator->addChild(hints);
  auto* nearer = new SoPolygonOffset;
  nearer->factor = -1.0f;
  nearer->units = -4.0f;
  separator->addChild(nearer);
  auto* set = new SoIndexedFaceSet;
  set->vertexProperty =
      coloured(triangles.vertices, triangles.colours, SoVertexProperty::PER_VERTEX_INDEXED);
  set->coordIndex.setValues(0, static_cast<int>(triangles.corners.size()),
                            triangles.corners.data());
  separator->addChild(set);
  return separator;
}

}  // namespace patchmill::scene
