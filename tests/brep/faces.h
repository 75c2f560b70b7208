// Faces for tests: the Bezier surface of Xu & Sasahara 2016, Table 1, and simple ones.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "../core/patch/table1_surface.h"

#include <cmath>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Face.hxx>

namespace patchmill {

/// Table 1, rows as printed: row 1 is the side of greatest Y, columns go along X.
inline Handle(Geom_BezierSurface) table1_surface() {
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double(&p)[3] = patch::kTable1[i][j];
      poles.SetValue(i + 1, j + 1, gp_Pnt(p[0], p[1], p[2]));
    }
  return new Geom_BezierSurface(poles);
}

/// The Table 1 face; its natural normal points upwards.
inline TopoDS_Face table1_face() {
  return BRepBuilderAPI_MakeFace(table1_surface(), Precision::Confusion());
}

/// A B-spline over [0, 1]² with evenly spaced simple inner knots.
inline Handle(Geom_BSplineSurface)
    uniform_bspline(const TColgp_Array2OfPnt& poles, const TColStd_Array2OfReal& weights,
                    int u_degree, int v_degree) {
  auto knots = [](int count, int degree, TColStd_Array1OfInteger& multiplicities) {
    TColStd_Array1OfReal values(1, count - degree + 1);
    multiplicities.Resize(1, count - degree + 1, false);
    multiplicities.Init(1);
    multiplicities(1) = multiplicities(count - degree + 1) = degree + 1;
    for (int i = 1; i <= count - degree + 1; ++i) values(i) = double(i - 1) / (count - degree);
    return values;
  };
  TColStd_Array1OfInteger u_mult(1, 1), v_mult(1, 1);
  const auto u_knots = knots(poles.NbRows(), u_degree, u_mult);
  const auto v_knots = knots(poles.NbColumns(), v_degree, v_mult);
  return new Geom_BSplineSurface(poles, weights, u_knots, v_knots, u_mult, v_mult, u_degree,
                                 v_degree);
}

/// Waves on a plane that rises along X by 0.35, so that no normal is vertical: a cubic B-spline of
/// poles x poles over a square of side `size` [mm] around the origin.
inline TopoDS_Face wavy_face(double size, int poles_per_side) {
  TColgp_Array2OfPnt poles(1, poles_per_side, 1, poles_per_side);
  TColStd_Array2OfReal weights(1, poles_per_side, 1, poles_per_side);
  weights.Init(1.0);
  for (int i = 1; i <= poles_per_side; ++i)
    for (int j = 1; j <= poles_per_side; ++j) {
      const double u = (i - 1.0) / (poles_per_side - 1), v = (j - 1.0) / (poles_per_side - 1);
      const double wave = 0.004 * size * std::sin(12.0 * u) * std::cos(10.0 * v);
      poles.SetValue(i, j,
                     gp_Pnt((u - 0.5) * size, (v - 0.5) * size, 0.35 * (u - 0.5) * size + wave));
    }
  return BRepBuilderAPI_MakeFace(uniform_bspline(poles, weights, 3, 3), Precision::Confusion());
}

}  // namespace patchmill
