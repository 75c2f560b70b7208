// Walking along the lattice: what the shapes' helices are made of.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/lattice.h"

#include <vector>

namespace patchmill::patch {

/// Appends the points met going `steps` steps from `at` in direction (dx, dy); `at` is then the last of them.
inline void walk(std::vector<LatticePoint>& path, LatticePoint& at, int steps, int dx, int dy) {
  for (int i = 0; i < steps; ++i) {
    at = {at[0] + dx, at[1] + dy};
    path.push_back(at);
  }
}

}  // namespace patchmill::patch
