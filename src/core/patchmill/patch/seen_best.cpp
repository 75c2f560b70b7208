// Sums of vector areas; see seen_best.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/seen_best.h"

#include "patchmill/geometry/error.h"

#include <algorithm>

#include <fmt/format.h>

namespace patchmill::patch {

std::optional<Vec3> summed_normal(const std::vector<Vec3>& area_vectors) {
  Vec3 sum = Vec3::Zero();
  double area = 0.0;
  for (const Vec3& v : area_vectors) {
    sum += v;
    area += v.norm();
  }
  if (!(sum.norm() > 0.01 * area)) return std::nullopt;
  return sum.normalized();
}

SeenBest seen_best(const std::vector<Vec3>& area_vectors, const Vec3& preferred) {
  if (!preferred.allFinite() || !(preferred.norm() > 1e-12))
    throw InputError("Direction",
                     fmt::format("({}, {}, {})", preferred.x(), preferred.y(), preferred.z()),
                     "give a finite vector that is not zero.");
  if (const auto sum = summed_normal(area_vectors)) return {-*sum, false};
  const auto seen = [&](const Vec3& direction) {
    double area = 0.0;
    for (const Vec3& v : area_vectors) area += std::max(0.0, -v.dot(direction));
    return area;
  };
  const Vec3 first = preferred.normalized();
  Vec3 best = first;
  for (const Vec3& axis : {Vec3(Vec3::UnitZ()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitX())})
    for (const double side : {-1.0, 1.0})
      if (seen(side * axis) > 1.000001 * seen(best)) best = side * axis;
  return {seen(first) >= 0.5 * seen(best) ? first : best, true};
}

}  // namespace patchmill::patch
