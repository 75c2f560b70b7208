// Voxel files that were damaged are taken for none: see damaged_programs_test.cpp.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz/damage.h"
#include "fuzz/voxel_files.h"

#include <gtest/gtest.h>

namespace patchmill {
namespace {

TEST(DamagedVoxelFiles, AreReadOrRefused) {
  const auto good = fuzz::files_of(PATCHMILL_CORPUS "/voxel_files");
  ASSERT_EQ(good.size(), 3U);
  for (const fuzz::Bytes& data : good) EXPECT_TRUE(fuzz::read_voxel_file(data.data(), data.size()));
  std::mt19937 numbers(23);
  for (int i = 0; i < 10000; ++i) {
    const fuzz::Bytes data = fuzz::damaged(good, numbers);
    fuzz::read_voxel_file(data.data(), data.size());
  }
}

}  // namespace
}  // namespace patchmill
