// Search for the rounded corner; see fit_length.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/sync/fit_length.h"

#include <limits>

namespace patchmill {

Vec3 fit_corner(const Vec3& a, const Vec3& ideal, const Vec3& b, double length,
                const Decimals& decimals, double good_enough) {
  const Vec3 middle = decimals.round(ideal);
  Vec3 best = middle;
  double miss = std::numeric_limits<double>::infinity();
  for (int reach = 1; reach <= 3 && miss > good_enough; ++reach)
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach; j <= reach; ++j)
        for (int k = -reach; k <= reach; ++k) {
          const Vec3 p = decimals.round(middle + decimals.unit() * Vec3(i, j, k));
          const double m = std::abs(way_over(a, p, b) - length);
          if (m < miss) {
            miss = m;
            best = p;
          }
        }
  return best;
}

}  // namespace patchmill
