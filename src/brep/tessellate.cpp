// Tessellation; see tessellate.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/tessellate.h"

#include "brep/mesher.h"
#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <fmt/format.h>

namespace patchmill {
namespace {

using Index = std::int32_t;

constexpr double kFinest = 1e-5;  // mm; below 1e-7 OpenCASCADE makes nothing

/// Sets of nodes that are one vertex; the lowest number stands for a set.
class Merger {
 public:
  Index add() {
    parent_.push_back(static_cast<Index>(parent_.size()));
    return parent_.back();
  }
  Index of(Index node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }
  void unite(Index a, Index b) {
    a = of(a);
    b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

struct MeshedFace {
  TopoDS_Face face;
  Handle(Poly_Triangulation) triangles;
  TopLoc_Location location;
  Index first = 0;  ///< node 1 of the face has this number
};

/// Gathers the faces' nodes and makes those one that the topology says are one.
class Assembly {
 public:
  void add(const TopoDS_Face& face, Index number) {
    MeshedFace meshed{face, {}, {}, static_cast<Index>(points_.size())};
    meshed.triangles = BRep_Tool::Triangulation(face, meshed.location);
    if (meshed.triangles.IsNull() || meshed.triangles->NbTriangles() == 0) {
      missing_.push_back(number);
      return;
    }
    const gp_Trsf move = meshed.location.Transformation();
    for (int i = 1; i <= meshed.triangles->NbNodes(); ++i) {
      const gp_Pnt p = meshed.triangles->Node(i).Transformed(move);
      points_.emplace_back(p.X(), p.Y(), p.Z());
      nodes_.add();
    }
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next())
      join(meshed, TopoDS::Edge(e.Current()));
    collect(meshed, number);
  }

  const std::vector<Index>& missing() const { return missing_; }

  void finish(Tessellation& result) {
    std::vector<Index> vertex(points_.size(), -1);
    const auto vertex_of = [&](Index node) {
      Index& known = vertex[static_cast<std::size_t>(nodes_.of(node))];
      if (known < 0) {
        known = static_cast<Index>(result.mesh.vertices.size());
        result.mesh.vertices.push_back(points_[static_cast<std::size_t>(nodes_.of(node))]);
      }
      return known;
    };
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      auto corner = corners_[i];
      for (Index& c : corner) c = nodes_.of(c);
      if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
      for (Index& c : corner) c = vertex_of(c);
      result.mesh.triangles.push_back(corner);
      result.face.push_back(face_[i]);
    }
  }

 private:
  /// The nodes of a face on one of its edges: the k-th is the k-th on every other face of the edge. A seam
  /// has two rows of nodes on its face; a degenerated edge is all one point.
  void join(const MeshedFace& meshed, const TopoDS_Edge& edge) {
    const Handle(Poly_PolygonOnTriangulation) polygon =
        BRep_Tool::PolygonOnTriangulation(edge, meshed.triangles, meshed.location);
    if (polygon.IsNull()) return;
    const int count = polygon->NbNodes();
    const auto node = [&](int k) { return meshed.first + polygon->Node(k) - 1; };
    // the first and last node of an edge that runs backwards in the face are still those of its own sense
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    join_vertex(TopExp::FirstVertex(forward), node(1));
    join_vertex(TopExp::LastVertex(forward), node(count));
    if (BRep_Tool::Degenerated(edge)) {
      for (int k = 2; k <= count; ++k) nodes_.unite(node(1), node(k));
      return;
    }
    const int number = edges_.Add(edge);
    std::vector<Index>& known = edge_nodes_[number];
    if (known.empty())
      for (int k = 1; k <= count; ++k) known.push_back(node(k));
    else if (known.size() == static_cast<std::size_t>(count))
      for (int k = 1; k <= count; ++k)
        nodes_.unite(known[static_cast<std::size_t>(k - 1)], node(k));
  }

  void join_vertex(const TopoDS_Vertex& vertex, Index node) {
    if (vertex.IsNull()) return;
    const auto [at, is_new] = vertex_node_.try_emplace(vertices_.Add(vertex), node);
    if (!is_new) nodes_.unite(at->second, node);
  }

  void collect(const MeshedFace& meshed, Index number) {
    const bool flip = (meshed.face.Orientation() == TopAbs_REVERSED) !=
                      meshed.location.Transformation().IsNegative();
    for (int i = 1; i <= meshed.triangles->NbTriangles(); ++i) {
      int a = 0, b = 0, c = 0;
      meshed.triangles->Triangle(i).Get(a, b, c);
      if (flip) std::swap(b, c);
      const Index from = meshed.first - 1;
      corners_.push_back({from + a, from + b, from + c});
      face_.push_back(number);
    }
  }

  std::vector<Vec3> points_;
  Merger nodes_;
  std::vector<std::array<Index, 3>> corners_;
  std::vector<Index> face_, missing_;
  TopTools_IndexedMapOfShape edges_, vertices_;  // by IsSame: orientation does not count
  std::map<int, std::vector<Index>> edge_nodes_;
  std::map<int, Index> vertex_node_;
};

void require_valid(const TessellationOptions& options) {
  if (!(options.deflection >= kFinest) || !std::isfinite(options.deflection))
    throw InputError("Deflection", fmt::format("{} mm", options.deflection),
                     fmt::format("give {} mm or more.", kFinest));
  const double degrees = options.angle.degrees();
  if (!(degrees > 0.0 && degrees <= 90.0))
    throw InputError("DeflectionAngle", fmt::format("{} degrees", degrees),
                     "give a value from 0 to 90 degrees.");
}

/// Why a mesh is no closed solid; empty if it is one. One that is inside out is turned.
std::string close(mesh::TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return "The shape has no face that could be meshed.";
  if (mesh::volume(mesh) < 0.0)
    for (auto& corner : mesh.triangles) std::swap(corner[1], corner[2]);
  try {
    mesh::require_closed(mesh, "Shape");
  } catch (const InputError& error) {
    return fmt::format("The mesh of the shape is not a closed solid ({}).", error.value());
  }
  return {};
}

}  // namespace

Tessellation tessellate(const TopoDS_Shape& shape, const TessellationOptions& options) {
  require_valid(options);
  Tessellation result;
  if (shape.IsNull()) {
    result.reason = "There is no shape.";
    return result;
  }
  Assembly assembly;
  Index faces = 0;
  try {
    mesh_faces(shape, options.deflection, options.angle, options.most_triangles);
    for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next())
      assembly.add(TopoDS::Face(e.Current()), faces++);
  } catch (const Standard_Failure& error) {
    result.reason = fmt::format("The mesher failed: {}.", error.GetMessageString());
    return result;
  }
  assembly.finish(result);
  if (assembly.missing().empty())
    result.reason = close(result.mesh);
  else
    result.reason = fmt::format("{} of {} faces could not be meshed, the first is Face{}.",
                                assembly.missing().size(), faces, assembly.missing().front() + 1);
  result.closed = result.reason.empty();
  return result;
}

}  // namespace patchmill
