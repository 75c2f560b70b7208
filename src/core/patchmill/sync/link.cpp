// Links of Eq. 3; see link.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/link.h"

#include <algorithm>
#include <limits>

namespace patchmill::sync {
namespace {

constexpr double kGoodFit = 1e-5;  // mm: 0.008 degrees at the paper's F and S

// Steps sideways [units] that lengthen a lift of `height` by one unit: e² / 2h = unit.
int sideways_reach(double height, double unit) {
  return static_cast<int>(std::ceil(std::sqrt(2.0 * std::max(height, unit) / unit)));
}

// The x that solves  x + sqrt(d² + x²) = d + missing: how much one end of a level traverse of
// length d must rise for lift and traverse together to become longer by `missing`.
double raise_for(double d, double missing) {
  return missing > 0.0 ? missing * (missing + 2.0 * d) / (2.0 * (missing + d)) : 0.0;
}

}  // namespace

double link_length(const LinkRequest& r, const std::array<Vec3, 2>& c) {
  return (c[0] - r.from).norm() + (c[1] - c[0]).norm() + (r.to - c[1]).norm();
}

double length_miss(const LinkRequest& r, double length) {
  const double periods = (length - r.length_zero) / r.length_period;
  return (periods - std::round(periods)) * r.length_period;
}

std::array<Vec3, 2> link_corners(const LinkRequest& r, const Decimals& decimals) {
  const double unit = decimals.unit();
  const double base = decimals.round(std::ceil(r.safe_height / unit - 1e-6) * unit);
  const Vec3 across = r.to - r.from;
  const Vec3 side =
      std::abs(across.x()) > std::abs(across.y()) ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitX());
  const std::array<Vec3, 2> level = {Vec3(r.from.x(), r.from.y(), base),
                                     Vec3(r.to.x(), r.to.y(), base)};
  std::array<Vec3, 2> best{};
  double miss = std::numeric_limits<double>::infinity();
  const int reach = sideways_reach(base - r.from.z(), unit);
  for (std::size_t end = 0; end < 2; ++end)
    for (int aside = 0; aside <= reach && miss > kGoodFit; ++aside) {
      std::array<Vec3, 2> trial = level;
      trial[end] += aside * unit * side;
      // the first corner is raised to make up what is missing to the next length that keeps the
      // phase
      const double periods = (link_length(r, trial) - r.length_zero) / r.length_period;
      const double missing = (std::ceil(periods) - periods) * r.length_period;
      const double raise = raise_for((trial[1] - trial[0]).norm(), missing);
      trial[0] = decimals.round(trial[0] + raise * Vec3::UnitZ());
      trial[1] = decimals.round(trial[1]);
      const double m = std::abs(length_miss(r, link_length(r, trial)));
      if (m < miss) {
        miss = m;
        best = trial;
      }
    }
  return best;
}

}  // namespace patchmill::sync
