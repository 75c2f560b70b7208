// A live session: batches join, conditions change half-way, nothing is gouged, cut too deep or left.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/live_session.h"

#include "patchmill/copy/drop_cutter.h"
#include "patchmill/dcm/field_reader.h"
#include "patchmill/geometry/error.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace patchmill::copy {
namespace {

constexpr double kRadius = 3.0;
const Vec3 kStock(50, 50, 30);

struct Fixture {
  mesh::TriangleMesh part = shapes::convex_part(24);
  mesh::TriangleBvh bvh{part};
  voxel::VoxelGrid grid;
  CopyOptions options;
  Fixture() {
    voxel::VoxelOptions voxels;
    voxels.pitch = 2.0;
    grid = voxel::voxelise(mesh::box_mesh(Vec3::Zero(), kStock), part, voxels);
    options.tool = {kRadius, 2};
    options.spindle.speed = 100.0;
    options.feed = 400.0 / 60.0;
    options.radial_depth = 2.0;
    options.axial_depth = 3.0;
    options.overlap = 0.87 * kRadius;
    options.stock.include(Vec3::Zero());
    options.stock.include(kStock);
  }
};

// The stock as heights over a fine grid, lowered by the ball along the moves.
struct HeightMap {
  static constexpr double kCell = 0.5;
  static constexpr int kCount = 101;
  std::vector<double> z = std::vector<double>(kCount * kCount, kStock.z());
  double deepest = 0.0;  // of the tip under the material over it, in any cut

  void pass(const Vec3& centre) {
    const int i = static_cast<int>(std::lround(centre.x() / kCell));
    const int j = static_cast<int>(std::lround(centre.y() / kCell));
    if (i >= 0 && j >= 0 && i < kCount && j < kCount)
      deepest = std::max(deepest, z[j * kCount + i] - (centre.z() - kRadius));
    const int reach = static_cast<int>(kRadius / kCell) + 1;
    for (int b = std::max(0, j - reach); b <= std::min(kCount - 1, j + reach); ++b)
      for (int a = std::max(0, i - reach); a <= std::min(kCount - 1, i + reach); ++a) {
        const double d2 = std::pow(a * kCell - centre.x(), 2) + std::pow(b * kCell - centre.y(), 2);
        if (d2 >= kRadius * kRadius) continue;
        const double low = centre.z() - std::sqrt(kRadius * kRadius - d2);
        z[b * kCount + a] = std::min(z[b * kCount + a], low);
      }
  }
};

struct Check {
  HeightMap map;
  Vec3 last = Vec3::Constant(std::nan(""));
  double gouge = 0.0, slowest = 1e9, fastest = 0.0, seconds = 0.0;

  void batch(const Fixture& f, const ToolPath& path, double limit) {
    if (!std::isnan(last.x())) {
      EXPECT_LT((path.start.tip - last).norm(), 1e-9);
    }
    Vec3 from = path.start.tip;
    double sum = 0.0;
    for (const Move& move : path.moves) {
      const double length = (move.end.tip - from).norm();
      const int n = 1 + static_cast<int>(length / 0.25);
      for (int k = 1; k <= n; ++k) {
        const Vec3 centre = from + k * (move.end.tip - from) / n + Vec3(0, 0, kRadius);
        const auto cross = mesh::line_crossings(f.bvh, centre.y(), centre.z());
        const bool inside =
            (std::upper_bound(cross.begin(), cross.end(), centre.x()) - cross.begin()) % 2 == 1;
        const double d = mesh::closest_point(f.bvh, centre, kRadius + 1.0).distance;
        gouge = std::max(gouge, kRadius - (inside ? -d : d));
        map.pass(centre);
      }
      if (move.kind != MoveKind::Rapid && length > 1e-6) {
        const double feed = length / duration(move, path.spindle);
        slowest = std::min(slowest, feed);
        fastest = std::max(fastest, feed);
        sum += duration(move, path.spindle);
      }
      from = move.end.tip;
    }
    EXPECT_LE(sum, limit * (1 + 1e-9));
    seconds += sum;
    last = from;
  }

  // Everything is cut down to the part but for the scallops, and to the floor beside it.
  void expect_finished(const Fixture& f, double radial) const {
    double most = 0.0;
    for (int j = 0; j < HeightMap::kCount; ++j)
      for (int i = 0; i < HeightMap::kCount; ++i) {
        const double x = i * HeightMap::kCell, y = j * HeightMap::kCell;
        const double surface = drop_ball(f.bvh, x, y, 0.001);
        const double left = map.z[j * HeightMap::kCount + i] - surface;
        if (std::isfinite(surface)) most = std::max(most, left);
      }
    // lines b apart are b / cos(a) apart on a slope of a, and a ridge is 1 / cos(a) as high over the line below
    const double steepest = std::cos(std::atan(20.0 * kPi / 50.0));
    EXPECT_LT(most, scallop_height(Tool{kRadius, 2}, radial / steepest) / steepest + 0.02);
  }
};

constexpr dcm::FeedLimits kFeed{400.0 / 60.0, 800.0 / 60.0};

TEST(LiveSession, CutsTheWholePartInBatches) {
  const Fixture f;
  LiveSession session(f.bvh, f.grid, f.options, kFeed);
  Check check;
  int batches = 0;
  while (!session.done()) {
    check.batch(f, session.next(2.0), 2.0);
    ASSERT_LT(++batches, 100000);
  }
  EXPECT_TRUE(session.next(2.0).moves.empty());
  EXPECT_LE(check.gouge, f.options.tolerance);
  EXPECT_LE(check.map.deepest, f.options.axial_depth + 0.01);
  EXPECT_GE(check.slowest, kFeed.low * (1 - 1e-9));
  EXPECT_LE(check.fastest, kFeed.high * (1 + 1e-9));
  check.expect_finished(f, f.options.radial_depth);
  std::printf("%d batches, %.0f s\n", batches, check.seconds);
}

TEST(LiveSession, GoesOnFromWhereItIsWhenConditionsChange) {
  const Fixture f;
  LiveSession session(f.bvh, f.grid, f.options, kFeed);
  Check check;
  const LiveConditions given[] = {{2.0, 1.0, {300.0 / 60, 500.0 / 60}},
                                  {1.0, 5.0, {300.0 / 60, 500.0 / 60}},
                                  {3.0, 2.0, {600.0 / 60, 1200.0 / 60}}};
  for (int batches = 0; !session.done(); ++batches) {
    ASSERT_LT(batches, 100000);
    if (batches % 137 == 100) {  // at all kinds of moments: in a cut, a lift, a plunge
      const LiveConditions& to = given[batches / 137 % 3];
      const double y = session.line();
      session.change(to);
      EXPECT_EQ(session.line(), y);
      check.slowest = 1e9;
      check.fastest = 0.0;
      check.map.deepest = 0.0;
    }
    check.batch(f, session.next(0.7), 0.7);
    const LiveConditions& now = session.conditions();
    if (batches % 137 == 99 || batches % 137 == 50) {
      EXPECT_GE(check.slowest, now.feed.low * (1 - 1e-9));
      EXPECT_LE(check.fastest, now.feed.high * (1 + 1e-9));
      EXPECT_LE(check.map.deepest, now.axial_depth + 0.05) << batches;
    }
  }
  EXPECT_LE(check.gouge, f.options.tolerance);
  check.expect_finished(f, 3.0);
}

// With V_Lo = V_Hi = v the steady field is v everywhere, so that the feed is v times the factor wherever all
// voxels that are read are of one material.
TEST(LiveSession, SlowsInAMaterialBeforeAndAfterAChange) {
  const Fixture f;
  const mesh::TriangleMesh insert = mesh::box_mesh(Vec3(-1, -1, -1), Vec3(25, 51, 31));
  const mesh::TriangleBvh insert_bvh(insert);
  const dcm::FeedFactors factors{dcm::materials_of(f.grid, {{&insert, &insert_bvh}}), {1.0, 0.25}};
  double v = 8.0;
  LiveSession session(f.bvh, f.grid, f.options, {v, v}, {}, factors);
  Check check;
  int slow = 0, plain = 0;
  for (int batches = 0; !session.done(); ++batches) {
    ASSERT_LT(batches, 100000);
    if (batches == 3000) session.change({2.0, 3.0, {v = 16.0, v}});
    const ToolPath path = session.next(0.7);
    check.batch(f, path, 0.7);
    Vec3 from = ball_centre(path.start, kRadius);
    for (const Move& move : path.moves) {
      const Vec3 to = ball_centre(move.end, kRadius);
      double least = 1.0, most = 0.0;
      for (const Vec3& p : {from, to}) {
        const dcm::ReadingStencil at = dcm::reading_stencil(f.grid, p, dcm::Reading::Trilinear);
        for (int i = 0; i < at.size; ++i) {
          least = std::min(least, factors.factor[factors.material[at.cell[i]]]);
          most = std::max(most, factors.factor[factors.material[at.cell[i]]]);
        }
        if (at.air > 0.0) most = 1.0;
      }
      if (move.kind != MoveKind::Rapid && (to - from).norm() > 1e-6 && least == most) {
        ASSERT_NEAR((to - from).norm() / duration(move, path.spindle), least * v, 1e-6);
        ++(least < 1.0 ? slow : plain);
      }
      from = to;
    }
  }
  EXPECT_GT(slow, 1000);
  EXPECT_GT(plain, 1000);
  EXPECT_NEAR(check.slowest, 2.0, 1e-6);
  std::printf("%d moves in the material, %d outside\n", slow, plain);
}

TEST(LiveSession, RefusesAConditionAndStaysAsItWas) {
  const Fixture f;
  LiveSession session(f.bvh, f.grid, f.options, kFeed);
  session.next(1.0);
  for (const LiveConditions& bad :
       {LiveConditions{0.0, 1.0, kFeed}, LiveConditions{1.0, -1.0, kFeed},
        LiveConditions{1.0, 1.0, {2.0, 1.0}}})
    EXPECT_THROW(session.change(bad), InputError);
  EXPECT_EQ(session.conditions().axial_depth, f.options.axial_depth);
  EXPECT_THROW(session.next(0.0), InputError);
  CopyOptions contour = f.options;
  contour.mode = CopyMode::Contour;
  EXPECT_THROW(LiveSession(f.bvh, f.grid, contour, kFeed), InputError);
  const dcm::FeedFactors missing{std::vector<std::uint8_t>(f.grid.kind.size(), 1), {1.0}};
  EXPECT_THROW(LiveSession(f.bvh, f.grid, f.options, kFeed, {}, missing), InputError);
}

}  // namespace
}  // namespace patchmill::copy
