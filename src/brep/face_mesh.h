// The meshes of a shape's faces while they are put together, and how they are made finer. OpenCASCADE's mesher takes
// more than a square of the number of triangles on one face (a torus of a million took over nine minutes), so that
// fine meshes are its coarse ones halved: where an edge of a triangle leaves the surface, or the shape's own edge,
// by more than the deflection, it gets a node in its middle there, and the triangles on both sides are cut at it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <Geom2d_Curve.hxx>
#include <gp_Pnt2d.hxx>

namespace patchmill {

/// Sets of nodes that are one vertex; the lowest number stands for a set.
class Merger {
 public:
  /// One more node, a set of its own; its number.
  std::int32_t add() {
    parent_.push_back(static_cast<std::int32_t>(parent_.size()));
    return parent_.back();
  }
  /// The node that stands for the set of `node`.
  std::int32_t of(std::int32_t node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }
  /// Makes two sets one.
  void unite(std::int32_t a, std::int32_t b) {
    a = of(a);
    b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::int32_t> parent_;
};

/// What of a node's place on its face says nothing: at a pole, that of the direction around it.
enum class Pole : std::uint8_t { None, U, V };

/// A node of one face; those of neighbours on a common edge are other ones, which a Merger makes one.
struct FaceNode {
  Vec3 point = Vec3::Zero();  ///< [mm]
  gp_Pnt2d at;                ///< parameters on the face's surface
  Pole pole = Pole::None;
};

/// A stretch of an edge of the shape, on one of its faces, between neighbouring nodes.
struct EdgePiece {
  std::size_t edge = 0;         ///< number among FaceMesh::edges
  double from = 0.0, to = 0.0;  ///< parameters, from the node of the lower number to the other
};

/// An edge of the shape as one face has it.
struct FaceEdge {
  Handle(BRepAdaptor_Curve) curve;
  Handle(Geom2d_Curve) on_face;
};

/// Triangles over nodes that know where on their faces they are.
struct FaceMesh {
  std::vector<FaceNode> nodes;
  Merger same;  ///< which nodes are one vertex
  std::vector<std::array<std::int32_t, 3>> corners;
  std::vector<std::int32_t> face;                     ///< of each triangle
  std::vector<Handle(BRepAdaptor_Surface)> surfaces;  ///< by number of the face
  std::vector<FaceEdge> edges;
  std::unordered_map<std::uint64_t, EdgePiece> pieces;  ///< by pair()

  /// A node of its own; its number.
  std::int32_t add(const FaceNode& node) {
    nodes.push_back(node);
    return same.add();
  }
  /// Two nodes as one number, whichever is first.
  static std::uint64_t pair(std::int32_t a, std::int32_t b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32U |
           static_cast<std::uint32_t>(std::max(a, b));
  }
};

/// Halves triangles until their edges and middles are within `deflection` [mm] of their surfaces, and those on the
/// shape's edges within it of these. Errors: InputError naming Deflection if there are more than `most` of them.
void refine(FaceMesh& mesh, double deflection, double most);

}  // namespace patchmill
