// The order of dimples inside a patch: the helical path of Matsuda 2008 (Fig. 1b) and Xu & Sasahara
// 2016 (Fig. 1a) as lattice steps. The outline loop first, then the next loop inside it, to the
// centre. SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/patch/dimple.h"

#include <vector>

namespace patchmill {

enum class HelixOrder : std::uint8_t { Inward, Outward };

/// The m*m points {0..m-1}² of a square patch, each once. Every step, also from loop to loop, is
/// one lattice step. Inward starts at (0, 0) and goes first along +x, counter-clockwise; Outward is
/// the same path backwards. Errors: InputError if `side` is not in 1..100000.
std::vector<LatticePoint> square_helix(int side, HelixOrder order);

}  // namespace patchmill
