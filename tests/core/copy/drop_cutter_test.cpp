// The dropped ball: closed forms, and a slow reference that comes down step by step.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/drop_probe.h"
#include "voxel/shapes.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::copy {
namespace {

// Comes down from above by the distance that is surely free, until the ball touches.
double by_sphere_tracing(const mesh::TriangleBvh& bvh, double x, double y, double radius) {
  double z = bvh.nodes()[0].hi.z() + radius + 1.0;
  for (int i = 0; i < 100000 && z > bvh.nodes()[0].lo.z() - 2 * radius; ++i) {
    const double gap = mesh::closest_point(bvh, Vec3(x, y, z)).distance - radius;
    if (gap < 1e-12) return z;
    z -= std::max(gap, 1e-13);
  }
  return kNoContact;
}

TEST(DropBall, RestsOnFaceEdgeAndCornerOfABox) {
  const mesh::TriangleBvh bvh(mesh::box_mesh(Vec3(0, 0, 0), Vec3(10, 20, 5)));
  EXPECT_DOUBLE_EQ(drop_ball(bvh, 4, 7, 3), 8.0);
  EXPECT_DOUBLE_EQ(drop_ball(bvh, 12, 7, 3), 5.0 + std::sqrt(9.0 - 4.0));
  EXPECT_DOUBLE_EQ(drop_ball(bvh, 11, 21.5, 3), 5.0 + std::sqrt(9.0 - 1.0 - 2.25));
  EXPECT_EQ(drop_ball(bvh, 13.5, 7, 3), kNoContact);
}

RC_GTEST_PROP(DropBall, RestsOnAPlaneOfAnySlope, ()) {
  const auto number = [](int lo, int hi) { return *rc::gen::inRange(lo * 100, hi * 100) / 100.0; };
  const double sx = number(-3, 3), sy = number(-3, 3), radius = number(1, 5);
  const auto at = [&](double x, double y) { return Vec3(x, y, sx * x + sy * y); };
  mesh::TriangleMesh mesh;
  mesh.vertices = {at(-100, -100), at(100, -100), at(100, 100), at(-100, 100)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const double x = number(-9, 9), y = number(-9, 9);
  const double exact = sx * x + sy * y + radius * std::sqrt(1 + sx * sx + sy * sy);
  RC_ASSERT(std::abs(drop_ball(mesh::TriangleBvh(mesh), x, y, radius) - exact) < 1e-10);
}

RC_GTEST_PROP(DropBall, EqualsSphereTracingOnRandomTriangles, (unsigned seed)) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-6, 6);
  mesh::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const int n = static_cast<int>(mesh.vertices.size());
    for (int k = 0; k < 3; ++k)
      mesh.vertices.emplace_back(place(random), place(random), place(random));
    mesh.triangles.push_back({n, n + 1, n + 2});
  }
  const mesh::TriangleBvh bvh(mesh);
  const double radius = 0.5 + 0.25 * (seed % 8);
  for (int i = 0; i < 5; ++i) {
    const double x = place(random), y = place(random);
    const double a = drop_ball(bvh, x, y, radius), b = by_sphere_tracing(bvh, x, y, radius);
    if (b == kNoContact) {
      RC_ASSERT(a == kNoContact);
    } else {
      RC_ASSERT(std::abs(a - b) < 1e-6);
    }
  }
}

// Triangles of all sizes and slopes, slivers and upright ones among them, far from the origin too.
struct RandomTriangles {
  std::mt19937 random;
  Vec3 far;
  double radius;
  mesh::TriangleMesh mesh;

  explicit RandomTriangles(unsigned seed) : random(seed) {
    far = std::pow(10.0, 4.0 * share()) * Vec3(share(), 1, -share());
    radius = std::pow(10.0, 2.0 * share() - 1.0);
    const int count = 1 + static_cast<int>(random() % 600);
    for (int i = 0; i < count; ++i) {
      const double size = std::pow(10.0, -3.0 * share());
      const Vec3 middle = far + Vec3(place(), place(), place());
      for (int k = 0; k < 3; ++k)
        mesh.vertices.push_back(middle + size * Vec3(place(), place(), place()));
      if (i % 5 == 0) mesh.vertices[3 * i + 2].head<2>() = mesh.vertices[3 * i].head<2>();
      if (i % 7 == 0)
        mesh.vertices[3 * i + 2] += 0.999 * (mesh.vertices[3 * i + 1] - mesh.vertices[3 * i + 2]);
      mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
  }
  double share() { return std::uniform_real_distribution<double>(0, 1)(random); }
  double place() { return std::uniform_real_distribution<double>(-6, 6)(random); }
  double largest(const mesh::TriangleBvh& bvh, double x, double y) const {
    double z = kNoContact;
    for (const mesh::Triangle& t : bvh.triangles()) z = std::max(z, drop_ball_on(t, x, y, radius));
    return z;
  }
};

RC_GTEST_PROP(DropBall, IsTheLargestOverAllTriangles, (unsigned seed)) {
  RandomTriangles some(seed);
  const mesh::TriangleBvh bvh(some.mesh);
  for (int i = 0; i < 20; ++i) {
    const double x = some.far.x() + some.place(), y = some.far.y() + some.place();
    RC_ASSERT(drop_ball(bvh, x, y, some.radius) == some.largest(bvh, x, y));
  }
}

// To the last bit, on ways with long and short steps, to and fro, jumps, and the same place twice.
RC_GTEST_PROP(DropProbe, IsTheLargestOverAllTriangles, (unsigned seed)) {
  RandomTriangles some(seed);
  const mesh::TriangleBvh bvh(some.mesh);
  DropProbe probe(bvh, some.radius);
  for (int line = 0; line < 4; ++line) {
    Vec2 p = some.far.head<2>() + Vec2(some.place(), some.place());
    Vec2 step = std::pow(10.0, -3.0 * some.share()) * Vec2(some.place(), some.place());
    if (line % 2 == 0) step.y() = 0.0;
    for (int i = 0; i < 25; ++i) {
      RC_ASSERT(probe(p.x(), p.y()) == some.largest(bvh, p.x(), p.y()));
      p += i % 5 == 3 ? Vec2(-0.6 * step) : i % 5 == 4 ? Vec2::Zero() : step;
    }
  }
}

TEST(DropProbe, FollowsSmoothAndSteepPartsToTheLastBit) {
  for (const mesh::TriangleMesh& mesh :
       {shapes::convex_part(40), shapes::sphere(Vec3(20, 20, 5), 12, 4),
        mesh::box_mesh(Vec3(10, 10, 0), Vec3(30, 40, 7))}) {
    const mesh::TriangleBvh bvh(mesh);
    for (const double radius : {0.3, 3.0, 11.0}) {
      DropProbe probe(bvh, radius);
      for (int i = 0; i < 6000; ++i) {
        const double x = -4.0 + 0.3 * (i % 200), y = -4.0 + 1.9 * (i / 200);
        ASSERT_EQ(probe(x, y), drop_ball(bvh, x, y, radius)) << x << ' ' << y << ' ' << radius;
      }
    }
  }
}

TEST(DropBall, OnASphereItIsAnotherSphere) {
  // a ball of R on a sphere of r: the centre is on a sphere of R + r, less the sag of the facets,
  // which for a facet of edge e is at most (e / sqrt 3)^2 / 2 r along the normal
  const mesh::TriangleMesh mesh = shapes::sphere(Vec3::Zero(), 10, 5);
  const mesh::TriangleBvh bvh(mesh);
  double edge = 0.0;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      edge = std::max(edge, (mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]).norm());
  const double sag = edge * edge / 3.0 / 20.0;
  for (double x = -9; x <= 9; x += 1.5) {
    const double exact = std::sqrt(13.0 * 13.0 - x * x - 4.0), z = drop_ball(bvh, x, 2.0, 3.0);
    EXPECT_LE(z, exact + 1e-12);
    EXPECT_GE(z, exact - 1.01 * sag * 13.0 / exact);
  }
}

TEST(DropBall, ManyAtOnceAreTheSame) {
  const mesh::TriangleBvh bvh(shapes::convex_part(20));
  std::vector<Vec2> xy;
  for (int i = 0; i < 500; ++i) xy.emplace_back(i % 50 + 0.3, i / 10.0);
  const std::vector<double> z = drop_balls(bvh, xy, 3.0);
  for (std::size_t i = 0; i < xy.size(); ++i)
    EXPECT_EQ(z[i], drop_ball(bvh, xy[i].x(), xy[i].y(), 3.0));
}

}  // namespace
}  // namespace patchmill::copy
