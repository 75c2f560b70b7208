// Rows: another milling order of the same dimples. Where the helix of Matsuda 2008 (Fig. 1b) turns a corner
// every few dimples, a row of the lattice runs on across the borders of patches, over the whole face, and a
// spindle-locked path turns round at its end only. What is left out - holes, masks, the faces' borders - cuts a row
// into pieces. Deviation: the papers mill patch by patch.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/lattice.h"

namespace patchmill::patch {

enum class RowExtent : std::uint8_t {
  WholeFace,  ///< rows run on across the borders of patches; a dimple's patch becomes its row's number
  EachPatch  ///< patches in their order, rows inside each of them
};

/// How rows are run through.
struct RowOrder {
  RowExtent extent = RowExtent::WholeFace;
  std::size_t direction = 0;  ///< which of neighbour_steps(kind) the rows go along
  bool one_way = false;       ///< all rows in one sense; else to and fro
};

/// The dimples in the order of rows, beginning with the first row's least place; those left out come last, in the
/// order in which they are. Dimples of one place keep their order. Errors: InputError naming RowDirection if the
/// lattice has no such step.
Dimples in_rows(const Dimples& dimples, LatticeKind kind, const RowOrder& order);

/// Which of neighbour_steps(kind) goes nearest to `direction`, a vector in the lattice laid out flat; either sense. The
/// first one of equals, and of no direction.
std::size_t nearest_step(LatticeKind kind, const Vec2& direction);

/// Which of neighbour_steps(kind) bends least over the dimples that are to be cut: the least mean of the normal
/// curvature's size between neighbours along it. Rows along it have the smallest kinks. The first one of equals.
std::size_t flattest_step(const Dimples& dimples, LatticeKind kind);

}  // namespace patchmill::patch
