// Tessellation against closed forms: volumes and areas of solids, closedness whatever the placements,
// seams, poles and common edges; and what cannot be meshed is said so.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/tessellate.h"

#include "faces.h"
#include "patchmill/geometry/error.h"

#include <cstdio>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gtest/gtest.h>

namespace patchmill {
namespace {

TessellationOptions within(double deflection) {
  return {deflection, Angle::degrees(20)};
}

/// Volume, area and closedness of a shape; the volume of an inscribed mesh may be off by area x deflection.
void expect_solid(const TopoDS_Shape& shape, double volume_of_it, double area_of_it) {
  const double deflection = 0.002;
  const Tessellation t = tessellate(shape, within(deflection));
  ASSERT_TRUE(t.closed) << t.reason;
  EXPECT_NEAR(volume(t.mesh), volume_of_it, 2.0 * area_of_it * deflection);
  EXPECT_NEAR(mesh::surface_area(t.mesh), area_of_it, 0.01 * area_of_it);
  EXPECT_EQ(t.face.size(), t.mesh.triangles.size());
}

TEST(Tessellate, SolidsOfKnownVolumeAreClosed) {
  expect_solid(BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Solid(), 24.0, 52.0);
  expect_solid(BRepPrimAPI_MakeSphere(2.0).Solid(), 32.0 / 3.0 * kPi, 16.0 * kPi);
  expect_solid(BRepPrimAPI_MakeCylinder(1.0, 3.0).Solid(), 3.0 * kPi, 8.0 * kPi);
  expect_solid(BRepPrimAPI_MakeCone(1.0, 0.0, 2.0).Solid(), 2.0 / 3.0 * kPi,
               kPi * (1.0 + std::sqrt(5.0)));
  expect_solid(BRepPrimAPI_MakeTorus(3.0, 1.0).Solid(), 6.0 * kPi * kPi, 12.0 * kPi * kPi);
}

/// How far the middles of a mesh's edges and triangles are from the shape that `height` is the distance from, at most.
template <class Height>
double farthest(const mesh::TriangleMesh& mesh, Height&& height) {
  double most = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    for (const Vec3& p :
         {Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3(0.5 * (c + a)), Vec3((a + b + c) / 3.0)})
      most = std::max(most, std::abs(height(p)));
  }
  return most;
}

/// A mesh so fine that it is a coarser one made finer.
template <class Height>
void expect_refined(const TopoDS_Shape& shape, double deflection, double volume_of_it,
                    double most_triangles, Height&& height) {
  const Tessellation t = tessellate(shape, within(deflection));
  ASSERT_TRUE(t.closed) << t.reason;
  EXPECT_LE(farthest(t.mesh, height), deflection);
  EXPECT_LT(static_cast<double>(t.mesh.triangles.size()), most_triangles);
  EXPECT_NEAR(volume(t.mesh), volume_of_it, mesh::surface_area(t.mesh) * deflection);
  EXPECT_EQ(t.face.size(), t.mesh.triangles.size());
}

// Seams, poles, an apex, round edges of flat faces, faces that bend both ways. A lattice of right-angled triangles has
// two for each place, of sides sqrt(8 r deflection) each way; halving makes edges up to half as long as need be, and so
// up to four times as many.
TEST(Tessellate, FineMeshesAreWithinTheirDeflectionAndClosed) {
  expect_refined(BRepPrimAPI_MakeSphere(10.0).Solid(), 8e-4, 4000.0 / 3.0 * kPi,
                 8.0 * 400.0 * kPi / (80.0 * 8e-4), [](const Vec3& p) { return p.norm() - 10.0; });
  expect_refined(BRepPrimAPI_MakeTorus(10.0, 2.0).Solid(), 8e-4, 80.0 * kPi * kPi,
                 8.0 * 80.0 * kPi * kPi / (8.0 * std::sqrt(20.0) * 8e-4), [](const Vec3& p) {
                   return std::hypot(std::hypot(p.x(), p.y()) - 10.0, p.z()) - 2.0;
                 });
  expect_refined(BRepPrimAPI_MakeCylinder(10.0, 5.0).Solid(), 1e-4, 500.0 * kPi, 1e5,
                 [](const Vec3& p) {
                   return std::max({std::hypot(p.x(), p.y()) - 10.0, -p.z(), p.z() - 5.0});
                 });
  expect_refined(BRepPrimAPI_MakeCone(10.0, 0.0, 10.0).Solid(), 1e-4, 1000.0 / 3.0 * kPi, 1e5,
                 [](const Vec3& p) {
                   return std::max((std::hypot(p.x(), p.y()) + p.z() - 10.0) / std::sqrt(2.0),
                                   -p.z());
                 });
}

// The round edge of a flat face is followed, not only the faces beside it.
TEST(Tessellate, FineMeshesFollowTheEdgesOfFlatFaces) {
  const double deflection = 1e-4;
  const Tessellation t =
      tessellate(BRepPrimAPI_MakeCylinder(10.0, 5.0).Solid(), within(deflection));
  double area = 0.0;
  for (const auto& corner : t.mesh.triangles) {
    const Vec3 &a = t.mesh.vertices[corner[0]], &b = t.mesh.vertices[corner[1]],
               &c = t.mesh.vertices[corner[2]];
    if (a.z() == 0.0 && b.z() == 0.0 && c.z() == 0.0) area += 0.5 * (b - a).cross(c - a).norm();
  }
  EXPECT_LT(area, 100.0 * kPi);
  EXPECT_NEAR(area, 100.0 * kPi, 20.0 * kPi * deflection);
}

TEST(Tessellate, AFineMeshIsTheSameEachTime) {
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(10.0, 2.0).Solid();
  const Tessellation one = tessellate(torus, within(8e-4)), other = tessellate(torus, within(8e-4));
  EXPECT_EQ(one.mesh.vertices, other.mesh.vertices);
  EXPECT_EQ(one.mesh.triangles, other.mesh.triangles);
}

// A sphere of 10 mm within 10 nm would be about 10 million triangles: it is refused after two coarse meshes, and
// what the refusal says does, without being much coarser than need be.
TEST(Tessellate, MoreTrianglesThanThereIsRoomForAreRefusedBeforeTheyAreMade) {
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(10.0).Solid();
  TessellationOptions options = within(1e-5);
  options.most_triangles = 2e4;
  try {
    tessellate(sphere, options);
    FAIL() << "more than there is room for";
  } catch (const InputError& error) {
    EXPECT_EQ(error.property(), "Deflection");
    double foreseen = 0.0, enough = 0.0;
    ASSERT_EQ(std::sscanf(error.value().c_str(), "%*g mm, about %lf million", &foreseen), 1);
    EXPECT_GT(foreseen, 5.0);
    EXPECT_LT(foreseen, 20.0);
    const std::string& remedy = error.remedy();
    ASSERT_EQ(std::sscanf(remedy.c_str() + remedy.find("give "), "give %lf mm", &enough), 1)
        << remedy;
    options.deflection = enough;
    const std::size_t made = tessellate(sphere, options).mesh.triangles.size();
    EXPECT_LT(made, 20000U);
    EXPECT_GT(made, 5000U);
  }
}

TEST(Tessellate, FineDeflectionsAreTakenWhereTheyMakeFewTriangles) {
  const Tessellation box = tessellate(BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Solid(), within(1e-5));
  EXPECT_EQ(box.mesh.triangles.size(), 12U);
  TessellationOptions options = within(2e-5);
  options.most_triangles = 2e4;
  EXPECT_TRUE(tessellate(BRepPrimAPI_MakeCylinder(1.0, 3.0).Solid(), options).closed);
}

// OpenCASCADE makes nothing of less than 1e-7 mm, and says nothing.
TEST(Tessellate, ADeflectionThatTheMesherDoesNotTakeIsRefused) {
  for (const double deflection : {0.0, 1e-9, 0.99e-5, std::nan("")})
    EXPECT_THROW(tessellate(BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Solid(), within(deflection)),
                 InputError);
}

// The top of a prism is its base moved: the same edges in another place.
TEST(Tessellate, ClosedWhereFacesHavePlacementsOfTheirOwn) {
  const TopoDS_Shape block = BRepPrimAPI_MakePrism(table1_face(), gp_Vec(0.1, 0.2, -50.0));
  const Tessellation t = tessellate(block, within(0.01));
  EXPECT_TRUE(t.closed) << t.reason;
  gp_Trsf move;
  move.SetRotation(gp_Ax1({1.0, 2.0, 3.0}, {1.0, 1.0, 0.3}), 0.7);
  const TopoDS_Shape moved = block.Moved(TopLoc_Location(move));
  const Tessellation m = tessellate(moved, within(0.01));
  EXPECT_TRUE(m.closed) << m.reason;
  EXPECT_NEAR(volume(m.mesh), volume(t.mesh), 1e-6 * volume(t.mesh));
}

TEST(Tessellate, MirroredAndReversedSolidsFaceOutwards) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}));
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(1.0, 1.0, 1.0), 2.0, 3.0, 4.0).Solid();
  expect_solid(BRepBuilderAPI_Transform(box, mirror, true).Shape(), 24.0, 52.0);
  expect_solid(box.Reversed(), 24.0, 52.0);
}

TEST(Tessellate, NodesLieOnTheSurfaceAndTrianglesNear) {
  const double deflection = 0.001;
  const Tessellation t = tessellate(BRepPrimAPI_MakeSphere(5.0).Solid(), within(deflection));
  for (const Vec3& v : t.mesh.vertices) EXPECT_NEAR(v.norm(), 5.0, 1e-9);
  for (const auto& c : t.mesh.triangles) {
    const Vec3 middle =
        (t.mesh.vertices[c[0]] + t.mesh.vertices[c[1]] + t.mesh.vertices[c[2]]) / 3.0;
    EXPECT_LT(5.0 - middle.norm(), 2.0 * deflection);
  }
}

TEST(Tessellate, WhatIsNoClosedSolidIsSaid) {
  const Tessellation face = tessellate(table1_face(), within(0.01));
  EXPECT_FALSE(face.closed);
  EXPECT_NE(face.reason.find("open shell"), std::string::npos) << face.reason;
  EXPECT_FALSE(face.mesh.triangles.empty());
  EXPECT_FALSE(tessellate(TopoDS_Shape()).closed);
  TopoDS_Compound five;  // a box without its last face
  BRep_Builder builder;
  builder.MakeCompound(five);
  TopExp_Explorer e(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Solid(), TopAbs_FACE);
  for (int i = 0; i < 5; ++i, e.Next()) builder.Add(five, e.Current());
  EXPECT_FALSE(tessellate(five).closed);
  TopoDS_Face nothing;  // a face without a surface
  builder.MakeFace(nothing);
  builder.Add(five, nothing);
  const Tessellation broken = tessellate(five);
  EXPECT_FALSE(broken.closed);
  EXPECT_NE(broken.reason.find("Face6"), std::string::npos) << broken.reason;
}

TEST(Tessellate, BadOptionsAreNamed) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Solid();
  EXPECT_THROW(tessellate(box, {0.0, Angle::degrees(20)}), InputError);
  EXPECT_THROW(tessellate(box, {0.1, Angle::degrees(0)}), InputError);
}

}  // namespace
}  // namespace patchmill
