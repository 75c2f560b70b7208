// Links of Eq. 3; see link.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/sync/link.h"

#include <limits>

namespace patchmill {

double link_length(const LinkRequest& r, const std::array<Vec3, 2>& c) {
  return (c[0] - r.from).norm() + (c[1] - c[0]).norm() + (r.to - c[1]).norm();
}

double length_miss(const LinkRequest& r, double length) {
  const double periods = (length - r.length_zero) / r.length_period;
  return (periods - std::round(periods)) * r.length_period;
}

std::array<Vec3, 2> link_corners(const LinkRequest& r, const Decimals& decimals) {
  std::array<Vec3, 2> corner = {r.from, r.to};
  const double base = std::ceil(r.safe_height / decimals.unit() - 1e-6) * decimals.unit();
  corner[0].z() = corner[1].z() = decimals.round(base);
  // raise both ends by half of what is missing to the next length that keeps the phase
  const double periods = (link_length(r, corner) - r.length_zero) / r.length_period;
  const double missing = (std::ceil(periods) - periods) * r.length_period;
  corner[0].z() = corner[1].z() = decimals.round(corner[0].z() + 0.5 * missing);

  // a unit of height more on one end is a unit of length; a step sideways of e adds about e²/2h:
  // fine steps between the coarse ones
  const Vec3 across = r.to - r.from;
  const bool along_x = std::abs(across.x()) > std::abs(across.y());
  const Vec3 side = along_x ? Vec3::UnitY() : Vec3::UnitX();
  std::array<Vec3, 2> best = corner;
  double miss = std::numeric_limits<double>::infinity();
  for (int up = 0; up <= 2; ++up)
    for (int aside = 0; aside <= 150; ++aside) {
      std::array<Vec3, 2> trial = corner;
      trial[0] =
          decimals.round(corner[0] + decimals.unit() * (up * Vec3::UnitZ() + double(aside) * side));
      const double m = std::abs(length_miss(r, link_length(r, trial)));
      if (m < miss) {
        miss = m;
        best = trial;
      }
    }
  return best;
}

}  // namespace patchmill
