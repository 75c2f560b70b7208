// Flooding from held cells, brick by brick; see reach.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/reach.h"

#include "patchmill/geometry/stop.h"

#include <array>
#include <deque>

namespace patchmill::voxel {
namespace {

// One bit per cell: a 64-bit word is a layer z, its byte y a row, its bit x a cell.
using Bits = std::array<std::uint64_t, kBrickSide>;
constexpr std::uint64_t kFirstColumn = 0x0101010101010101U, kLastColumn = 0x8080808080808080U;

std::uint64_t spread_in_layer(std::uint64_t v) {
  return v | ((v << 1) & ~kFirstColumn) | ((v >> 1) & ~kLastColumn) | (v << 8) | (v >> 8);
}

// Grows `reached` within `open` until it grows no more.
void flood(const Bits& open, Bits& reached) {
  for (bool more = true; more;) {
    more = false;
    for (int z = 0; z < kBrickSide; ++z) {
      std::uint64_t next = spread_in_layer(reached[z]);
      if (z > 0) next |= reached[z - 1];
      if (z < 7) next |= reached[z + 1];
      next = (next & open[z]) | reached[z];
      more = more || next != reached[z];
      reached[z] = next;
    }
  }
}

// Cells of the neighbour on `side` that a brick's own bits touch.
Bits shadow(const Bits& bits, int side) {
  Bits out{};
  for (int z = 0; z < kBrickSide; ++z) {
    if (side == 0) out[z] = (bits[z] & kFirstColumn) << 7;
    if (side == 1) out[z] = (bits[z] & kLastColumn) >> 7;
    if (side == 2) out[z] = bits[z] << 56;
    if (side == 3) out[z] = bits[z] >> 56;
  }
  if (side == 4) out[7] = bits[0];
  if (side == 5) out[0] = bits[7];
  return out;
}

Bits bits_of(const std::vector<CellRole>& role, std::size_t brick, CellRole wanted) {
  Bits bits{};
  for (int cell = 0; cell < kBrickCells; ++cell)
    if (role[brick * kBrickCells + cell] == wanted)
      bits[cell / 64] |= std::uint64_t{1} << (cell % 64);
  return bits;
}

bool within(const Bits& part, const Bits& whole) {
  for (int z = 0; z < kBrickSide; ++z)
    if (part[z] & ~whole[z]) return false;
  return true;
}

}  // namespace

std::int64_t exclude_unreached(const BrickTable& table, std::vector<CellRole>& role) {
  std::vector<Bits> open(table.size()), reached(table.size());
  patchmill::parallel_for(std::size_t{0}, table.size(), [&](std::size_t brick) {
    open[brick] = bits_of(role, brick, CellRole::Unknown);
    reached[brick] = bits_of(role, brick, CellRole::Held);
    flood(open[brick], reached[brick]);
  });
  std::deque<std::int32_t> todo;
  for (std::size_t i = 0; i < table.size(); ++i) todo.push_back(static_cast<std::int32_t>(i));
  while (!todo.empty()) {
    stop_point();
    const std::int32_t brick = todo.front();
    todo.pop_front();
    for (int side = 0; side < 6; ++side) {
      const std::int32_t near = table.neighbours[brick][side];
      if (near == kNoBrick) continue;
      const Bits touched = shadow(reached[brick], side);
      bool fresh = false;
      for (int z = 0; z < kBrickSide; ++z) {
        const std::uint64_t add = touched[z] & open[near][z] & ~reached[near][z];
        reached[near][z] |= add;
        fresh = fresh || add != 0;
      }
      if (!fresh) continue;
      flood(open[near], reached[near]);
      todo.push_back(near);
    }
  }
  std::int64_t excluded = 0;
  for (std::size_t brick = 0; brick < table.size(); ++brick) {
    if (within(open[brick], reached[brick])) continue;
    for (int cell = 0; cell < kBrickCells; ++cell) {
      const std::uint64_t missed = open[brick][cell / 64] & ~reached[brick][cell / 64];
      if (!(missed >> (cell % 64) & 1)) continue;
      role[brick * kBrickCells + cell] = CellRole::Outside;
      ++excluded;
    }
  }
  return excluded;
}

}  // namespace patchmill::voxel
