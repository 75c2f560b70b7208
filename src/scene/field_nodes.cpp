// Slices and arrows of fields; see field_nodes.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/field_nodes.h"

#include "patchmill/geometry/error.h"
#include "scene/shapes.h"

#include <string>

namespace patchmill::scene {
namespace {

// Squares side by side overlap by so much: in single precision their edges would leave gaps of a pixel.
constexpr double kOverlap = 1.004;

void require_same(const char* what, std::size_t given, std::size_t wanted) {
  if (given != wanted) throw InputError(what, std::to_string(given), "give as many as places.");
}

double share(double value, double low, double high) {
  return high > low ? (value - low) / (high - low) : 0.5;
}

}  // namespace

Display slice_display(const std::vector<Vec3>& centres, const std::vector<double>& values,
                      double side, int axis, double low, double high) {
  require_same("values", values.size(), centres.size());
  if (axis < 0 || axis > 2) throw InputError("axis", std::to_string(axis), "give 0, 1 or 2.");
  const double half = 0.5 * side * kOverlap;
  const Vec3 a = half * Vec3::Unit((axis + 1) % 3), b = half * Vec3::Unit((axis + 2) % 3);
  Triangles triangles;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const auto first = static_cast<std::int32_t>(triangles.vertices.size());
    const Vec3& c = centres[i];
    for (const Vec3& corner :
         {Vec3(c - a - b), Vec3(c + a - b), Vec3(c + a + b), Vec3(c - a + b)}) {
      triangles.vertices.push_back(single(corner));
      triangles.colours.push_back(scale_colour(share(values[i], low, high)));
    }
    triangles.corners.insert(triangles.corners.end(),
                             {first, first + 1, first + 2, -1, first, first + 2, first + 3, -1});
  }
  return {triangle_node(triangles).file()};
}

Display arrow_display(const std::vector<Vec3>& places, const std::vector<Vec3>& vectors,
                      double scale, const std::vector<double>& values, double low, double high) {
  require_same("vectors", vectors.size(), places.size());
  require_same("values", values.size(), places.size());
  Polylines lines;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3 along = scale * vectors[i];
    if (!along.allFinite() || along.isZero()) continue;
    const Rgba colour = scale_colour(share(values[i], low, high));
    const Vec3 tip = places[i] + along, back = -0.3 * along;
    const Vec3 side = 0.4 * back.norm() * along.unitOrthogonal();
    const std::size_t shaft = lines.vertices.size();
    lines.add(places[i], colour);
    lines.add(tip, colour);
    lines.close_from(shaft);
    const std::size_t head = lines.vertices.size();
    for (const Vec3& corner : {Vec3(tip + back + side), tip, Vec3(tip + back - side)})
      lines.add(corner, colour);
    lines.close_from(head);
  }
  return {line_node(lines, 1.5f).file()};
}

}  // namespace patchmill::scene
