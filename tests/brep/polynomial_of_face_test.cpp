// PolynomialSurface against OpenCASCADE's own evaluation, on random rational B-splines of any degree.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/polynomial_of_face.h"

#include "faces.h"

#include <random>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

namespace patchmill {
namespace {

struct Knots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;
  int poles;
};

// Uneven knots; inner ones of random multiplicity below the degree.
Knots random_knots(std::mt19937& random, int degree) {
  const int spans = 1 + int(random() % 4);
  Knots k{TColStd_Array1OfReal(1, spans + 1), TColStd_Array1OfInteger(1, spans + 1), 0};
  double at = -0.7;
  int sum = 0;
  for (int i = 1; i <= spans + 1; ++i) {
    k.values(i) = at;
    at += 0.1 + double(random() % 100) / 50.0;
    k.multiplicities(i) = i == 1 || i == spans + 1
                              ? degree + 1
                              : 1 + int(random() % unsigned(std::max(1, degree - 1)));
    sum += k.multiplicities(i);
  }
  k.poles = sum - degree - 1;
  return k;
}

Handle(Geom_BSplineSurface)
    random_surface(std::mt19937& random, int u_degree, int v_degree, bool rational) {
  const Knots u = random_knots(random, u_degree), v = random_knots(random, v_degree);
  TColgp_Array2OfPnt poles(1, u.poles, 1, v.poles);
  TColStd_Array2OfReal weights(1, u.poles, 1, v.poles);
  weights.Init(1.0);
  std::uniform_real_distribution<double> jitter(-1, 1);
  for (int i = 1; i <= u.poles; ++i)
    for (int j = 1; j <= v.poles; ++j) {
      poles(i, j) = gp_Pnt(10 * i + jitter(random), 10 * j + jitter(random), 5 * jitter(random));
      if (rational) weights(i, j) = 1.0 + 0.5 * jitter(random);
    }
  return new Geom_BSplineSurface(poles, weights, u.values, v.values, u.multiplicities,
                                 v.multiplicities, u_degree, v_degree);
}

double difference(const Vec3& a, const gp_XYZ& b) {
  return (a - Vec3(b.X(), b.Y(), b.Z())).norm();
}

void expect_equal(const PolynomialSurface& mine, const Handle(Geom_Surface) & peer,
                  std::mt19937& random) {
  double u0, u1, v0, v1;
  peer->Bounds(u0, u1, v0, v1);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 200; ++i) {
    const double u = u0 + (u1 - u0) * share(random), v = v0 + (v1 - v0) * share(random);
    gp_Pnt p;
    gp_Vec du, dv;
    peer->D1(u, v, p, du, dv);
    const SurfaceD1 d = mine.d1(u, v);
    EXPECT_LT(difference(d.point, p.XYZ()), 1e-10);
    EXPECT_LT(difference(d.du, du.XYZ()), 1e-8 * (1.0 + du.Magnitude()));
    EXPECT_LT(difference(d.dv, dv.XYZ()), 1e-8 * (1.0 + dv.Magnitude()));
  }
}

TEST(PolynomialOfFace, EqualsOpenCascadeOnRandomSplines) {
  std::mt19937 random(7);
  for (int u_degree = 1; u_degree <= PolynomialSurface::kMostDegree; ++u_degree)
    for (int v_degree = 1; v_degree <= PolynomialSurface::kMostDegree; ++v_degree)
      for (bool rational : {false, true}) {
        const auto surface = random_surface(random, u_degree, v_degree, rational);
        const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, Precision::Confusion());
        const auto mine = polynomial_of(face);
        ASSERT_TRUE(mine.has_value());
        expect_equal(*mine, surface, random);
      }
}

TEST(PolynomialOfFace, EqualsOpenCascadeOnTheSurfaceOfTable1) {
  std::mt19937 random(8);
  expect_equal(*polynomial_of(table1_face()), table1_surface(), random);
}

TEST(PolynomialOfFace, LeavesOtherSurfacesAlone) {
  const TopoDS_Face plane = BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
  EXPECT_FALSE(polynomial_of(plane).has_value());
}

}  // namespace
}  // namespace patchmill
