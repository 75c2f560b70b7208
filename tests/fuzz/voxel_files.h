// Any bytes as a voxel file: a model, none, or an InputError, and no more memory than the file is worth.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/dcm/voxel_file.h"
#include "patchmill/geometry/error.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <unistd.h>

namespace patchmill::fuzz {

/// Reads the bytes from a file; whether it is a whole voxel model of the key "key". Ends the process where the numbers
/// of its cells are at odds.
inline bool read_voxel_file(const std::uint8_t* data, std::size_t size) {
  static const std::string name = "/tmp/patchmill-fuzz-" + std::to_string(getpid()) + ".voxels";
  std::ofstream(name, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  bool whole = false;
  try {
    if (const auto model = dcm::read_voxel_model(name, "key")) {
      whole = true;
      const std::size_t cells = model->grid.kind.size();
      if (cells != model->grid.table.cell_count()) std::abort();
      if (!model->material.empty() && model->material.size() != cells) std::abort();
      if (model->posture)
        for (const auto& values : model->posture->value)
          if (values.size() != cells) std::abort();
    }
  } catch (const InputError&) {  // a refusal
  }
  std::remove(name.c_str());
  return whole;
}

}  // namespace patchmill::fuzz
