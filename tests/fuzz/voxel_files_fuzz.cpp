// Any bytes as a voxel file: a model, none, or an InputError, and no more memory than the file is worth.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/voxel_file.h"
#include "patchmill/geometry/error.h"

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>
#include <unistd.h>

using namespace patchmill;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string name = "/tmp/patchmill-fuzz-" + std::to_string(getpid()) + ".voxels";
  std::ofstream(name, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    dcm::read_voxel_model(name, "key");
  } catch (const InputError&) {  // a refusal
  }
  std::remove(name.c_str());
  return 0;
}
