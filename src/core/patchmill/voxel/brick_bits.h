// What the 512 voxels of a brick are, a bit each: a 64-bit word is a layer z, its byte y a row, its bit x a
// voxel. Most bricks of a box are all of one kind, which eight words tell at once.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/voxel/voxel_grid.h"

#include <array>
#include <cstdint>

namespace patchmill::voxel {

using Bits = std::array<std::uint64_t, kBrickSide>;

/// One bit for each cell of a brick.
struct BrickBits {
  Bits part{}, removal{}, surface{};  ///< no voxel is in two; one in none is Air
};

/// `stock` and `part`: the voxel's centre is in it; `touched`: the part's surface is in the voxel. 64 bytes
/// each, one per row, y fastest.
BrickBits brick_bits(const std::uint8_t* stock, const std::uint8_t* part,
                     const std::uint8_t* touched);

/// Is there air in the brick?
bool has_air(const BrickBits& bits);

/// Is every voxel of this kind: Air, Part, Removal or Surface?
bool all_of_kind(const BrickBits& bits, VoxelKind kind);

/// One kind per voxel, in the order of a brick.
void write_kinds(const BrickBits& bits, VoxelKind* kinds);

}  // namespace patchmill::voxel
