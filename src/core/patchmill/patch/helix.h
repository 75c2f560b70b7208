// The order of dimples inside a patch: the helical path of Matsuda 2008 (Fig. 1b) and Xu & Sasahara
// 2016 (Fig. 1a) as lattice steps. The outline loop first, then the next loop inside it, to the
// centre (or from the centre out). Every step, also from loop to loop, is one lattice step; each shape's
// own is in shapes/.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/shapes/shape_traits.h"

namespace patchmill::patch {

enum class HelixOrder : std::uint8_t { Inward, Outward };

/// The lattice that patches of a shape lie on.
inline LatticeKind lattice_of(PatchShape shape) {
  return traits(shape).lattice;
}

/// Points of a patch. `size` is one that the shape may have.
std::int64_t point_count(PatchShape shape, PatchSize size);

/// The helix of any shape, turned counter-clockwise about the patch's centre by `turn` of the shape's
/// turns, so that it starts elsewhere and covers the same points. Inward starts on the outline and goes
/// counter-clockwise; Outward is the same path backwards. `down` is for shapes that have inverted patches.
/// Errors: InputError naming PatchSide or PatchSideAcross if the shape may not have the size.
std::vector<LatticePoint> patch_helix(PatchShape shape, PatchSize size, HelixOrder order,
                                      bool down = false, int turn = 0);

/// Errors: InputError naming PatchSide or PatchSideAcross if the shape may not have the size.
void require_valid(PatchShape shape, PatchSize size);

}  // namespace patchmill::patch
