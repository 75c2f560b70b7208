// The axis that keeps a holder clear, against a dense sampling of the holder's surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/clear_axis.h"

#include "patchmill/dcm/apply_dcm.h"
#include "patchmill/geometry/error.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::collision {
namespace {

// A shank of radius 3 and a holder of radius 12 that begins 20 mm above the ball.
const std::vector<HolderSection> kHolder{{1.0, 20.0, 3.0, 3.0}, {20.0, 50.0, 12.0, 14.0}};

// The part lies in the ball of `radius` at the origin: a sample further from that than the least one is passed over.
double sampled_distance(const mesh::TriangleBvh& part, double radius,
                        const std::vector<HolderSection>& holder, const Vec3& centre,
                        const Vec3& axis, int n) {
  const Vec3 u = any_normal_to(axis), v = axis.cross(u);
  double least = 1e9;
  const auto look = [&](double h, double r) {
    for (int k = 0; k < n; ++k) {
      const double a = 2.0 * kPi * k / n;
      const Vec3 p = centre + h * axis + r * (std::cos(a) * u + std::sin(a) * v);
      if (p.norm() - radius < least) least = std::min(least, mesh::closest_point(part, p).distance);
    }
  };
  for (const HolderSection& s : holder)
    for (int i = 0; i <= n; ++i) {
      const double t = double(i) / n;
      look(s.from + t * (s.to - s.from), s.radius_from + t * (s.radius_to - s.radius_from));
      look(s.from, t * s.radius_from);
      look(s.to, t * s.radius_to);
    }
  return least;
}

// Nearest point of the solid frustum by trying many, and the tangent plane that must lie below.
RC_GTEST_PROP(Frustum, DistanceIsThatOfTheNearestPointAndConvex, (unsigned seed)) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&](double size) -> Vec3 {
    return size * Vec3(number(random), number(random), number(random));
  };
  const double from = 1.0 + number(random);
  const HolderSection s{from, from + 3.0 + 2.0 * number(random),
                        std::max(0.0, 3.0 * number(random)), 2.0 + 2.0 * number(random)};
  const Vec3 centre = vector(5), axis = (vector(1) + Vec3(0, 0, 1e-3)).normalized();
  const Vec3 p = centre + vector(12);
  const SignedDistance d = frustum_distance(s, centre, axis, p);
  double sampled = 1e9;
  const Vec3 u = any_normal_to(axis), v = axis.cross(u);
  for (int i = 0; i <= 60; ++i)
    for (int k = 0; k < 120; ++k)
      for (const double across : {1.0, i / 60.0}) {
        const double share = across < 1.0 ? double(k % 2) : i / 60.0;
        const double h = s.from + share * (s.to - s.from), a = 2 * kPi * k / 120;
        const double r = across * (s.radius_from + share * (s.radius_to - s.radius_from));
        const Vec3 q = centre + h * axis + r * (std::cos(a) * u + std::sin(a) * v);
        sampled = std::min(sampled, (q - p).norm());
      }
  RC_ASSERT(std::abs(d.value) <= sampled + 1e-9);
  RC_ASSERT(std::abs(d.value) >= sampled - 0.25);  // spacing of the samples
  RC_ASSERT(d.gradient.norm() <= 1.0 + 1e-9);
  for (int i = 0; i < 50; ++i) {
    const Vec3 q = p + vector(i % 2 ? 8.0 : 0.1);
    RC_ASSERT(frustum_distance(s, centre, axis, q).value >= d.value + d.gradient.dot(q - p) - 1e-9);
  }
}

RC_GTEST_PROP(HolderDistance, AgreesWithADenseSampling, ()) {
  const auto real = [](double lo, double hi) {
    return lo + (hi - lo) * *rc::gen::inRange(0, 1001) / 1000;
  };
  const mesh::TriangleBvh part(shapes::sphere(Vec3(0, 0, 0), 10.0, 3));
  const Vec3 centre(real(12, 30), real(-20, 20), real(-20, 20));
  const Vec3 axis = Vec3(real(-1, 1), real(-1, 1), real(0.1, 1)).normalized();
  const double found = holder_distance(part, kHolder, centre, axis, 0.05, 1e3);
  const double sampled = sampled_distance(part, 10.0, kHolder, centre, axis, 60);
  RC_ASSERT(found <= sampled + 0.05);
  if (sampled > 2.0) RC_ASSERT(found >= sampled - 1.5);  // spacing of the samples
}

TEST(HolderDistance, OfAHolderBesideAWall) {
  const mesh::TriangleBvh wall(mesh::box_mesh(Vec3(20, -50, -50), Vec3(40, 50, 80)));
  // the wider end of the holder, radius 14, is nearest: 20 - 14 - 3
  EXPECT_NEAR(holder_distance(wall, kHolder, Vec3(3, 0, 0), Vec3::UnitZ(), 0.01, 100), 3.0, 0.011);
  EXPECT_EQ(holder_distance(wall, kHolder, Vec3(10, 0, 0), Vec3::UnitZ(), 0.01, 100), 0.0);
}

TEST(HolderDistance, OfAPartThatIsWithinTheHolder) {
  const mesh::TriangleBvh pin(mesh::box_mesh(Vec3(-1, -1, 30), Vec3(1, 1, 32)));
  EXPECT_EQ(holder_distance(pin, kHolder, Vec3::Zero(), Vec3::UnitZ(), 0.01, 10), 0.0);
}

TEST(ClearAxis, LeavesAClearAxisAsItIs) {
  const mesh::TriangleBvh wall(mesh::box_mesh(Vec3(20, -50, -50), Vec3(40, 50, 80)));
  const Vec3 wanted = Vec3(-0.2, 0.1, 1).normalized();
  const ClearAxis found = clear_axis(wall, kHolder, Vec3(0, 0, 0), wanted);
  EXPECT_TRUE(found.clear);
  EXPECT_EQ(found.axis, wanted);
}

TEST(ClearAxis, YieldsToTheNearestClearOne) {
  const mesh::TriangleBvh wall(mesh::box_mesh(Vec3(20, -200, -50), Vec3(40, 200, 80)));
  const Vec3 wanted = Vec3(std::sin(0.5), 0, std::cos(0.5));
  ClearOptions options;
  options.clearance = 2.0;
  const Vec3 centre(4, 0, 0);
  const ClearAxis found = clear_axis(wall, kHolder, centre, wanted, options);
  ASSERT_TRUE(found.clear);
  EXPECT_GE(holder_distance(wall, kHolder, centre, found.axis, 0.01, 10), 2.0);
  // in the plane of the tilt by hand: the rim at height 50, radius 14 is at x = 4 + 50 sin a + 14 cos a
  double by_hand = 0.5;
  while (4 + 50 * std::sin(by_hand) + 14 * std::cos(by_hand) > 18.0) by_hand -= 1e-5;
  EXPECT_NEAR(std::acos(found.axis.dot(wanted)), 0.5 - by_hand, Angle::degrees(0.2).radians());
}

// However coarse the resolution, the clearance is kept by a distance that is found much finer.
RC_GTEST_PROP(ClearAxis, KeepsItsClearanceAtAnyResolution, ()) {
  const auto real = [](double lo, double hi) {
    return lo + (hi - lo) * *rc::gen::inRange(0, 1001) / 1000;
  };
  const mesh::TriangleBvh part(shapes::sphere(Vec3(0, 0, 0), 10.0, 3));
  const Vec3 out = Vec3(real(-1, 1), real(-1, 1), real(-1, 1)) + Vec3(0, 0, 1e-3);
  const Vec3 centre = 13.0 * out.normalized();
  const Vec3 wanted = (out.normalized() + Vec3(real(-1, 1), real(-1, 1), real(-1, 1))).normalized();
  ClearOptions options;
  options.clearance = 2.0;
  options.resolution = *rc::gen::element(0.02, 0.2, 1.0);
  const std::vector<HolderSection> holder{{3.0, 20.0, 3.0, 3.0}, {20.0, 50.0, 12.0, 14.0}};
  const ClearAxis found = clear_axis(part, holder, centre, wanted, options);
  RC_CLASSIFY(found.clear && found.axis != wanted, "yields");
  if (found.clear) RC_ASSERT(holder_distance(part, holder, centre, found.axis, 1e-4, 10.0) >= 2.0);
}

TEST(ClearAxis, SaysWhereThereIsNone) {
  mesh::TriangleMesh
      pit;  // a hole of radius about 5 in which the holder cannot go whatever its axis
  pit = shapes::block_with_top(100, 100, 40, [](double u, double v) {
    const double r = std::hypot(100 * u - 50, 100 * v - 50);
    return Vec3(100 * u, 100 * v, r < 8 ? 10.0 : 60.0);
  });
  const ClearAxis found =
      clear_axis(mesh::TriangleBvh(pit), kHolder, Vec3(50, 50, 14), Vec3::UnitZ());
  EXPECT_FALSE(found.clear);
  EXPECT_EQ(found.axis, Vec3::UnitZ());
}

TEST(ClearAxis, RefusesBadOptions) {
  const mesh::TriangleBvh wall(mesh::box_mesh(Vec3(20, -50, -50), Vec3(40, 50, 80)));
  ClearOptions options;
  options.clearance = 0.0;
  EXPECT_THROW(clear_axis(wall, kHolder, Vec3(0, 0, 0), Vec3::UnitZ(), options), InputError);
  EXPECT_THROW(clear_axis(wall, {{5, 4, 1, 1}}, Vec3(0, 0, 0), Vec3::UnitZ()), InputError);
}

// The ball all along the overhanging part's section at y, where it fits.
ToolPath along_the_section(const mesh::TriangleBvh& part, double y) {
  const auto surface = [&](double u) {
    const double bump = std::pow(std::sin(kPi * u), 2), lean = (20.0 + 10.0 * y / 50) * bump;
    return Vec3(60 * u + lean * std::sin(kPi * u), y, 8.0 + 22.0 * bump);
  };
  ToolPath path;
  path.tool = {3.0, 2};
  path.spindle.speed = 150.0;
  for (double u = 0.02; u < 0.98; u += 0.01) {
    const Vec3 d = surface(u + 1e-5) - surface(u - 1e-5);
    const Vec3 centre = surface(u) + 3.0 * Vec3(-d.z(), 0, d.x()).normalized();
    if (mesh::closest_point(part, centre).distance < 2.9) continue;
    Move move;
    move.kind = path.moves.empty() ? MoveKind::Rapid : MoveKind::Cut;
    move.end.tip = centre - Vec3(0, 0, 3);
    move.turns = 10.0;
    path.moves.push_back(move);
  }
  path.start = path.moves.front().end;
  return path;
}

// The overhanging part of the paper: its posture drives this holder into the part; with the rule it does
// not, and the ball centre is where it was.
TEST(ClearAxis, KeepsTheHolderOutWhereThePapersPostureDrivesItIn) {
  const mesh::TriangleMesh part = shapes::overhanging_part(40);
  const mesh::TriangleBvh bvh(part);
  voxel::VoxelOptions voxels;
  voxels.pitch = 2.0;
  const voxel::VoxelGrid grid =
      voxel::voxelise(mesh::box_mesh(Vec3::Zero(), Vec3(76, 50, 40)), part, voxels);
  const dcm::PostureField posture = dcm::steady_posture(grid, part, bvh);
  const std::vector<HolderSection> holder{{3.0, 8.0, 2.5, 2.5}, {8.0, 40.0, 15.0, 15.0}};
  const ToolPath path = along_the_section(bvh, 40.0);
  dcm::DcmOptions options;
  const ToolPath blind = dcm::apply_dcm(path, grid, nullptr, &posture, options);
  ClearOptions clear;
  clear.clearance = 1.0;
  std::int64_t none = 0;
  options.axis_rule = [&](const Vec3& c, const Vec3& wanted) {
    const ClearAxis found = clear_axis(bvh, holder, c, wanted, clear);
    none += found.clear ? 0 : 1;
    return found.axis;
  };
  const ToolPath seeing = dcm::apply_dcm(path, grid, nullptr, &posture, options);
  const PathClearance before = path_clearance(bvh, holder, blind, clear);
  const PathClearance after = path_clearance(bvh, holder, seeing, clear);
  std::printf("least distance of the holder: %.3f mm before, %.3f mm after (%ld of %zu moves)\n",
              before.least, after.least, long(after.too_near), seeing.moves.size());
  EXPECT_EQ(none, 0);
  EXPECT_LT(before.least, 0.05);  // it does collide
  EXPECT_GE(after.least, clear.clearance);
  EXPECT_NEAR(
      (ball_centre(seeing.moves.back().end, 3.0) - ball_centre(path.moves.back().end, 3.0)).norm(),
      0.0, 1e-9);
}

}  // namespace
}  // namespace patchmill::collision
