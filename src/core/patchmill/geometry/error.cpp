// Checks that throw InputError; see error.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/error.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill {

namespace {

// As a sentence says it: a plain number has no unit.
std::string in_unit(double value, const char* unit) {
  return *unit == '\0' ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
}

}  // namespace

void require_positive(const char* property, double value, const char* unit) {
  if (std::isfinite(value) && value > 0.0) return;
  throw InputError(property, in_unit(value, unit), "give a finite value greater than zero.");
}

void require_in_range(const char* property, double value, double lo, double hi, const char* unit) {
  if (value >= lo && value <= hi) return;
  throw InputError(property, in_unit(value, unit),
                   fmt::format("give a value from {} to {}.", lo, in_unit(hi, unit)));
}

}  // namespace patchmill
