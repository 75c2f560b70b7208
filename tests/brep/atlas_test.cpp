// Lattices laid on faces of OpenCASCADE: distances, coverage, seams, and that they move with the face.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/atlas_faces.h"
#include "patchmill/geometry/error.h"
#include "patchmill/patch/atlas/laid_lattice.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gtest/gtest.h>

namespace patchmill {
namespace {

TopoDS_Face face_of(const TopoDS_Shape& shape, int number = 1) {
  TopExp_Explorer e(shape, TopAbs_FACE);
  while (--number > 0) e.Next();
  return TopoDS::Face(e.Current());
}

TopoDS_Face cylinder(double radius, double height, double angle) {
  return face_of(BRepPrimAPI_MakeCylinder(radius, height, angle).Shape());
}

TopoDS_Face saddle(double half, double bend_x, double bend_y) {
  TColgp_Array2OfPnt points(1, 7, 1, 7);
  for (int i = 1; i <= 7; ++i)
    for (int j = 1; j <= 7; ++j) {
      const double x = (i - 4) / 3.0, y = (j - 4) / 3.0;
      points.SetValue(i, j, gp_Pnt(half * x, half * y, half * (bend_x * x * x - bend_y * y * y)));
    }
  return BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points).Surface(),
                                 Precision::Confusion());
}

struct Laid {
  patch::Dimples dimples;  // all that are laid, seen from everywhere
  double worth = 0.0;
  std::size_t pieces = 0;
  std::int64_t crowded = 0;

  double nearest() const {
    const std::vector<double> all = patch::nearest_distances(dimples);
    return all.empty() ? 0.0 : *std::min_element(all.begin(), all.end());
  }
  double coverage() const { return double(dimples.size()) / worth; }
};

Laid lay(const std::vector<TopoDS_Face>& faces, patch::PatchShape shape, double spacing,
         const patch::AtlasStart& start = {}) {
  const patch::PatchPattern pattern{shape, spacing, 3};
  patch::Atlas atlas = *patch::make_atlas(atlas_faces(faces), spacing, start);
  Laid laid;
  laid.worth = atlas.area / (patch::cell_area(patch::lattice_of(shape)) * spacing * spacing);
  laid.pieces = atlas.charts.size();
  const patch::LaidLattice lattice(std::move(atlas), pattern, !start.at);
  laid.crowded = lattice.crowded();
  for (patch::Dimple d : patch::lattice_points(lattice.cover())) {
    const patch::SurfaceSample sample = lattice.at(patch::to_vec(d.lattice));
    if (sample.state != patch::DimpleState::Cut) continue;
    d.surface = sample.point;
    laid.dimples.push_back(d);
  }
  return laid;
}

void expect_good(const Laid& laid, double spacing, double off = 0.1) {
  EXPECT_GE(laid.nearest(), patch::LaidLattice::kLeastDistance * spacing * (1.0 - 1e-12));
  EXPECT_NEAR(laid.coverage(), 1.0, off)
      << laid.dimples.size() << " of " << laid.worth << " in " << laid.pieces << " pieces, "
      << laid.crowded << " crowded";
}

gp_Trsf somewhere(std::mt19937& random) {
  std::normal_distribution<double> n;
  gp_Trsf turn, shift;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(n(random), n(random), n(random))), n(random));
  shift.SetTranslation(gp_Vec(20 * n(random), 20 * n(random), 20 * n(random)));
  return shift * turn;
}

struct Case {
  const char* name;
  TopoDS_Face face;
  double spacing;
};

std::vector<Case> bent_faces() {
  return {
      {"quarter cylinder", cylinder(1.0, 40.0, kPi / 2), 0.5},
      {"thin quarter cylinder", cylinder(0.19, 14.8, kPi / 2), 0.14},
      {"roller", cylinder(5.0, 20.0, 2 * kPi), 0.7},
      {"cone", face_of(BRepPrimAPI_MakeCone(9.0, 3.0, 12.0, 2.0).Shape()), 0.5},
      {"cone with its apex", face_of(BRepPrimAPI_MakeCone(8.0, 0.0, 9.0).Shape()), 0.6},
      {"quarter torus", face_of(BRepPrimAPI_MakeTorus(9.0, 3.0, 0.0, kPi / 2, 1.5).Shape()), 0.5},
      {"octant", face_of(BRepPrimAPI_MakeSphere(6.0, 0.0, kPi / 2, kPi / 2).Shape()), 0.4},
      {"dome", face_of(BRepPrimAPI_MakeSphere(8.0, kPi / 5, kPi / 2, 2 * kPi).Shape()), 0.5},
      {"sphere", face_of(BRepPrimAPI_MakeSphere(8.0).Shape()), 0.6},
      {"saddle", saddle(8.0, 0.5, 0.4), 0.5},
      {"bowl", saddle(8.0, 0.5, -0.3), 0.5}};
}

TEST(Atlas, DimplesAreApartAndCoverTheFace) {
  for (const Case& c : bent_faces())
    for (patch::PatchShape shape : {patch::PatchShape::Square, patch::PatchShape::Triangle}) {
      SCOPED_TRACE(std::string(c.name) +
                   (shape == patch::PatchShape::Square ? ", square" : ", triangular"));
      expect_good(lay({c.face}, shape, c.spacing), c.spacing);
    }
}

TEST(Atlas, ALatticeMovesWithItsFace) {
  std::mt19937 random(7);
  for (const Case& c : bent_faces()) {
    SCOPED_TRACE(c.name);
    const Laid here = lay({c.face}, patch::PatchShape::Hexagon, c.spacing);
    for (int placement = 0; placement < 2; ++placement) {
      const gp_Trsf move = somewhere(random);
      // by its location, and by a copy whose own geometry is moved
      const TopoDS_Face moved =
          placement ? TopoDS::Face(BRepBuilderAPI_Transform(c.face, move, true).Shape())
                    : TopoDS::Face(c.face.Moved(TopLoc_Location(move)));
      const Laid there = lay({moved}, patch::PatchShape::Hexagon, c.spacing);
      ASSERT_EQ(there.dimples.size(), here.dimples.size());
      double furthest = 0.0;
      for (std::size_t k = 0; k < here.dimples.size(); ++k) {
        const Vec3& p = here.dimples[k].surface.position;
        const gp_Pnt q = gp_Pnt(p.x(), p.y(), p.z()).Transformed(move);
        furthest = std::max(furthest,
                            (Vec3(q.X(), q.Y(), q.Z()) - there.dimples[k].surface.position).norm());
      }
      EXPECT_LT(furthest, 1e-3);
    }
  }
}

TEST(Atlas, FacesThatRollOutKeepEveryDistanceAlongThem) {
  const double radius = 4.0, f = 0.5;
  const Laid laid = lay({cylinder(radius, 10.0, 2.0)}, patch::PatchShape::Square, f);
  EXPECT_EQ(laid.pieces, 1u);
  const patch::SpacingSpread spread =
      patch::spacing_spread(laid.dimples, patch::LatticeKind::Square, f);
  EXPECT_NEAR(spread.along[0].least, 2.0 * radius / f * std::sin(0.5 * f / radius), 1e-9);
  EXPECT_NEAR(spread.along[0].greatest, spread.along[0].least, 1e-9);
  EXPECT_NEAR(spread.along[1].least, 1.0, 1e-9);
  EXPECT_NEAR(spread.along[1].greatest, 1.0, 1e-9);
}

TEST(Atlas, ARollerGetsAWholeNumberRoundAndNoSeam) {
  const double radius = 5.0, f = 0.7;
  for (patch::PatchShape shape : {patch::PatchShape::Square, patch::PatchShape::Hexagon}) {
    const Laid laid = lay({cylinder(radius, 20.0, 2 * kPi)}, shape, f);
    EXPECT_EQ(laid.crowded, 0);
    const double round = std::round(2 * kPi * radius / f);
    const double chord = 2.0 * radius * std::sin(kPi / round);
    for (const double d : patch::nearest_distances(laid.dimples))
      EXPECT_LT(std::abs(d - chord), 0.03 * f);
  }
}

TEST(Atlas, TheLatticeBeginsWhereItIsTold) {
  const TopoDS_Face face = cylinder(4.0, 10.0, 2.0);
  const auto at = find_on_faces({face}, Vec3(4.0 * std::cos(0.7), 4.0 * std::sin(0.7), 3.0));
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->second.x(), 0.7, 1e-9);
  patch::AtlasStart start;
  start.at = at;
  start.rotation = Angle::degrees(30.0);
  const Laid laid = lay({face}, patch::PatchShape::Square, 0.5, start);
  double nearest = 1e9;
  for (const patch::Dimple& d : laid.dimples)
    nearest = std::min(
        nearest, (d.surface.position - Vec3(4.0 * std::cos(0.7), 4.0 * std::sin(0.7), 3.0)).norm());
  EXPECT_LT(nearest, 1e-9);
  EXPECT_FALSE(find_on_faces({face}, Vec3(0.0, 0.0, 3.0)));
}

TEST(Atlas, NeighbouringFacesAreOneLattice) {
  // a cylinder's wall and the cone that goes on from it
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(5.0, 5.0001, 6.0, kPi / 2).Shape();
  const TopoDS_Face a = cylinder(5.0, 6.0, kPi / 2);
  const Laid one = lay({a}, patch::PatchShape::Square, 0.5),
             two = lay({a, face_of(cone)}, patch::PatchShape::Square, 0.5);
  EXPECT_EQ(one.pieces, 1u);
  EXPECT_EQ(two.pieces, 2u);  // they share no edge, so each has its own, and none lies on the other
  EXPECT_GE(two.nearest(), 0.45 * (1.0 - 1e-12));
}

}  // namespace
}  // namespace patchmill
