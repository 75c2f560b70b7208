// The voxel model written and read back, and files that must not be believed; sections of the fields.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/voxel_file.h"

#include "patchmill/dcm/field_view.h"
#include "patchmill/geometry/error.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace patchmill::dcm {
namespace {

struct Fixture {
  mesh::TriangleMesh part = shapes::convex_part(20);
  mesh::TriangleBvh bvh{part};
  VoxelModel model;
  Fixture() {
    voxel::VoxelOptions options;
    options.pitch = 2.0;
    model.grid = voxel::voxelise(mesh::box_mesh(Vec3::Zero(), Vec3(50, 50, 36)), part, options);
    model.posture = steady_posture(model.grid, part, bvh);
    for (std::size_t i = 0; i < model.grid.kind.size(); ++i) model.material.push_back(i % 3);
  }
};

// of this process: tests of one file run side by side
const std::string kPath =
    testing::TempDir() + "patchmill_model_" + std::to_string(getpid()) + ".voxels";

std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(VoxelFile, GivesBackWhatWasWritten) {
  const Fixture f;
  write_voxel_model(kPath, "key", f.model);
  const auto read = read_voxel_model(kPath, "key");
  ASSERT_TRUE(read && read->posture);
  EXPECT_EQ(read->grid.kind, f.model.grid.kind);
  EXPECT_EQ(read->grid.solid_bricks, f.model.grid.solid_bricks);
  EXPECT_EQ(read->grid.frame.cells, f.model.grid.frame.cells);
  EXPECT_EQ(read->posture->value, f.model.posture->value);
  EXPECT_EQ(read->material, f.model.material);
  EXPECT_EQ(read->grid.table.neighbours, f.model.grid.table.neighbours);
  std::remove(kPath.c_str());
}

TEST(VoxelFile, IsNotBelievedWhenAnythingIsWrong) {
  const Fixture f;
  EXPECT_FALSE(read_voxel_model(kPath + ".none", "key"));
  write_voxel_model(kPath, "key", f.model);
  EXPECT_FALSE(read_voxel_model(kPath, "kex"));
  EXPECT_FALSE(read_voxel_model(kPath, "longer key"));
  const std::string whole = bytes_of(kPath);
  for (std::size_t cut = 0; cut < whole.size(); cut += 1 + whole.size() / 97) {
    std::ofstream(kPath, std::ios::binary).write(whole.data(), std::streamsize(cut));
    EXPECT_FALSE(read_voxel_model(kPath, "key")) << cut;
  }
  for (std::size_t at = 0; at < 200; at += 3) {  // bytes of the head changed: refused or harmless
    std::string bad = whole;
    bad[at] = static_cast<char>(bad[at] ^ 0x5a);
    std::ofstream(kPath, std::ios::binary) << bad;
    read_voxel_model(kPath, "key");
  }
  std::remove(kPath.c_str());
  EXPECT_THROW(write_voxel_model("/nowhere/at/all/x", "key", f.model), InputError);
}

TEST(VoxelFile, IsNotBelievedWhenAnyByteIsAnother) {
  const Fixture f;
  write_voxel_model(kPath, "key", f.model);
  ASSERT_TRUE(read_voxel_model(kPath, "key"));
  const std::string whole = bytes_of(kPath);
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 199) {
    std::string bad = whole;
    bad[at] = static_cast<char>(bad[at] ^ 1);
    std::ofstream(kPath, std::ios::binary) << bad;
    EXPECT_FALSE(read_voxel_model(kPath, "key")) << "byte " << at << " of " << whole.size();
  }
  std::remove(kPath.c_str());
}

// A few bytes that ask for a box of 32768 cells a side: 64 GiB of bricks.
TEST(VoxelFile, TakesNoMoreMemoryThanTheFileIsLong) {
  const Fixture f;
  write_voxel_model(kPath, "key", f.model);
  std::string head = bytes_of(kPath).substr(0, 8 + 8 + 3 + 4 * 8 + 3 * 4 + 8);
  const std::array<std::int32_t, 3> cells{32768, 32768, 32768};
  const std::uint64_t bricks = std::uint64_t{1} << 36;
  std::memcpy(&head[head.size() - 20], cells.data(), 12);
  std::memcpy(&head[head.size() - 8], &bricks, 8);
  std::ofstream(kPath, std::ios::binary) << head;
  EXPECT_FALSE(read_voxel_model(kPath, "key"));
  std::remove(kPath.c_str());
}

// Whoever opened it would wait until another writes into it.
TEST(VoxelFile, IsNoPipe) {
  ASSERT_EQ(mkfifo(kPath.c_str(), 0600), 0);
  EXPECT_FALSE(read_voxel_model(kPath, "key"));
  std::remove(kPath.c_str());
  EXPECT_FALSE(read_voxel_model("/dev/zero", "key"));
}

TEST(FieldView, SectionHoldsTheFieldsOfItsLayer) {
  const Fixture f;
  const FeedField feed = steady_feed(f.model.grid, {5.0, 10.0});
  const GridSection s = section_of(f.model.grid, 1, 24.5);
  EXPECT_EQ(s.columns, 25);
  EXPECT_EQ(s.rows, 18);
  EXPECT_EQ(s.place, 25.0);
  const auto along_x = feed_on(s, feed, Vec3::UnitX());
  const auto axes = axes_on(s, *f.model.posture);
  int with = 0;
  for (std::size_t i = 0; i < s.kind.size(); ++i) {
    const bool none = s.kind[i] == voxel::VoxelKind::Air || s.kind[i] == voxel::VoxelKind::Part;
    EXPECT_EQ(none, std::isnan(along_x[i]));
    EXPECT_EQ(none, std::isnan(axes[i].x()));
    if (none) continue;
    ++with;
    EXPECT_NEAR(axes[i].norm(), 1.0, 1e-6);
    if (s.kind[i] == voxel::VoxelKind::Surface) {
      EXPECT_EQ(along_x[i], 5.0);
    }
    if (s.kind[i] == voxel::VoxelKind::Exterior) {
      EXPECT_EQ(along_x[i], 10.0);
    }
  }
  EXPECT_GT(with, 100);
  EXPECT_THROW(section_of(f.model.grid, 1, 50.5), InputError);
  EXPECT_THROW(section_of(f.model.grid, 3, 10), InputError);
}

TEST(FieldView, ArrowsAndDistances) {
  const Fixture f;
  const auto all = arrows_of(f.model.grid, *f.model.posture, 1);
  const auto count = voxel::count_kinds(f.model.grid);
  EXPECT_EQ(std::int64_t(all.size()), count[2] + count[3] + count[4]);
  const auto some = arrows_of(f.model.grid, *f.model.posture, 3);
  std::size_t wanted = 0;
  shapes::for_each_cell(f.model.grid.table, [&](std::size_t i, const voxel::Cell& c) {
    const bool third = c.x() % 3 == 0 && c.y() % 3 == 0 && c.z() % 3 == 0;
    wanted += third && static_cast<int>(f.model.grid.kind[i]) >= 2 ? 1 : 0;
  });
  EXPECT_EQ(some.size(), wanted);
  const auto distance = distance_to_part(f.model.grid, f.bvh);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (f.model.grid.kind[i] == voxel::VoxelKind::Surface) {
      EXPECT_LE(distance[i], std::sqrt(3.0) + 1e-6);
    }  // half the diagonal of 2 mm
    if (f.model.grid.kind[i] == voxel::VoxelKind::Removal) {
      EXPECT_GE(distance[i], 1.0 - 1e-6);
    }
  }
}

}  // namespace
}  // namespace patchmill::dcm
