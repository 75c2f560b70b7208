// OpenCASCADE's faces for the atlas; see atlas_faces.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/atlas_faces.h"

#include "brep/polynomial_of_face.h"
#include "brep/trim_grid.h"
#include "patchmill/geometry/error.h"
#include "patchmill/patch/atlas/development.h"

#include <cmath>
#include <memory>

#include <BRepAdaptor_Curve2d.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>
#include <gp_Cone.hxx>

namespace patchmill {
namespace {

constexpr double kPole = 1e-10;  // of du x dv over the lengths' product: no normal there
constexpr int kEdgeSamples = 40;
constexpr double kOnFace = 1e-5;  // mm

Vec3 vec(const gp_XYZ& p) {
  return {p.X(), p.Y(), p.Z()};
}

class OpenCascadeFace final : public patch::CurvedFace {
 public:
  explicit OpenCascadeFace(const TopoDS_Face& face)
      : surface_(face, false),
        polynomial_(polynomial_of(face)),
        reversed_(face.Orientation() == TopAbs_REVERSED),
        trim_(face),
        box_(Vec2(trim_.u_min(), trim_.v_min()), Vec2(trim_.u_max(), trim_.v_max())) {
    roll_ = rolled();
  }

  SurfaceD1 d1(const Vec2& uv) const override {
    if (polynomial_) return polynomial_->d1(uv.x(), uv.y());
    gp_Pnt p;
    gp_Vec pu, pv;
    surface_.D1(uv.x(), uv.y(), p, pu, pv);
    return {vec(p.XYZ()), vec(pu.XYZ()), vec(pv.XYZ())};
  }

  Vec3 normal(const Vec2& uv) const override {
    Vec2 at = uv;
    for (double inwards = 1e-7; inwards < 1e-2; inwards *= 10.0) {
      const SurfaceD1 s = d1(at);
      const Vec3 across = s.du.cross(s.dv);
      const double size = across.norm();
      if (size > kPole * (s.du.squaredNorm() + s.dv.squaredNorm()))
        return (reversed_ ? -1.0 : 1.0) / size * across;
      at = uv + inwards * (box_.center() - uv);  // a pole: a hair's breadth inside
    }
    return Vec3::UnitZ();
  }

  bool reversed() const override { return reversed_; }
  bool inside(const Vec2& uv) const override { return trim_.inside(uv.x(), uv.y()); }
  patch::Box2 box() const override { return box_; }
  const patch::Development* development() const override { return roll_ ? &*roll_ : nullptr; }

 private:
  std::optional<patch::Development> rolled() const {
    switch (surface_.GetType()) {
      case GeomAbs_Plane:
        return patch::develop_plane();
      case GeomAbs_Cylinder:
        return patch::develop_cylinder(surface_.Cylinder().Radius());
      case GeomAbs_Cone: {
        const gp_Cone cone = surface_.Cone();
        return patch::develop_cone(cone.RefRadius(), Angle::radians(cone.SemiAngle()),
                                   box_.center().x());
      }
      case GeomAbs_SurfaceOfExtrusion: {
        const gp_Dir along = surface_.Direction();
        const auto profile = [this](double u) {
          const SurfaceD1 at = d1({u, 0.0});
          return std::pair(at.point, at.du);
        };
        return patch::develop_extrusion(profile, vec(along.XYZ()), box_.min().x(), box_.max().x());
      }
      default:
        return std::nullopt;
    }
  }

  BRepAdaptor_Surface surface_;
  std::optional<PolynomialSurface> polynomial_;
  bool reversed_;
  TrimGrid trim_;
  patch::Box2 box_;
  std::optional<patch::Development> roll_;
};

// Points of an edge in the parameters of a face that it bounds.
std::vector<Vec2> along_edge(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  std::vector<Vec2> points;
  const BRepAdaptor_Curve2d curve(edge, face);
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  for (int k = 0; k < kEdgeSamples; ++k) {
    const gp_Pnt2d p = curve.Value(first + (last - first) * (k + 0.5) / kEdgeSamples);
    points.emplace_back(p.X(), p.Y());
  }
  return points;
}

std::vector<patch::SharedEdge> shared_edges(const std::vector<TopoDS_Face>& faces) {
  TopTools_IndexedMapOfShape edges;
  std::vector<std::vector<std::pair<int, TopoDS_Edge>>> uses;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (TopExp_Explorer e(faces[f], TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(e.Current());
      if (BRep_Tool::Degenerated(edge)) continue;
      const auto index = std::size_t(edges.Add(edge));
      uses.resize(std::max(uses.size(), index));
      uses[index - 1].emplace_back(static_cast<int>(f), edge);
    }
  std::vector<patch::SharedEdge> shared;
  for (const auto& by : uses) {
    if (by.size() != 2 || by[0].first == by[1].first) continue;
    const auto& [a, edge_a] = by[0];
    const auto& [b, edge_b] = by[1];
    shared.push_back({a, b, along_edge(edge_a, faces[std::size_t(a)]),
                      along_edge(edge_b, faces[std::size_t(b)])});
  }
  return shared;
}

}  // namespace

patch::FaceSet atlas_faces(const std::vector<TopoDS_Face>& faces) {
  if (faces.empty()) throw InputError("Base", "no face", "select at least one face.");
  patch::FaceSet set;
  for (const TopoDS_Face& face : faces) {
    const std::string which = fmt::format("face {}", set.faces.size() + 1);
    if (BRep_Tool::Surface(face).IsNull())
      throw InputError("Base", which, "it has no surface: repair the shape.");
    try {
      set.faces.push_back(std::make_shared<OpenCascadeFace>(face));
    } catch (const Standard_Failure& e) {
      throw InputError("Base", which, std::string(e.GetMessageString()) + ": repair the shape.");
    }
  }
  set.edges = shared_edges(faces);
  return set;
}

std::optional<std::pair<int, Vec2>> find_on_faces(const std::vector<TopoDS_Face>& faces,
                                                  const Vec3& point) {
  const gp_Pnt p(point.x(), point.y(), point.z());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Handle(Geom_Surface) s = BRep_Tool::Surface(faces[f]);
    const GeomAPI_ProjectPointOnSurf foot(p, s);
    if (foot.NbPoints() == 0 || foot.LowerDistance() > kOnFace) continue;
    const TrimGrid trim(faces[f]);
    Vec2 at;
    foot.LowerDistanceParameters(at.x(), at.y());
    for (int axis = 0; axis < 2; ++axis) {  // the period of a closed face that its trimming is in
      if (!(axis ? s->IsVPeriodic() : s->IsUPeriodic())) continue;
      const double period = axis ? s->VPeriod() : s->UPeriod();
      const double middle =
          axis ? 0.5 * (trim.v_min() + trim.v_max()) : 0.5 * (trim.u_min() + trim.u_max());
      at[axis] -= period * std::round((at[axis] - middle) / period);
    }
    if (trim.inside(at.x(), at.y())) return std::pair(static_cast<int>(f), at);
  }
  return std::nullopt;
}

}  // namespace patchmill
