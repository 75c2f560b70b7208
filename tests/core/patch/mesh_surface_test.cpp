// What a mesh says of itself as a surface, and what is refused.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_fields.h"
#include "patchmill/geometry/error.h"
#include "patchmill/patch/seen_best.h"

#include <gtest/gtest.h>

namespace patchmill::patch {
namespace {

TEST(MeshSurface, SaysHowFarItIsFromASmoothOne) {
  double last = 0.0;
  for (const int n : {40, 80}) {
    const MeshSurface surface(field(n, waves), Angle::degrees(60));
    double off = 0.0;
    const auto places = random_places(4000, kHalf * (1.0 - 4.0 / n));
    for (const SurfaceSample& s : sampler_on(surface.mesh()).sample(places)) {
      const Vec3& p = s.point.position;
      off = std::max(off, std::abs(p.z() - waves(p.x(), p.y())));
    }
    EXPECT_GT(surface.chord_height(), 0.5 * off);
    EXPECT_LT(surface.chord_height(), 4.0 * off);
    EXPECT_GT(surface.normal_deviation().degrees(), 1.0);
    if (last > 0.0) {
      EXPECT_NEAR(surface.normal_deviation().radians() / last, 0.5, 0.05);
    }
    last = surface.normal_deviation().radians();
  }
}

TEST(MeshSurface, IsSeenBestFromAbove) {
  const MeshSurface surface(field(20, waves), Angle::degrees(60));
  const SeenBest found = seen_best(surface.area_vectors(), {1, 0, 0});
  EXPECT_FALSE(found.even);
  EXPECT_LT((found.direction - Vec3(0, 0, -1)).norm(), 0.2);
}

TEST(MeshSurface, RefusesWhatIsNone) {
  const Angle crease = Angle::degrees(30);
  mesh::TriangleMesh m = field(2, waves);
  EXPECT_THROW(MeshSurface(m, Angle::degrees(91)), InputError);
  EXPECT_THROW(MeshSurface(mesh::TriangleMesh(), crease), InputError);
  m.vertices[3].x() = std::nan("");
  EXPECT_THROW(MeshSurface(m, crease), InputError);
  m = field(2, waves);
  m.triangles[0][1] = 9;
  EXPECT_THROW(MeshSurface(m, crease), InputError);
  m.triangles = {{0, 0, 1}, {2, 2, 2}};
  EXPECT_THROW(MeshSurface(m, crease), InputError);
  EXPECT_THROW(MeshSampler(nullptr, TexturePlane(), crease), InputError);
}

}  // namespace
}  // namespace patchmill::patch
