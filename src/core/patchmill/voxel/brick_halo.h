// A brick and the layer of cells around it, copied into one small array so that a 7-point stencil
// runs over plain rows. Cells beyond the stored bricks read as zero. Edges and corners of the halo
// are never filled: no face stencil reads them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vector_clones.h"
#include "patchmill/voxel/bricks.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace patchmill::voxel {

/// Rows are 16 values apart and begin at 8: the cell at x = -1 is at 7, the one at x = 8 at 16,
/// which is the unused first value of the next row.
template <class T>
struct alignas(64) BrickHalo {
  static constexpr int kRow = 16, kSlab = 10 * kRow;
  T value[10 * kSlab + kRow];  // not cleared: load_halo writes every cell that a face stencil reads

  /// Index of a cell; each of x, y, z from -1 to 8.
  static constexpr int index(int x, int y, int z) {
    return (z + 1) * kSlab + (y + 1) * kRow + 8 + x;
  }
  /// The eight cells at x = 0 .. 7.
  T* row(int y, int z) { return value + index(0, y, z); }
  /// The same, to be read.
  const T* row(int y, int z) const { return value + index(0, y, z); }
  /// Sets all to zero.
  void clear() { std::fill(std::begin(value), std::end(value), T{}); }
};

/// Sum of the six neighbours of the cell at `c` in a halo, opposite ones paired: one order of additions, so that
/// every kernel gets the same bits.
template <class T>
inline T sum_of_neighbours(const T* c) {
  return ((c[-1] + c[1]) + (c[-BrickHalo<T>::kRow] + c[BrickHalo<T>::kRow])) +
         (c[-BrickHalo<T>::kSlab] + c[BrickHalo<T>::kSlab]);
}

namespace detail {

template <class T>
inline void copy_row(const T* from, T* to) {
  std::memcpy(to, from, kBrickSide * sizeof(T));
}

template <class T>
inline void load_sides(const T* data, const std::array<std::int32_t, 6>& near, BrickHalo<T>& halo) {
  static constexpr T zero[kBrickCells] = {};
  const auto brick = [&](int side) {
    return near[side] == kNoBrick ? zero : data + std::size_t(near[side]) * kBrickCells;
  };
  const T *west = brick(0), *east = brick(1), *south = brick(2), *north = brick(3);
  const T *below = brick(4), *above = brick(5);
  for (int k = 0; k < kBrickSide; ++k) {
    for (int j = 0; j < kBrickSide; ++j) {
      halo.row(j, k)[-1] = west[in_brick(7, j, k)];
      halo.row(j, k)[8] = east[in_brick(0, j, k)];
    }
    copy_row(south + in_brick(0, 7, k), halo.row(-1, k));
    copy_row(north + in_brick(0, 0, k), halo.row(8, k));
    copy_row(below + in_brick(0, k, 7), halo.row(k, -1));
    copy_row(above + in_brick(0, k, 0), halo.row(k, 8));
  }
}

}  // namespace detail

/// Fills the halo of one brick of a field.
template <class T>
inline void load_halo(const T* data, const BrickTable& table, std::size_t brick,
                      BrickHalo<T>& halo) {
  const T* own = data + brick * kBrickCells;
  for (int k = 0; k < kBrickSide; ++k)
    for (int j = 0; j < kBrickSide; ++j) detail::copy_row(own + in_brick(0, j, k), halo.row(j, k));
  detail::load_sides(data, table.neighbours[brick], halo);
}

}  // namespace patchmill::voxel
