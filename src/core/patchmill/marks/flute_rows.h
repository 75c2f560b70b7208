// Rows of cells for the kernel of flute_kernel.h; see flute_lanes.h for how it is compiled.
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "patchmill/marks/flute_lanes.h"
// clang-format off: in this order
#include "patchmill/marks/flute_newton.h"
#include "patchmill/marks/flute_search.h"
// clang-format on

namespace patchmill::marks::PATCHMILL_ISA {
namespace {

PATCHMILL_INLINE Lanes load(const float* from) {
  Lanes v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}

template <bool kTurning, class Cells>
PATCHMILL_INLINE void treat_group(bool near_axis_only, const PassFrame& pass, const Cells* cells,
                                  int count, float* height) {
  if (near_axis_only)
    search_group<kTurning>(pass, cells, count, height);
  else
    mill_group<kTurning>(pass, cells, count, height);
}

template <bool kTurning>
PATCHMILL_INLINE void mill_flat_row(bool near_axis_only, const PassFrame& pass, float x, float y,
                                    float step, int chunks, float* height) {
  Lanes column;
  for (int i = 0; i < kWidth; ++i) column[i] = static_cast<float>(i);
  FlatCells cells[kGroup];
  for (int c = 0; c < chunks; c += kGroup) {
    const int count = chunks - c < kGroup ? chunks - c : kGroup;
    for (int k = 0; k < count; ++k)
      cells[k] = {x + (column + static_cast<float>((c + k) * kWidth)) * step, all(y),
                  pass.centre_height};
    treat_group<kTurning>(near_axis_only, pass, cells, count, height + c * kWidth);
  }
}

template <bool kTurning>
PATCHMILL_INLINE void mill_curved_row(bool near_axis_only, const PassFrame& pass,
                                      const CurvedRow& row, const float shift[3], int chunks,
                                      float* height) {
  CurvedCells cells[kGroup];
  for (int c = 0; c < chunks; c += kGroup) {
    const int count = chunks - c < kGroup ? chunks - c : kGroup;
    for (int k = 0; k < count; ++k) {
      const int at = (c + k) * kWidth;
      cells[k] = {
          {load(row.x + at) + shift[0], load(row.y + at) + shift[1], load(row.z + at) + shift[2]},
          {load(row.nx + at), load(row.ny + at), load(row.nz + at)}};
    }
    treat_group<kTurning>(near_axis_only, pass, cells, count, height + c * kWidth);
  }
}

}  // namespace

/// See flute_kernel.h.
void mill_flat(bool near_axis_only, const PassFrame& pass, float x, float y, float step, int chunks,
               float* height) {
  const int registers = chunks * (kLanes / kWidth);
  if (pass.turning)
    mill_flat_row<true>(near_axis_only, pass, x, y, step, registers, height);
  else
    mill_flat_row<false>(near_axis_only, pass, x, y, step, registers, height);
}

/// See flute_kernel.h.
void mill_curved(bool near_axis_only, const PassFrame& pass, const CurvedRow& row,
                 const float shift[3], int chunks, float* height) {
  const int registers = chunks * (kLanes / kWidth);
  if (pass.turning)
    mill_curved_row<true>(near_axis_only, pass, row, shift, registers, height);
  else
    mill_curved_row<false>(near_axis_only, pass, row, shift, registers, height);
}

}  // namespace patchmill::marks::PATCHMILL_ISA
