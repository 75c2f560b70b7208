// Tolerances in whole steps; see corner_tolerance.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/path/corner_tolerance.h"

#include <cmath>

namespace patchmill {

CornerTolerance::CornerTolerance(std::uint32_t steps)
    : bytes_{static_cast<std::uint8_t>(steps & 0xff), static_cast<std::uint8_t>(steps >> 8 & 0xff),
             static_cast<std::uint8_t>(steps >> 16)} {}

CornerTolerance CornerTolerance::at_least(double mm) {
  constexpr double kSlack = 1e-6;  // of a step: what divisions leave of a whole one
  return CornerTolerance(std::ceil(mm / kFinestRounding - kSlack) * kFinestRounding);
}

std::uint32_t CornerTolerance::steps_of(double mm) {
  if (std::isnan(mm)) return kAsSet;
  if (!(mm > 0.0)) return 0;
  const double steps = std::round(mm / kFinestRounding);
  if (steps >= kMost) return kMost;
  return steps < 1.0 ? 1 : static_cast<std::uint32_t>(steps);
}

}  // namespace patchmill
