// The material numbers of a voxel model as Python holds them: one opaque object, never a list.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/dcm/materials.h"

namespace patchmill {

struct VoxelMaterials {
  std::vector<std::uint8_t> number;  ///< per stored voxel
};

}  // namespace patchmill
