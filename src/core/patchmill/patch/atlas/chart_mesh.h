// ChartMesh: a rectangle of a face's parameters as a grid of triangles, fine where the face bends. Sides that
// shrink to a point (poles) are one vertex, and the two sides of a closed face are one where a pole makes a
// disk of it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/atlas/curved_face.h"

namespace patchmill::patch {

/// Triangles over the parameters of a face.
struct ChartMesh {
  /// A corner of a triangle.
  struct Corner {
    int vertex = 0;
    Vec2 uv;  ///< as seen from its triangle: at a pole each triangle has its own
  };
  /// Its three corners.
  using Triangle = std::array<Corner, 3>;
  /// Two vertices with the distance between them along the face.
  struct Edge {
    int a = 0, b = 0;
    double length = 0.0;  ///< to third order [mm]
    double weight = 0.0;  ///< area that it stands for [mm²]
  };
  std::vector<Vec3> positions, normals;  ///< by vertex
  std::vector<Triangle> triangles;       ///< counter-clockwise in (u, v)
  std::vector<char> on_face;             ///< by triangle: whether the trimmed face comes near it
  std::vector<Edge> edges;               ///< sides and both diagonals of all cells
  std::vector<std::array<int, 3>> unrolling;  ///< vertices of all triangles, with either diagonal
  double area = 0.0;                          ///< inside the trimming [mm²]
  double curvature =
      0.0;  ///< solid angle of the normals over the trimmed face [sr], saddles negative
  double length_u = 0.0, length_v = 0.0;  ///< mean lengths of the rectangle along u and v [mm]
};

/// About `cells` cells, more where the face bends. The rectangle is within the face's box().
ChartMesh chart_mesh(const CurvedFace& face, const Box2& rectangle, int cells);

/// Distance of two points of a surface along it, to third order.
double along_surface(const Vec3& a, const Vec3& normal_a, const Vec3& b, const Vec3& normal_b);

}  // namespace patchmill::patch
