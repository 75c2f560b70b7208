// What is made of a mesh before its voxels are, and their table, ends when it is told to stop: of large ones each takes
// a good part of a second.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/stopped.h"
#include "patchmill/mesh/triangle_bvh.h"
#include "patchmill/voxel/row_bits.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <gtest/gtest.h>

namespace patchmill::voxel {
namespace {

const mesh::TriangleMesh& ball() {
  static const mesh::TriangleMesh made = shapes::sphere(Vec3::Zero(), 28, 4);
  return made;
}

TEST(Stops, TheTreeOverTriangles) {
  EXPECT_TRUE(ends_when_stopped([] { mesh::TriangleBvh tree(ball()); }));
}

TEST(Stops, TheCheckOfAClosedMesh) {
  EXPECT_TRUE(ends_when_stopped([] { mesh::require_closed(ball(), "Shape"); }));
}

TEST(Stops, TheTrianglesOfColumns) {
  const GridFrame frame = frame_over(mesh::bounds(ball()), 1.0);
  EXPECT_TRUE(ends_when_stopped([&] { sort_into_columns(ball(), frame); }));
}

TEST(Stops, TheTableOfBricks) {
  const Cell cells(64, 64, 64);
  const std::vector<std::uint8_t> wanted(512, 1);
  EXPECT_TRUE(ends_when_stopped([&] { make_brick_table(cells, wanted); }));
}

}  // namespace
}  // namespace patchmill::voxel
