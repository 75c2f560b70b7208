// Signed distance from meshes against closed forms: boxes, wedges, spheres; and checks with them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/mesh_distance.h"

#include "patchmill/collision/frustum.h"
#include "patchmill/geometry/error.h"
#include "patchmill/mesh/signed_distance.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::collision {
namespace {

double box_distance(const Vec3& p, const Vec3& lo, const Vec3& hi) {
  const Vec3 out = (lo - p).cwiseMax(p - hi);
  const double outside = out.cwiseMax(0.0).norm();
  return outside > 0.0 ? outside : out.maxCoeff();
}

RC_GTEST_PROP(MeshDistance, OfABoxIsExact, (std::uint16_t a, std::uint16_t b, std::uint16_t c)) {
  const Vec3 lo(1.0, 2.0, 3.0), hi(3.0, 3.5, 7.0);
  static const PartDistance distance = distance_from_mesh(mesh::box_mesh(lo, hi));
  const Vec3 p(a % 500 * 0.01, b % 600 * 0.01, c % 1000 * 0.01);
  RC_ASSERT(std::abs(distance(p) - box_distance(p, lo, hi)) < 1e-12);
}

/// A sphere by latitude and longitude, with poles.
mesh::TriangleMesh sphere_mesh(double radius, int n) {
  mesh::TriangleMesh mesh;
  const auto at = [&](int i, int j) {
    const double u = kPi * i / n, v = kPi * (j % (2 * n)) / n;
    return Vec3(radius * Vec3(std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u)));
  };
  mesh::TriangleMesh loose;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      const auto k = static_cast<std::int32_t>(loose.vertices.size());
      for (const Vec3& v : {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)})
        loose.vertices.push_back(v);
      if (i > 0) loose.triangles.push_back({k, k + 2, k + 3});
      if (i < n - 1) loose.triangles.push_back({k, k + 1, k + 2});
    }
  for (Vec3& v : loose.vertices)  // the poles come out at x = 1e-16
    v = v.unaryExpr([](double x) { return std::abs(x) < 1e-12 ? 0.0 : x; });
  return mesh::weld(loose);
}

RC_GTEST_PROP(MeshDistance, OfASphereIsWithinTheChordsOfIt,
              (std::uint16_t a, std::uint16_t b, std::uint16_t c)) {
  static const PartDistance distance = distance_from_mesh(sphere_mesh(2.0, 60));
  const Vec3 p(a % 600 * 0.01 - 3.0, b % 600 * 0.01 - 3.0, c % 600 * 0.01 - 3.0);
  RC_ASSERT(std::abs(distance(p) - (p.norm() - 2.0)) < 2.0 * (1.0 - std::cos(kPi / 60)));
}

// The normals of smooth faces say the same side as the parity of crossings does, to the last bit.
RC_GTEST_PROP(MeshDistance, NormalsAndParityTellTheSameSide,
              (std::uint16_t a, std::uint16_t b, std::uint16_t c)) {
  static const mesh::TriangleMesh meshes[] = {sphere_mesh(2.0, 12),
                                              mesh::box_mesh({-1, -2, -1}, {1, 2, 2})};
  for (const mesh::TriangleMesh& one : meshes) {
    const mesh::TriangleBvh bvh(one);
    const Vec3 p(a % 600 * 0.01 - 3.0, b % 600 * 0.01 - 3.0, c % 600 * 0.01 - 3.0);
    RC_ASSERT(mesh::signed_distance(bvh, mesh::SmoothFaces(one), p) ==
              mesh::signed_distance(bvh, p));
  }
}

// A thin wedge: at its sharp edge the two faces look in opposite directions.
TEST(MeshDistance, SignIsRightAtASharpEdge) {
  mesh::TriangleMesh wedge;
  wedge.vertices = {{0, 0, 0}, {10, 0, 0}, {10, 0, 0.2}, {0, 5, 0}, {10, 5, 0}, {10, 5, 0.2}};
  wedge.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1},
                     {0, 2, 5}, {0, 5, 3}, {1, 4, 5}, {1, 5, 2}};
  const PartDistance distance = distance_from_mesh(wedge);
  for (int k = -20; k <= 20; ++k) {
    const Vec3 before(-1.0, 2.5, 0.05 * k);
    EXPECT_NEAR(distance(before), std::hypot(1.0, 0.05 * k), 1e-12);
  }
  EXPECT_NEAR(distance({5.0, 2.5, 0.05}), -0.05 * std::cos(std::atan(0.02)), 1e-9);
}

TEST(MeshDistance, AnOpenMeshIsRefused) {
  mesh::TriangleMesh open = mesh::box_mesh({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_THROW(distance_from_mesh(open), InputError);
}

ToolPath path_through(const std::vector<Vec3>& tips) {
  ToolPath path;
  path.tool = {1.0, 2};
  path.spindle = {10.0, SpindleSense::M3};
  path.start.tip = tips.front();
  for (std::size_t k = 1; k < tips.size(); ++k)
    path.moves.push_back({{tips[k], Vec3::UnitZ()}, 0.5, kNoDimple, MoveKind::Cut});
  return path;
}

// The distance of a section from a mesh against the least over very many points of it.
TEST(SectionDistance, IsTheLeastOverTheMesh) {
  const mesh::TriangleMesh mesh = sphere_mesh(2.0, 12);
  const mesh::TriangleBvh bvh(mesh);
  const ToolSection section{ToolPart::Holder, 1.0, 4.0, 1.5, 2.5};
  for (int k = 0; k < 40; ++k) {
    const Vec3 axis = Vec3(std::sin(0.4 * k), std::cos(1.1 * k), 0.3 * std::sin(k)).normalized();
    const ToolPose pose{3.0 * Vec3(std::cos(k), std::sin(0.7 * k), std::cos(0.3 * k)), axis};
    double least = 1e9;
    for (const auto& t : mesh.triangles)
      for (int i = 0; i <= 20; ++i)
        for (int j = 0; j + i <= 20; ++j) {
          const Vec3 p = mesh.vertices[t[0]] +
                         0.05 * i * (mesh.vertices[t[1]] - mesh.vertices[t[0]]) +
                         0.05 * j * (mesh.vertices[t[2]] - mesh.vertices[t[0]]);
          const Vec3 from = p - pose.tip;  // the closed form for a cone's side and caps
          const double h = from.dot(axis), r = (from - h * axis).norm();
          const double slope = std::atan(1.0 / 3.0);
          const double side = (r - 1.5) * std::cos(slope) - (h - 1.0) * std::sin(slope);
          const double inside = std::max({side, 1.0 - h, h - 4.0});
          if (inside <= 0.0) least = std::min(least, inside);
          least =
              std::min(least, frustum_distance(section.frustum(), pose.tip, pose.axis, p).value);
        }
    const SectionDistance found = nearest_section(bvh, section, pose, 1e9);
    EXPECT_LE(found.distance, least + 1e-5);
    EXPECT_GE(found.distance, least - 0.06);  // the points are so far apart
    EXPECT_NEAR(frustum_distance(section.frustum(), pose.tip, pose.axis, found.place).value,
                found.distance, 1e-12);
  }
}

// Flat meets flat: nothing to search.
TEST(SectionDistance, HolderComingDownOnAFlatPart) {
  const ToolSection holder{ToolPart::Holder, 25.0, 60.0, 20.0, 20.0};
  const auto report = check_sections(path_through({{0, 0, 40}, {0, 0, -25.2}}), {holder},
                                     shape_from_mesh(mesh::box_mesh({-20, -20, -60}, {20, 20, 0})));
  ASSERT_EQ(report.outcome, ClearanceOutcome::Violated);
  double worst = 0.0;
  for (const auto& f : report.findings)
    if (f.part == ToolPart::Holder) worst = std::max(worst, f.depth);
  EXPECT_NEAR(worst, 0.2 + 0.1, 1e-5);
}

/// A block of 40 x 40 x 10 with a wall of 2 x 40 x 30 on it, one closed mesh each.
PartShape block_with_wall() {
  return join({shape_from_mesh(mesh::box_mesh({-20, -20, -10}, {20, 20, 0})),
               shape_from_mesh(mesh::box_mesh({10, -20, -5}, {12, 20, 30}))});
}

const std::vector<ToolSection> kTool = {{ToolPart::Flute, 1.0, 8.0, 1.0, 1.0},
                                        {ToolPart::Shank, 8.0, 25.0, 1.5, 1.5},
                                        {ToolPart::Holder, 25.0, 60.0, 12.0, 16.0}};

const ClearanceOptions kRough{0.01, 0.1, 0.002, 1000};

TEST(MeshDistance, FlutesMayTouchAWallThatShankAndHolderMayNot) {
  const PartShape part = block_with_wall();
  // the flutes' cylinder touches the wall over two millimetres; the shank would stand 0.5 in it
  const auto clear =
      check_sections(path_through({{0, 0, 40}, {9, 0, 40}, {9, 0, 27}}), kTool, part, kRough);
  EXPECT_EQ(clear.outcome, ClearanceOutcome::Clear);
  const auto shank =
      check_sections(path_through({{9, 0, 23}, {9, 0, 21.5}}), {kTool[0], kTool[1]}, part, kRough);
  ASSERT_EQ(shank.outcome, ClearanceOutcome::Violated);
  for (const auto& f : shank.findings) EXPECT_EQ(f.part, ToolPart::Shank);
  EXPECT_NEAR(shank.findings[0].depth, 0.5 + 0.1, 0.02 * 0.6 + 0.001);
  const Vec3 at = shank.findings[0].place;  // on the wall, in the shank
  EXPECT_TRUE(at.x() > 10.0 - 1e-6 && at.x() < 10.5 + 1e-6) << at;
  EXPECT_TRUE(at.z() > 29.5 - 1e-6 && at.z() < 30.0 + 1e-6) << at;
  const auto holder =
      check_sections(path_through({{0, 0, 20}, {0, 0, 0}}), {kTool[2]}, part, kRough);
  ASSERT_EQ(holder.outcome, ClearanceOutcome::Violated);
  EXPECT_EQ(holder.findings[0].part, ToolPart::Holder);
  EXPECT_GT(holder.findings[0].place.x(), 10.0 - 1e-6);  // on the wall, above the block
  EXPECT_GT(holder.findings[0].place.z(), 25.0 - 1e-6);
  // at right angles to its side, 5 above its lower edge
  EXPECT_NEAR(holder.findings[0].depth,
              (12.0 + 4.0 * 5.0 / 35.0 - 10.0) * std::cos(std::atan(4.0 / 35.0)) + 0.1, 1e-5);
}

TEST(MeshDistance, FlutesThatSinkIntoAWallAreFound) {
  const auto report =
      check_sections(path_through({{0, 0, 1}, {9.2, 0, 1}}), {kTool[0]}, block_with_wall());
  ASSERT_EQ(report.outcome, ClearanceOutcome::Violated);
  bool flute = false;
  for (const auto& f : report.findings)
    if (f.part == ToolPart::Flute) {
      flute = true;
      EXPECT_NEAR(f.depth, 0.2 - 0.002, 0.01);
    }
  EXPECT_TRUE(flute);
}

}  // namespace
}  // namespace patchmill::collision
