// Border edges; see edges.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/edges.h"

#include "patchmill/geometry/error.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

namespace patchmill {
namespace {

constexpr double kAngle = 0.2;  // rad: greatest turn from piece to piece

void append(const TopoDS_Edge& edge, double deflection, std::vector<patch::Segment3>& out) {
  const BRepAdaptor_Curve curve(edge);
  const GCPnts_TangentialDeflection points(curve, kAngle, deflection);
  if (points.NbPoints() < 2)
    throw InputError("Base", "an edge without a curve", "repair the shape.");
  const auto at = [&](int i) {
    const gp_Pnt p = points.Value(i);
    return Vec3(p.X(), p.Y(), p.Z());
  };
  for (int i = 1; i < points.NbPoints(); ++i) out.push_back({at(i), at(i + 1)});
}

}  // namespace

std::vector<patch::Segment3> border_segments(const std::vector<TopoDS_Face>& faces,
                                             double deflection) {
  require_positive("Deflection", deflection, "mm");
  TopTools_IndexedMapOfShape edges;
  std::vector<int> uses;
  for (const TopoDS_Face& face : faces)
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
      const auto index = static_cast<std::size_t>(edges.Add(e.Current()));
      if (uses.size() < index) uses.resize(index, 0);
      ++uses[index - 1];
    }
  std::vector<patch::Segment3> segments;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i));
    if (uses[static_cast<std::size_t>(i - 1)] == 1 && !BRep_Tool::Degenerated(edge))
      append(edge, deflection, segments);
  }
  return segments;
}

}  // namespace patchmill
