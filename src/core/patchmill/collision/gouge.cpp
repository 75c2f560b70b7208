// Connected cells below the tolerance; see gouge.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/gouge.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

namespace patchmill::collision {

std::vector<Gouge> find_gouges(const marks::Relief& relief, double tolerance) {
  require_in_range("Tolerance", tolerance, 0.0, 1e6, "mm");
  const marks::SurfaceGrid& grid = relief.grid;
  std::vector<bool> seen(relief.height.size(), false);
  const auto is_new = [&](std::int64_t cell) {
    const auto k = static_cast<std::size_t>(cell);
    return !seen[k] && relief.height[k] < -tolerance;
  };
  std::vector<Gouge> gouges;
  std::vector<std::int64_t> open;
  for (std::int64_t start = 0; start < grid.cells(); ++start) {
    if (!is_new(start)) continue;
    std::int64_t deepest = start, count = 0;
    seen[static_cast<std::size_t>(start)] = true;
    open.assign(1, start);
    while (!open.empty()) {
      const std::int64_t cell = open.back();
      open.pop_back();
      ++count;
      if (relief.height[static_cast<std::size_t>(cell)] <
          relief.height[static_cast<std::size_t>(deepest)])
        deepest = cell;
      const int i = static_cast<int>(cell % grid.columns),
                j = static_cast<int>(cell / grid.columns);
      for (int jj = std::max(j - 1, 0); jj <= std::min(j + 1, grid.rows - 1); ++jj)
        for (int ii = std::max(i - 1, 0); ii <= std::min(i + 1, grid.columns - 1); ++ii) {
          const std::int64_t next = grid.number(ii, jj);
          if (!is_new(next)) continue;
          seen[static_cast<std::size_t>(next)] = true;
          open.push_back(next);
        }
    }
    const int i = static_cast<int>(deepest % grid.columns);
    const int j = static_cast<int>(deepest / grid.columns);
    gouges.push_back({marks::relief_point(relief, i, j), grid.plane_point(i, j),
                      -double{relief.at(i, j)},
                      static_cast<double>(count) * grid.step * grid.step});
  }
  std::stable_sort(gouges.begin(), gouges.end(),
                   [](const Gouge& a, const Gouge& b) { return a.depth > b.depth; });
  return gouges;
}

std::int64_t count_missing(const marks::Relief& relief) {
  return std::count_if(relief.height.begin(), relief.height.end(),
                       [](float h) { return std::isnan(h); });
}

}  // namespace patchmill::collision
