// Checks that throw InputError; see require.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/require.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill {
namespace {

std::string listed(const Eigen::Ref<const Eigen::VectorXd>& value) {
  std::string text;
  for (Eigen::Index i = 0; i < value.size(); ++i)
    text += fmt::format("{}{:g}", i ? ", " : "", value[i]);
  return "(" + text + ")";
}

}  // namespace

void require_finite(const char* property, double value, const char* unit) {
  if (std::isfinite(value)) return;
  throw InputError(property, fmt::format("{} {}", value, unit), "give a finite number.");
}

void require_finite(const char* property, const Eigen::Ref<const Eigen::VectorXd>& value,
                    const char* unit) {
  if (value.allFinite()) return;
  throw InputError(property, fmt::format("{} {}", listed(value), unit), "give finite numbers.");
}

Vec3 unit_along(const char* property, const Vec3& direction) {
  const double largest = direction.cwiseAbs().maxCoeff();
  if (!direction.allFinite() || !(largest > 1e-9))
    throw InputError(property, listed(direction), "give a direction: finite, and not zero.");
  return (direction / largest).normalized();
}

void require_one_each(const char* property, std::size_t given, std::size_t wanted, const char* of) {
  if (given == wanted) return;
  throw InputError(property, fmt::format("{} given", given),
                   fmt::format("give one for each of the {} {}.", wanted, of));
}

}  // namespace patchmill
