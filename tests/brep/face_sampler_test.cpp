// Projection on faces: closed forms, the paper's surface, trimming, folds, poles, placements.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_sampler.h"

#include "faces.h"
#include "patchmill/geometry/error.h"

#include <random>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace patchmill {
namespace {

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next())
    faces.push_back(TopoDS::Face(e.Current()));
  return faces;
}

std::vector<Vec2> grid(int n, double half) {
  std::vector<Vec2> points;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      points.emplace_back(half * (2.0 * i / (n - 1) - 1.0), half * (2.0 * j / (n - 1) - 1.0));
  return points;
}

TEST(FaceSampler, PointsOfTheBezierSurfaceOfTable1) {
  const FaceSampler sampler({table1_face()}, patch::TexturePlane(), Angle::degrees(80));
  const std::vector<Vec3> known = {{0, 0.546875, 24.875},
                                   {-16.502929688, 16.698486328, 23.759765625},
                                   {-16.801757813, -14.947509766, 22.880859375}};
  std::vector<Vec2> places;
  for (const Vec3& p : known) places.push_back(p.head<2>());
  const auto hits = sampler.sample(places);
  for (std::size_t i = 0; i < known.size(); ++i) {
    ASSERT_EQ(hits[i].state, patch::DimpleState::Cut);
    EXPECT_NEAR((hits[i].point.position - known[i]).norm(), 0.0, 1e-6);
    EXPECT_GT(hits[i].point.normal.z(), 0.0);
    EXPECT_NEAR(hits[i].point.normal.norm(), 1.0, 1e-12);
  }
}

TEST(FaceSampler, EqualsOpenCascadesIntersector) {
  const TopoDS_Face face = table1_face();
  const FaceSampler sampler({face}, patch::TexturePlane(), Angle::degrees(80));
  IntCurvesFace_ShapeIntersector peer;
  peer.Load(face, 1e-7);
  const auto points = grid(41, 31.0);  // beyond the face's edges
  const auto hits = sampler.sample(points);
  int on = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    peer.Perform(gp_Lin(gp_Pnt(points[i].x(), points[i].y(), 100), gp_Dir(0, 0, -1)), 0, 200);
    ASSERT_EQ(peer.NbPnt() > 0, patch::on_face(hits[i].state)) << points[i].transpose();
    if (peer.NbPnt() == 0) continue;
    ++on;
    EXPECT_NEAR(peer.Pnt(1).Z(), hits[i].point.position.z(), 1e-7) << points[i].transpose();
  }
  EXPECT_GT(on, 1000);
  EXPECT_LT(on, 41 * 41);
}

TEST(FaceSampler, SphereFromAboveAndFromBelow) {
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(gp_Pnt(1, 2, 3), 10.0).Shape();
  for (double side : {+1.0, -1.0}) {
    const patch::TexturePlane plane =
        patch::texture_plane({1, 2, 50 * side}, {0, 0, -side}, {1, 0, 0}, 0.0);
    const FaceSampler sampler(faces_of(sphere), plane, Angle::degrees(60));
    const auto points = grid(61, 11.0);  // its middle is the pole
    const auto hits = sampler.sample(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double r2 = points[i].squaredNorm();
      if (r2 > 100.0) {
        EXPECT_EQ(hits[i].state, patch::DimpleState::OffFace) << points[i].transpose();
      } else if (r2 > 99.9) {
        continue;  // grazing: either way
      } else {
        const bool steep = std::sqrt(r2) > 10.0 * std::sin(60.0 * kPi / 180.0);
        ASSERT_EQ(hits[i].state, steep ? patch::DimpleState::TooSteep : patch::DimpleState::Cut)
            << points[i].transpose();
        const Vec3 out = hits[i].point.position - Vec3(1, 2, 3);
        EXPECT_NEAR(out.norm(), 10.0, 1e-9);
        EXPECT_GT(out.z() * side, 0.0) << "first hit";
        EXPECT_NEAR((out / 10.0 - hits[i].point.normal).norm(), 0.0, 1e-8) << points[i].transpose();
      }
    }
  }
}

TEST(FaceSampler, TorusIsHitOnItsNearSideOnly) {
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(10.0, 3.0).Shape();
  // looked at along X, the ray meets up to four places; the first is the one of least depth
  const patch::TexturePlane plane = patch::texture_plane({50, 0, 0}, {-1, 0, 0}, {0, 1, 0}, 0.0);
  const FaceSampler sampler(faces_of(torus), plane, Angle::degrees(70));
  for (double y : {0.0, 2.5, -6.0, 9.5, -12.0}) {
    const auto hit = sampler.sample({Vec2(y, 0.0)})[0];
    ASSERT_TRUE(patch::on_face(hit.state));
    EXPECT_NEAR(hit.point.position.x(), std::sqrt(13.0 * 13.0 - y * y), 1e-9);
  }
  EXPECT_EQ(sampler.sample({Vec2(13.1, 0)})[0].state, patch::DimpleState::OffFace);
}

TEST(FaceSampler, KeepsInsideTrimming) {
  // a plate with a round hole
  const gp_Pln z5(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1));
  auto ring = [&](double r) {
    const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1)), r);
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire();
  };
  BRepBuilderAPI_MakeFace make(z5, ring(20.0));
  TopoDS_Wire hole = ring(7.0);
  hole.Reverse();
  make.Add(hole);
  const FaceSampler sampler({make.Face()}, patch::TexturePlane(), Angle::degrees(80));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> xy(-22, 22);
  std::vector<Vec2> points;
  for (int i = 0; i < 20000; ++i) points.emplace_back(xy(random), xy(random));
  const auto hits = sampler.sample(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double r = points[i].norm();
    if (std::abs(r - 7.0) < 1e-6 || std::abs(r - 20.0) < 1e-6) continue;
    ASSERT_EQ(hits[i].state == patch::DimpleState::Cut, r > 7.0 && r < 20.0)
        << points[i].transpose();
  }
}

TEST(FaceSampler, MovesWithItsPlacement) {
  gp_Trsf move;
  move.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 1)), 0.7);
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(5, -4, 3));
  move.PreMultiply(shift);
  const TopoDS_Face face = table1_face();
  const TopoDS_Face moved = TopoDS::Face(face.Moved(TopLoc_Location(move)));
  auto turned = [&](const Vec3& v, bool point) {
    gp_Pnt p(v.x(), v.y(), v.z());
    gp_Vec w(v.x(), v.y(), v.z());
    if (point) p.Transform(move);
    w.Transform(move);
    return point ? Vec3(p.X(), p.Y(), p.Z()) : Vec3(w.X(), w.Y(), w.Z());
  };
  patch::TexturePlane here, there;
  there.origin = turned(here.origin, true);
  there.x_axis = turned(here.x_axis, false);
  there.y_axis = turned(here.y_axis, false);
  there.direction = turned(here.direction, false);
  const auto points = grid(21, 27.0);
  const auto a = FaceSampler({face}, here, Angle::degrees(80)).sample(points);
  const auto b = FaceSampler({moved}, there, Angle::degrees(80)).sample(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(a[i].state, b[i].state);
    EXPECT_NEAR((turned(a[i].point.position, true) - b[i].point.position).norm(), 0.0, 1e-9);
    EXPECT_NEAR((turned(a[i].point.normal, false) - b[i].point.normal).norm(), 0.0, 1e-9);
  }
}

TEST(FaceSampler, ObliqueDirectionOnAPlane) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, 0), 20, 20, 4).Shape();
  patch::TexturePlane plane;
  plane.origin = {0, 0, 20};
  plane.direction = Vec3(0.3, -0.2, -1.0).normalized();
  const auto hit =
      FaceSampler(faces_of(box), plane, Angle::degrees(80)).sample({Vec2(1.0, 2.0)})[0];
  EXPECT_NEAR((hit.point.position - Vec3(1.0 + 0.3 * 16, 2.0 - 0.2 * 16, 4.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((hit.point.normal - Vec3::UnitZ()).norm(), 0.0, 1e-12);
}

TEST(FaceSampler, SameBytesOnOneThreadAndOnMany) {
  const auto points = grid(150, 31.0);
  const FaceSampler sampler({table1_face()}, patch::TexturePlane(), Angle::degrees(30));
  const auto many = sampler.sample(points);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto single = sampler.sample(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(many[i].state, single[i].state);
    ASSERT_EQ(many[i].point.position, single[i].point.position);
    ASSERT_EQ(many[i].point.normal, single[i].point.normal);
  }
}

TEST(FaceSampler, StopsWhenAsked) {
  const FaceSampler sampler({table1_face()}, patch::TexturePlane(), Angle::degrees(80));
  EXPECT_TRUE(sampler.sample(grid(200, 25.0), [](double) { return false; }).empty());
}

TEST(FaceSampler, RefusesNoFaceAndBadLimit) {
  EXPECT_THROW(FaceSampler({}, patch::TexturePlane(), Angle::degrees(80)), InputError);
  EXPECT_THROW(FaceSampler({table1_face()}, patch::TexturePlane(), Angle::degrees(0)), InputError);
  EXPECT_THROW(FaceSampler({table1_face()}, patch::TexturePlane(), Angle::degrees(90)), InputError);
}

}  // namespace
}  // namespace patchmill
