// A row of 8 cells as one value, so that stencils are written without a loop over x: the vector type of
// GCC and Clang, which becomes one AVX2 or two SSE registers; elsewhere an array with the same
// operators.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <cstring>

namespace patchmill::voxel {

#if defined(__GNUC__)
typedef float Row __attribute__((vector_size(32)));
typedef std::int32_t RowMask __attribute__((vector_size(32)));  ///< -1 where true
#else
/// One truth for each lane; -1 where true.
struct RowMask {
  std::int32_t lane[8];
};
/// Eight floats side by side.
struct Row {
  float lane[8];
  /// Lane by lane.
  Row operator+(const Row& o) const {
    Row sum;
    for (int i = 0; i < 8; ++i) sum.lane[i] = lane[i] + o.lane[i];
    return sum;
  }
  /// Lane by lane.
  Row operator*(const Row& o) const {
    Row product;
    for (int i = 0; i < 8; ++i) product.lane[i] = lane[i] * o.lane[i];
    return product;
  }
};
#endif

/// Reads or writes 8 floats at any address.
inline void load_row(const float* from, Row& row) {
  std::memcpy(&row, from, sizeof row);
}
inline void store_row(const Row& row, float* to) {
  std::memcpy(to, &row, sizeof row);
}

/// row = where the mask is true `a`, elsewhere unchanged.
inline void assign_where(const RowMask& mask, const Row& a, Row& row) {
#if defined(__GNUC__)
  row = mask ? a : row;
#else
  for (int i = 0; i < 8; ++i)
    if (mask.lane[i]) row.lane[i] = a.lane[i];
#endif
}

}  // namespace patchmill::voxel
