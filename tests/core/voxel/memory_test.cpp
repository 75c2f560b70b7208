// What voxel models take of memory against what was foreseen before it was taken.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/feed_field.h"
#include "patchmill/dcm/materials.h"
#include "patchmill/dcm/posture_field.h"
#include "patchmill/mesh/triangle_bvh.h"
#include "patchmill/voxel/foreseen_memory.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/peak_memory.h"
#include "voxel/shapes.h"

#include <cstdio>

#include <gtest/gtest.h>

namespace patchmill::voxel {
namespace {

VoxelOptions pitch(double mm) {
  VoxelOptions options;
  options.pitch = mm;
  return options;
}

TEST(Memory, AHundredMillionVoxelsOfBoxFitInFourGiB) {
  // 464^3 voxels of box, half of it to be removed, 88 %, or all
  const GridFrame frame = frame_over({Vec3::Zero(), Vec3::Constant(464)}, 1.0);
  const double box = 464.0 * 464 * 464;
  for (const double share : {0.5, 0.88, 1.0})
    EXPECT_NO_THROW(require_memory(estimate_memory(frame, share * box, 12.0 * 464 * 464),
                                   4.0 * 1024 * 1024 * 1024, frame));
}

class PeakOf : public testing::TestWithParam<dcm::PostureForm> {};

// Model, posture and feed of 168^3 voxels, 88 % to be removed: what the process took at the worst moment.
TEST_P(PeakOf, ModelPostureAndFeedIsWhatWasForeseen) {
#ifdef PATCHMILL_SANITIZE
  GTEST_SKIP() << "the sanitizer has its own memory";
#endif
  const mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Zero(), Vec3::Constant(168));
  const mesh::TriangleMesh part = mesh::box_mesh(Vec3::Constant(40.2), Vec3::Constant(123.0));
  const mesh::TriangleBvh bvh(part);
  const VoxelOptions options = pitch(1.0);
  const PeakMemory peak;
  if (!peak.known()) GTEST_SKIP() << "this system does not say it";
  const VoxelGrid grid = voxelise(stock, part, options);
  dcm::PostureOptions posture_options;
  posture_options.form = GetParam();
  const dcm::PostureField posture = dcm::steady_posture(grid, part, bvh, posture_options);
  const int fields = static_cast<int>(posture.value.size());
  ASSERT_TRUE(posture.outcome.converged);
  const dcm::FeedField feed = dcm::steady_feed(grid, {5.0, 10.0});
  const double taken = peak.bytes(), exact = memory_of(grid.table, fields).total();
  const double foreseen =
      estimate_memory(grid.frame, mesh::volume(stock) - mesh::volume(part),
                      mesh::surface_area(stock) + mesh::surface_area(part), fields)
          .total();
  std::printf("peak %.1f MB; %.1f for the bricks stored, %.1f foreseen\n", 1e-6 * taken,
              1e-6 * exact, 1e-6 * foreseen);
  EXPECT_LT(taken, foreseen);
  EXPECT_LT(taken, exact + 8e6);  // and the threads' own
  EXPECT_GT(taken, 0.85 * exact);
  EXPECT_EQ(feed.along[0].size(), posture.value[0].size());
}

INSTANTIATE_TEST_SUITE_P(Memory, PeakOf,
                         testing::Values(dcm::PostureForm::Angles, dcm::PostureForm::UnitVector),
                         [](const testing::TestParamInfo<dcm::PostureForm>& form) {
                           return form.param == dcm::PostureForm::Angles ? "Angles" : "UnitVector";
                         });

// A box of 20 million voxels and its materials, which take a byte each; touched, so that they are resident.
TEST(Memory, MaterialsTakeWhatWasForeseen) {
#ifdef PATCHMILL_SANITIZE
  GTEST_SKIP() << "the sanitizer has its own memory";
#endif
  const mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Zero(), Vec3(320, 320, 200));
  const mesh::TriangleMesh part = mesh::box_mesh(Vec3::Constant(50), Vec3::Constant(60));
  const mesh::TriangleBvh bvh(stock);
  const VoxelGrid grid = voxelise(stock, part, pitch(1.0));
  const PeakMemory peak;
  if (!peak.known()) GTEST_SKIP() << "this system does not say it";
  const std::vector<std::uint8_t> material = dcm::materials_of(grid, {{&stock, &bvh}});
  const double taken = peak.bytes();
  const double foreseen =
      memory_of(grid.table, 2, true).fields - memory_of(grid.table, 2, false).fields;
  std::printf("peak %.1f MB of %.1f foreseen\n", 1e-6 * taken, 1e-6 * foreseen);
  EXPECT_EQ(static_cast<double>(material.size()), foreseen);
  EXPECT_GT(taken, 0.95 * foreseen);
  EXPECT_LT(taken, 1.05 * foreseen + 1e6);  // and the threads' own
}

// Without a posture only the feed fields and the voxels' roles are made.
TEST(Memory, FeedAloneTakesWhatWasForeseen) {
#ifdef PATCHMILL_SANITIZE
  GTEST_SKIP() << "the sanitizer has its own memory";
#endif
  const mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Zero(), Vec3(320, 320, 100));
  const mesh::TriangleMesh part = mesh::box_mesh(Vec3::Constant(50), Vec3::Constant(60));
  const VoxelGrid grid = voxelise(stock, part, {1.0, 1e9, 0});
  const PeakMemory peak;
  if (!peak.known()) GTEST_SKIP() << "this system does not say it";
  const dcm::FeedField feed = dcm::steady_feed(grid, {1.0, 2.0});
  const double taken = peak.bytes(), foreseen = memory_of(grid.table, 0).fields;
  std::printf("peak %.1f MB of %.1f foreseen\n", 1e-6 * taken, 1e-6 * foreseen);
  EXPECT_EQ(memory_of(grid.table, 0).solver, 0.0);
  EXPECT_EQ(24.0 * static_cast<double>(feed.along[0].size()), foreseen);
  EXPECT_GT(taken, 0.95 * foreseen);
  EXPECT_LT(taken, 1.1 * foreseen);
}

TEST(Memory, EstimateIsCloseToWhatIsStored) {
  const mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Constant(-32), Vec3::Constant(32));
  const mesh::TriangleMesh part = shapes::sphere(Vec3::Zero(), 28, 4);
  const VoxelGrid grid = voxelise(stock, part, pitch(0.5));
  const double foreseen = estimate_memory(grid.frame, mesh::volume(stock) - mesh::volume(part),
                                          mesh::surface_area(stock) + mesh::surface_area(part))
                              .total();
  const double exact = memory_of(grid.table).total();
  EXPECT_GT(foreseen, 0.95 * exact);
  EXPECT_LT(foreseen, 1.4 * exact);
}

// Where stock and part share sides, and where they do not: bricks along a side count once.
TEST(Memory, BricksAreForeseenOneByOne) {
  const mesh::TriangleMesh block = mesh::box_mesh(Vec3::Zero(), Vec3(60, 44, 30));
  const mesh::TriangleMesh low = mesh::box_mesh(Vec3::Zero(), Vec3(60, 44, 21.3));
  const mesh::TriangleMesh inner = mesh::box_mesh(Vec3(11, 8, 7), Vec3(50.4, 33, 23.7));
  const mesh::TriangleMesh round = shapes::sphere(Vec3(30, 22, 15), 13.7, 4);
  for (const mesh::TriangleMesh* part : {&low, &inner, &round})
    for (const double side : {0.4, 0.5, 0.61}) {
      const VoxelGrid grid = voxelise(block, *part, pitch(side));
      const auto stored = static_cast<double>(grid.table.size());
      const auto foreseen = static_cast<double>(bricks_to_store(block, *part, grid.frame));
      EXPECT_GE(foreseen, stored);
      EXPECT_LE(foreseen, 1.03 * stored);
    }
}

}  // namespace
}  // namespace patchmill::voxel
