// Which unknown cells are connected, face to face, to a held one. The others have no unique
// solution: nothing tells their level, so the solver leaves them at their first guess.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/voxel/laplace_level.h"

#include <cstdint>
#include <vector>

namespace patchmill::voxel {

/// Number of unknown cells that no path of unknown cells joins to a held cell. Their roles are
/// changed to Outside. Bits of a brick are flooded together, so the cost is a fraction of one
/// solver sweep.
std::int64_t exclude_unreached(const BrickTable& table, std::vector<CellRole>& role);

}  // namespace patchmill::voxel
