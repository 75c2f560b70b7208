// Voxel files under libFuzzer.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz/voxel_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  patchmill::fuzz::read_voxel_file(data, size);
  return 0;
}
