// Conversion of spline surfaces; see polynomial_of_face.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/polynomial_of_face.h"

#include <algorithm>

#include <BRep_Tool.hxx>
#include <GeomConvert_BSplineSurfaceToBezierSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>

namespace patchmill {
namespace {

// Appends the patch's homogeneous Bernstein coefficients, u rows first.
void append(const Handle(Geom_BezierSurface) & patch, std::vector<Eigen::Vector4d>& out) {
  for (int a = 1; a <= patch->NbUPoles(); ++a)
    for (int b = 1; b <= patch->NbVPoles(); ++b) {
      const gp_Pnt p = patch->Pole(a, b);
      const double w = patch->Weight(a, b);
      out.emplace_back(w * p.X(), w * p.Y(), w * p.Z(), w);
    }
}

std::vector<double> values(const TColStd_Array1OfReal& array) {
  return {array.begin(), array.end()};
}

bool too_high(int u_degree, int v_degree) {
  return std::max(u_degree, v_degree) > PolynomialSurface::kMostDegree;
}

std::optional<PolynomialSurface> of_bezier(const Handle(Geom_BezierSurface) & s) {
  if (too_high(s->UDegree(), s->VDegree())) return {};
  std::vector<Eigen::Vector4d> bernstein;
  append(s, bernstein);
  return PolynomialSurface(s->UDegree(), s->VDegree(), {0.0, 1.0}, {0.0, 1.0}, bernstein,
                           s->IsURational() || s->IsVRational());
}

std::optional<PolynomialSurface> of_bspline(const Handle(Geom_BSplineSurface) & s) {
  if (too_high(s->UDegree(), s->VDegree()) || s->IsUPeriodic() || s->IsVPeriodic()) return {};
  GeomConvert_BSplineSurfaceToBezierSurface convert(s);
  TColStd_Array1OfReal u_knots(1, convert.NbUPatches() + 1), v_knots(1, convert.NbVPatches() + 1);
  convert.UKnots(u_knots);
  convert.VKnots(v_knots);
  std::vector<Eigen::Vector4d> bernstein;
  for (int i = 1; i <= convert.NbUPatches(); ++i)
    for (int j = 1; j <= convert.NbVPatches(); ++j) append(convert.Patch(i, j), bernstein);
  return PolynomialSurface(s->UDegree(), s->VDegree(), values(u_knots), values(v_knots), bernstein,
                           s->IsURational() || s->IsVRational());
}

}  // namespace

std::optional<PolynomialSurface> polynomial_of(const TopoDS_Face& face) {
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
    surface = trimmed->BasisSurface();
  if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(surface)) return of_bezier(bezier);
  if (const auto bspline = Handle(Geom_BSplineSurface)::DownCast(surface))
    return of_bspline(bspline);
  return {};
}

}  // namespace patchmill
