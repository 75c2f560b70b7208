// Faces for tests: the Bezier surface of Xu & Sasahara 2016, Table 1, and simple ones.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Face.hxx>

namespace patchmill {

/// Table 1, rows as printed: row 1 is the side of greatest Y, columns go along X.
inline Handle(Geom_BezierSurface) table1_surface() {
  const double z[4][4] = {{24, 32, 20, 30}, {15, 20, 30, 19}, {24, 35, 21, 32}, {14, 23, 18, 21}};
  const double x[4][4] = {
      {-30, -14, 16, 30}, {-31, -15, 15, 29}, {-32, -16, 16, 32}, {-30, -14, 14, 30}};
  const double y[4][4] = {
      {30, 32, 29, 29}, {14, 13, 16, 14}, {-10, -12, -15, -14}, {-30, -29, -30, -30}};
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) poles.SetValue(i + 1, j + 1, gp_Pnt(x[i][j], y[i][j], z[i][j]));
  return new Geom_BezierSurface(poles);
}

/// The Table 1 face; its natural normal points upwards.
inline TopoDS_Face table1_face() {
  return BRepBuilderAPI_MakeFace(table1_surface(), Precision::Confusion());
}

}  // namespace patchmill
