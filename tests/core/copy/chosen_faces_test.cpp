// Copy milling of chosen faces: nothing else is touched, all of the face is, and the layers over it go with it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/chosen_faces.h"

#include "patchmill/geometry/error.h"
#include "voxel/shapes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace patchmill::copy {
namespace {

constexpr double kRadius = 3.0, kTolerance = 0.01;

// Two steps beside each other: 0 <= x <= 20 is 4 mm high, 20 <= x <= 40 is 10 mm; 30 mm wide. The wall between
// them is at x = 20.
mesh::TriangleMesh steps() {
  const double x[] = {0, 20, 20, 40}, z[] = {4, 4, 10, 10};
  mesh::TriangleMesh mesh;
  for (int i = 0; i < 4; ++i)
    for (const double y : {0.0, 30.0}) mesh.vertices.emplace_back(x[i], y, z[i]);
  for (std::int32_t i = 0; i < 3; ++i) {
    mesh.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 1});
    mesh.triangles.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
  }
  return mesh;
}

mesh::TriangleMesh only(const mesh::TriangleMesh& mesh, std::size_t first) {
  mesh::TriangleMesh some = mesh;
  some.triangles = {mesh.triangles[2 * first], mesh.triangles[2 * first + 1]};
  return some;
}

CopyOptions options(CopyMode mode) {
  CopyOptions o;
  o.mode = mode;
  o.tool = {kRadius, 2};
  o.spindle.speed = 100.0;
  o.feed = 5.0;
  o.radial_depth = 1.0;
  o.axial_depth = 2.0;
  o.tolerance = kTolerance;
  o.stock.include({0, 0, 4});
  o.stock.include({40, 30, 12});
  return o;
}

struct Extent {
  mesh::Box box;
  double cut = 0.0;
};

// Of the cuts over the part, not of those around its open sides.
Extent extent(const ToolPath& path) {
  Extent e;
  Vec3 from = path.start.tip;
  for (const Move& move : path.moves) {
    const double y = std::min(from.y(), move.end.tip.y());
    if (move.kind == MoveKind::Cut && y >= 0.0 && std::max(from.y(), move.end.tip.y()) <= 30.0) {
      e.box.include(from);
      e.box.include(move.end.tip);
      e.cut += (move.end.tip - from).norm();
    }
    from = move.end.tip;
  }
  return e;
}

class ChosenFaces : public testing::TestWithParam<CopyMode> {
 protected:
  const mesh::TriangleMesh mesh = steps();
  const mesh::TriangleBvh part{mesh};
  const CopyOptions o = options(GetParam());
  const ToolPath whole = copy_mill(part, o).path;

  ToolPath over(std::size_t face) const {
    return over_faces(whole, part, mesh::TriangleBvh(only(mesh, face)), o);
  }
};

TEST_P(ChosenFaces, TheFloorUpToTheWall) {
  const Extent e = extent(over(0));
  EXPECT_NEAR(e.box.lo.z(), 4.0, kTolerance);
  EXPECT_LE(e.box.hi.x(), 20.0 - kRadius + 2 * kTolerance);  // the ball stands at the wall
  EXPECT_GE(e.box.hi.x(), 20.0 - kRadius - 0.1);
  EXPECT_LE(e.box.lo.x(), 0.5);
  EXPECT_LE(e.box.lo.y(), 0.5);
  EXPECT_GE(e.box.hi.y(), 29.5);
}

TEST_P(ChosenFaces, TheUpperStep) {
  const Extent e = extent(over(2));
  // over its edges the ball rolls by 60 degrees
  EXPECT_GE(e.box.lo.z(), 10.0 - 0.5 * kRadius - 0.05);
  EXPECT_GE(e.box.lo.x(), 20.0 - 0.87 * kRadius - 0.05);
  EXPECT_LE(e.box.lo.x(), 20.0);
  EXPECT_LE(e.box.hi.x(), 40.0 + 0.87 * kRadius + 0.05);
  EXPECT_GE(e.box.hi.x(), 39.5);
}

TEST_P(ChosenFaces, TheLayersOverAFaceGoWithIt) {
  double levels[4] = {};  // mm of cuts at 10, 8, 6 and 4 mm over the floor
  Vec3 from = whole.start.tip;
  for (const Move& move : over(0).moves) {
    const double z = move.end.tip.z();
    const long level = std::lround((10.0 - z) / 2.0);
    if (move.kind == MoveKind::Cut && level >= 0 && level < 4 &&
        std::abs(z - (10.0 - 2.0 * level)) < 1e-6)
      levels[level] += (move.end.tip - from).norm();
    from = move.end.tip;
  }
  for (const double length : levels)
    EXPECT_GT(length, 15.0 * 30.0 / 1.2);  // lines 1 mm apart over it
}

TEST_P(ChosenFaces, AllFacesAreTheWholePath) {
  const ToolPath all = over_faces(whole, part, part, o);
  EXPECT_NEAR(extent(all).cut, extent(whole).cut, 0.1 * extent(whole).cut);
}

TEST_P(ChosenFaces, NothingOfAFaceThatTheBallDoesNotReach) {
  mesh::TriangleMesh away = only(mesh, 0);
  for (Vec3& v : away.vertices) v.z() -= 50.0;
  EXPECT_EQ(extent(over_faces(whole, part, mesh::TriangleBvh(away), o)).cut, 0.0);
}

TEST_P(ChosenFaces, TheSameOnAnyNumberOfRuns) {
  const ToolPath a = over(0), b = over(0);
  ASSERT_EQ(a.moves.size(), b.moves.size());
  for (std::size_t i = 0; i < a.moves.size(); ++i)
    EXPECT_EQ(a.moves[i].end.tip, b.moves[i].end.tip);
}

INSTANTIATE_TEST_SUITE_P(Modes, ChosenFaces, testing::Values(CopyMode::Scanning, CopyMode::Contour),
                         [](const auto& info) {
                           return info.param == CopyMode::Scanning ? "Scanning" : "Contour";
                         });

}  // namespace
}  // namespace patchmill::copy
