// Doubles as floats that are surely larger or smaller, for bounds that are kept in floats.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace patchmill::mesh {

constexpr double kFloatError =
    1.0 / (1 << 22);  ///< of a sum of a few floats, relative to its terms

// A float lies at most half a unit of its last digit from the double, and |f| / 2^23 is one unit or more.
inline float above(double v) {
  const float f = static_cast<float>(v);
  return f + (std::abs(f) * 0x1p-23f + 0x1p-126f);
}
inline float below(double v) {
  const float f = static_cast<float>(v);
  return f - (std::abs(f) * 0x1p-23f + 0x1p-126f);
}

}  // namespace patchmill::mesh
