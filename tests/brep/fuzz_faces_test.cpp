// Ten thousand random faces: B-splines of random degree, poles and weights, folded ones too, with random
// trimming, holes, placements and directions. Nothing crashes, nothing is a NaN, no point is off its ray or
// off its face. Independent judges: OpenCASCADE's extrema and its face classifier.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_sampler.h"
#include "faces.h"

#include <random>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Circle.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax22d.hxx>
#include <gp_Lin.hxx>
#include <gtest/gtest.h>

namespace patchmill {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

int below(Random& random, int n) {
  return static_cast<int>(random() % static_cast<unsigned>(n));
}

// A B-spline over [0, 1]² whose poles are jittered, sometimes so far that it folds.
Handle(Geom_BSplineSurface) random_surface(Random& random) {
  const double jitter = below(random, 4) == 0 ? 12.0 : 3.0;
  const int degree[2] = {1 + below(random, 4), 1 + below(random, 4)};
  const int poles[2] = {degree[0] + 1 + below(random, 4), degree[1] + 1 + below(random, 4)};
  TColgp_Array2OfPnt pole(1, poles[0], 1, poles[1]);
  TColStd_Array2OfReal weight(1, poles[0], 1, poles[1]);
  weight.Init(1.0);
  const bool rational = below(random, 3) == 0;
  for (int i = 1; i <= poles[0]; ++i)
    for (int j = 1; j <= poles[1]; ++j) {
      pole(i, j) = gp_Pnt(10.0 * i + uniform(random, -jitter, jitter),
                          10.0 * j + uniform(random, -jitter, jitter), uniform(random, -8, 8));
      if (rational) weight(i, j) = uniform(random, 0.3, 3.0);
    }
  return uniform_bspline(pole, weight, degree[0], degree[1]);
}

TopoDS_Wire circle_in_parameters(const Handle(Geom_Surface) & surface, double u, double v,
                                 double r) {
  const Handle(Geom2d_Circle) circle =
      new Geom2d_Circle(gp_Ax22d(gp_Pnt2d(u, v), gp_Dir2d(1, 0)), r);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(circle, surface).Edge();
  BRepLib::BuildCurves3d(edge);
  return BRepBuilderAPI_MakeWire(edge).Wire();
}

TopoDS_Face random_face(Random& random) {
  const auto surface = random_surface(random);
  TopoDS_Face face;
  const int kind = below(random, 3);
  if (kind == 0) {
    face = BRepBuilderAPI_MakeFace(surface, 1e-7);
  } else if (kind == 1) {
    face = BRepBuilderAPI_MakeFace(surface, uniform(random, 0, 0.4), uniform(random, 0.5, 1),
                                   uniform(random, 0, 0.4), uniform(random, 0.5, 1), 1e-7);
  } else {
    const double r = uniform(random, 0.05, 0.3);
    BRepBuilderAPI_MakeFace make(surface, 1e-7);
    TopoDS_Wire hole = circle_in_parameters(surface, 0.5, 0.5, r);
    hole.Reverse();
    make.Add(hole);
    face = make.Face();
  }
  gp_Trsf move, turn;
  move.SetTranslation(
      gp_Vec(uniform(random, -100, 100), uniform(random, -100, 100), uniform(random, -100, 100)));
  turn.SetRotation(
      gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(uniform(random, -1, 1), uniform(random, -1, 1), 1.1)),
      uniform(random, -3, 3));
  face.Move(TopLoc_Location(move * turn));
  if (below(random, 2)) face.Reverse();
  return face;
}

bool near(const gp_Pnt& a, const Vec3& b) {
  return (Vec3(a.X(), a.Y(), a.Z()) - b).norm() < 1e-6;
}

// OpenCASCADE's intersector finds the point on the trimmed face, or its extrema do and its classifier puts
// the foot inside. Each of the two overlooks a few points in ten thousand faces; never both.
void expect_on_face(const TopoDS_Face& face, const Vec3& p, const Vec3& direction) {
  const gp_Pnt at(p.x(), p.y(), p.z());
  IntCurvesFace_Intersector ray(face, 1e-9);
  ray.Perform(gp_Lin(at, gp_Dir(direction.x(), direction.y(), direction.z())), -1e3, 1e3);
  for (int i = 1; ray.IsDone() && i <= ray.NbPnt(); ++i)
    if (near(ray.Pnt(i), p)) return;
  GeomAPI_ProjectPointOnSurf nearest(at, BRep_Tool::Surface(face));
  for (int i = 1; i <= nearest.NbPoints(); ++i) {
    double u, v;
    nearest.Parameters(i, u, v);
    if (near(nearest.Point(i), p) &&
        BRepClass_FaceClassifier(face, gp_Pnt2d(u, v), 1e-6).State() != TopAbs_OUT)
      return;
  }
  ADD_FAILURE() << "not on the face: " << p.transpose();
}

// `judge`: also ask OpenCASCADE about one of the points, which takes it longer than all the rest.
void try_face(Random& random, bool judge, long& on, long& left_out, long& judged) {
  const TopoDS_Face face = random_face(random);
  const Vec3 d(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
  if (d.norm() < 0.1) return;
  const patch::TexturePlane plane =
      patch::texture_plane(Vec3(1, 2, 3), d, any_normal_to(d.normalized()), 0.3);
  const FaceSampler sampler({face}, plane, Angle::degrees(85));
  const auto [low, high] = sampler.extent();
  std::vector<Vec2> points;
  for (int i = 0; i < 24; ++i)
    points.emplace_back(uniform(random, low.x(), high.x()), uniform(random, low.y(), high.y()));
  const auto samples = sampler.sample(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!patch::on_face(samples[i].state)) {
      ++left_out;
      continue;
    }
    ++on;
    const Vec3& p = samples[i].point.position;
    ASSERT_TRUE(p.allFinite() && samples[i].point.normal.allFinite());
    ASSERT_NEAR(samples[i].point.normal.norm(), 1.0, 1e-9);
    ASSERT_LT((p - plane.at(points[i])).cross(plane.direction).norm(), 1e-9 * (1.0 + p.norm()));
    if (!judge) continue;
    judge = false;
    ++judged;
    expect_on_face(face, p, plane.direction);
  }
}

TEST(FuzzFaces, TenThousand) {
  Random random(20160101);
  long on = 0, left_out = 0, judged = 0;
  for (int i = 0; i < 10000; ++i) {
    SCOPED_TRACE(i);
    try_face(random, i % 4 == 0, on, left_out, judged);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(on, 50000);
  EXPECT_GT(left_out, 1000);
  EXPECT_GT(judged, 2000);
}

}  // namespace
}  // namespace patchmill
