// Voxels of a brick as bits; see brick_bits.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/brick_bits.h"

#include <algorithm>
#include <cstring>

namespace patchmill::voxel {
namespace {

constexpr std::uint64_t kAll = ~std::uint64_t{0};

Bits words_of(const std::uint8_t* rows) {
  Bits words;
  std::memcpy(words.data(), rows, sizeof words);
  return words;
}

bool full(const Bits& bits) {
  return std::all_of(bits.begin(), bits.end(), [](std::uint64_t w) { return w == kAll; });
}

}  // namespace

BrickBits brick_bits(const std::uint8_t* stock, const std::uint8_t* part,
                     const std::uint8_t* touched) {
  const Bits s = words_of(stock), p = words_of(part), t = words_of(touched);
  BrickBits out;
  for (int z = 0; z < kBrickSide; ++z) {
    out.surface[z] = s[z] & t[z];
    out.part[z] = p[z] & ~out.surface[z];
    out.removal[z] = s[z] & ~p[z] & ~out.surface[z];
  }
  return out;
}

bool has_air(const BrickBits& bits) {
  std::uint64_t all = kAll;
  for (int z = 0; z < kBrickSide; ++z) all &= bits.part[z] | bits.removal[z] | bits.surface[z];
  return all != kAll;
}

bool all_of_kind(const BrickBits& bits, VoxelKind kind) {
  if (kind == VoxelKind::Part) return full(bits.part);
  if (kind == VoxelKind::Removal) return full(bits.removal);
  if (kind == VoxelKind::Surface) return full(bits.surface);
  std::uint64_t any = 0;
  for (int z = 0; z < kBrickSide; ++z) any |= bits.part[z] | bits.removal[z] | bits.surface[z];
  return any == 0;
}

void write_kinds(const BrickBits& bits, VoxelKind* kinds) {
  std::array<std::uint8_t, 64> part, removal, surface;
  std::memcpy(part.data(), bits.part.data(), sizeof part);
  std::memcpy(removal.data(), bits.removal.data(), sizeof removal);
  std::memcpy(surface.data(), bits.surface.data(), sizeof surface);
  const auto kind = [](VoxelKind k) { return static_cast<int>(k); };
  for (int row = 0; row < 64; ++row)
    for (int x = 0; x < 8; ++x)
      kinds[8 * row + x] =
          static_cast<VoxelKind>((part[row] >> x & 1) * kind(VoxelKind::Part) +
                                 (removal[row] >> x & 1) * kind(VoxelKind::Removal) +
                                 (surface[row] >> x & 1) * kind(VoxelKind::Surface));
}

}  // namespace patchmill::voxel
