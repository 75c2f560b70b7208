// Tessellation; see tessellate.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/tessellate.h"

#include "brep/face_mesh.h"
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

struct MeshedFace {
  TopoDS_Face face;
  Handle(Poly_Triangulation) triangles;
  TopLoc_Location location;
  Index first = 0;  ///< node 1 of the face has this number
  Index number = 0;
};

/// Gathers the faces' nodes and makes those one that the topology says are one.
class Assembly {
 public:
  void add(const TopoDS_Face& face, Index number) {
    MeshedFace meshed{face, {}, {}, static_cast<Index>(mesh_.nodes.size()), number};
    meshed.triangles = BRep_Tool::Triangulation(face, meshed.location);
    mesh_.surfaces.push_back(new BRepAdaptor_Surface(face, false));
    if (meshed.triangles.IsNull() || meshed.triangles->NbTriangles() == 0) {
      missing_.push_back(number);
      return;
    }
    const gp_Trsf move = meshed.location.Transformation();
    for (int i = 1; i <= meshed.triangles->NbNodes(); ++i) {
      const gp_Pnt p = meshed.triangles->Node(i).Transformed(move);
      mesh_.add({Vec3(p.X(), p.Y(), p.Z()), meshed.triangles->UVNode(i)});
    }
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next())
      join(meshed, TopoDS::Edge(e.Current()));
    collect(meshed);
  }

  const std::vector<Index>& missing() const { return missing_; }

  void refine(double deflection, double most) { patchmill::refine(mesh_, deflection, most); }

  void finish(Tessellation& result) {
    std::vector<Index> vertex(mesh_.nodes.size(), -1);
    const auto vertex_of = [&](Index node) {
      Index& known = vertex[static_cast<std::size_t>(mesh_.same.of(node))];
      if (known < 0) {
        known = static_cast<Index>(result.mesh.vertices.size());
        result.mesh.vertices.push_back(
            mesh_.nodes[static_cast<std::size_t>(mesh_.same.of(node))].point);
      }
      return known;
    };
    for (std::size_t i = 0; i < mesh_.corners.size(); ++i) {
      auto corner = mesh_.corners[i];
      for (Index& c : corner) c = mesh_.same.of(c);
      if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
      for (Index& c : corner) c = vertex_of(c);
      result.mesh.triangles.push_back(corner);
      result.face.push_back(mesh_.face[i]);
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
      for (int k = 2; k <= count; ++k) mesh_.same.unite(node(1), node(k));
      const gp_XY along = mesh_.nodes[node(count)].at.XY() - mesh_.nodes[node(1)].at.XY();
      const Pole pole = std::abs(along.X()) > std::abs(along.Y()) ? Pole::U : Pole::V;
      for (int k = 1; k <= count; ++k) mesh_.nodes[node(k)].pole = pole;
      return;
    }
    keep_pieces(meshed, edge, *polygon);
    const int number = edges_.Add(edge);
    std::vector<Index>& known = edge_nodes_[number];
    if (known.empty())
      for (int k = 1; k <= count; ++k) known.push_back(node(k));
    else if (known.size() == static_cast<std::size_t>(count))
      for (int k = 1; k <= count; ++k)
        mesh_.same.unite(known[static_cast<std::size_t>(k - 1)], node(k));
  }

  /// What an edge is between neighbouring nodes, for those who cut it there.
  void keep_pieces(const MeshedFace& meshed, const TopoDS_Edge& edge,
                   const Poly_PolygonOnTriangulation& polygon) {
    double from = 0.0, to = 0.0;
    Handle(Geom2d_Curve) on_face = BRep_Tool::CurveOnSurface(edge, meshed.face, from, to);
    if (on_face.IsNull() || !polygon.HasParameters()) return;
    const TopoDS_Shape other = edge.Reversed();  // of a seam: on which side the nodes are, they say
    const Handle(Geom2d_Curve) other_side =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(other), meshed.face, from, to);
    const gp_Pnt2d first = mesh_.nodes[meshed.first + polygon.Node(1) - 1].at;
    const auto away = [&](const Handle(Geom2d_Curve) & curve) {
      return curve->Value(polygon.Parameter(1)).SquareDistance(first);
    };
    if (away(other_side) < away(on_face)) on_face = other_side;
    for (int k = 1; k < polygon.NbNodes(); ++k) {
      const Index a = meshed.first + polygon.Node(k) - 1,
                  b = meshed.first + polygon.Node(k + 1) - 1;
      EdgePiece piece{mesh_.edges.size(), polygon.Parameter(k), polygon.Parameter(k + 1)};
      if (a > b) std::swap(piece.from, piece.to);
      mesh_.pieces[FaceMesh::pair(a, b)] = piece;
    }
    mesh_.edges.push_back({new BRepAdaptor_Curve(edge), on_face});
  }

  void join_vertex(const TopoDS_Vertex& vertex, Index node) {
    if (vertex.IsNull()) return;
    const auto [at, is_new] = vertex_node_.try_emplace(vertices_.Add(vertex), node);
    if (!is_new) mesh_.same.unite(at->second, node);
  }

  void collect(const MeshedFace& meshed) {
    const bool flip = (meshed.face.Orientation() == TopAbs_REVERSED) !=
                      meshed.location.Transformation().IsNegative();
    for (int i = 1; i <= meshed.triangles->NbTriangles(); ++i) {
      int a = 0, b = 0, c = 0;
      meshed.triangles->Triangle(i).Get(a, b, c);
      if (flip) std::swap(b, c);
      const Index from = meshed.first - 1;
      mesh_.corners.push_back({from + a, from + b, from + c});
      mesh_.face.push_back(meshed.number);
    }
  }

  FaceMesh mesh_;
  std::vector<Index> missing_;
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
    const double meshed =
        mesh_faces(shape, options.deflection, options.angle, options.most_triangles);
    for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next())
      assembly.add(TopoDS::Face(e.Current()), faces++);
    if (meshed > options.deflection)
      assembly.refine(options.deflection, 2.0 * options.most_triangles);
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
