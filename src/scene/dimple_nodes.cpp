// Discs, order lines and outlines of a texture; see dimple_nodes.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/dimple_nodes.h"

#include "patchmill/geometry/stop.h"
#include "scene/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace patchmill::scene {
namespace {

constexpr std::size_t kChunk = 1024;    // dimples that are shown or simplified together
constexpr float kPixelsOfDisc = 12.0f;  // a disc with less of the screen becomes a point
constexpr float kPixelsOfPoint = 1.5f;  // and with less than this, one point stands for several
constexpr std::size_t kFew = 16;
constexpr double kLift =
    0.3;  // of the disc's radius: above the host's own, coarser triangles of the face
constexpr std::array<Rgba, 2> kOrderColours{0x1b3a57ff, 0xa34a00ff};

bool has_place(const patch::Dimple& dimple) {
  return dimple.state != patch::DimpleState::OffFace &&
         dimple.state != patch::DimpleState::OffNet && dimple.surface.position.allFinite() &&
         dimple.surface.normal.allFinite();
}

/// Two unit vectors that make a right angle with each other and with `normal`.
std::array<Vec3, 2> tangents(const Vec3& normal) {
  const Vec3 a = normal.unitOrthogonal();
  return {a, normal.cross(a)};
}

constexpr int kCorners = 6;  // of a disc

/// Corners of a regular hexagon on the unit circle.
constexpr std::array<std::array<double, 2>, kCorners> kHexagon{{{1.0, 0.0},
                                                                {0.5, 0.8660254037844386},
                                                                {-0.5, 0.8660254037844386},
                                                                {-1.0, 0.0},
                                                                {-0.5, -0.8660254037844386},
                                                                {0.5, -0.8660254037844386}}};

void add_disc(Triangles& triangles, const patch::Dimple& dimple, double radius) {
  const auto [a, b] = tangents(dimple.surface.normal);
  const auto first = static_cast<std::int32_t>(triangles.vertices.size());
  const Vec3 middle = dimple.surface.position + kLift * radius * dimple.surface.normal;
  for (const auto& [across, up] : kHexagon) {
    triangles.vertices.push_back(single(middle + radius * (across * a + up * b)));
    triangles.colours.push_back(state_colour(dimple.state));
  }
  for (int i = 1; i + 1 < kCorners; ++i)
    for (const std::int32_t corner : {first, first + i, first + i + 1, std::int32_t{-1}})
      triangles.corners.push_back(corner);
}

struct DimpleChunk {
  Triangles discs;
  std::vector<Point3f> points, few_points;
  std::vector<Rgba> colours, few_colours;
};

DimpleChunk chunk_of(const std::vector<const patch::Dimple*>& dimples, std::size_t first,
                     std::size_t last, double radius) {
  DimpleChunk chunk;
  chunk.discs.vertices.reserve(kCorners * (last - first));
  chunk.discs.colours.reserve(kCorners * (last - first));
  chunk.discs.corners.reserve(4 * (kCorners - 2) * (last - first));
  for (std::size_t i = first; i < last; ++i) {
    const patch::Dimple& dimple = *dimples[i];
    const Point3f place = single(dimple.surface.position + kLift * radius * dimple.surface.normal);
    add_disc(chunk.discs, dimple, radius);
    chunk.points.push_back(place);
    chunk.colours.push_back(state_colour(dimple.state));
    if (i % kFew) continue;
    chunk.few_points.push_back(place);
    chunk.few_colours.push_back(state_colour(dimple.state));
  }
  return chunk;
}

InventorNode node_of(const DimpleChunk& chunk) {
  const auto count = static_cast<float>(chunk.points.size());
  return detail_node({kPixelsOfDisc * count, kPixelsOfPoint * count},
                     {triangle_node(chunk.discs), point_node(chunk.points, chunk.colours, 3.0f),
                      point_node(chunk.few_points, chunk.few_colours, 3.0f)});
}

/// An arrowhead at `tip`, coming from `tail`, in the tangent plane.
void add_arrowhead(Polylines& lines, const Vec3& tail, const Vec3& tip, const Vec3& normal,
                   Rgba colour) {
  const Vec3 back = 0.35 * (tail - tip);
  const Vec3 side = 0.5 * normal.cross(back);
  const std::size_t first = lines.vertices.size();
  for (const Vec3& corner : {Vec3(tip + back + side), tip, Vec3(tip + back - side)})
    lines.add(corner, colour);
  lines.close_from(first);
}

}  // namespace

Display dimple_display(const patch::Dimples& dimples, double radius) {
  std::vector<const patch::Dimple*> shown;
  for (const patch::Dimple& dimple : dimples)
    if (has_place(dimple)) shown.push_back(&dimple);
  Display display((shown.size() + kChunk - 1) / kChunk);
  patchmill::parallel_for(std::size_t{0}, display.size(), [&](std::size_t i) {
    const std::size_t last = std::min(shown.size(), (i + 1) * kChunk);
    display[i] = node_of(chunk_of(shown, i * kChunk, last, radius)).file();
  });
  return display;
}

Display order_display(const patch::Dimples& dimples, double spacing) {
  constexpr int kStepsToAnArrow = 4;
  constexpr std::size_t kVertices = 20000;  // in one chunk, or a little more
  Display display;
  Polylines lines, heads;
  const auto flush = [&] {
    InventorNode root("Separator");
    root.child(line_node(lines, 1.0f)).child(line_node(heads, 1.5f));
    display.push_back(root.file());
    lines = heads = Polylines();
  };
  const double lift = 0.2 * spacing;
  const patch::Dimple* before = nullptr;
  std::size_t first = 0;
  int step = 0;
  for (const patch::Dimple& dimple : dimples) {
    if (dimple.state != patch::DimpleState::Cut) continue;
    const Rgba colour = kOrderColours[static_cast<std::size_t>(dimple.patch % 2)];
    const Vec3 place = dimple.surface.position + lift * dimple.surface.normal;
    const bool same_patch = before && before->patch == dimple.patch;
    if (!same_patch) {
      lines.close_from(first);
      if (lines.vertices.size() > kVertices) flush();
      first = lines.vertices.size();
      step = 0;
    }
    lines.add(place, colour);
    if (same_patch && step++ % kStepsToAnArrow == 0)
      add_arrowhead(heads, before->surface.position + lift * before->surface.normal, place,
                    dimple.surface.normal, colour);
    before = &dimple;
  }
  lines.close_from(first);
  flush();
  return display;
}

Display outline_display(const std::vector<std::vector<Vec3>>& outlines) {
  Polylines lines;
  for (const auto& outline : outlines) {
    std::size_t first = lines.vertices.size();
    for (const Vec3& corner : outline) {
      if (corner.allFinite()) {
        lines.add(corner, 0x303030ff);
        continue;
      }
      lines.close_from(first);
      first = lines.vertices.size();
    }
    lines.close_from(first);
  }
  return {line_node(lines, 1.5f).file()};
}

}  // namespace patchmill::scene
